// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_SEGMENTED_SURFACE_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_SEGMENTED_SURFACE_H

#include "Face_graph.h"
#include "Face_regions.h"
#include "Nearest_sources.h"
#include "../surface/root_of_area.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Segmentation_tree_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A surface prepared for segmentation: repaired, simplified if it has many faces, and without small
// components, each of which is a part of its own: so costs do not depend on their number.
class Segmented_surface
{
public:
  // `polygons`: rows of `points`. `pose`: one row per point, or none.
  Segmented_surface(const Point_matrix& points, const Face_list& polygons, const Point_matrix& pose)
    : m_number_of_faces(polygons.size()), m_polygons(polygons)
  {
    check_pose(points, pose);
    const Repaired_surface_3 repaired = repair_surface(points, polygons);
    m_face_of_triangle = repaired.face_of_triangle;
    for(const std::size_t origin : repaired.origins)
      m_vertices.push_back(repaired.representatives[origin]);
    m_triangles = repaired.triangles;
    m_caps = repaired.caps;
    m_points = repaired.points;
    if(pose.rows() > 0)
    {
      m_pose = rows_at(pose, repaired.origins);
      if(!(root_of_area(m_pose, m_triangles) > 0))
        throw std::invalid_argument("no face of the pose has an area");
    }
    m_given_graph = face_graph(m_points, m_triangles, m_vertices);
    if(m_triangles.size() > MOST_FACES)
      simplify();
    remove_small_components();
  }

  bool has_pose() const { return m_pose.rows() > 0; }

  // The triangles on which parts are computed.
  const std::vector<Index_triangle>& triangles() const { return m_triangles; }
  // These and the caps of holes, if there are any.
  std::vector<Index_triangle> closed_triangles() const
  {
    std::vector<Index_triangle> result = m_triangles;
    result.insert(result.end(), m_caps.begin(), m_caps.end());
    return result;
  }
  const Point_matrix& pose() const { return m_pose; }

  Face_graph graph() const
  {
    return is_simplified() || m_number_of_small_components > 0
             ? face_graph(m_points, m_triangles, m_vertices)
             : m_given_graph;
  }
  Face_graph graph_of_pose() const { return face_graph(m_pose, m_triangles, m_vertices); }

  // The number of parts of the triangles, if that of the whole surface is requested, or 0.
  std::size_t number_of_parts_of_triangles(const std::size_t requested_number) const
  {
    return requested_number == 0
             ? 0
             : requested_number - (std::min)(m_number_of_small_components, requested_number - 1);
  }

  // The tree of the polygons of the input, with leaves for small components. `tree`: of the triangles.
  Segmentation_tree_3 tree_of_polygons(Segmentation_tree_3 tree,
                                       const std::size_t requested_number_of_parts) const
  {
    std::vector<std::size_t> labels = m_small_component;
    std::size_t next = 0;
    for(std::size_t& label : labels)
      label
        = label == Disjoint_sets::NONE ? tree.leaf_of_face[next++] : tree.number_of_leaves + label;
    tree.leaf_of_face = labels_of_polygons(labels);
    for(Segmentation_tree_3::Merge& merge : tree.merges)
      for(std::size_t& node : merge.nodes)
        if(node >= tree.number_of_leaves)
          node += m_number_of_small_components;
    tree.number_of_leaves += m_number_of_small_components;
    tree.number_of_parts = requested_number_of_parts > 0
                             ? requested_number_of_parts
                             : tree.number_of_parts + m_number_of_small_components;
    return tree;
  }

private:
  static constexpr std::size_t MOST_FACES = 25000; // before the surface is simplified
  static constexpr std::size_t COARSE_VERTICES = 10000;
  static constexpr double LEAST_COMPONENT = 1. / 300; // area of one that may have several parts

  bool is_simplified() const { return !m_given_triangle.empty(); }

  static void check_pose(const Point_matrix& points, const Point_matrix& pose)
  {
    if(pose.rows() == 0)
      return;
    if(pose.rows() != points.rows())
      throw std::invalid_argument("the pose has " + std::to_string(pose.rows())
                                  + " vertices, but the surface has "
                                  + std::to_string(points.rows()));
    for(Eigen::Index i = 0; i < pose.rows(); ++i)
      if(!pose.row(i).allFinite())
        throw std::invalid_argument("vertex " + std::to_string(i) + " of the pose is not finite");
  }

  // Caps are not needed: only few rays leave through holes.
  void simplify()
  {
    Surface_component_3 surface;
    surface.points = m_points;
    surface.triangles = m_triangles;
    surface.face_of_triangle.resize(m_triangles.size());
    std::iota(surface.face_of_triangle.begin(), surface.face_of_triangle.end(), std::size_t(0));
    surface.origins = surface.body_origins = m_vertices;
    const Coarse_surface_3 coarse = coarse_surface(surface, COARSE_VERTICES);
    m_given_triangle = coarse.surface.face_of_triangle;
    m_triangles = coarse.surface.triangles;
    m_vertices = coarse.surface.origins;
    m_points = coarse.surface.points;
    m_caps.clear();
    if(has_pose())
      m_pose = rows_at(m_pose, coarse.vertices);
  }

