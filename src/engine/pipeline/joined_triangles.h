// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_JOINED_TRIANGLES_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_JOINED_TRIANGLES_H

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The triangles of several components, with one matrix of points.
struct Joined_triangles
{
  Point_matrix points;
  std::vector<Index_triangle> triangles, caps;
  std::vector<std::size_t> component_of_triangle;
};

// `indices`: of the components.
inline Joined_triangles joined_triangles(const std::vector<Surface_component_3>& components,
                                         const std::vector<std::size_t>& indices)
{
  Joined_triangles result;
  Eigen::Index n = 0;
  for(const std::size_t c : indices)
    n += components[c].points.rows();
  result.points.resize(n, 3);
  n = 0;
  const auto append
    = [&](const std::vector<Index_triangle>& from, std::vector<Index_triangle>& to) {
        const auto first = static_cast<std::size_t>(n);
        for(const Index_triangle& t : from)
          to.push_back({t[0] + first, t[1] + first, t[2] + first});
      };
  for(const std::size_t c : indices)
  {
    append(components[c].triangles, result.triangles);
    append(components[c].caps, result.caps);
    result.component_of_triangle.resize(result.triangles.size(), c);
    result.points.middleRows(n, components[c].points.rows()) = components[c].points;
    n += components[c].points.rows();
  }
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_JOINED_TRIANGLES_H
