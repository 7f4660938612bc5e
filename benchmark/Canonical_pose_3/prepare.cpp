// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "prepare.h"

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "Child_process.h"

#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>

namespace Canonical_pose_benchmark {

namespace {

// Runs in the child. Returns the bytes of the target and, after it, of the distances.
std::string targets_here(const Point_matrix& points, const Triangles& triangles)
{
  namespace CP = CGAL::Canonical_pose_3;
  using Mesh = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  const Mesh mesh = CP::make_triangle_mesh<Mesh>(points, triangles);
  const CP::Landmark_fields_3 fields = CP::farthest_point_landmarks(
    CP::Heat_geodesics_3<Mesh>(mesh), 80, CP::extremal_vertex(mesh, mesh.points()));
  CP::Landmark_mds_target_builder_3<> builder;
  builder.build(fields);
  const Eigen::VectorXd shares = CP::vertex_area_shares(points, triangles);
  const Point_matrix& embedded = builder.targets();
  const Point_matrix target = CP::align_target(
    embedded, points, shares,
    CP::target_handedness(embedded, points, triangles, shares).is_mirror_image());
  std::string bytes(reinterpret_cast<const char*>(target.data()),
                    sizeof(double) * static_cast<std::size_t>(target.size()));
  return bytes.append(reinterpret_cast<const char*>(fields.distances.data()),
                      sizeof(double) * static_cast<std::size_t>(fields.distances.size()));
}

} // namespace

Body_problem prepare(const Point_matrix& points, const Triangles& triangles, const Triangles& caps)
{
  Child_process child([&] { return targets_here(points, triangles); }, Limits());
  child.wait();
  if(child.ending() != Child_process::RETURNED)
    throw std::runtime_error(child.description());
  Body_problem problem;
  problem.points = points;
  problem.triangles = triangles;
  problem.caps = caps;
  problem.target.resize(points.rows(), 3);
  const std::size_t size = sizeof(double) * static_cast<std::size_t>(problem.target.size());
  const std::size_t column = sizeof(double) * static_cast<std::size_t>(points.rows());
  problem.distances.resize(points.rows(),
                           static_cast<Eigen::Index>((child.output().size() - size) / column));
  std::memcpy(problem.target.data(), child.output().data(), size);
  std::memcpy(problem.distances.data(), child.output().data() + size, child.output().size() - size);
  return problem;
}

} // namespace Canonical_pose_benchmark
