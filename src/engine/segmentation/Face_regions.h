// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_FACE_REGIONS_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_FACE_REGIONS_H

#include "Face_graph.h"
#include "Nearest_sources.h"

#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>

#include <CGAL/boost/graph/Alpha_expansion_MaxFlow_tag.h>
#include <CGAL/boost/graph/alpha_expansion_graphcut.h>

#include <Eigen/Core>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Two neighboring regions, and the faces near their common boundary.
struct Region_pair
{
  std::array<std::size_t, 2> regions;
  std::vector<std::size_t> faces;
};

// The pairs of neighboring regions in the same group. Each face of the two within `distance` of a
// boundary belongs to the pair with the nearest one.
inline std::vector<Region_pair> region_pairs(const Face_graph& graph,
                                             const std::vector<std::size_t>& region_of_face,
                                             const std::vector<std::size_t>& group_of_face,
                                             const double distance)
{
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> index;
  std::vector<Region_pair> result;
  Nearest_sources boundaries(graph, edge_distances(graph), distance);
  for(const Face_graph::Edge& edge : graph.edges)
  {
    const auto [a, b] = std::minmax(region_of_face[edge.faces[0]], region_of_face[edge.faces[1]]);
    if(a == b || group_of_face[edge.faces[0]] != group_of_face[edge.faces[1]])
      continue;
    const auto [it, is_new] = index.emplace(std::make_pair(a, b), result.size());
    if(is_new)
      result.push_back({{a, b}, {}});
    for(const std::size_t face : edge.faces)
      boundaries.insert(face, it->second);
  }
  boundaries.update();
  for(std::size_t f = 0; f < region_of_face.size(); ++f)
    if(boundaries.distances()[f] < distance)
    {
      Region_pair& pair = result[boundaries.labels()[f]];
      if(region_of_face[f] == pair.regions[0] || region_of_face[f] == pair.regions[1])
        pair.faces.push_back(f);
    }
  result.erase(std::remove_if(result.begin(), result.end(),
                              [](const Region_pair& pair) { return pair.faces.empty(); }),
               result.end());
  return result;
}

// Moves the boundary between two regions such that it is short and runs along concave edges, by a
// graph cut (Boykov et al. 2001). Only the faces of the pair change their region; boundaries between
// groups cost nothing. `cost(face, region)`: what it costs to assign a face to a region.
template <class Cost>
void refine_boundary(const Face_graph& graph, const Region_pair& pair,
                     const std::vector<std::size_t>& group_of_face,
                     std::vector<std::size_t>& region_of_face, const double concavity_scale,
                     const Cost& cost)
{
  using Graph
    = boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property,
                            boost::property<boost::edge_weight_t, double>>;
  std::unordered_map<std::size_t, std::size_t> index;
  std::vector<std::size_t> sides;
  std::vector<std::vector<double>> costs;
  for(const std::size_t f : pair.faces)
  {
    index.emplace(f, sides.size());
    sides.push_back(region_of_face[f] == pair.regions[0] ? 0 : 1);
    costs.push_back({cost(f, pair.regions[0]), cost(f, pair.regions[1])});
  }
  Graph subgraph(sides.size());
  for(const std::size_t f : pair.faces)
    for(const Face_graph::Neighbor& neighbor : graph.neighbors[f])
    {
      if(group_of_face[f] != group_of_face[neighbor.face])
        continue;
      const Face_graph::Edge& edge = graph.edges[neighbor.edge];
      const double weight = edge.length * concavity_factor(edge.concave_angle, concavity_scale);
      const auto it = index.find(neighbor.face);
      if(it == index.end())
        for(std::size_t side = 0; side < 2; ++side)
          costs[index[f]][side] += region_of_face[neighbor.face] == pair.regions[side] ? 0 : weight;
      else if(f < neighbor.face)
        boost::add_edge(index[f], it->second, weight, subgraph);
    }
  const auto vertex_index = get(boost::vertex_index, subgraph);
  alpha_expansion_graphcut(
    subgraph, get(boost::edge_weight, subgraph),
    boost::make_iterator_property_map(costs.begin(), vertex_index),
    boost::make_iterator_property_map(sides.begin(), vertex_index),
    parameters::vertex_index_map(vertex_index).implementation_tag(Alpha_expansion_MaxFlow_tag()));
  for(std::size_t i = 0; i < sides.size(); ++i)
    region_of_face[pair.faces[i]] = pair.regions[sides[i]];
}

