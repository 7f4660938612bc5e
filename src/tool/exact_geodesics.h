// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_EXACT_GEODESICS_H
#define CGAL_CANONICAL_POSE_3_TOOL_EXACT_GEODESICS_H

#include "formats/Cgal_types.h"

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

using Exact_geodesics = CGAL::Canonical_pose_3::Exact_geodesics_3<Surface>;

inline CGAL::Canonical_pose_3::Landmark_fields_function exact_landmark_fields()
{
  return CGAL::Canonical_pose_3::landmark_fields_function<Exact_geodesics>();
}

// The distances of that name: heat, wavefront, exact.
inline void set_geodesics(CGAL::Canonical_pose_3::Options& options, const std::string& name)
{
  if(name == "wavefront")
    options.geodesics = CGAL::Canonical_pose_3::Options::Geodesics::WAVEFRONT;
  else if(name == "exact")
    options.landmark_fields_function = exact_landmark_fields();
}

// See CGAL::Canonical_pose_3::Distances_function.
inline Eigen::MatrixXd exact_distances(const CGAL::Canonical_pose_3::Point_matrix& points,
                                       const std::vector<std::array<std::size_t, 3>>& triangles,
                                       const std::vector<std::size_t>& sources)
{
  const Surface surface = CGAL::Canonical_pose_3::make_triangle_mesh<Surface>(points, triangles);
  std::vector<Surface::Vertex_index> vertices;
  for(const std::size_t source : sources)
    vertices.emplace_back(static_cast<Surface::size_type>(source));
  return Exact_geodesics(surface).distances(vertices);
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_EXACT_GEODESICS_H
