// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_PATCHES_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_PATCHES_H

#include "Face_graph.h"
#include "Nearest_sources.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Small regions of about the same size, each the faces nearest to one of its centers.
struct Patches
{
  std::size_t size() const { return centers.size(); }

  std::vector<std::size_t> centers; // faces
  std::vector<std::size_t> patch_of_face;
};

// Whether patches are hardly larger than faces.
inline bool are_coarse(const Patches& patches)
{
  constexpr std::size_t least_number_of_faces = 3; // of a patch
  return patches.patch_of_face.size() < least_number_of_faces * patches.size();
}

// Lengths of the edges of the graph, larger across concave edges, so that patches end there.
inline std::vector<double> concave_lengths(const Face_graph& graph, const double concavity_scale)
{
  constexpr double most = 5; // times the distance
  std::vector<double> result;
  result.reserve(graph.edges.size());
  for(const Face_graph::Edge& edge : graph.edges)
  {
    const double factor = concavity_factor(edge.concave_angle, concavity_scale);
    result.push_back(edge.distance * (factor + most * (1 - factor)));
  }
  return result;
}

// The face farthest from the centroid of the surface.
inline std::size_t farthest_face(const Face_graph& graph)
{
  const Eigen::RowVector3d centroid = graph.areas.transpose() * graph.centroids;
  Eigen::Index result;
  (graph.centroids.rowwise() - centroid).rowwise().squaredNorm().maxCoeff(&result);
  return static_cast<std::size_t>(result);
}

// Chooses centers by farthest-point sampling with shortest paths on the graph. Each component has
// at least one, even if there are more components than `number`. `lengths`: one per edge.
inline Patches farthest_point_patches(const Face_graph& graph, std::vector<double> lengths,
                                      const std::size_t number, const std::size_t first)
{
  Patches result;
  Nearest_sources sources(graph, std::move(lengths));
  for(std::size_t center = first;;)
  {
    sources.insert(center, result.size());
    result.centers.push_back(center);
    sources.update();
    const std::vector<double>& distances = sources.distances();
    const auto farthest = std::max_element(distances.begin(), distances.end());
    if(*farthest <= 0 || (result.size() >= number && std::isfinite(*farthest)))
      break;
    center = static_cast<std::size_t>(farthest - distances.begin());
  }
  result.patch_of_face = sources.labels();
  return result;
}

// Means over patches of values of faces, weighted by areas.
template <class Matrix>
Matrix patch_means(const Face_graph& graph, const Patches& patches, const Matrix& values,
                   const Eigen::VectorXd& patch_areas)
{
  Matrix result = Matrix::Zero(patch_areas.size(), values.cols());
  for(std::size_t f = 0; f < graph.number_of_faces(); ++f)
  {
    const auto row = static_cast<Eigen::Index>(f);
    result.row(static_cast<Eigen::Index>(patches.patch_of_face[f]))
      += graph.areas[row] * values.row(row);
  }
  return patch_areas.cwiseInverse().asDiagonal() * result;
}

// Areas of the patches; positive, even if no face of a patch has an area.
inline Eigen::VectorXd patch_areas(const Face_graph& graph, const Patches& patches)
{
  constexpr double least = 1e-12; // of the surface
  Eigen::VectorXd result
    = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(patches.size()), least);
  for(std::size_t f = 0; f < graph.number_of_faces(); ++f)
    result[static_cast<Eigen::Index>(patches.patch_of_face[f])]
      += graph.areas[static_cast<Eigen::Index>(f)];
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_PATCHES_H
