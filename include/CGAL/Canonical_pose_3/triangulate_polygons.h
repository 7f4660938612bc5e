// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TRIANGULATE_POLYGONS_H
#define CGAL_CANONICAL_POSE_3_TRIANGULATE_POLYGONS_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/surface/Loop_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds triangles, and the polygon to which each belongs.

\sa `triangulate_polygons()`
*/
struct Triangulated_polygons
{
  /// triples of vertices of the polygons, with the orientation of their polygon.
  std::vector<std::array<std::size_t, 3>> triangles;
  /// index of the polygon of each triangle, in ascending order.
  std::vector<std::size_t> polygon_of_triangle;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief divides polygons into triangles with the same vertices: those of minimal area if there are at
most 64 corners. Nothing is repaired; triangles are returned as they are.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.

\throws std::invalid_argument if a coordinate is not finite, or a polygon has an invalid row; the
       message states the vertex, or the polygon.

\sa `repair_surface()`
*/
inline Triangulated_polygons triangulate_polygons(const Point_matrix& points,
                                                  const Face_list& polygons)
{
  internal::check_finite(points);
  internal::check_elements(polygons, static_cast<std::size_t>(points.rows()), "face");
  Triangulated_polygons result;
  result.triangles.reserve(polygons.size());
  Point_matrix scaled; // so that areas do not overflow
  for(std::size_t p = 0; p < polygons.size(); ++p)
  {
    const Face_list::Face corners = polygons[p];
    if(corners.size() == 3)
      result.triangles.push_back({corners[0], corners[1], corners[2]});
    else
    {
      if(scaled.rows() == 0 && points.rows() > 0)
      {
        const double unit = points.cwiseAbs().maxCoeff();
        scaled = unit > 0 ? Point_matrix(points / unit) : points;
      }
      internal::Loop_triangulation(scaled, {corners.begin(), corners.end()}).run(result.triangles);
    }
    result.polygon_of_triangle.resize(result.triangles.size(), p);
  }
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TRIANGULATE_POLYGONS_H
