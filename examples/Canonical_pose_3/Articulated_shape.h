// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_SHAPE_H
#define CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_SHAPE_H

// Procedural shapes, for examples and tests that require one shape in many poses with known
// correspondence. `Articulated_figure` and `Articulated_animal` define one each.
//
// Units: meters. Axes: x to the left of the shape, y up, z forward. The lowest points are at y = 0.

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/Kernel_traits.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace Canonical_pose_examples {

/// A shape, meshed once in its rest pose; all poses have the same faces and the same order of the
/// vertices. What takes long to compile is in sources, see `Anatomy.h`.
///
/// \tparam Anatomy has the shape and moves it; known to the source of a shape only.
/// \tparam Angles the angles of the joints; all are zero in the rest pose.
template <class Anatomy, class Angles>
class Articulated_shape
{
public:
  using Joint_angles = Angles;
  struct Named_pose
  {
    std::string name;
    Joint_angles angles;
  };
  using Points = std::vector<std::array<double, 3>>;
  using Triangles = std::vector<std::array<std::size_t, 3>>;

  /// Has exactly the requested number of vertices, at least 2000 and at most 2 million.
  explicit Articulated_shape(std::size_t number_of_vertices = 10000);

  /// Indices into `points()`, counterclockwise seen from outside.
  const Triangles& triangles() const { return faces; }

  /// The position of each vertex in the given pose; the lowest is at y = 0.
  Points points(const Joint_angles& angles = Joint_angles()) const;

  /// The pose as a mesh, any model of `MutableFaceGraph`; vertices in the order of `points()`.
  template <class TriangleMesh>
  TriangleMesh make_mesh(const Joint_angles& angles = Joint_angles()) const
  {
    using Point_map = typename boost::property_map<TriangleMesh, CGAL::vertex_point_t>::type;
    using Point = typename boost::property_traits<Point_map>::value_type;
    using FT = typename CGAL::Kernel_traits<Point>::Kernel::FT;
    TriangleMesh mesh;
    using Vertex = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;
    std::vector<Vertex> vertices;
    for(const auto& p : points(angles))
    {
      vertices.push_back(add_vertex(mesh));
      put(CGAL::vertex_point, mesh, vertices.back(), Point(FT(p[0]), FT(p[1]), FT(p[2])));
    }
    for(const auto& t : faces)
      CGAL::Euler::add_face(std::array<Vertex, 3>{{vertices[t[0]], vertices[t[1]], vertices[t[2]]}},
                            mesh);
    return mesh;
  }

  /// Index of the vertex nearest to `point` in the rest pose.
  std::size_t nearest_vertex(const Eigen::Vector3d& point) const;

private:
  std::vector<Eigen::Vector3d> rest;
  Triangles faces;
};

} // namespace Canonical_pose_examples

#endif // CGAL_CANONICAL_POSE_3_EXAMPLES_ARTICULATED_SHAPE_H
