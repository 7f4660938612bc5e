// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_DIAGNOSIS_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_DIAGNOSIS_H

#include "Self_intersections.h"
#include "Soup_topology.h"
#include "../support/in_parallel.h"

#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The elements with a defect: their number, and the first ones.
struct Soup_finding
{
  static constexpr std::size_t MAXIMUM_NUMBER_OF_EXAMPLES = 5;

  void add(const std::initializer_list<std::size_t> example)
  {
    if(count++ < MAXIMUM_NUMBER_OF_EXAMPLES)
      examples.emplace_back(example);
  }
  std::string first(const std::size_t i = 0) const { return std::to_string(examples[0][i]); }
  std::string first_edge() const { return first() + " to vertex " + first(1); }

  std::size_t count = 0;
  std::vector<std::vector<std::size_t>> examples;
};

// The checks of diagnose(), one function each, the worst defect first.
class Soup_diagnosis
{
public:
  explicit Soup_diagnosis(const Soup_topology& topology)
    : m_topology(topology), m_points(topology.soup.points()), m_faces(topology.faces),
      m_corners(topology.corners), m_components(static_cast<std::size_t>(m_points.rows())),
      m_is_degenerate(m_faces.size(), false)
  {
    m_result.vertices = static_cast<std::size_t>(m_points.rows());
    m_result.faces = m_faces.size();
  }

  Diagnosis_3 run(const bool searches_self_intersections)
  {
    if(m_faces.empty())
      m_result.defects.push_back({"no_faces", 1, "face", {}, Checked_soup::NO_FACE});
    std::vector<Corner_table::Index> numbers_of_fans;
    in_parallel(
      [&] {
        find_degenerate_faces();
        find_duplicate_faces();
        examine_edges();
      },
      [&] { numbers_of_fans = count_fans(); });
    find_non_manifold_vertices(numbers_of_fans);
    find_components();
    if(searches_self_intersections)
      find_self_intersections();
    std::vector<Vertex_pair> duplicates;
    in_parallel(
      [&] {
        find_holes();
        find_components_inside_out();
      },
      [&] { duplicates = duplicated_points(); });
    find_duplicated_points(duplicates);
    find_polygons();
    if(!m_result.defects.empty())
      m_result.first_defect = m_result.defects.front().message;
    return m_result;
  }

private:
  using Vertex_pair = std::pair<std::size_t, std::size_t>;
  using Finding = Soup_finding;

  void add_defect(const char* kind, const char* element, const Finding& finding,
                  const std::string& message)
  {
    m_result.defects.push_back({kind, finding.count, element, finding.examples, message});
  }

  auto point(const std::size_t v) const { return m_points.row(static_cast<Eigen::Index>(v)); }

  bool has_no_area(const std::size_t f) const
  {
    const Face_list::Face face = m_faces[f];
    if(face.size() == 3)
    {
      const Index_triangle t = {face[0], face[1], face[2]};
      return names_a_vertex_twice(t) || is_degenerate(m_points, t);
    }
    std::vector<std::size_t> p(face.begin(), face.end());
    std::sort(p.begin(), p.end());
    if(p.size() < 3 || std::adjacent_find(p.begin(), p.end()) != p.end())
      return true;
    std::size_t i = 1; // the first corner at another position than corner 0
    while(i + 2 < p.size() && point(p[i]) == point(p[0]))
      ++i;
    return std::all_of(p.begin() + static_cast<std::ptrdiff_t>(i) + 1, p.end(),
                       [&](const std::size_t v) {
                         return is_degenerate(m_points, {p[0], p[i], v});
                       });
  }

  void find_degenerate_faces()
  {
    for_each_block(m_faces.size(),
                   [&](std::size_t, const std::size_t begin, const std::size_t end) {
                     for(std::size_t f = begin; f < end; ++f)
                       m_is_degenerate[f] = has_no_area(f);
                   });
    Finding found;
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      if(m_is_degenerate[f])
        found.add({f});
    m_result.degenerate_faces = found.count;
    if(found.count > 0)
      add_defect("degenerate_faces", "face", found, "face " + found.first() + " is degenerate");
  }

  void find_duplicate_faces()
  {
    Finding found;
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      if(m_topology.is_duplicate[f])
        found.add({f});
    m_result.duplicate_faces = found.count;
    if(found.count > 0)
      add_defect("duplicate_faces", "face", found,
                 "face " + found.first() + " has the vertices of another one");
  }

