// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "closed.h"
#include "root_of_area.h"
#include "../support/angle_between.h"

#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/cut_contacts.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/Path_on_surface.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Edges, their lengths and how much they are creased.
class Creased_mesh
{
public:
  using Halfedge_index = Indexed_mesh::Halfedge_index;
  using Vertex_index = Indexed_mesh::Vertex_index;

  // Throws std::invalid_argument if the triangles are not an oriented 2-manifold.
  Creased_mesh(const Point_matrix& points, const std::vector<Index_triangle>& triangles)
    : m_points(points), m_mesh(indexed_mesh(points, triangles))
  {
    for(const Index_triangle& t : triangles)
      m_normals.push_back(
        Eigen::Vector3d(point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])).normalized());
    for(const Indexed_mesh::Edge_index e : m_mesh.edges())
      m_turns.push_back(concave_turn(m_mesh.halfedge(e)));
  }

  const Indexed_mesh& mesh() const { return m_mesh; }

  Eigen::Vector3d point(const std::size_t v) const
  {
    return m_points.row(static_cast<Eigen::Index>(v));
  }

  double length(const Halfedge_index h) const
  {
    return (point(m_mesh.source(h)) - point(m_mesh.target(h))).norm();
  }

  // The angle between the normals of the faces at a concave edge; otherwise 0.
  double turn(const Halfedge_index h) const { return m_turns[m_mesh.edge(h)]; }

  double length_of_crease(const Halfedge_index h) const
  {
    constexpr double largest_turn = 1; // radians
    return length(h) * (1 - 0.8 * (std::min)(turn(h) / largest_turn, 1.));
  }

private:
  double concave_turn(const Halfedge_index h) const
  {
    if(m_mesh.is_border(m_mesh.edge(h)))
      return 0;
    const Halfedge_index opposite = m_mesh.opposite(h);
    const Eigen::Vector3d& normal = m_normals[m_mesh.face(h)];
    const Eigen::Vector3d& other = m_normals[m_mesh.face(opposite)];
    const Eigen::Vector3d side
      = point(m_mesh.target(m_mesh.next(opposite))) - point(m_mesh.source(opposite));
    return side.dot(normal) > 0 ? angle_between(normal, other) : 0;
  }

  const Point_matrix& m_points;
  Indexed_mesh m_mesh;
  std::vector<Eigen::Vector3d> m_normals; // of faces
  std::vector<double> m_turns;            // at edges
};

// A closed curve of halfedges.
using Halfedge_loop = std::vector<Indexed_mesh::Halfedge_index>;

// Finds short closed curves around handles.
class Contact_loops
{
public:
  Contact_loops(const Creased_mesh& mesh, const double longest)
    : m_mesh(mesh), m_longest(longest), m_topology(mesh.mesh())
  {}

