// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_MATCH_MATCHABLE_DATA_H
#define CANONICAL_POSE_3_ENGINE_MATCH_MATCHABLE_DATA_H

#include "Deformable_pose.h"
#include "../support/Point_search.h"
#include "../support/in_parallel.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

using Function_matrix
  = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>; // a column each

// What matching needs of a surface. Rows are those of the repaired surface, of which components far from the largest one have
// been left out, or of its coarse copy.
struct Matchable_data
{
  // `repaired`: from these polygons.
  Matchable_data(const Repaired_surface_3& repaired, const Face_list& polygons,
                 const Point_matrix& pose);

  std::size_t number_of_vertices; // of the input
  Repaired_surface_3 surface;
  std::vector<std::array<std::size_t, 3>>
    corners; // of the input: those of the face of each triangle
  Coarse_surface_3 coarse;
  // Components that are not small are compared; the other ones and isolated vertices may be anywhere.
  std::vector<bool> is_counted;     // of the rows
  std::vector<std::size_t> counted; // of the coarse vertices
  // In the frame of the principal axes of the pose; the mean square of the distances from the origin is 1. Only what is
  // counted has weight.
  Point_matrix pose_of_vertices, pose, coarse_pose;
  Point_matrix normals;                         // of the pose
  Eigen::Vector3d lengths_of_axes;              // the roots of the variances
  Function_matrix functions;                    // of the coarse surface; the first one is constant
  Function_matrix reliefs;                      // of the coarse surface, see reliefs_of()
  double root_of_area;                          // of the surface
  double compared_share;                        // of the area of the repaired surface
  std::optional<Point_search> search;           // of what is counted of the coarse pose
  std::vector<std::vector<std::size_t>> nearby; // for each coarse vertex, the nearest ones of these

  // Of what is counted, at even steps: at least `number`, or all if there are fewer.
  std::vector<std::size_t> samples(std::size_t number) const;

  // Of the coarse pose; made by the first match that needs it.
  const Deformable_body& deformable_body() const
  {
    isolated([&] {
      std::call_once(m_body_flag, [&] {
        m_body = std::make_unique<const Deformable_body>(coarse_pose, coarse.surface.triangles);
      });
    });
    return *m_body;
  }

private:
  mutable std::once_flag m_body_flag;
  mutable std::unique_ptr<const Deformable_body> m_body;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_MATCH_MATCHABLE_DATA_H