  void examine_edges()
  {
    Finding complex, inconsistent;
    std::size_t sides_of_first_complex = 0;
    m_corners.for_each_edge([&](const Corner_table::Edge& sides) {
      const auto [v, w] = m_corners.ends(sides[0]);
      m_components.unite(v, w);
      if(sides.size() == 1)
        m_boundary_edges.push_back({v, w});
      else if(sides.size() > 2)
      {
        if(complex.count == 0)
          sides_of_first_complex = sides.size();
        complex.add({v, w});
      }
      else if(m_corners.vertex(sides[0]) == m_corners.vertex(sides[1]))
        inconsistent.add({v, w});
      else
        return;
      m_open_faces.push_back(m_corners.face(sides[0]));
    });
    m_result.boundary_edges = m_boundary_edges.size();
    m_result.inconsistently_oriented_edges = inconsistent.count;
    m_result.non_manifold_edges = complex.count + inconsistent.count;
    if(complex.count > 0)
      add_defect("non_manifold_edges", "edge", complex,
                 "the edge from vertex " + complex.first_edge() + " belongs to "
                   + std::to_string(sides_of_first_complex) + " faces");
    if(inconsistent.count > 0)
      add_defect("inconsistent_orientation", "edge", inconsistent,
                 "the edge from vertex " + inconsistent.first_edge()
                   + " separates two faces of opposite orientation");
  }

  // The number of fans at each vertex. Two corners of a vertex belong to the same fan if their faces
  // share an edge.
  std::vector<Corner_table::Index> count_fans() const
  {
    Disjoint_sets fans(m_corners.number_of_corners());
    m_corners.for_each_edge([&](const Corner_table::Edge& sides) {
      const auto [v, w] = m_corners.ends(sides[0]);
      for(std::size_t i = 1; i < sides.size(); ++i)
        for(const std::size_t end : {v, w})
          fans.unite(m_corners.corner_of_end(sides[i - 1], end),
                     m_corners.corner_of_end(sides[i], end));
    });
    std::vector<Corner_table::Index> result(m_result.vertices, 0);
    for(std::size_t c = 0; c < m_corners.number_of_corners(); ++c)
      if(fans.representative(c) == c)
        ++result[m_corners.vertex(c)];
    return result;
  }

  void find_non_manifold_vertices(const std::vector<Corner_table::Index>& number_of_fans)
  {
    Finding found;
    for(std::size_t v = 0; v < m_result.vertices; ++v)
      if(number_of_fans[v] == 0)
        m_isolated.add({v});
      else if(number_of_fans[v] > 1)
        found.add({v});
    m_result.isolated_vertices = m_isolated.count;
    m_result.non_manifold_vertices = found.count;
    if(found.count > 0)
      add_defect("non_manifold_vertices", "vertex", found,
                 "vertex " + found.first()
                   + " is not manifold: " + std::to_string(number_of_fans[found.examples[0][0]])
                   + " fans of faces meet there");
  }

  void find_components()
  {
    const auto vertex = [&](const std::size_t f) -> std::size_t {
      return m_faces[f].empty() ? Disjoint_sets::NONE : m_faces[f][0];
    };
    m_labels = label_components(m_components, m_faces.size(), vertex);
    Finding found;
    for(const std::size_t f : m_labels.first_items)
      found.add({f});
    m_result.components = found.count;
    if(found.count > 1)
      add_defect("components", "face", found,
                 "the surface has " + std::to_string(found.count) + " connected components");
    if(m_isolated.count > 0)
      add_defect("isolated_vertices", "vertex", m_isolated,
                 "vertex " + m_isolated.first() + " belongs to no face");
  }

  // Faces that were separated, as in an STL file, are neighbors here.
  void find_self_intersections()
  {
    m_result.has_searched_self_intersections = true;
    if(m_faces.empty())
      return;
    Triangle_soup soup = m_topology.soup.triangle_soup();
    for(Index_triangle& t : soup.triangles)
      for(std::size_t& v : t)
        v = m_topology.places[v];
    soup.keep_if([&](const std::size_t t) {
      const std::size_t f = soup.face_of_triangle[t];
      return !m_is_degenerate[f] && !m_topology.is_duplicate[f]
             && (m_faces[f].size() == 3 || !is_degenerate(m_points, soup.triangles[t]));
    });
    const auto pairs
      = Self_intersections(m_points, soup).run(Diagnosis_3::MAXIMUM_NUMBER_OF_SELF_INTERSECTIONS);
    if(!pairs)
      return;
    m_result.self_intersections = pairs->size();
    Finding found;
    for(const auto& pair : *pairs)
      found.add({pair.first, pair.second});
    if(found.count > 0)
      add_defect("self_intersections", "faces", found,
                 "the surface intersects itself: " + std::to_string(found.count)
                   + (found.count == 1 ? " pair of faces, " : " pairs of faces, among them ")
                   + found.first() + " and " + found.first(1));
  }

