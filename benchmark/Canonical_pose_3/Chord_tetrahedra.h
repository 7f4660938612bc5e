// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_CHORD_TETRAHEDRA_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_CHORD_TETRAHEDRA_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/internal/lattice/surface_chords.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

/// Returns a body that requires no mesher: one tetrahedron per face, from the face to a vertex of
/// the face where the ray from its centroid against its normal leaves the shape. The tetrahedra
/// overlap; a face without such a vertex has none. Any oriented surface can be used.
///
/// `caps`: triangles that close the holes; `distances`: those to the landmarks; `unit`: the largest
/// of them. Rays do not stop at other limbs that they cross.
inline CGAL::Canonical_pose_3::Conforming_body_3
chord_tetrahedra(const CGAL::Canonical_pose_3::Point_matrix& points,
                 const std::vector<std::array<std::size_t, 3>>& triangles,
                 const std::vector<std::array<std::size_t, 3>>& caps,
                 const Eigen::MatrixXd& distances, const double unit)
{
  namespace Internal = CGAL::Canonical_pose_3::internal;
  const Internal::Row_points unit_points = points / unit;
  std::vector<Internal::Surface_sample> centroids;
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for(const std::size_t v : triangles[f])
      sum += unit_points.row(static_cast<Eigen::Index>(v));
    centroids.push_back({f, sum / 3});
  }
  std::vector<std::array<int, 4>> cells;
  const Internal::Geodesic_bounds bounds(distances, unit);
  const Internal::Chord_finder find_chords(unit_points, triangles, caps, bounds);
  for(const Internal::Chord& chord : find_chords(centroids))
  {
    if(!chord.exit_vertex)
      continue;
    const auto& t = triangles[chord.face];
    const std::array<std::size_t, 4> corners = {t[0], t[1], t[2], *chord.exit_vertex};
    Eigen::Matrix3d edges;
    for(int k = 0; k < 3; ++k)
      edges.row(k) = unit_points.row(static_cast<Eigen::Index>(corners[k + 1]))
                     - unit_points.row(static_cast<Eigen::Index>(corners[0]));
    if(std::abs(edges.determinant()) > 1e-15)
      cells.push_back({static_cast<int>(corners[0]), static_cast<int>(corners[1]),
                       static_cast<int>(corners[2]), static_cast<int>(corners[3])});
  }
  return CGAL::Canonical_pose_3::Conforming_body_3(points, std::move(cells),
                                                   static_cast<std::size_t>(points.rows()));
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_CHORD_TETRAHEDRA_H
