// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_FACE_GRAPH_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_FACE_GRAPH_H

#include "../support/angle_between.h"
#include "../surface/root_of_area.h"

#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

using Row_vectors = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;

// The dual graph of a triangulated surface, in the unit in which its area is 1.
struct Face_graph
{
  // Two faces with a common edge.
  struct Edge
  {
    std::array<std::size_t, 2> faces;
    double length;        // of the common edge
    double distance;      // of the centroids, via the midpoint of the common edge
    double concave_angle; // by which the normals differ; 0 if the edge is convex
  };

  struct Neighbor
  {
    std::size_t face, edge;
  };

  std::size_t number_of_faces() const { return static_cast<std::size_t>(areas.size()); }

  Row_vectors points;
  Eigen::VectorXd areas;
  Row_vectors centroids, normals; // the normal of a face without area is 0
  std::vector<Edge> edges;
  Buckets<Neighbor> neighbors; // for each face
};

inline constexpr double least_concavity_factor = .05;

// Factor of the cost of a boundary along a concave edge; 1 along a convex one.
inline double concavity_factor(const double concave_angle, const double scale,
                               const double least = least_concavity_factor)
{
  return concave_angle > 0 ? (std::max)(least, std::exp(-concave_angle / scale)) : 1.;
}

// Computes areas, centroids and normals. The area of the surface is positive.
inline void measure_faces(Point_matrix points, const std::vector<Index_triangle>& triangles,
                          Face_graph& graph)
{
  normalize(points);
  graph.points = points / root_of_area(points, triangles);
  const auto n = static_cast<Eigen::Index>(triangles.size());
  graph.areas.resize(n);
  graph.centroids.resize(n, 3);
  graph.normals.resize(n, 3);
  for(Eigen::Index f = 0; f < n; ++f)
  {
    const Index_triangle& t = triangles[static_cast<std::size_t>(f)];
    const auto point = [&](const int k) -> Eigen::RowVector3d {
      return graph.points.row(static_cast<Eigen::Index>(t[static_cast<std::size_t>(k)]));
    };
    const Eigen::RowVector3d normal = (point(1) - point(0)).cross(point(2) - point(0));
    graph.areas[f] = 0.5 * normal.norm();
    graph.normals.row(f) = normal.stableNormalized();
    graph.centroids.row(f) = (point(0) + point(1) + point(2)) / 3;
  }
}

inline Face_graph::Edge measured_edge(const Face_graph& graph, const std::size_t a,
                                      const std::size_t b, const std::size_t from,
                                      const std::size_t to)
{
  const auto row = [](const std::size_t i) { return static_cast<Eigen::Index>(i); };
  const Eigen::RowVector3d ends[2] = {graph.points.row(row(from)), graph.points.row(row(to))};
  const Eigen::RowVector3d midpoint = (ends[0] + ends[1]) / 2;
  const Eigen::RowVector3d ca = graph.centroids.row(row(a)), cb = graph.centroids.row(row(b));
  const Eigen::RowVector3d na = graph.normals.row(row(a)), nb = graph.normals.row(row(b));
  const bool is_concave = na.dot(cb - ca) > 0;
  return {{a, b},
          (ends[1] - ends[0]).norm(),
          (ca - midpoint).norm() + (cb - midpoint).norm(),
          is_concave ? angle_between(na, nb) : 0.};
}

// The distances of neighbors, for each edge.
inline std::vector<double> edge_distances(const Face_graph& graph)
{
  std::vector<double> result;
  result.reserve(graph.edges.size());
  for(const Face_graph::Edge& edge : graph.edges)
    result.push_back(edge.distance);
  return result;
}

// `triangles` are rows of `points`, consistently oriented; `vertices` maps rows that are copies of
// the same vertex to the same number, so that faces are neighbors across edges that are not manifold.
inline Face_graph face_graph(const Point_matrix& points,
                             const std::vector<Index_triangle>& triangles,
                             const std::vector<std::size_t>& vertices)
{
  Face_graph graph;
  measure_faces(points, triangles, graph);
  std::vector<Index_triangle> faces = triangles;
  for(Index_triangle& t : faces)
    for(std::size_t& v : t)
      v = vertices[v];
  const Corner_table corners(*std::max_element(vertices.begin(), vertices.end()) + 1, faces);
  corners.for_each_edge([&](const Corner_table::Edge& sides) {
    // A chain, not a star: the number of neighbors of a face is bounded, as the graph cuts require.
    for(std::size_t k = 1; k < sides.size(); ++k)
    {
      const std::size_t side = sides[k - 1];
      const std::size_t a = corners.face(side), b = corners.face(sides[k]);
      if(a != b)
        graph.edges.push_back(
          measured_edge(graph, a, b, triangles[a][side % 3], triangles[a][(side + 1) % 3]));
    }
  });
  graph.neighbors = Buckets<Face_graph::Neighbor>(graph.number_of_faces(), [&](const auto& put) {
    for(std::size_t e = 0; e < graph.edges.size(); ++e)
    {
      const auto [a, b] = graph.edges[e].faces;
      put(a, Face_graph::Neighbor{b, e});
      put(b, Face_graph::Neighbor{a, e});
    }
  });
  return graph;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_FACE_GRAPH_H
