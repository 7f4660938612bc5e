// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_DIAGNOSE_H
#define CGAL_CANONICAL_POSE_3_DIAGNOSE_H

#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/internal/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <Eigen/Geometry>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

class Soup_diagnosis
{
public:
  Soup_diagnosis(const Point_matrix& points, const std::vector<Index_triangle>& triangles)
    : m_points(points), m_triangles(triangles)
  {}

  Diagnosis_3 run()
  {
    m_result.vertices = static_cast<std::size_t>(m_points.rows());
    m_result.faces = m_triangles.size();
    check_indices();
    if(m_triangles.empty())
      add_defect("the surface has no face");
    find_degenerate_faces();
    find_non_manifold_edges();
    find_non_manifold_vertices();
    find_components();
    find_self_intersections();
    if(m_result.boundary_edges > 0)
      add_defect("the surface is not closed: " + std::to_string(m_result.boundary_edges)
                 + " boundary edges, the first from vertex " + m_first_boundary_edge);
    return m_result;
  }

private:
  void add_defect(const std::string& message)
  {
    if(m_result.first_defect.empty())
      m_result.first_defect = message;
  }

  void check_indices() const
  {
    check_finite(m_points);
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      for(const std::size_t v : m_triangles[f])
        if(v >= m_result.vertices)
          throw std::invalid_argument("face " + std::to_string(f) + " names vertex "
                                      + std::to_string(v) + ", but there are "
                                      + std::to_string(m_result.vertices));
  }

  void find_degenerate_faces()
  {
    typedef Indexed_mesh_kernel::Point_3 Point;
    const auto point
      = [&](const std::size_t v) { return Point(m_points(v, 0), m_points(v, 1), m_points(v, 2)); };
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
    {
      const Index_triangle& t = m_triangles[f];
      if(!CGAL::collinear(point(t[0]), point(t[1]), point(t[2])))
        continue;
      if(m_result.degenerate_faces++ == 0)
        add_defect("face " + std::to_string(f) + " is degenerate");
    }
  }

  void find_non_manifold_edges()
  {
    // smaller vertex, larger vertex, whether the face runs from the larger to the smaller
    typedef std::tuple<std::size_t, std::size_t, bool> Side;
    std::vector<Side> sides;
    sides.reserve(3 * m_triangles.size());
    for(const Index_triangle& t : m_triangles)
      for(int k = 0; k < 3; ++k)
        if(t[k] != t[(k + 1) % 3])
          sides.emplace_back((std::min)(t[k], t[(k + 1) % 3]), (std::max)(t[k], t[(k + 1) % 3]),
                             t[k] > t[(k + 1) % 3]);
    std::sort(sides.begin(), sides.end());
    for(std::size_t i = 0; i < sides.size();)
    {
      std::size_t j = i + 1;
      while(j < sides.size() && std::get<0>(sides[j]) == std::get<0>(sides[i])
            && std::get<1>(sides[j]) == std::get<1>(sides[i]))
        ++j;
      const std::string name = std::to_string(std::get<0>(sides[i])) + " to vertex "
                               + std::to_string(std::get<1>(sides[i]));
      if(j - i == 1 && m_result.boundary_edges++ == 0)
        m_first_boundary_edge = name;
      if((j - i > 2 || (j - i == 2 && sides[i] == sides[i + 1]))
         && m_result.non_manifold_edges++ == 0)
        add_defect("the edge from vertex " + name
                   + (j - i > 2 ? " belongs to " + std::to_string(j - i) + " faces"
                                : std::string(" separates two faces of opposite orientation")));
      i = j;
    }
  }

