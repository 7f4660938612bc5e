// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_TRIANGLE_GRAPH_H
#define CGAL_CANONICAL_POSE_3_TEST_TRIANGLE_GRAPH_H

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include "shapes.h"

#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace archetype {

/// How vertices can be numbered: by `std::hash`, as required by the concepts, or by a dynamic
/// property.
enum class Numbering { HASH, DYNAMIC_PROPERTY };

template <Numbering numbering, int kind>
struct Descriptor
{
  std::size_t index = std::size_t(-1);
  bool operator==(const Descriptor& other) const { return index == other.index; }
  bool operator!=(const Descriptor& other) const { return index != other.index; }
};

/// A model of FaceListGraph with only the features that the package requires: halfedges 3f, 3f +
/// 1, and 3f + 2 are those of face f, halfedges of the border follow, and vertices have points.
template <Numbering numbering>
struct Triangle_graph
{
  using Vertex = Descriptor<numbering, 0>;
  using Halfedge = Descriptor<numbering, 1>;
  using Face = Descriptor<numbering, 2>;
  using Point = CGAL::Simple_cartesian<double>::Point_3;

  /// Reads and writes a value per vertex.
  template <class Value>
  struct Vertex_map
  {
    using key_type = Vertex;
    using value_type = Value;
    using reference = const Value&;
    using category = boost::read_write_property_map_tag;
    friend const Value& get(const Vertex_map& map, Vertex v) { return (*map.values)[v.index]; }
    friend void put(const Vertex_map& map, Vertex v, const Value& value)
    {
      (*map.values)[v.index] = value;
    }
    std::shared_ptr<std::vector<Value>> values;
  };

  explicit Triangle_graph(const Canonical_pose_test::Triangle_soup& soup)
    : triangles(soup.triangles), points{std::make_shared<std::vector<Point>>()}
  {
    for(const auto& p : soup.points)
      points.values->emplace_back(p[0], p[1], p[2]);
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> sides;
    for(std::size_t h = 0; h < 3 * triangles.size(); ++h)
      sides[{source_index(h), target_index(h)}] = h;
    for(std::size_t h = 0; h < 3 * triangles.size(); ++h)
    {
      const auto found = sides.find({target_index(h), source_index(h)});
      opposites.push_back(found != sides.end() ? found->second : 3 * triangles.size() + h);
    }
  }

  std::size_t target_index(std::size_t h) const { return triangles[h / 3][h % 3]; }
  std::size_t source_index(std::size_t h) const { return triangles[h / 3][(h + 2) % 3]; }

  friend std::vector<Vertex> vertices(const Triangle_graph& g)
  {
    std::vector<Vertex> result;
    while(result.size() < g.points.values->size())
      result.push_back({result.size()});
    return result;
  }
  friend std::vector<Face> faces(const Triangle_graph& g)
  {
    std::vector<Face> result;
    while(result.size() < g.triangles.size())
      result.push_back({result.size()});
    return result;
  }
  friend Halfedge halfedge(Face f, const Triangle_graph&) { return {3 * f.index}; }
  friend Halfedge next(Halfedge h, const Triangle_graph&)
  {
    return {h.index % 3 == 2 ? h.index - 2 : h.index + 1};
  }
  friend Halfedge prev(Halfedge h, const Triangle_graph&)
  {
    return {h.index % 3 == 0 ? h.index + 2 : h.index - 1};
  }
  friend Halfedge opposite(Halfedge h, const Triangle_graph& g) { return {g.opposites[h.index]}; }
  friend Vertex target(Halfedge h, const Triangle_graph& g) { return {g.target_index(h.index)}; }
  friend Vertex source(Halfedge h, const Triangle_graph& g) { return {g.source_index(h.index)}; }
  friend Vertex_map<Point> get(CGAL::vertex_point_t, const Triangle_graph& g) { return g.points; }

  Canonical_pose_test::Triangles triangles;
  Vertex_map<Point> points;
  std::vector<std::size_t> opposites; // of the halfedges of the faces
};

using Hashed_graph = Triangle_graph<Numbering::HASH>;
using Graph_with_properties = Triangle_graph<Numbering::DYNAMIC_PROPERTY>;

template <class Value>
Graph_with_properties::Vertex_map<Value> get(CGAL::dynamic_vertex_property_t<Value>,
                                             const Graph_with_properties& g)
{
  return {std::make_shared<std::vector<Value>>(g.points.values->size())};
}

} // namespace archetype

template <>
struct std::hash<archetype::Hashed_graph::Vertex>
{
  std::size_t operator()(archetype::Hashed_graph::Vertex v) const { return v.index; }
};

template <archetype::Numbering numbering>
struct std::hash<archetype::Descriptor<numbering, 1>>
{
  std::size_t operator()(archetype::Descriptor<numbering, 1> h) const { return h.index; }
};

template <archetype::Numbering numbering>
struct boost::graph_traits<archetype::Triangle_graph<numbering>>
{
  using vertex_descriptor = archetype::Descriptor<numbering, 0>;
  using halfedge_descriptor = archetype::Descriptor<numbering, 1>;
  using face_descriptor = archetype::Descriptor<numbering, 2>;
  static vertex_descriptor null_vertex() { return {}; }
};

template <archetype::Numbering numbering>
struct boost::property_map<archetype::Triangle_graph<numbering>, CGAL::vertex_point_t>
{
  using type = typename archetype::Triangle_graph<numbering>::template Vertex_map<
    typename archetype::Triangle_graph<numbering>::Point>;
  using const_type = type;
};

template <archetype::Numbering numbering>
struct CGAL::graph_has_property<archetype::Triangle_graph<numbering>, CGAL::vertex_point_t>
  : CGAL::Tag_true
{};

#endif // CGAL_CANONICAL_POSE_3_TEST_TRIANGLE_GRAPH_H