  // The largest component remains, however many there are.
  void remove_small_components()
  {
    const Face_graph whole = graph();
    const Face_regions components
      = connected_pieces(whole, std::vector<std::size_t>(m_triangles.size(), 0));
    const auto largest
      = static_cast<std::size_t>(std::max_element(components.areas.begin(), components.areas.end())
                                 - components.areas.begin());
    std::vector<std::size_t> number(components.size(), Disjoint_sets::NONE);
    for(std::size_t c = 0; c < components.size(); ++c)
      if(c != largest && components.areas[c] < LEAST_COMPONENT)
        number[c] = m_number_of_small_components++;
    std::vector<Index_triangle> remaining;
    std::vector<bool> is_remaining(static_cast<std::size_t>(m_points.rows()), false);
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
    {
      m_small_component.push_back(number[components.region_of_face[t]]);
      if(m_small_component.back() == Disjoint_sets::NONE)
      {
        remaining.push_back(m_triangles[t]);
        for(const std::size_t v : m_triangles[t])
          is_remaining[v] = true;
      }
    }
    m_triangles = std::move(remaining);
    m_caps.erase(std::remove_if(m_caps.begin(), m_caps.end(),
                                [&](const Index_triangle& cap) {
                                  return !(is_remaining[cap[0]] && is_remaining[cap[1]]
                                           && is_remaining[cap[2]]);
                                }),
                 m_caps.end());
    if(has_pose() && !(root_of_area(m_pose, m_triangles) > 0))
      m_pose.resize(0, 3);
  }

  // Labels of the triangles, with those of small components, transferred to the polygons of the input.
  std::vector<std::size_t> labels_of_polygons(const std::vector<std::size_t>& labels) const
  {
    const std::vector<std::size_t> of_given = is_simplified() ? nearest_labels(labels) : labels;
    std::vector<std::size_t> result(m_number_of_faces, Disjoint_sets::NONE);
    std::vector<double> largest(m_number_of_faces, -1.);
    for(std::size_t t = 0; t < of_given.size(); ++t)
    {
      const std::size_t face = m_face_of_triangle[t];
      const double area = m_given_graph.areas[static_cast<Eigen::Index>(t)];
      if(area > largest[face])
      {
        largest[face] = area;
        result[face] = of_given[t];
      }
    }
    label_removed_faces(result);
    return result;
  }

  // Each remaining triangle has replaced one of the given ones, which has its label; the others have
  // that of the nearest of these, and then the boundaries are smoothed.
  std::vector<std::size_t> nearest_labels(const std::vector<std::size_t>& labels) const
  {
    constexpr double band = .04, concavity = .3, weight_of_label = 10;
    Nearest_sources sources(m_given_graph, edge_distances(m_given_graph));
    for(std::size_t t = 0; t < m_given_triangle.size(); ++t)
      sources.insert(m_given_triangle[t], labels[t]);
    sources.update();
    std::vector<std::size_t> result = sources.labels();
    const std::vector<std::size_t> group(result.size(), 0);
    for(const Region_pair& pair : region_pairs(m_given_graph, result, group, band))
      refine_boundary(m_given_graph, pair, group, result, concavity,
                      [&](const std::size_t face, const std::size_t label) {
                        return weight_of_label
                               * m_given_graph.areas[static_cast<Eigen::Index>(face)]
                               * (label == sources.labels()[face] ? 1 : 2);
                      });
    return result;
  }

  // Faces that the repair removed, since they are degenerate or there twice, get the label of a face
  // with a common vertex.
  void label_removed_faces(std::vector<std::size_t>& labels) const
  {
    std::vector<std::size_t> label_of_vertex;
    for(std::size_t f = 0; f < labels.size(); ++f)
      if(labels[f] != Disjoint_sets::NONE)
        for(const std::size_t v : m_polygons[f])
        {
          if(v >= label_of_vertex.size())
            label_of_vertex.resize(v + 1, Disjoint_sets::NONE);
          label_of_vertex[v] = labels[f];
        }
    for(std::size_t f = 0; f < labels.size(); ++f)
      if(labels[f] == Disjoint_sets::NONE)
      {
        for(const std::size_t v : m_polygons[f])
          if(v < label_of_vertex.size() && label_of_vertex[v] != Disjoint_sets::NONE)
            labels[f] = label_of_vertex[v];
        if(labels[f] == Disjoint_sets::NONE)
          labels[f] = 0;
      }
  }

  std::size_t m_number_of_faces;
  const Face_list& m_polygons;
  std::vector<std::size_t> m_face_of_triangle; // of the given triangles
  Face_graph m_given_graph;
  std::vector<std::size_t> m_given_triangle; // for each triangle, if simplified
  std::size_t m_number_of_small_components = 0;
  std::vector<std::size_t> m_small_component; // or NONE, for each triangle before they were removed
  std::vector<std::size_t> m_vertices;
  std::vector<Index_triangle> m_triangles, m_caps;
  Point_matrix m_points, m_pose;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_SEGMENTED_SURFACE_H