// Regions of faces.
struct Face_regions
{
  std::size_t size() const { return areas.size(); }

  std::vector<std::size_t> region_of_face;
  std::vector<double> areas;
  std::vector<std::map<std::size_t, double>> boundaries; // lengths, for each neighbor
};

// The connected pieces of regions.
inline Face_regions connected_pieces(const Face_graph& graph,
                                     const std::vector<std::size_t>& region_of_face)
{
  Disjoint_sets sets(graph.number_of_faces());
  for(const Face_graph::Edge& edge : graph.edges)
    if(region_of_face[edge.faces[0]] == region_of_face[edge.faces[1]])
      sets.unite(edge.faces[0], edge.faces[1]);
  Face_regions result;
  Component_labels labels = label_components(sets);
  result.region_of_face = std::move(labels.of_items);
  result.areas.assign(labels.first_items.size(), 0.);
  result.boundaries.resize(result.size());
  for(std::size_t f = 0; f < graph.number_of_faces(); ++f)
    result.areas[result.region_of_face[f]] += graph.areas[static_cast<Eigen::Index>(f)];
  for(const Face_graph::Edge& edge : graph.edges)
  {
    const std::size_t a = result.region_of_face[edge.faces[0]];
    const std::size_t b = result.region_of_face[edge.faces[1]];
    if(a != b)
    {
      result.boundaries[a][b] += edge.length;
      result.boundaries[b][a] += edge.length;
    }
  }
  return result;
}

// Adds regions smaller than `least_area` to the neighbor in the same group with the longest common
// boundary, the smallest ones first; returns the new region of each face, not numbered
// consecutively. Regions without such a neighbor remain.
inline std::vector<std::size_t> without_specks(Face_regions regions,
                                               const std::vector<std::size_t>& group_of_face,
                                               const double least_area)
{
  std::vector<std::size_t> group(regions.size());
  for(std::size_t f = 0; f < group_of_face.size(); ++f)
    group[regions.region_of_face[f]] = group_of_face[f];
  for(std::size_t r = 0; r < regions.size(); ++r)
    for(auto it = regions.boundaries[r].begin(); it != regions.boundaries[r].end();)
      it = group[it->first] == group[r] ? std::next(it) : regions.boundaries[r].erase(it);

  const auto smaller = [&](const std::size_t a, const std::size_t b) {
    return std::make_pair(regions.areas[a], a) < std::make_pair(regions.areas[b], b);
  };
  std::vector<std::size_t> specks, parent(regions.size());
  for(std::size_t r = 0; r < regions.size(); ++r)
  {
    parent[r] = r;
    if(regions.areas[r] < least_area)
      specks.push_back(r);
  }
  std::sort(specks.begin(), specks.end(), smaller);
  for(const std::size_t speck : specks)
  {
    // It may have grown.
    if(regions.areas[speck] >= least_area || regions.boundaries[speck].empty())
      continue;
    const std::map<std::size_t, double> boundary = std::move(regions.boundaries[speck]);
    const std::size_t owner
      = std::max_element(boundary.begin(), boundary.end(), [](const auto& a, const auto& b) {
          return a.second < b.second;
        })->first;
    parent[speck] = owner;
    regions.areas[owner] += regions.areas[speck];
    for(const auto& [neighbor, length] : boundary)
    {
      regions.boundaries[neighbor].erase(speck);
      if(neighbor != owner)
      {
        regions.boundaries[owner][neighbor] += length;
        regions.boundaries[neighbor][owner] += length;
      }
    }
  }
  for(std::size_t& region : regions.region_of_face)
    while(parent[region] != region)
      region = parent[region];
  return std::move(regions.region_of_face);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_FACE_REGIONS_H