  // Corners around a vertex are united across edges; a vertex with more than one class is pinched.
  void find_non_manifold_vertices()
  {
    typedef std::tuple<std::size_t, std::size_t, std::size_t> Spoke; // vertex, other end, corner
    std::vector<Spoke> spokes;
    for(std::size_t f = 0; f < m_triangles.size(); ++f)
      for(std::size_t k = 0; k < 3; ++k)
        for(std::size_t other = 1; other < 3; ++other)
          spokes.emplace_back(m_triangles[f][k], m_triangles[f][(k + other) % 3], 3 * f + k);
    std::sort(spokes.begin(), spokes.end());
    Disjoint_sets corners(3 * m_triangles.size());
    for(std::size_t i = 1; i < spokes.size(); ++i)
      if(std::get<0>(spokes[i]) == std::get<0>(spokes[i - 1])
         && std::get<1>(spokes[i]) == std::get<1>(spokes[i - 1]))
        corners.unite(std::get<2>(spokes[i]), std::get<2>(spokes[i - 1]));
    std::vector<std::pair<std::size_t, std::size_t>> fans;
    for(std::size_t c = 0; c < 3 * m_triangles.size(); ++c)
      if(corners.is_representative(c))
        fans.emplace_back(m_triangles[c / 3][c % 3], c);
    std::sort(fans.begin(), fans.end());
    for(std::size_t i = 0; i < fans.size();)
    {
      std::size_t j = i + 1;
      while(j < fans.size() && fans[j].first == fans[i].first)
        ++j;
      if(j - i > 1 && m_result.non_manifold_vertices++ == 0)
        add_defect("vertex " + std::to_string(fans[i].first)
                   + " is not manifold: " + std::to_string(j - i) + " fans of faces meet there");
      i = j;
    }
  }

  void find_components()
  {
    Disjoint_sets sets(m_result.vertices);
    std::vector<bool> used(m_result.vertices, false);
    for(const Index_triangle& t : m_triangles)
      for(const std::size_t v : t)
      {
        used[v] = true;
        sets.unite(t[0], v);
      }
    std::size_t first_isolated = m_result.vertices;
    for(std::size_t v = m_result.vertices; v-- > 0;)
      if(!used[v])
      {
        ++m_result.isolated_vertices;
        first_isolated = v;
      }
      else if(sets.is_representative(v))
        ++m_result.components;
    if(m_result.components > 1)
      add_defect("the surface has " + std::to_string(m_result.components)
                 + " connected components");
    if(m_result.isolated_vertices > 0)
      add_defect("vertex " + std::to_string(first_isolated) + " belongs to no face");
  }

  void find_self_intersections()
  {
    if(m_result.degenerate_faces > 0 || m_result.non_manifold_edges > 0
       || m_result.non_manifold_vertices > 0 || m_triangles.empty())
      return;
    const Indexed_mesh mesh = indexed_mesh(m_points, m_triangles);
    std::vector<std::pair<Indexed_mesh::Face_index, Indexed_mesh::Face_index>> pairs;
    Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
    m_result.self_intersections = pairs.size();
    if(pairs.empty())
      return;
    for(auto& pair : pairs)
      if(pair.second < pair.first)
        std::swap(pair.first, pair.second);
    const auto first = *std::min_element(pairs.begin(), pairs.end());
    add_defect("the surface intersects itself: " + std::to_string(pairs.size())
               + " pairs of faces, among them " + std::to_string(std::size_t(first.first)) + " and "
               + std::to_string(std::size_t(first.second)));
  }

  struct Disjoint_sets
  {
    explicit Disjoint_sets(const std::size_t n)
      : rank(n, 0), parent(n), sets(rank.data(), parent.data())
    {
      std::iota(parent.begin(), parent.end(), std::size_t(0));
    }
    void unite(const std::size_t a, const std::size_t b) { sets.union_set(a, b); }
    bool is_representative(const std::size_t a) { return sets.find_set(a) == a; }

    std::vector<std::size_t> rank, parent;
    boost::disjoint_sets<std::size_t*, std::size_t*> sets;
  };

  const Point_matrix& m_points;
  const std::vector<Index_triangle>& m_triangles;
  Diagnosis_3 m_result;
  std::string m_first_boundary_edge;
};

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief examines a triangle soup.

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.

\throws std::invalid_argument if a coordinate is not finite or a triangle names a row that does not
       exist.

<em>Complexity:</em> \f$ O(n \log n) \f$, plus the search for intersections.
*/
inline Diagnosis_3 diagnose(const Point_matrix& points,
                            const std::vector<std::array<std::size_t, 3>>& triangles)
{
  return internal::Soup_diagnosis(points, triangles).run();
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief examines a triangle mesh.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam VertexPointMap a model of `ReadablePropertyMap` with vertex descriptors as keys and points
       of a kernel as values

\throws std::invalid_argument if a face is not a triangle or a coordinate is not finite; the message
       names the element.
*/
template <typename TriangleMesh, typename VertexPointMap>
Diagnosis_3 diagnose(const TriangleMesh& tmesh, VertexPointMap vertex_point_map)
{
  return diagnose(point_matrix(tmesh, vertex_point_map), internal::index_triangles(tmesh));
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_DIAGNOSE_H
