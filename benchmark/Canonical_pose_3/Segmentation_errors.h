// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_SEGMENTATION_ERRORS_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_SEGMENTATION_ERRORS_H

#include "formats/Mesh_file.h" // of the tool

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

/// The part of each face.
using Parts = std::vector<std::size_t>;

/// Differences of two segmentations, as defined by X. Chen et al., "A benchmark for 3D mesh
/// segmentation", 2009, and computed by its evaluator; 0 if they are the same.
struct Segmentation_errors
{
  double rand = 0; ///< 1 - Rand index: the share of pairs of faces on which they disagree
  double cut = 0;  ///< cut discrepancy, by the mean radius; not a number if there is no cut in one
  double hamming = 0; ///< Hamming distance, by area
  double global = 0;  ///< global consistency error, by numbers of faces
  double local = 0;   ///< local consistency error, by numbers of faces
};

/// The faces of two segmentations by their parts.
class Contingency_table
{
public:
  Contingency_table(const Parts& a, const Parts& b, const Eigen::VectorXd& weights)
    : m_table(Eigen::MatrixXd::Zero(number_of(a), number_of(b)))
  {
    for(std::size_t f = 0; f < a.size(); ++f)
      m_table(static_cast<Eigen::Index>(a[f]), static_cast<Eigen::Index>(b[f]))
        += weights[static_cast<Eigen::Index>(f)];
  }
  const Eigen::MatrixXd& table() const { return m_table; }
  double total() const { return m_table.sum(); }
  Eigen::VectorXd of_first() const { return m_table.rowwise().sum(); }
  Eigen::VectorXd of_second() const { return m_table.colwise().sum().transpose(); }

private:
  static Eigen::Index number_of(const Parts& parts)
  {
    return static_cast<Eigen::Index>(*std::max_element(parts.begin(), parts.end()) + 1);
  }
  Eigen::MatrixXd m_table;
};

inline double rand_error(const Contingency_table& faces)
{
  const auto pairs
    = [](const auto& numbers) { return (numbers.array() * (numbers.array() - 1)).sum() / 2; };
  const double n = faces.total();
  return (pairs(faces.of_first()) + pairs(faces.of_second()) - 2 * pairs(faces.table()))
         / (n * (n - 1) / 2);
}

inline double hamming_distance(const Contingency_table& areas)
{
  return 1
         - (areas.table().rowwise().maxCoeff().sum() + areas.table().colwise().maxCoeff().sum())
             / (2 * areas.total());
}

/// The global and the local consistency error; both are 0 if one segmentation has a single part.
inline std::array<double, 2> consistency_errors(const Contingency_table& faces)
{
  const Eigen::MatrixXd& n = faces.table();
  if(n.rows() == 1 || n.cols() == 1)
    return {0, 0};
  const Eigen::MatrixXd first = 1 - (faces.of_first().cwiseInverse().asDiagonal() * n).array();
  const Eigen::MatrixXd second = 1 - (n * faces.of_second().cwiseInverse().asDiagonal()).array();
  const double sum = (std::min)(n.cwiseProduct(first).sum(), n.cwiseProduct(second).sum());
  return {sum / faces.total(), n.cwiseProduct(first.cwiseMin(second)).sum() / faces.total()};
}

/// Compares segmentations of the same mesh.
class Segmentation_comparison
{
public:
  /// A segmentation with the distances to its cuts.
  struct Segmentation
  {
    Parts parts;
    std::vector<std::size_t> cut_vertices;
    std::vector<double> distances; ///< of all vertices, along edges
  };

