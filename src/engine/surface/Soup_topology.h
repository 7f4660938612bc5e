// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_TOPOLOGY_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_TOPOLOGY_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A soup, validated and triangulated. Refers to the polygons.
class Checked_soup
{
public:
  static constexpr const char* NO_FACE = "the surface has no face";

  // Throws std::invalid_argument if a coordinate is not finite or a polygon has an invalid row.
  Checked_soup(const Point_matrix& points, const Face_list& polygons)
    : m_points(checked(points, polygons)), m_polygons(polygons),
      m_is_triangulated(polygons.are_triangles()
                        && std::none_of(polygons.begin(), polygons.end(), [](const auto& t) {
                             return names_a_vertex_twice({t[0], t[1], t[2]});
                           }))
  {
    if(!m_is_triangulated)
    {
      m_soup = internal::triangle_soup(m_points, polygons);
      m_triangles = m_soup.triangles;
    }
  }

  const Point_matrix& points() const { return m_points; } // normalized
  const Face_list& triangles() const { return m_is_triangulated ? m_polygons : m_triangles; }
  // The triangles, and the polygon to which each belongs.
  Triangle_soup triangle_soup() const
  {
    return m_is_triangulated ? internal::triangle_soup(m_points, m_polygons) : m_soup;
  }
  // Whether there is a polygon, even if it has no triangles.
  bool has_faces() const { return !m_polygons.empty(); }
  // Whether the triangles are the polygons: none was cut, and none was removed.
  bool is_triangulated() const { return m_is_triangulated; }

private:
  static Point_matrix checked(Point_matrix points, const Face_list& polygons)
  {
    check_finite(points);
    check_elements(polygons, static_cast<std::size_t>(points.rows()), "face");
    normalize(points);
    return points;
  }

  Point_matrix m_points;
  const Face_list& m_polygons;
  bool m_is_triangulated;
  Triangle_soup m_soup;  // if the polygons had to be cut
  Face_list m_triangles; // its triangles
};

// Data needed for both diagnosis and repair, for the polygons of a soup or for its triangles.
// Refers to both.
struct Soup_topology
{
  Soup_topology(const Checked_soup& the_soup, const Face_list& the_faces)
    : soup(the_soup), faces(the_faces),
      corners(static_cast<std::size_t>(soup.points().rows()), faces),
      is_duplicate(may_have_duplicates()
                     ? is_duplicate_face(static_cast<std::size_t>(soup.points().rows()), faces)
                     : std::vector<bool>(faces.size(), false)),
      places(places_of_boundary(soup.points(), corners))
  {}

  const Checked_soup& soup;
  const Face_list& faces;
  Corner_table corners;
  std::vector<bool> is_duplicate;  // of the faces
  std::vector<std::size_t> places; // see places_of_boundary()

private:
  // Triangles of three vertices each are only duplicates if two sides at an edge are opposite to the
  // same vertex.
  bool may_have_duplicates() const
  {
    bool result = &faces != &soup.triangles();
    corners.for_each_edge([&](const Corner_table::Edge& sides) {
      const auto opposite
        = [&](const std::size_t side) { return corners.target(corners.next(side)); };
      result = result || sides.size() > 2
               || (sides.size() == 2 && opposite(sides[0]) == opposite(sides[1]));
    });
    return result;
  }
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_TOPOLOGY_H
