// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_LANDMARK_MDS_TARGET_BUILDER_3_H
#define CGAL_CANONICAL_POSE_3_LANDMARK_MDS_TARGET_BUILDER_3_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Squared_distance_kernel.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/dense_products.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/leading_eigenvectors.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/internal/target/check_landmark_fields.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief embeds points by landmark multidimensional scaling, given their distances to a few of them.

The landmarks are embedded by the leading eigenvectors of their (centered) kernel matrix; all other
points are interpolated from their distances to the landmarks \cgalCite{cgal:canonical-st-glmnd-02},
\cgalCite{cgal:canonical-s-sdacm-15} (Equation 3). Let \f$ K_{ij} = k(g_{ij}/L) \f$ for the
symmetrized distances between landmarks, where \f$ L \f$ is the largest of all distances, let
\f$ H \f$ be the centering matrix, and \f$ HKH = Q \Lambda Q^t \f$ truncated to the \f$ m \f$
largest eigenvalues. Point \f$ i \f$ is mapped to \f$ s\,\Lambda^{-1/2} Q^t (k_i - \bar k) \f$,
where \f$ \bar k \f$ is the mean of the columns of \f$ K \f$. The scale
\f$ s = \sum d g / \sum d^2 \f$ over the pairs of landmarks (\f$ d \f$ embedded, \f$ g \f$ given)
yields the unit of the distances for any kernel.

If the matrix has fewer than \f$ m \f$ positive eigenvalues, the remaining coordinates are 0 (the
target is flat), see `number_of_positive_eigenvalues()`. The sign of each eigenvector is chosen such
that the third moment of its entries is nonnegative. Coincident landmarks are supported.

\tparam MdsKernel a model of `MdsKernel`

\sa `farthest_point_landmarks()`
\sa `align_target()`
*/
template <class MdsKernel = Squared_distance_kernel>
class Landmark_mds_target_builder_3
{
public:
  /// the kernel
  using Kernel = MdsKernel;

  /// constructs a builder without landmarks, for an embedding into `dimension` dimensions.
  /// \throws std::invalid_argument unless `dimension >= 1`
  explicit Landmark_mds_target_builder_3(MdsKernel kernel = MdsKernel(), const int dimension = 3)
    : m_kernel(std::move(kernel)), m_dimension(dimension)
  {
    internal::require_option(dimension >= 1, "dimension", dimension, ">= 1");
  }

  /*!
  embeds the points whose distances to the landmarks are given.

  \throws std::invalid_argument if there is no landmark, the sizes do not match, a landmark is not a
         row of the distances, or a distance is negative or not finite (for a point that is not
         connected to a landmark), stating the index of the element; or if the kernel is not finite
         at a distance.

  <em>Complexity:</em> \f$ O(nl) \f$ for \f$ n \f$ points and \f$ l \f$ landmarks, and the leading
  eigenvectors of an \f$ l \times l \f$ matrix: \f$ O(l^3) \f$ at most, and \f$ O(l^2) \f$ if the
  eigenvalues decay, as they do for distances on surfaces.
  */
  void build(const Landmark_fields_3& fields)
  {
    internal::check_landmark_fields(fields, static_cast<std::size_t>(fields.distances.rows()),
                                    "the landmark fields");
    m_length_scale = fields.distances.maxCoeff();
    const Eigen::MatrixXd g = landmark_distances(fields);
    const double unit = m_length_scale > 0 ? m_length_scale : 1;
    const Eigen::MatrixXd kernel = g.unaryExpr([&](const double d) { return m_kernel(d / unit); });
    check_kernel(kernel);
    const Eigen::VectorXd mean = kernel.rowwise().mean();

    Eigen::MatrixXd gram = kernel;
    if(m_kernel.is_centered())
    {
      gram.colwise() -= mean;
      gram.rowwise() -= Eigen::RowVectorXd(mean.transpose());
      gram.array() += mean.mean();
    }
    const Eigen::MatrixXd projection = eigen_projection(gram);
    const double kernel_scale = scale_to_distances(kernel, mean, projection, g, unit);
    interpolate(fields, mean, projection * kernel_scale, unit);
  }

  /// \name Results
  /// These functions refer to the last call of `build()`.
  /// @{

  /// returns the \f$ n \times m \f$ matrix of embedded points, in the unit of the distances.
  const Eigen::MatrixXd& targets() const { return m_targets; }

  /// returns the \f$ l \times m \f$ matrix of embedded landmarks, rows of `targets()`.
  const Eigen::MatrixXd& landmark_targets() const { return m_landmark_targets; }

  /// returns \f$ \sqrt{\sum (d - g)^2 / \sum g^2} \f$ over all pairs of landmarks; 0 if all
  /// distances are 0.
  double stress() const { return m_stress; }

  /// returns the leading eigenvalues of the (centered) kernel matrix of distances divided by the
  /// largest one, in decreasing order: at least six, and at least one more than the dimension; all
  /// of them if there are at most 300 landmarks.
  const Eigen::VectorXd& eigenvalues() const { return m_eigenvalues; }

  /// returns how many of the first \f$ m \f$ eigenvalues exceed \f$ 10^{-9} \f$ times the first
  /// one. Smaller ones do not count as positive, because of rounding errors.
  int number_of_positive_eigenvalues() const { return m_number_of_positive_eigenvalues; }

