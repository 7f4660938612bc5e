// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_PATCH_GRAPH_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_PATCH_GRAPH_H

#include "Face_graph.h"
#include "Patches.h"
#include "../support/angle_between.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Patches and the costs of boundaries between neighbors.
struct Patch_graph
{
  struct Edge
  {
    std::size_t a, b;
    double cost;           // of a boundary between the two
    double conductance;    // the cost by the distance of the centroids
    double length = 0;     // of the boundary
    double shape_cost = 0; // the cost without the thickness, and without mean normals that have no
                           // direction, such as those of patches around a bar
  };

  Eigen::VectorXd areas;
  std::vector<Edge> edges;
};

// What boundaries avoid or prefer.
struct Boundary_preferences
{
  double edge_concavity;  // scale of the angles between faces
  double patch_concavity; // scale of the angles between the mean normals of patches; 0: ignored
  double thickness_ratio; // scale of the differences of the logarithm of the thickness; 0: ignored
  double least_of_concavity = least_concavity_factor; // least factor for a concave edge or angle
};

// Costs of the boundaries between patches: lengths, times a factor for each preference.
// `log_thickness`: one value per face.
inline Patch_graph patch_graph(const Face_graph& graph, const Patches& patches,
                               const Boundary_preferences& preferences,
                               const Eigen::VectorXd& log_thickness)
{
  constexpr double least_of_thickness = .2, shortest_distance = 1e-9;
  constexpr double least_with_direction = .5; // length of a mean normal
  Patch_graph result;
  result.areas = patch_areas(graph, patches);
  const Row_vectors centroids = patch_means(graph, patches, graph.centroids, result.areas);
  const Row_vectors normals = patch_means(graph, patches, graph.normals, result.areas);
  const Eigen::VectorXd thickness = patch_means(graph, patches, log_thickness, result.areas);

  std::unordered_map<std::size_t, std::size_t> edge_of_pair;
  for(const Face_graph::Edge& edge : graph.edges)
  {
    const auto [a, b]
      = std::minmax(patches.patch_of_face[edge.faces[0]], patches.patch_of_face[edge.faces[1]]);
    if(a == b)
      continue;
    const auto [it, is_new] = edge_of_pair.emplace(a * patches.size() + b, result.edges.size());
    if(is_new)
      result.edges.push_back({a, b, 0, 0, 0, 0});
    result.edges[it->second].length += edge.length;
    result.edges[it->second].cost
      += edge.length
         * concavity_factor(edge.concave_angle, preferences.edge_concavity,
                            preferences.least_of_concavity);
  }
  for(Patch_graph::Edge& edge : result.edges)
  {
    const auto a = static_cast<Eigen::Index>(edge.a), b = static_cast<Eigen::Index>(edge.b);
    const Eigen::RowVector3d difference = centroids.row(b) - centroids.row(a);
    const Eigen::RowVector3d na = normals.row(a), nb = normals.row(b);
    edge.shape_cost = edge.cost;
    if(preferences.patch_concavity > 0 && (na - nb).dot(difference) > 0)
    {
      edge.cost *= concavity_factor(angle_between(na, nb), preferences.patch_concavity,
                                    preferences.least_of_concavity);
      if((std::min)(na.norm(), nb.norm()) >= least_with_direction)
        edge.shape_cost = edge.cost;
    }
    if(preferences.thickness_ratio > 0)
    {
      const double ratio = (thickness[b] - thickness[a]) / preferences.thickness_ratio;
      edge.cost *= (std::max)(least_of_thickness, std::exp(-ratio * ratio / 2));
    }
    edge.conductance = edge.cost / (std::max)(difference.norm(), shortest_distance);
  }
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_PATCH_GRAPH_H
