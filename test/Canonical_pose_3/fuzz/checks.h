// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_FUZZ_CHECKS_H
#define CGAL_CANONICAL_POSE_3_FUZZ_CHECKS_H

#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>
#include <vector>

// Conditions that must hold for any input.

namespace Canonical_pose_fuzz {

using CGAL::Canonical_pose_3::Point_matrix;
using CGAL::Canonical_pose_3::Repaired_surface_3;
using Polygons = std::vector<std::vector<std::size_t>>;

/// Terminates the fuzzer, which then saves the input.
inline void require(const bool holds, const char* what)
{
  if(holds)
    return;
  std::fprintf(stderr, "it does not hold: %s\n", what);
  std::abort();
}

/// Runs a function that may refuse its input; returns whether it accepted it. Other exceptions,
/// including those of CGAL's assertions, terminate the fuzzer.
template <class Function>
bool is_accepted(const Function& function)
{
  try
  {
    function();
    return true;
  }
  catch(const std::invalid_argument&)
  {}
  catch(const std::runtime_error&)
  {}
  return false;
}

/// Each edge is traversed equally often in both directions.
inline bool is_closed(const std::vector<std::array<std::size_t, 3>>& triangles)
{
  std::vector<std::pair<std::size_t, std::size_t>> there, back;
  for(const auto& t : triangles)
    for(std::size_t k = 0; k < 3; ++k)
    {
      there.emplace_back(t[k], t[(k + 1) % 3]);
      back.emplace_back(t[(k + 1) % 3], t[k]);
    }
  std::sort(there.begin(), there.end());
  std::sort(back.begin(), back.end());
  return there == back;
}

inline void check_repaired(const Repaired_surface_3& surface, const Point_matrix& points)
{
  std::vector<bool> is_used(surface.origins.size(), false);
  for(const auto& t : surface.triangles)
    for(const std::size_t v : t)
      is_used.at(v) = true;
  require(std::find(is_used.begin(), is_used.end(), false) == is_used.end(),
          "each vertex of a repaired surface is in a face");
  require(surface.points.rows() == Eigen::Index(surface.origins.size()),
          "each vertex has an origin");
  for(std::size_t v = 0; v < surface.origins.size(); ++v)
    require(surface.origins[v] < std::size_t(points.rows())
              && surface.points.row(Eigen::Index(v))
                   == points.row(Eigen::Index(surface.origins[v])),
            "a vertex is where its origin is");
  require(is_accepted([&] {
            CGAL::Canonical_pose_3::internal::indexed_mesh(surface.points, surface.triangles);
          }),
          "a repaired surface is an oriented 2-manifold");
  auto closed = surface.triangles;
  closed.insert(closed.end(), surface.caps.begin(), surface.caps.end());
  require(is_closed(closed), "the caps close the surface");
  require(surface.component_of_triangle.size() == surface.triangles.size(),
          "each triangle has a component");
}

/// Examines and repairs a soup, and each component of the result.
inline void check_surface(const Point_matrix& points,
                          const CGAL::Canonical_pose_3::Face_list& polygons)
{
  namespace CP = CGAL::Canonical_pose_3;
  is_accepted([&] { CP::diagnose(points, polygons); });
  Repaired_surface_3 surface;
  if(!is_accepted([&] { surface = CP::repair_surface(points, polygons); }))
    return;
  check_repaired(surface, points);
  const CP::Diagnosis_3 diagnosis = CP::diagnose(surface.points, surface.triangles);
  require(diagnosis.non_manifold_edges == 0 && diagnosis.non_manifold_vertices == 0,
          "nothing is left to be repaired");
  for(std::size_t c = 0; c < surface.number_of_components; ++c)
    check_repaired(CP::component_of_surface(surface, c), points);
}

} // namespace Canonical_pose_fuzz

#endif // CGAL_CANONICAL_POSE_3_FUZZ_CHECKS_H
