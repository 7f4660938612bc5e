// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_LINES_OF_SIGHT_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_LINES_OF_SIGHT_H

#include "Face_graph.h"
#include "K_means.h"
#include "../lattice/Surface_rays.h"
#include "../linear_algebra/smallest_eigenpairs.h"

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Which of some faces see each other through the inside of the surface: the parts of a shape are
// nearly convex, so most pairs of points of one part do. (As in O. van Kaick et al., "Shape
// segmentation by approximate convexity analysis", 2014.)
class Lines_of_sight
{
public:
  // `triangles`: those of the graph, then caps, if any.
  Lines_of_sight(const Face_graph& graph, const std::vector<Index_triangle>& triangles,
                 std::vector<std::size_t> faces)
    : m_graph(graph), m_rays(graph.points, triangles), m_faces(std::move(faces))
  {}

  // 1 or 0 for each pair of faces.
  Eigen::MatrixXd visibility() const
  {
    const auto n = static_cast<Eigen::Index>(m_faces.size());
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
    for_each_index(m_faces.size(), [&](const std::size_t j) {
      for(std::size_t i = 0; i < j; ++i)
        if(is_visible(m_faces[i], m_faces[j]))
          result(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = 1;
    });
    return result + result.transpose();
  }

  // Distances of the centroids.
  Eigen::MatrixXd distances() const
  {
    const auto n = static_cast<Eigen::Index>(m_faces.size());
    Eigen::MatrixXd result(n, n);
    for(Eigen::Index j = 0; j < n; ++j)
      for(Eigen::Index i = 0; i < n; ++i)
        result(i, j) = (centroid(m_faces[static_cast<std::size_t>(i)])
                        - centroid(m_faces[static_cast<std::size_t>(j)]))
                         .norm();
    return result;
  }

  // The logarithm of the thickness of the shape at the faces: of the median length of rays in a cone
  // around the inward normal. (L. Shapira et al., "Consistent mesh partitioning and skeletonisation
  // using the shape diameter function", 2008.)
  Eigen::VectorXd log_thickness() const
  {
    Eigen::VectorXd result(static_cast<Eigen::Index>(m_faces.size()));
    for_each_index(m_faces.size(), [&](const std::size_t i) {
      result[static_cast<Eigen::Index>(i)] = std::log(thickness(m_faces[i]));
    });
    return result;
  }

private:
  Eigen::Vector3d centroid(const std::size_t f) const
  {
    return m_graph.centroids.row(static_cast<Eigen::Index>(f));
  }
  Eigen::Vector3d normal(const std::size_t f) const
  {
    return m_graph.normals.row(static_cast<Eigen::Index>(f));
  }

  bool is_visible(const std::size_t from, const std::size_t to) const
  {
    constexpr double slack = 1e-6; // of the distance
    const Eigen::Vector3d difference = centroid(to) - centroid(from);
    const double distance = difference.norm();
    if(!(normal(from).dot(difference) < 0 && normal(to).dot(difference) > 0))
      return false;
    bool result = true;
    m_rays.trace(centroid(from), difference / distance, from, [&](const Surface_rays::Hit& hit) {
      result = hit.face == to || hit.distance >= (1 - slack) * distance;
      return false;
    });
    return result;
  }

  double thickness(const std::size_t face) const
  {
    constexpr int number_of_rays = 16;
    constexpr double slope = 1.03;           // of the cone
    constexpr double golden_angle = 2.39996; // spreads the rays evenly
    constexpr double unknown = .05, least = 1e-3;
    const Eigen::Vector3d axis = -normal(face);
    if(axis.squaredNorm() < .5) // without area
      return unknown;
    const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.cross(u);
    std::vector<double> lengths;
    for(int k = 0; k < number_of_rays; ++k)
    {
      const double radius = slope * std::sqrt((k + .5) / number_of_rays);
      const double angle = golden_angle * k;
      const Eigen::Vector3d direction = axis + radius * (std::cos(angle) * u + std::sin(angle) * v);
      m_rays.trace(centroid(face), direction.normalized(), face, [&](const Surface_rays::Hit& hit) {
        if(hit.is_exit)
          lengths.push_back(hit.distance);
        return !hit.is_exit;
      });
    }
    if(lengths.empty())
      return unknown;
    const auto median = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), median, lengths.end());
    return (std::max)(*median, least);
  }

  const Face_graph& m_graph;
  Surface_rays m_rays;
  std::vector<std::size_t> m_faces;
};

// Clusters patches that see each other, by normalized spectral clustering (Ng et al. 2001).
// `affinities`: symmetric, not negative.
inline std::vector<std::size_t> spectral_clusters(const Eigen::MatrixXd& affinities,
                                                  const Eigen::VectorXd& areas,
                                                  const std::size_t number_of_clusters,
                                                  Random_numbers& random)
{
  constexpr double least_degree = 1e-12;
  constexpr int number_of_runs = 8;
  const auto k = (std::min)(static_cast<Eigen::Index>(number_of_clusters), areas.size());
  const Eigen::VectorXd roots = areas.cwiseSqrt();
  const Eigen::MatrixXd weighted = roots.asDiagonal() * affinities * roots.asDiagonal();
  const Eigen::VectorXd scale
    = weighted.rowwise().sum().cwiseMax(least_degree).cwiseSqrt().cwiseInverse();
  std::optional<Eigenpairs> pairs
    = smallest_eigenpairs(-(scale.asDiagonal() * weighted * scale.asDiagonal()), k);
  if(!pairs)
    throw std::runtime_error("the eigenvalues of a symmetric matrix could not be computed");
  Eigen::MatrixXd& rows = pairs->vectors;
  rows.rowwise().normalize();
  return K_means(rows, areas, static_cast<std::size_t>(k)).run(random, number_of_runs);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_LINES_OF_SIGHT_H
