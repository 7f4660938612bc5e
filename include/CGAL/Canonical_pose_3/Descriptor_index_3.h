// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_DESCRIPTOR_INDEX_3_H
#define CGAL_CANONICAL_POSE_3_DESCRIPTOR_INDEX_3_H

#include <CGAL/assertions.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief searches shapes by their shape distances, those of their descriptors.

\tparam ShapeDescriptor a model of `ShapeDescriptor_3`

All values are in memory. A query computes the shape distances to all, which takes about as long as
reading the values.

\sa `shape_descriptor()`, `fused_distances()`, `manifold_ranking()`
*/
template <class ShapeDescriptor>
class Descriptor_index_3
{
public:
  /// a shape, and its shape distance to the query.
  struct Neighbor
  {
    std::size_t shape; ///< its number, in the order of insertion.
    double distance;   ///< see `ShapeDescriptor_3`.
  };

  /// creates an empty index.
  explicit Descriptor_index_3(ShapeDescriptor descriptor = ShapeDescriptor())
    : m_descriptor(std::move(descriptor)),
      m_values(static_cast<Eigen::Index>(m_descriptor.size()), 0)
  {}

  /// returns the number of shapes.
  std::size_t size() const { return m_size; }

  /// reserves memory.
  void reserve(const std::size_t number_of_shapes)
  {
    if(static_cast<Eigen::Index>(number_of_shapes) > m_values.cols())
      m_values.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(number_of_shapes));
  }

  /*!
  adds a shape, and returns its number.

  \throws std::invalid_argument if the number of values is not that of the descriptor, or one is not
          finite.

  <em>Complexity:</em> constant, amortized.
  */
  std::size_t insert(const Eigen::VectorXd& values)
  {
    check(values);
    if(static_cast<Eigen::Index>(m_size) == m_values.cols())
      reserve((std::max)(2 * m_size, std::size_t(16)));
    m_values.col(static_cast<Eigen::Index>(m_size)) = values;
    return m_size++;
  }

  /// returns the values of a shape.
  /// \pre `shape < size()`
  Eigen::VectorXd values(const std::size_t shape) const
  {
    CGAL_precondition(shape < m_size);
    return m_values.col(static_cast<Eigen::Index>(shape));
  }

  /*!
  returns the shape distances of a query to all shapes.

  \throws std::invalid_argument as `insert()`.
  */
  Eigen::VectorXd distances(const Eigen::VectorXd& query) const
  {
    check(query);
    return m_descriptor.distances(query, m_values.leftCols(static_cast<Eigen::Index>(m_size)));
  }

  /*!
  returns the nearest shapes, by increasing shape distance; of equal ones, that with the smaller number
  comes first.

  \param query values of the descriptor.
  \param number at most as many shapes are returned.

  \throws std::invalid_argument as `insert()`.
  */
  std::vector<Neighbor> nearest(const Eigen::VectorXd& query, const std::size_t number) const
  {
    const Eigen::VectorXd all = distances(query);
    std::vector<Neighbor> result;
    result.reserve(m_size);
    for(std::size_t i = 0; i < m_size; ++i)
      result.push_back({i, all[static_cast<Eigen::Index>(i)]});
    const auto end = result.begin() + static_cast<std::ptrdiff_t>((std::min)(number, m_size));
    std::partial_sort(result.begin(), end, result.end(), [](const Neighbor& a, const Neighbor& b) {
      return std::make_pair(a.distance, a.shape) < std::make_pair(b.distance, b.shape);
    });
    result.erase(end, result.end());
    return result;
  }

  /// returns the symmetric matrix of the shape distances of all pairs.
  Eigen::MatrixXd distances() const
  {
    const auto n = static_cast<Eigen::Index>(m_size);
    Eigen::MatrixXd result(n, n);
    for(Eigen::Index j = 0; j < n; ++j)
      result.col(j) = m_descriptor.distances(m_values.col(j), m_values.leftCols(n));
    return result;
  }

private:
  void check(const Eigen::VectorXd& values) const
  {
    if(values.size() != m_values.rows())
      throw std::invalid_argument("there are " + std::to_string(values.size()) + " values, but "
                                  + m_descriptor.name() + " has "
                                  + std::to_string(m_values.rows()));
    for(Eigen::Index i = 0; i < values.size(); ++i)
      if(!std::isfinite(values[i]))
        throw std::invalid_argument("value " + std::to_string(i) + " is not finite");
  }

  ShapeDescriptor m_descriptor;
  std::size_t m_size = 0;
  Eigen::MatrixXd m_values; // a column per shape, and further ones in reserve
};

