// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The one call with user-defined distances and body: graph distances along the edges, and a coarse
// lattice.

#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/dijkstra_shortest_paths.h>

#include <boost/property_map/function_property_map.hpp>

#include "Articulated_figure.h"

#include <cstdlib>
#include <iostream>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A model of GeodesicDistances_3.
class Edge_distances
{
public:
  using Triangle_mesh = Mesh;
  using vertex_descriptor = Mesh::Vertex_index;
  explicit Edge_distances(const Mesh& mesh) : m_mesh(mesh) {}
  const Mesh& triangle_mesh() const { return m_mesh; }
  std::size_t index(const vertex_descriptor v) const { return v; }
  Eigen::VectorXd distances(const vertex_descriptor source) const
  {
    Eigen::VectorXd result(m_mesh.number_of_vertices());
    const auto length = boost::make_function_property_map<Mesh::Edge_index>([&](const auto e) {
      return CGAL::Polygon_mesh_processing::edge_length(m_mesh.halfedge(e), m_mesh);
    });
    const auto map
      = boost::make_iterator_property_map(result.data(), get(boost::vertex_index, m_mesh));
    boost::dijkstra_shortest_paths(m_mesh, source, boost::weight_map(length).distance_map(map));
    return result;
  }

private:
  const Mesh& m_mesh;
};

int main()
{
  const auto mesh = Canonical_pose_examples::Articulated_figure(2500).make_mesh<Mesh>();
  CP::Options options;
  options.landmark_fields_function = CP::landmark_fields_function<Edge_distances>();
  options.make_body = [](const auto& points, const auto& triangles, const auto& fields) {
    return CP::Lattice_body_3(points, triangles, fields.distances, 1. / 40);
  };
  Mesh pose = mesh;
  const CP::Result result = CGAL::canonical_pose_3(mesh, pose.points(), options);
  std::cout << result << '\n';
  return result.is_usable() ? EXIT_SUCCESS : EXIT_FAILURE;
}