  // Simple curves, by increasing length, where concave edges count less.
  std::vector<Halfedge_loop> operator()() const
  {
    std::vector<std::pair<double, Halfedge_loop>> found;
    for(const Creased_mesh::Vertex_index base : bases())
    {
      Halfedge_loop loop = loop_through(base);
      double length = 0, length_of_crease = 0;
      for(const auto h : loop)
      {
        length += m_mesh.length(h);
        length_of_crease += m_mesh.length_of_crease(h);
      }
      if(loop.size() >= 3 && length <= m_longest && is_simple(loop))
        found.emplace_back(length_of_crease, std::move(loop));
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Halfedge_loop> result;
    for(auto& pair : found)
      result.push_back(std::move(pair.second));
    return result;
  }

private:
  struct Length_of_crease
  {
    using Weight_t = double;
    double operator()(const Indexed_mesh::Halfedge_index h) const
    {
      return mesh.length_of_crease(h);
    }
    const Creased_mesh& mesh;
  };

  // Vertices of the sharpest concave edges, apart from each other.
  std::vector<Creased_mesh::Vertex_index> bases() const
  {
    constexpr double least_turn = 0.3; // radians
    constexpr std::size_t most = 32;
    std::vector<std::pair<double, Creased_mesh::Vertex_index>> creased;
    for(const auto e : m_mesh.mesh().edges())
    {
      const auto h = m_mesh.mesh().halfedge(e);
      if(m_mesh.turn(h) > least_turn)
        creased.emplace_back(m_mesh.turn(h), m_mesh.mesh().source(h));
    }
    std::stable_sort(creased.begin(), creased.end(),
                     [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<Creased_mesh::Vertex_index> result;
    for(const auto& [turn, v] : creased)
      if(result.size() < most
         && std::none_of(result.begin(), result.end(), [&, vertex = v](const auto other) {
              return (m_mesh.point(vertex) - m_mesh.point(other)).norm() < m_longest / 10;
            }))
        result.push_back(v);
    return result;
  }

  Halfedge_loop loop_through(const Creased_mesh::Vertex_index base) const
  {
    const auto path = m_topology.compute_shortest_non_contractible_cycle_with_base_point(
      m_mesh.mesh().halfedge(base), Length_of_crease{m_mesh});
    Halfedge_loop loop;
    for(std::size_t i = 0; i < path.length(); ++i)
      loop.push_back(path.get_ith_real_dart(i));
    std::size_t begin = 0, end = loop.size(); // without a tail that is passed twice
    while(end - begin >= 2 && loop[begin] == m_mesh.mesh().opposite(loop[end - 1]))
    {
      ++begin;
      --end;
    }
    return Halfedge_loop(loop.begin() + static_cast<std::ptrdiff_t>(begin),
                         loop.begin() + static_cast<std::ptrdiff_t>(end));
  }

  bool is_simple(const Halfedge_loop& loop) const
  {
    std::vector<std::size_t> vertices;
    for(std::size_t i = 0; i < loop.size(); ++i)
    {
      vertices.push_back(m_mesh.mesh().source(loop[i]));
      if(m_mesh.mesh().target(loop[i]) != m_mesh.mesh().source(loop[(i + 1) % loop.size()]))
        return false;
    }
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) == vertices.end();
  }

  const Creased_mesh& m_mesh;
  double m_longest;
  Surface_mesh_topology::Curves_on_surface_topology<Indexed_mesh> m_topology;
};

// The surface, cut along a simple curve. The last rows are copies of its vertices, in this order.
inline Surface_component_3 cut_along(Surface_component_3 surface, const Indexed_mesh& mesh,
                                     const Halfedge_loop& loop)
{
  const std::size_t n = static_cast<std::size_t>(surface.points.rows()), k = loop.size();
  surface.points.conservativeResize(static_cast<Eigen::Index>(n + k), 3);
  const std::size_t number_of_triangles = surface.triangles.size();
  for(std::size_t i = 0; i < k; ++i)
  {
    const std::size_t v = mesh.source(loop[i]);
    surface.points.row(static_cast<Eigen::Index>(n + i))
      = surface.points.row(static_cast<Eigen::Index>(v)).eval();
    surface.origins.push_back(surface.origins[v]);
    surface.body_origins.push_back(surface.body_origins[v]);
    auto h = loop[i];
    while(mesh.opposite(h) != loop[(i + k - 1) % k]) // the faces on the left
      h = mesh.opposite(mesh.prev(h));
    for(; h != loop[i]; h = mesh.opposite(mesh.prev(h)))
    {
      const std::size_t f = mesh.face(h);
      Index_triangle& t
        = f < number_of_triangles ? surface.triangles[f] : surface.caps[f - number_of_triangles];
      std::replace(t.begin(), t.end(), v, n + i);
    }
  }
  const std::size_t first = mesh.source(loop[0]);
  for(std::size_t i = 1; i + 1 < k; ++i)
  {
    surface.caps.push_back({{first, mesh.target(loop[i]), mesh.source(loop[i])}});
    surface.caps.push_back({{n, n + i, n + i + 1}});
  }
  return surface;
}

// The distance along edges between the two copies of a curve of k vertices along which a surface was cut;
// infinite if they are not connected.
inline double distance_across(const Surface_component_3& surface, const std::size_t k)
{
  const std::size_t n = static_cast<std::size_t>(surface.points.rows());
  std::vector<std::vector<std::size_t>> neighbors(n);
  for(const Index_triangle& t : surface.triangles)
    for(std::size_t i = 0; i < 3; ++i)
    {
      neighbors[t[i]].push_back(t[(i + 1) % 3]);
      neighbors[t[(i + 1) % 3]].push_back(t[i]);
    }
  std::vector<bool> is_left(n, false);
  for(std::size_t i = 0; i + 2 < k; ++i)
    for(const std::size_t v : surface.caps[surface.caps.size() - 2 * (k - 2) + 2 * i])
      is_left[v] = true;

  using Distance_and_vertex = std::pair<double, std::size_t>;
  std::priority_queue<Distance_and_vertex, std::vector<Distance_and_vertex>, std::greater<>> queue;
  std::vector<double> distance(n, (std::numeric_limits<double>::infinity)());
  for(std::size_t v = n - k; v < n; ++v)
    queue.emplace(distance[v] = 0, v);
  while(!queue.empty())
  {
    const auto [d, v] = queue.top();
    queue.pop();
    if(d > distance[v])
      continue;
    if(is_left[v])
      return d;
    for(const std::size_t w : neighbors[v])
    {
      const double longer = d
                            + (surface.points.row(static_cast<Eigen::Index>(v))
                               - surface.points.row(static_cast<Eigen::Index>(w)))
                                .norm();
      if(longer < distance[w])
        queue.emplace(distance[w] = longer, w);
    }
  }
  return (std::numeric_limits<double>::infinity)();
}

// The surface without one of its contacts, if there is any.
inline std::optional<Surface_component_3> without_contact(const Surface_component_3& surface)
{
  constexpr double longest_loop = 0.25, shortest_detour = 0.6; // by the square root of the area
  const double size = root_of_area(surface.points, surface.triangles);
  const Creased_mesh creased(surface.points, closed(surface));
  const Indexed_mesh& mesh = creased.mesh();
  std::size_t number_of_vertices = 0;
  for(const auto v : mesh.vertices())
    if(!mesh.is_isolated(v))
      ++number_of_vertices;
  if(number_of_vertices + mesh.number_of_faces() == mesh.number_of_edges() + 2) // a sphere
    return std::nullopt;
  for(const auto h : mesh.halfedges())
    if(mesh.is_border(h))
      return std::nullopt;
  for(const Halfedge_loop& loop : Contact_loops(creased, longest_loop * size)())
  {
    Surface_component_3 result = cut_along(surface, mesh, loop);
    const double detour = distance_across(result, loop.size());
    if(std::isfinite(detour) && detour >= shortest_detour * size)
    {
      result.contacts.push_back(surface.origins[mesh.source(loop[0])]);
      return result;
    }
  }
  return std::nullopt;
}

} // namespace internal

Surface_component_3 cut_contacts(const Surface_component_3& surface)
{
  Surface_component_3 result = surface;
  try
  {
    while(std::optional<Surface_component_3> next = internal::without_contact(result))
      result = std::move(*next);
  }
  catch(const std::invalid_argument&) // the caps do not make it a manifold
  {}
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
