// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_BODY_TRIAL_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_BODY_TRIAL_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Point_matrix;
using Triangles = std::vector<std::array<std::size_t, 3>>;

/// The input of the registration, except for the body.
struct Body_problem
{
  Point_matrix points;
  Triangles triangles, caps;
  Eigen::MatrixXd distances; ///< to the landmarks
  Point_matrix target;
  /// distance of a point to the solid, 0 inside; may be empty
  std::function<double(const Eigen::Vector3d&)> distance_outside;

  double length_scale() const { return distances.maxCoeff(); }
};

/// The bodies, in the order of the tables.
enum class Body_kind { TETGEN, LATTICE, MESH_3, CHORDS };
constexpr std::array<Body_kind, 4> all_bodies
  = {Body_kind::TETGEN, Body_kind::LATTICE, Body_kind::MESH_3, Body_kind::CHORDS};

inline const char* name(const Body_kind kind)
{
  static const char* const names[] = {"TetGen", "lattice", "Mesh_3", "chords"};
  return names[static_cast<std::size_t>(kind)];
}

/// The result for a body.
struct Body_trial
{
  struct Numbers
  {
    std::size_t vertices, cells, nonzeros, inverted;
    int iterations;
    double body_seconds, factorization_seconds, iteration_seconds, energy, strain;
    /// vertices - edges + facets - cells: 1 for a ball, 0 for a solid torus
    long long euler_characteristic;
    double farthest_outside; ///< largest distance of a cell's centroid to the solid
  };

  std::string failure; ///< empty if there is a pose
  Numbers numbers = {};
  double megabytes = 0; ///< peak memory, minus that of an idle process
  Point_matrix pose;
};

/// Registers a body of one kind in a separate process, and waits for it.
Body_trial try_body(Body_kind kind, const Body_problem& problem);

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_BODY_TRIAL_H