namespace internal {

// Throws `std::invalid_argument` unless there are finite nonnegative distances of all pairs.
inline void check_distances_of_pairs(const Eigen::MatrixXd& distances, const std::string& what)
{
  if(distances.rows() != distances.cols())
    throw std::invalid_argument(what + " is not square");
  for(Eigen::Index j = 0; j < distances.cols(); ++j)
    for(Eigen::Index i = 0; i < distances.rows(); ++i)
      if(!(distances(i, j) >= 0) || !std::isfinite(distances(i, j)))
        throw std::invalid_argument("entry (" + std::to_string(i) + ", " + std::to_string(j)
                                    + ") of " + what + " is negative or not finite");
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief combines shape distances of several descriptors: their sum, after each was divided by its mean
over all pairs.

\param distances matrices from `Descriptor_index_3::distances()`, of the same shapes.
\param weights positive, one per matrix; all are 1 if empty.

\throws std::invalid_argument if there is no matrix, they have different sizes, an entry is negative
        or not finite, or a weight is not positive or missing.
*/
inline Eigen::MatrixXd fused_distances(const std::vector<Eigen::MatrixXd>& distances,
                                       const std::vector<double>& weights = {})
{
  if(distances.empty())
    throw std::invalid_argument("there are no distances to combine");
  if(!weights.empty() && weights.size() != distances.size())
    throw std::invalid_argument("there are " + std::to_string(weights.size()) + " weights, but "
                                + std::to_string(distances.size()) + " descriptors");
  const Eigen::Index n = distances.front().rows();
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
  for(std::size_t i = 0; i < distances.size(); ++i)
  {
    const double weight = weights.empty() ? 1 : weights[i];
    if(distances[i].rows() != n || distances[i].cols() != n)
      throw std::invalid_argument("matrix " + std::to_string(i) + " of distances has another size");
    internal::check_distances_of_pairs(distances[i],
                                       "matrix " + std::to_string(i) + " of distances");
    if(!(weight > 0) || !std::isfinite(weight))
      throw std::invalid_argument("weight " + std::to_string(i) + " is not positive");
    const double sum = distances[i].sum();
    if(sum > 0)
      result += weight * static_cast<double>(n * (n - 1)) / sum * distances[i];
  }
  return result;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns shape distances that take neighbors of neighbors into account.

Manifold ranking (D. Zhou et al., "Ranking on data manifolds", 2003): scores spread from the query
over the graph of nearest neighbors, whose weights depend on the distances to the farthest of them (L.
Zelnik-Manor and P. Perona, "Self-tuning spectral clustering", 2004). Entry \f$ (i, j) \f$ is small if shape \f$ j \f$ has a high score for query
\f$ i \f$; shapes without a path to the query follow in the order of their shape distances. The matrix
is not symmetric.

\param distances shape distances of all pairs, symmetric.
\param number_of_neighbors in the graph, per shape.

\throws std::invalid_argument if the matrix is not square, an entry is negative or not finite, or the
        number is 0.

<em>Complexity:</em> \f$ O(n^3) \f$ for \f$ n \f$ shapes.
*/
inline Eigen::MatrixXd manifold_ranking(const Eigen::MatrixXd& distances,
                                        const std::size_t number_of_neighbors = 5)
{
  constexpr double spread = .8; // of the score to neighbors
  internal::check_distances_of_pairs(distances, "the matrix of distances");
  if(number_of_neighbors == 0)
    throw std::invalid_argument("the number of neighbors is 0");
  const Eigen::Index n = distances.rows();
  const std::size_t k
    = (std::min)(number_of_neighbors, static_cast<std::size_t>((std::max)(n, Eigen::Index(1)) - 1));
  std::vector<std::vector<Eigen::Index>> neighbors;
  Eigen::VectorXd farthest_neighbor = Eigen::VectorXd::Zero(n);
  for(Eigen::Index i = 0; i < n; ++i)
  {
    std::vector<Eigen::Index> order;
    for(Eigen::Index j = 0; j < n; ++j)
      if(j != i)
        order.push_back(j);
    std::partial_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(k), order.end(),
                      [&](const Eigen::Index a, const Eigen::Index b) {
                        return std::make_pair(distances(a, i), a)
                               < std::make_pair(distances(b, i), b);
                      });
    order.resize(k);
    if(k > 0)
      farthest_neighbor[i] = distances(order.back(), i);
    neighbors.push_back(std::move(order));
  }
  constexpr double least = 1e-300;
  Eigen::MatrixXd weights = Eigen::MatrixXd::Zero(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
    for(const Eigen::Index j : neighbors[static_cast<std::size_t>(i)])
    {
      const double d = distances(j, i);
      weights(i, j) = weights(j, i)
        = std::exp(-d * d / (std::max)(farthest_neighbor[i] * farthest_neighbor[j], least));
    }
  const Eigen::VectorXd scale = weights.rowwise().sum().cwiseMax(least).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scores
    = (Eigen::MatrixXd::Identity(n, n) - spread * scale.asDiagonal() * weights * scale.asDiagonal())
        .llt()
        .solve(Eigen::MatrixXd::Identity(n, n));
  // Scores are positive along paths; the distance decides between those that are (nearly) 0.
  const double largest = n > 0 ? scores.maxCoeff() : 1, farthest = n > 0 ? distances.maxCoeff() : 1;
  constexpr double negligible = 1e-9;
  Eigen::MatrixXd result = 1 - scores.array() / largest;
  if(farthest > 0)
    result += negligible / farthest * distances;
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DESCRIPTOR_INDEX_3_H
