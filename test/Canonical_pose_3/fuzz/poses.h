// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_FUZZ_POSES_H
#define CGAL_CANONICAL_POSE_3_FUZZ_POSES_H

#include "Byte_source.h"
#include "checks.h"

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Options of the one call, and what must hold for each result.

namespace Canonical_pose_fuzz {

using CGAL::Canonical_pose_3::Options;
using CGAL::Canonical_pose_3::Result;
using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

template <class Number, std::size_t n>
Number one_of(const std::array<Number, n>& numbers, Byte_source& bytes)
{
  return numbers[bytes.below(n)];
}

inline void add_constraints(Byte_source& bytes, const std::size_t number_of_points,
                            Options& options)
{
  const auto vertex = [&] { return bytes.below(number_of_points + 1); };
  const auto length = [&] { return one_of<double, 4>({{0, 0.1, 10, 1e300}}, bytes); };
  const auto vector = [&] { return Eigen::RowVector3d(length(), length(), length()); };
  const auto stiffness = [&] { return one_of<double, 4>({{1, 0, 1e6, -1}}, bytes); };
  for(std::size_t i = bytes.below(4); i > 0; --i)
    switch(bytes.below(4))
    {
    case 0:
      options.constraints.springs.push_back({vertex(), vertex(), length(), stiffness()});
      break;
    case 1:
      options.constraints.directions.push_back({vertex(), vertex(), vector(), stiffness()});
      break;
    case 2:
      options.constraints.handles.push_back({vertex(), vector(), stiffness()});
      break;
    default:
      options.constraints.symmetric_pairs.push_back({vertex(), vertex(), stiffness()});
    }
}

/// Few landmarks, large cells and few iterations: the sanitizers are slow.
inline Options read_options(Byte_source& bytes, const std::size_t number_of_points)
{
  Options options;
  options.body = Options::Body(bytes.below(4));
  options.components = Options::Components(bytes.below(3));
  options.kernel = Options::Kernel(bytes.below(3));
  options.geodesics = Options::Geodesics(bytes.below(3));
  options.solver = Options::Solver(bytes.below(3));
  options.number_of_landmarks = bytes.below(7);
  options.lattice_spacing = one_of<double, 8>({{0.1, 0.1, 0.2, 0.2, 0.5, 0, 1e-9, -1}}, bytes);
  options.number_of_threads = 1;
  options.registration.number_of_iterations = int(bytes.below(3));
  options.registration.detail_length = one_of<double, 6>({{0.1, 0.1, 0.1, 1e-6, 1e3, 0}}, bytes);
  options.registration.tikhonov = one_of<double, 4>({{0, 0, 10, -1}}, bytes);
  options.registration.fairing_passes = int(bytes.below(2));
  // By default, all inverted cells are untangled. Half of the cells of an unconverged pose may be:
  // this takes minutes in a lattice of usual size.
  options.registration.injective = bytes.below(2) == 1 && options.lattice_spacing != 0;
  add_constraints(bytes, number_of_points, options);
  options.number_of_rounds = int(bytes.below(3));
  options.number_of_coarse_vertices = 20 * bytes.below(3);
  return options;
}

inline std::vector<Point_3> to_points(const std::vector<std::array<double, 3>>& coordinates)
{
  std::vector<Point_3> points;
  for(const auto& p : coordinates)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

inline Point_matrix to_matrix(const std::vector<std::array<double, 3>>& coordinates)
{
  Point_matrix points(Eigen::Index(coordinates.size()), 3);
  for(std::size_t v = 0; v < coordinates.size(); ++v)
    points.row(Eigen::Index(v)) << coordinates[v][0], coordinates[v][1], coordinates[v][2];
  return points;
}

inline void check_result(const Result& result, const Options& options,
                         const std::size_t number_of_points)
{
  if(!result.is_usable())
    return;
  const bool is_injective = options.registration.injective.value_or(
    options.registration.fairing_passes == 0 && !options.paper_weights);
  require(!is_injective || result.summary.inverted == 0 || !result.summary.warnings.empty(),
          "no cell is inverted in injective mode, or there is a warning");
  require(result.pose.rows() == Eigen::Index(number_of_points), "each vertex has a pose");
  require(result.pose.allFinite(), "a usable pose is finite");
  require(result.pose_of_followers.allFinite(), "the pose of the followers is finite");
  require(result.target->allFinite(), "the target is finite");
  require(std::isfinite(result.summary.energy), "the energy is finite");
}

/// Returns the result for a soup, without a pose if it is refused.
inline Result checked_pose(const std::vector<std::array<double, 3>>& coordinates,
                           const CGAL::Canonical_pose_3::Face_list& polygons,
                           const Options& options)
{
  const std::vector<Point_3> points = to_points(coordinates);
  std::vector<Point_3> pose;
  Result result;
  is_accepted([&] { result = CGAL::canonical_pose_3(points, polygons, pose, options); });
  check_result(result, options, points.size());
  return result;
}

} // namespace Canonical_pose_fuzz

#endif // CGAL_CANONICAL_POSE_3_FUZZ_POSES_H
