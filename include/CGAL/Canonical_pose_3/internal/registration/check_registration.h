// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_CHECK_REGISTRATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_CHECK_REGISTRATION_H

#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline double checked_length_scale(const double length_scale)
{
  if(!(length_scale > 0) || !std::isfinite(length_scale))
    throw std::invalid_argument("the length scale must be positive and finite");
  return length_scale;
}

// Throws unless there are either no factors or n factors in the range of weights or, if zeros are
// allowed, 0, but not all of them, or in a range in which their sum and its inverse are finite.
// Messages refer to them by `what` and `element`.
inline void check_factors(const Eigen::VectorXd& factors, const Eigen::Index n,
                          const std::string& what, const std::string& element,
                          const bool zeros_are_allowed)
{
  if(factors.size() == 0)
    return;
  if(factors.size() != n)
    throw std::invalid_argument(std::to_string(factors.size()) + " numbers are given as " + what
                                + ", but it takes " + std::to_string(n) + ", one per " + element);
  const double least = zeros_are_allowed ? 1e-100 : Registration_options::SMALLEST_WEIGHT,
               largest = zeros_are_allowed ? 1e100 : Registration_options::LARGEST_WEIGHT;
  for(Eigen::Index i = 0; i < n; ++i)
    if(!(factors[i] >= least && factors[i] <= largest) && !(zeros_are_allowed && factors[i] == 0))
      throw std::invalid_argument("the " + what + " of " + element + ' ' + std::to_string(i)
                                  + " is " + shortest_number(factors[i]) + ", but must be "
                                  + (zeros_are_allowed ? "0 or from " : "from ")
                                  + shortest_number(least) + " to " + shortest_number(largest));
  if(!(factors.array() > 0).any())
    throw std::invalid_argument("the " + what + " of every " + element + " is 0");
}

inline const Eigen::VectorXd& checked_stiffness(const Eigen::VectorXd& stiffness,
                                                const std::size_t number_of_cells)
{
  check_factors(stiffness, static_cast<Eigen::Index>(number_of_cells), "stiffness", "cell", false);
  return stiffness;
}

// Unites the vertices of each cell.
template <class ElasticBody>
void unite_cells(const ElasticBody& body, Disjoint_sets& sets)
{
  for(const auto& cell : body.cells())
    for(int k = 1; k < 4; ++k)
      sets.unite(static_cast<std::size_t>(cell[0]), static_cast<std::size_t>(cell[k]));
}

// Returns for each vertex of the body whether its component has a surface vertex of positive
// weight. The matrix of the registration is positive definite if and only if all components do.
template <class ElasticBody>
std::vector<bool> held_vertices(const ElasticBody& body, const Eigen::VectorXd& weights)
{
  const std::size_t n = static_cast<std::size_t>(body.points().rows());
  Disjoint_sets sets(n);
  unite_cells(body, sets);
  std::vector<bool> is_held(n, false);
  const Eigen::SparseMatrix<double>& embedding = body.embedding();
  for(Eigen::Index v = 0; v < embedding.outerSize(); ++v)
    for(Eigen::SparseMatrix<double>::InnerIterator it(embedding, v); it; ++it)
      if(it.value() != 0 && weights[it.row()] > 0)
        is_held[sets.representative(static_cast<std::size_t>(v))] = true;
  for(std::size_t v = 0; v < n; ++v)
    is_held[v] = is_held[sets.representative(v)];
  return is_held;
}

// Returns a surface vertex of a body component whose surface vertices all have weight 0.
template <class ElasticBody>
std::optional<std::size_t> surface_vertex_of_loose_component(const ElasticBody& body,
                                                             const Eigen::VectorXd& weights)
{
  const std::vector<bool> is_held = held_vertices(body, weights);
  const Eigen::SparseMatrix<double>& embedding = body.embedding();
  for(Eigen::Index v = 0; v < embedding.outerSize(); ++v)
    for(Eigen::SparseMatrix<double>::InnerIterator it(embedding, v); it; ++it)
      if(it.value() != 0 && !is_held[static_cast<std::size_t>(v)])
        return static_cast<std::size_t>(it.row());
  return std::nullopt;
}

template <class ElasticBody>
void check_that_components_are_held(const ElasticBody& body, const Eigen::VectorXd& weights)
{
  const std::vector<bool> is_held = held_vertices(body, weights);
  const auto loose = std::find(is_held.begin(), is_held.end(), false);
  if(loose != is_held.end())
    throw std::invalid_argument("the component of the body with vertex "
                                + std::to_string(loose - is_held.begin())
                                + " carries no surface vertex of positive weight");
}

// Throws unless the cells are connected; otherwise parts without a target could move away from each
// other without end.
template <class ElasticBody>
void check_that_body_is_connected(const ElasticBody& body)
{
  Disjoint_sets sets(static_cast<std::size_t>(body.points().rows()));
  unite_cells(body, sets);
  const std::size_t first = sets.representative(static_cast<std::size_t>(body.cells()[0][0]));
  for(const auto& cell : body.cells())
    if(sets.representative(static_cast<std::size_t>(cell[0])) != first)
      throw std::invalid_argument("a body that is not connected cannot be unfolded: vertex "
                                  + std::to_string(cell[0]) + " is not connected to vertex "
                                  + std::to_string(body.cells()[0][0]));
}

// Returns the weights, scaled to sum 1.
template <class ElasticBody>
Eigen::VectorXd checked_matching_weights(const ElasticBody& body, const Eigen::VectorXd& weights)
{
  CGAL_precondition(weights.size() == body.embedding().rows());
  CGAL_precondition(body.embedding().cols() == body.points().rows());
  for(Eigen::Index i = 0; i < weights.size(); ++i)
    if(!(weights[i] >= 0) || !std::isfinite(weights[i]))
      throw std::invalid_argument("the matching weight of vertex " + std::to_string(i)
                                  + " is negative or not finite");
  check_that_components_are_held(body, weights);
  const double sum = weights.sum();
  if(!std::isfinite(sum) || !std::isfinite(1 / sum))
    throw std::invalid_argument("the sum of the matching weights is " + shortest_number(sum)
                                + ", which is too large or too small");
  return weights / sum;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_CHECK_REGISTRATION_H
