// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SELF_INTERSECTIONS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SELF_INTERSECTIONS_H

#include <CGAL/Canonical_pose_3/internal/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Searches triangles, manifold or not, for pairs that intersect elsewhere than in the vertices that
// they share. Polygon_mesh_processing::self_intersections() does the same for a mesh.
class Self_intersections
{
public:
  typedef std::pair<std::size_t, std::size_t> Face_pair;

  // Degenerate triangles must have been left out.
  Self_intersections(const Point_matrix& points, const Triangle_soup& soup) : m_soup(soup)
  {
    m_triangles.reserve(soup.triangles.size());
    for(const Index_triangle& t : soup.triangles)
      m_triangles.emplace_back(point(points, t[0]), point(points, t[1]), point(points, t[2]));
  }

  // Returns pairs of faces, the smaller one first, sorted; not more than `maximum`. Returns nothing
  // where so many bounding boxes overlap that it gives up before it has found a pair.
  std::optional<std::vector<Face_pair>> run(const std::size_t maximum)
  {
    std::vector<Box> boxes;
    boxes.reserve(m_triangles.size());
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      boxes.emplace_back(m_triangles[t].bbox(), t);
    std::vector<const Box*> pointers; // the address of a box is its name: boxes must not move
    for(const Box& box : boxes)
      pointers.push_back(&box);
    const std::size_t maximum_of_overlaps = 10000000 + 200 * m_triangles.size();
    std::size_t overlaps = 0;
    std::vector<Face_pair> pairs;
    bool has_given_up = false;
    try
    {
      box_self_intersection_d(pointers.begin(), pointers.end(), [&](const Box* a, const Box* b) {
        const std::size_t f = m_soup.face_of_triangle[a->info()],
                          g = m_soup.face_of_triangle[b->info()];
        if(f != g && do_intersect(a->info(), b->info()))
          pairs.push_back(std::minmax({f, g}));
        if(pairs.size() == maximum || ++overlaps == maximum_of_overlaps)
          throw Enough();
      });
    }
    catch(const Enough&)
    {
      has_given_up = pairs.empty();
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return has_given_up ? std::nullopt : std::make_optional(std::move(pairs));
  }

private:
  typedef Indexed_mesh_kernel Kernel;
  typedef Box_intersection_d::Box_with_info_d<double, 3, std::size_t,
                                              Box_intersection_d::ID_FROM_BOX_ADDRESS>
    Box;
  struct Enough
  {};

  static Kernel::Point_3 point(const Point_matrix& points, const std::size_t v)
  {
    const auto p = points.row(static_cast<Eigen::Index>(v));
    return Kernel::Point_3(p[0], p[1], p[2]);
  }

  bool do_intersect(const std::size_t s, const std::size_t t) const
  {
    const Kernel::Triangle_3 &a = m_triangles[s], &b = m_triangles[t];
    std::array<int, 3> i = {0, 1, 2}, j = {0, 1, 2}; // corners, those that are shared first
    const int shared = put_shared_corners_first(m_soup.triangles[s], m_soup.triangles[t], i, j);
    switch(shared)
    {
    case 0:
      return CGAL::do_intersect(a, b);
    case 1:
      return CGAL::do_intersect(a, Kernel::Segment_3(b[j[1]], b[j[2]]))
             || CGAL::do_intersect(b, Kernel::Segment_3(a[i[1]], a[i[2]]));
    case 2: // folded onto each other
      return CGAL::coplanar(a[i[0]], a[i[1]], a[i[2]], b[j[2]])
             && CGAL::coplanar_orientation(a[i[0]], a[i[1]], a[i[2]], b[j[2]]) == CGAL::POSITIVE;
    default:
      return false;
    }
  }

  static int put_shared_corners_first(const Index_triangle& s, const Index_triangle& t,
                                      std::array<int, 3>& i, std::array<int, 3>& j)
  {
    int shared = 0;
    for(int k = 0; k < 3; ++k)
      for(int l = shared; l < 3; ++l)
        if(s[i[k]] == t[j[l]])
        {
          std::swap(i[shared], i[k]);
          std::swap(j[shared], j[l]);
          ++shared;
          break;
        }
    return shared;
  }

  const Triangle_soup& m_soup;
  std::vector<Kernel::Triangle_3> m_triangles;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SELF_INTERSECTIONS_H