  /// returns `false` if the eigenvalue after the last used one exceeds 0.9 times that one: a
  /// different choice of axes is then about equally good, and the pose depends on details of the
  /// distances.
  bool is_determined() const
  {
    return m_eigenvalues.size() <= m_dimension
           || m_eigenvalues[m_dimension] <= 0.9 * m_eigenvalues[m_dimension - 1];
  }

  /// returns the largest distance, \f$ L \f$.
  double length_scale() const { return m_length_scale; }

  /// returns the kernel.
  const MdsKernel& kernel() const { return m_kernel; }

  /// @}

private:
  static constexpr Eigen::Index LARGEST_NUMBER_TO_DECOMPOSE = 300;

  void check_kernel(const Eigen::Ref<const Eigen::MatrixXd>& values) const
  {
    if(!values.allFinite())
      throw std::invalid_argument(std::string("the kernel ") + m_kernel.name()
                                  + " is not finite at a distance between points");
  }

  static Eigen::MatrixXd landmark_distances(const Landmark_fields_3& fields)
  {
    const Eigen::Index l = fields.distances.cols();
    Eigen::MatrixXd g(l, l);
    for(Eigen::Index i = 0; i < l; ++i)
      g.row(i) = fields.distances.row(static_cast<Eigen::Index>(fields.landmarks[i]));
    return (0.5 * (g + g.transpose())).eval();
  }

  // The columns are those of Q Lambda^(-1/2), zero if the eigenvalue is not positive.
  Eigen::MatrixXd eigen_projection(const Eigen::MatrixXd& gram)
  {
    const internal::Eigenpairs leading
      = gram.rows() <= LARGEST_NUMBER_TO_DECOMPOSE
          ? internal::largest_of_all_eigenpairs(gram, gram.rows())
          : internal::leading_eigenpairs(gram, (std::max)(6, m_dimension + 1));
    m_eigenvalues = leading.values;
    // rounding errors of the coordinates are 1e-16 times the power -3/2 of this
    constexpr double smallest = 1e-9;
    const double smallest_positive = smallest * (std::max)(m_eigenvalues[0], 0.);
    m_number_of_positive_eigenvalues = 0;
    Eigen::MatrixXd projection = Eigen::MatrixXd::Zero(gram.rows(), m_dimension);
    const Eigen::Index available = (std::min)(static_cast<Eigen::Index>(m_dimension), gram.rows());
    for(Eigen::Index c = 0; c < available; ++c)
    {
      if(!(m_eigenvalues[c] > smallest_positive))
        break;
      const Eigen::VectorXd q = leading.vectors.col(c);
      projection.col(c) = (q.array().cube().sum() < 0 ? -1. : 1.) / std::sqrt(m_eigenvalues[c]) * q;
      ++m_number_of_positive_eigenvalues;
    }
    return projection;
  }

  // Returns the scale s and stores the stress after scaling.
  double scale_to_distances(const Eigen::MatrixXd& kernel, const Eigen::VectorXd& mean,
                            const Eigen::MatrixXd& projection, const Eigen::MatrixXd& g,
                            const double unit)
  {
    const Eigen::MatrixXd embedded
      = internal::product_of_transposed(kernel.colwise() - mean, projection);
    double dg = 0, dd = 0, gg = 0;
    for(Eigen::Index i = 0; i < g.rows(); ++i)
      for(Eigen::Index j = 0; j < i; ++j)
      {
        const double distance = (embedded.row(i) - embedded.row(j)).norm();
        const double given = g(i, j) / unit;
        dg += distance * given;
        dd += distance * distance;
        gg += given * given;
      }
    const double scale = dd > 0 ? dg / dd : 1;
    // sum (s d - g)^2 at the optimal s
    m_stress = gg > 0 ? std::sqrt((std::max)(gg - scale * dg, 0.) / gg) : 0;
    return scale;
  }

  void interpolate(const Landmark_fields_3& fields, const Eigen::VectorXd& mean,
                   const Eigen::MatrixXd& projection, const double unit)
  {
    m_targets = Eigen::MatrixXd::Zero(fields.distances.rows(), m_dimension);
    for(Eigen::Index j = 0; j < fields.distances.cols(); ++j)
    {
      const Eigen::VectorXd k = fields.distances.col(j).unaryExpr(
        [&](const double d) { return m_kernel(d / unit) - mean[j]; });
      check_kernel(k);
      m_targets.noalias() += k * projection.row(j);
    }
    m_targets *= unit;
    m_landmark_targets.resize(fields.distances.cols(), m_dimension);
    for(Eigen::Index j = 0; j < fields.distances.cols(); ++j)
      m_landmark_targets.row(j)
        = m_targets.row(static_cast<Eigen::Index>(fields.landmarks[static_cast<std::size_t>(j)]));
  }

  MdsKernel m_kernel;
  int m_dimension;
  Eigen::MatrixXd m_targets, m_landmark_targets;
  Eigen::VectorXd m_eigenvalues;
  double m_stress = 0;
  double m_length_scale = 0;
  int m_number_of_positive_eigenvalues = 0;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LANDMARK_MDS_TARGET_BUILDER_3_H