  void find_holes()
  {
    Disjoint_sets loops(m_result.vertices);
    for(const auto& edge : m_boundary_edges)
      loops.unite(edge[0], edge[1]);
    const auto vertex = [&](const std::size_t e) { return m_boundary_edges[e][0]; };
    Finding found;
    for(const std::size_t e : label_components(loops, m_boundary_edges.size(), vertex).first_items)
      found.add({m_boundary_edges[e][0], m_boundary_edges[e][1]});
    m_result.holes = found.count;
    if(found.count > 0)
      add_defect("holes", "edge", found,
                 "the surface is not closed: " + std::to_string(m_result.boundary_edges)
                   + " boundary edges, the first from vertex " + found.first_edge());
  }

  void find_components_inside_out()
  {
    const std::vector<std::size_t>& first = m_labels.first_items;
    std::vector<bool> is_open(first.size(), false);
    for(const std::size_t f : m_open_faces)
      is_open[m_labels.of_items[f]] = true;
    std::vector<double> volume(first.size(), 0), size(first.size(), 0);
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      const Face_list::Face p = m_faces[f];
      if(p.empty())
        continue;
      const std::size_t component = m_labels.of_items[f];
      const Eigen::RowVector3d o = point(m_faces[first[component]][0]);
      for(std::size_t i = 1; i + 1 < p.size(); ++i)
      {
        const Eigen::RowVector3d normal
          = (point(p[i]) - point(p[0])).cross(point(p[i + 1]) - point(p[0]));
        volume[component] += (point(p[0]) - o).dot(normal);
        size[component] += normal.norm();
      }
    }
    std::vector<std::pair<std::size_t, std::size_t>> inside_out; // by their representatives
    for(std::size_t c = 0; c < first.size(); ++c)
      if(!is_open[c] && volume[c] < -1e-10 * std::pow(size[c], 1.5))
        inside_out.emplace_back(m_components.representative(m_faces[first[c]][0]), first[c]);
    std::sort(inside_out.begin(), inside_out.end());
    Finding found;
    for(const auto& component : inside_out)
      found.add({component.second});
    m_result.inside_out_components = found.count;
    if(found.count > 0)
      add_defect("inside_out", "face", found,
                 "the component of face " + found.first() + " is inside out");
  }

  // Each vertex at the position of an earlier one, and that vertex.
  std::vector<Vertex_pair> duplicated_points() const
  {
    std::vector<std::pair<std::array<double, 3>, std::size_t>> sorted;
    sorted.reserve(m_result.vertices);
    for(std::size_t v = 0; v < m_result.vertices; ++v)
      sorted.push_back({{point(v)[0], point(v)[1], point(v)[2]}, v});
    sort_in_parallel(sorted);
    std::vector<Vertex_pair> result;
    for(std::size_t i = 1; i < sorted.size(); ++i)
      if(sorted[i].first == sorted[i - 1].first)
        result.emplace_back(sorted[i].second, sorted[i - 1].second);
    std::sort(result.begin(), result.end());
    return result;
  }

  void find_duplicated_points(const std::vector<Vertex_pair>& duplicates)
  {
    Finding found;
    for(const auto& d : duplicates)
      found.add({d.second, d.first});
    m_result.duplicated_points = found.count;
    if(found.count > 0)
      add_defect("duplicated_points", "vertices", found,
                 "vertices " + found.first() + " and " + found.first(1) + " are at the same place");
  }

  void find_polygons()
  {
    Finding found;
    for(std::size_t f = 0; f < m_faces.size(); ++f)
      if(m_faces[f].size() > 3)
        found.add({f});
    m_result.polygons = found.count;
    if(found.count > 0)
      add_defect("polygons", "face", found, "face " + found.first() + " is not a triangle");
  }

  const Soup_topology& m_topology;
  const Point_matrix& m_points; // normalized
  const Face_list& m_faces;
  const Corner_table& m_corners;
  Disjoint_sets m_components; // of vertices
  Component_labels m_labels;  // of faces
  std::vector<char> m_is_degenerate; // not of bool: written in parallel
  std::vector<std::array<std::size_t, 2>> m_boundary_edges;
  std::vector<std::size_t> m_open_faces; // at edges without two consistently oriented faces
  Finding m_isolated;
  Diagnosis_3 m_result;
};

inline Diagnosis_3 diagnosis_of(const Soup_topology& topology,
                                const bool searches_self_intersections)
{
  return Soup_diagnosis(topology).run(searches_self_intersections);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_SOUP_DIAGNOSIS_H
