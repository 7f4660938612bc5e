// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_TOPOLOGY_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_TOPOLOGY_H

#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A soup, validated and triangulated.
class Checked_soup
{
public:
  static constexpr const char* NO_FACE = "the surface has no face";

  // Throws std::invalid_argument if a coordinate is not finite or a polygon has an invalid row.
  template <class Polygons>
  Checked_soup(const Point_matrix& points, const Polygons& polygons)
    : m_points(checked(points, polygons)), m_triangles(triangle_soup(m_points, polygons)),
      m_has_faces(!polygons.empty()),
      m_is_triangulated(m_triangles.triangles.size() == polygons.size()
                        && std::all_of(polygons.begin(), polygons.end(),
                                       [](const auto& p) { return p.size() == 3; }))
  {}

  const Point_matrix& points() const { return m_points; } // normalized
  const Triangle_soup& triangles() const { return m_triangles; }
  // Whether there is a polygon, even if it has no triangles.
  bool has_faces() const { return m_has_faces; }
  // Whether the triangles are the polygons: none was cut, and none was removed.
  bool is_triangulated() const { return m_is_triangulated; }

private:
  template <class Polygons>
  static Point_matrix checked(Point_matrix points, const Polygons& polygons)
  {
    check_finite(points);
    check_elements(polygons, static_cast<std::size_t>(points.rows()), "face");
    normalize(points);
    return points;
  }

  Point_matrix m_points;
  Triangle_soup m_triangles;
  bool m_has_faces, m_is_triangulated;
};

// Data needed for both diagnosis and repair, for the polygons of a soup or for its triangles.
// Refers to both.
template <class Faces>
struct Soup_topology
{
  Soup_topology(const Checked_soup& the_soup, const Faces& the_faces)
    : soup(the_soup), faces(the_faces),
      corners(static_cast<std::size_t>(soup.points().rows()), faces),
      is_duplicate(is_duplicate_face(static_cast<std::size_t>(soup.points().rows()), faces)),
      places(places_of_boundary(soup.points(), corners))
  {}

  const Checked_soup& soup;
  const Faces& faces;
  Corner_table corners;
  std::vector<bool> is_duplicate;  // of the faces
  std::vector<std::size_t> places; // see places_of_boundary()
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_TOPOLOGY_H
