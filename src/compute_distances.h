// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_DISTANCES_H
#define CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_DISTANCES_H

#include "Cgal_types.h"
#include "Mesh_file.h"

#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Solver.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Thread_limit.h>
#include <CGAL/Canonical_pose_3/internal/soup/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/soup/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

using CGAL::Canonical_pose_3::Options;

// One row per vertex, one column per source.
inline Eigen::MatrixXd compute_distances(const Mesh_file& input,
                                         const std::vector<std::size_t>& source_rows,
                                         const Options& options)
{
  if(input.is_tetrahedral)
    throw std::invalid_argument("this is a tetrahedral mesh, but a surface is needed");
  for(const std::size_t source : source_rows)
    if(source >= input.points.size())
      throw std::invalid_argument("--source names vertex " + std::to_string(source)
                                  + ", but there are " + std::to_string(input.points.size()));
  const auto repaired
    = CGAL::Canonical_pose_3::repair_surface(matrix_of(points_of(input)), input.faces);
  const std::vector<std::size_t> copies = CGAL::Canonical_pose_3::internal::first_copies(repaired);
  const auto none = std::find(copies.begin(), copies.end(), repaired.origins.size());
  if(none != copies.end())
    throw std::invalid_argument("vertex " + std::to_string(none - copies.begin())
                                + " belongs to no face: there are no distances from or to it");
  const Surface surface
    = CGAL::Canonical_pose_3::internal::indexed_mesh(repaired.points, repaired.triangles);
  std::vector<Surface::Vertex_index> sources;
  for(const std::size_t source : source_rows)
    sources.emplace_back(static_cast<Surface::size_type>(copies[source]));
  const CGAL::Canonical_pose_3::internal::Thread_limit limit(options);
  const CGAL::Canonical_pose_3::internal::Solver solver(options);
  const Eigen::MatrixXd distances = [&]() -> Eigen::MatrixXd {
    if(options.geodesics == Options::Geodesics::EXACT)
      return CGAL::Canonical_pose_3::internal::with_faces_of_input(repaired.face_of_triangle, [&] {
        return CGAL::Canonical_pose_3::Exact_geodesics_3<Surface>(surface).distances(sources);
      });
    if(options.geodesics == Options::Geodesics::WAVEFRONT)
      return CGAL::Canonical_pose_3::Wavefront_geodesics_3<Surface>(surface).distances(sources);
    return CGAL::Canonical_pose_3::Heat_geodesics_3<Surface>(surface, surface.points(), {},
                                                             solver.lane_factor_maker)
      .distances(sources);
  }();
  Eigen::MatrixXd result(static_cast<Eigen::Index>(copies.size()), distances.cols());
  for(std::size_t v = 0; v < copies.size(); ++v)
    result.row(static_cast<Eigen::Index>(v)) = distances.row(static_cast<Eigen::Index>(copies[v]));
  return result;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COMPUTE_DISTANCES_H