  explicit Segmentation_comparison(const Canonical_pose_tool::Mesh_file& mesh)
    : m_neighbors(mesh.points.size()), m_areas(static_cast<Eigen::Index>(mesh.faces.size()))
  {
    std::map<std::array<std::size_t, 2>, std::size_t> first_face;
    Eigen::MatrixX3d centroids(m_areas.size(), 3);
    for(std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      const CGAL::Canonical_pose_3::Face_list::Face face = mesh.faces[f];
      const Eigen::RowVector3d corner = point(mesh, face[0]);
      Eigen::RowVector3d normal = Eigen::RowVector3d::Zero(), sum = Eigen::RowVector3d::Zero();
      for(std::size_t k = 0; k < face.size(); ++k)
      {
        const std::size_t a = face[k], b = face[(k + 1) % face.size()];
        normal += (point(mesh, a) - corner).cross(point(mesh, b) - corner) / 2;
        sum += point(mesh, a);
        const auto [it, is_new] = first_face.insert({{(std::min)(a, b), (std::max)(a, b)}, f});
        if(!is_new)
          m_edges.push_back({a, b, it->second, f});
        else
          add_edge(a, b, (point(mesh, b) - point(mesh, a)).norm());
      }
      m_areas[static_cast<Eigen::Index>(f)] = normal.norm();
      centroids.row(static_cast<Eigen::Index>(f)) = sum / static_cast<double>(face.size());
    }
    const Eigen::RowVector3d center = m_areas.transpose() * centroids / m_areas.sum();
    m_mean_radius = m_areas.dot((centroids.rowwise() - center).rowwise().norm()) / m_areas.sum();
  }

  const Eigen::VectorXd& areas() const { return m_areas; }

  Segmentation segmentation(Parts parts) const
  {
    Segmentation result{std::move(parts), {}, {}};
    std::vector<bool> is_cut(m_neighbors.size(), false);
    for(const Edge& edge : m_edges)
      if(result.parts[edge.first_face] != result.parts[edge.second_face])
        is_cut[edge.a] = is_cut[edge.b] = true;
    for(std::size_t v = 0; v < is_cut.size(); ++v)
      if(is_cut[v])
        result.cut_vertices.push_back(v);
    result.distances = distances(result.cut_vertices);
    return result;
  }

  Segmentation_errors errors(const Segmentation& a, const Segmentation& b) const
  {
    const Contingency_table faces(a.parts, b.parts, Eigen::VectorXd::Ones(m_areas.size()));
    const auto [global, local] = consistency_errors(faces);
    return {rand_error(faces), cut_discrepancy(a, b),
            hamming_distance(Contingency_table(a.parts, b.parts, m_areas)), global, local};
  }

private:
  struct Edge
  {
    std::size_t a, b, first_face, second_face;
  };

  static Eigen::RowVector3d point(const Canonical_pose_tool::Mesh_file& mesh, const std::size_t v)
  {
    return Eigen::RowVector3d(mesh.points[v][0], mesh.points[v][1], mesh.points[v][2]);
  }

  void add_edge(const std::size_t a, const std::size_t b, const double length)
  {
    m_neighbors[a].emplace_back(b, length);
    m_neighbors[b].emplace_back(a, length);
  }

  double cut_discrepancy(const Segmentation& a, const Segmentation& b) const
  {
    if(a.cut_vertices.empty() || b.cut_vertices.empty())
      return std::numeric_limits<double>::quiet_NaN();
    double sum = 0;
    for(const std::size_t v : a.cut_vertices)
      sum += b.distances[v];
    for(const std::size_t v : b.cut_vertices)
      sum += a.distances[v];
    const double mean = sum / static_cast<double>(a.cut_vertices.size() + b.cut_vertices.size());
    return std::isfinite(mean) ? mean / m_mean_radius : std::numeric_limits<double>::quiet_NaN();
  }

  std::vector<double> distances(const std::vector<std::size_t>& sources) const
  {
    using Entry = std::pair<double, std::size_t>;
    std::vector<double> result(m_neighbors.size(), std::numeric_limits<double>::infinity());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
    for(const std::size_t v : sources)
    {
      result[v] = 0;
      queue.emplace(0, v);
    }
    while(!queue.empty())
    {
      const auto [distance, v] = queue.top();
      queue.pop();
      if(distance == result[v])
        for(const auto& [w, length] : m_neighbors[v])
          if(distance + length < result[w])
          {
            result[w] = distance + length;
            queue.emplace(result[w], w);
          }
    }
    return result;
  }

  std::vector<std::vector<std::pair<std::size_t, double>>> m_neighbors; // of vertices
  std::vector<Edge> m_edges;                                            // with two faces
  Eigen::VectorXd m_areas;
  double m_mean_radius;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_SEGMENTATION_ERRORS_H
