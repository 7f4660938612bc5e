// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_MATCHING_METHODS_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_MATCHING_METHODS_H

#include "Functional_map.h"
#include "Nearest_points.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/canonical_frame.h>
#include <CGAL/Canonical_pose_3/match_surfaces.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

using Triangles = std::vector<std::array<std::size_t, 3>>;

/// A connected surface with all that a method needs of it.
struct Surface_to_match
{
  Surface_to_match(Point_matrix given_points, Triangles given_triangles,
                   const CGAL::Canonical_pose_3::Options& options)
    : points(std::move(given_points)), triangles(std::move(given_triangles)),
      shares(CGAL::Canonical_pose_3::vertex_area_shares(points, triangles))
  {
    using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
    std::vector<Point> soup, posed;
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      soup.emplace_back(points(i, 0), points(i, 1), points(i, 2));
    const CGAL::Canonical_pose_3::Result result
      = CGAL::canonical_pose_3(soup, triangles, posed, options);
    if(!result.is_usable())
      throw std::runtime_error("there is no pose");
    pose = result.pose;
    target = *result.target;
  }

  Point_matrix points;
  Triangles triangles;
  Eigen::VectorXd shares; ///< of vertices in the area
  Point_matrix target, pose;
  std::optional<CGAL::Canonical_pose_3::Matchable_surface_3> matchable;
  std::optional<Spectral_surface> spectral;
};

/// For each of `points`, the nearest one of `others`: in the frames of their principal axes, at unit
/// radius of gyration, after that of four rotations which brings both nearest to each other.
inline std::vector<std::size_t> nearest_vertices(const Point_matrix& points,
                                                 const Eigen::VectorXd& shares,
                                                 const Point_matrix& others,
                                                 const Eigen::VectorXd& shares_of_others)
{
  const auto in_frame = [](const Point_matrix& positions, const Eigen::VectorXd& weights) {
    const Eigen::Isometry3d frame = CGAL::Canonical_pose_3::canonical_frame(positions, weights);
    const Point_matrix moved = (frame * positions.transpose()).transpose();
    return Point_matrix(moved / std::sqrt(weights.dot(moved.rowwise().squaredNorm())));
  };
  const auto sample = [](const Point_matrix& positions) {
    constexpr Eigen::Index number = 1000;
    const Eigen::Index step = (std::max)(Eigen::Index(1), positions.rows() / number);
    return Point_matrix(positions(Eigen::seq(0, Eigen::last, step), Eigen::all));
  };
  const auto mean_distance = [](const Point_matrix& from, const Point_matrix& to) {
    return (rows_of(to, Nearest_points(to).find(from)) - from).rowwise().norm().mean();
  };
  const Point_matrix p = in_frame(points, shares), q = in_frame(others, shares_of_others),
                     sample_of_p = sample(p), sample_of_q = sample(q);
  Eigen::RowVector3d best;
  double least = (std::numeric_limits<double>::infinity)();
  for(const Eigen::RowVector3d& signs :
      {Eigen::RowVector3d(1, 1, 1), Eigen::RowVector3d(1, -1, -1), Eigen::RowVector3d(-1, 1, -1),
       Eigen::RowVector3d(-1, -1, 1)})
  {
    const Point_matrix turned = sample_of_p * signs.asDiagonal();
    const double distance = mean_distance(turned, sample_of_q) + mean_distance(sample_of_q, turned);
    if(distance < least)
    {
      least = distance;
      best = signs;
    }
  }
  return Nearest_points(q).find(Point_matrix(p * best.asDiagonal()));
}

struct Matching_method
{
  std::string name;
  /// For each vertex of the first surface, the position on the second one.
  std::function<Point_matrix(const Surface_to_match&, const Surface_to_match&)> match;
  /// What it needs in addition to points, target and pose.
  std::function<void(Surface_to_match&)> prepare = [](Surface_to_match&) {};
};

inline std::vector<Matching_method> matching_methods()
{
  const auto nearest = [](Point_matrix Surface_to_match::*const positions) {
    return [positions](const Surface_to_match& a, const Surface_to_match& b) {
      return rows_of(b.points, nearest_vertices(a.*positions, a.shares, b.*positions, b.shares));
    };
  };
  return {{"nearest, input", nearest(&Surface_to_match::points)},
          {"nearest, target", nearest(&Surface_to_match::target)},
          {"nearest, pose", nearest(&Surface_to_match::pose)},
          {"functional map",
           [](const Surface_to_match& a, const Surface_to_match& b) {
             return rows_of(b.points, Functional_map(*a.spectral, *b.spectral).vertices());
           },
           [](Surface_to_match& s) { s.spectral.emplace(s.points, s.triangles); }},
          {"match_surfaces()",
           [](const Surface_to_match& a, const Surface_to_match& b) {
             return CGAL::Canonical_pose_3::match_surfaces(*a.matchable, *b.matchable)
               .interpolated(b.points);
           },
           [](Surface_to_match& s) { s.matchable.emplace(s.points, s.triangles, s.pose); }}};
}

/// Those with the given names, separated by semicolons, or all of them if there are none.
inline std::vector<Matching_method> chosen_matching_methods(const std::string& names)
{
  std::vector<Matching_method> result;
  for(Matching_method& method : matching_methods())
    if(names.empty() || (';' + names + ';').find(';' + method.name + ';') != names.npos)
      result.push_back(std::move(method));
  if(result.empty())
    throw std::invalid_argument("--methods names none");
  return result;
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_MATCHING_METHODS_H
