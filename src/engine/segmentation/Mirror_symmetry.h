// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_MIRROR_SYMMETRY_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_MIRROR_SYMMETRY_H

#include "Face_graph.h"
#include "Patch_graph.h"
#include "Patches.h"
#include "../support/plane_normals.h"

#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/internal/support/rotation_by_traits.h>
#include <CGAL/Canonical_pose_3/internal/support/weighted_product.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Deformation_Eigen_closest_rotation_traits_3.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The mirror symmetry of a shape, such as that of the left and the right of an animal, as a map of its
// patches. A reflection is fitted by iterated closest points (Besl and McKay 1992), from several
// planes. Since limbs may be bent, each patch is then mapped to one that has similar distances along
// the surface to the first patches, too.
class Mirror_symmetry
{
public:
  Mirror_symmetry(const Face_graph& graph, const Patches& patches)
    : m_areas(patch_areas(graph, patches)), m_features(m_areas.size(), 6)
  {
    const Row_vectors centers = patch_means(graph, patches, graph.centroids, m_areas);
    const Principal_axes frame(centers, m_areas);
    m_features.leftCols<3>() = centers.rowwise() - frame.centroid;
    m_features.rightCols<3>()
      = WEIGHT_OF_NORMALS
        * patch_means(graph, patches, graph.normals, m_areas).rowwise().normalized();
    m_distances = distances_along_surface(graph, patches);

    const std::vector<Eigen::Vector3d> normals = plane_normals(frame.axes);
    std::vector<Images> images(normals.size());
    for_each_index(normals.size(), [&](const std::size_t i) { images[i] = fit(normals[i]); });
    double least = std::numeric_limits<double>::infinity();
    for(Images& map : images)
    {
      const double value = mean_square(m_distances - mirrored(m_distances, map));
      if(value < least)
      {
        least = value;
        m_images = std::move(map);
      }
    }
    const double all = mean_square(m_distances);
    m_distortion = all > 0 ? std::sqrt(least / all) : std::numeric_limits<double>::infinity();
  }

  // The root mean square of the differences of distances between patches and between their images,
  // relative to that of the distances. Not 0 even for a symmetric shape: its patches are not symmetric, and
  // are mapped as a whole.
  double distortion() const { return m_distortion; }

  // The values for the images of two patches instead of those for the patches.
  Eigen::MatrixXd mirrored(const Eigen::MatrixXd& values) const
  {
    return mirrored(values, m_images);
  }

private:
  using Images = std::vector<Eigen::Index>;
  static constexpr double WEIGHT_OF_NORMALS = .1;

  static Eigen::Index image(const Images& images, const Eigen::Index patch)
  {
    return images[static_cast<std::size_t>(patch)];
  }

  static Eigen::MatrixXd mirrored(const Eigen::MatrixXd& values, const Images& images)
  {
    Eigen::MatrixXd result(values.rows(), values.cols());
    for(Eigen::Index j = 0; j < values.cols(); ++j)
      for(Eigen::Index i = 0; i < values.rows(); ++i)
        result(i, j) = values(image(images, i), image(images, j));
    return result;
  }

  double mean_square(const Eigen::MatrixXd& values) const
  {
    return m_areas.dot(values.cwiseAbs2() * m_areas);
  }

  // Along edges of the graph of patches (Floyd and Warshall). Patches that are not connected are about
  // as far from each other as a path is at most.
  Eigen::MatrixXd distances_along_surface(const Face_graph& graph, const Patches& patches) const
  {
    const Eigen::Index n = m_areas.size();
    const Patch_graph neighbors
      = patch_graph(graph, patches, {1, 0, 0}, Eigen::VectorXd::Zero(graph.areas.size()));
    double farthest = 0;
    for(const Patch_graph::Edge& edge : neighbors.edges)
      farthest += length(edge);
    Eigen::MatrixXd result = Eigen::MatrixXd::Constant(n, n, farthest);
    result.diagonal().setZero();
    for(const Patch_graph::Edge& edge : neighbors.edges)
    {
      const auto a = static_cast<Eigen::Index>(edge.a), b = static_cast<Eigen::Index>(edge.b);
      result(a, b) = result(b, a) = length(edge);
    }
    for(Eigen::Index k = 0; k < n; ++k)
      for(Eigen::Index j = 0; j < n; ++j)
        if(result(k, j) < farthest)
          result.col(j) = result.col(j).cwiseMin((result.col(k).array() + result(k, j)).matrix());
    return result;
  }

  double length(const Patch_graph::Edge& edge) const
  {
    return (m_features.row(static_cast<Eigen::Index>(edge.a)).head<3>()
            - m_features.row(static_cast<Eigen::Index>(edge.b)).head<3>())
      .norm();
  }

  Images fit(const Eigen::Vector3d& normal) const
  {
    constexpr int most_fits = 25, most_corrections = 6;
    constexpr Eigen::Index most_references = 24;
    const Eigen::Index n = m_areas.size(), references = (std::min)(n, most_references);
    Eigen::Matrix3d reflection = Eigen::Matrix3d::Identity() - 2 * normal * normal.transpose();
    Eigen::RowVector3d shift = Eigen::RowVector3d::Zero();
    Images result;
    for(int i = 0; i < most_fits; ++i)
    {
      Images images = closest_rows(reflected(reflection, shift), m_features);
      if(images == result)
        break;
      result = std::move(images);
      std::tie(reflection, shift) = best_reflection(result);
    }

    const double scale = 1 / std::sqrt(static_cast<double>(references));
    Eigen::MatrixXd moved(n, 6 + references), fixed(n, 6 + references);
    moved << reflected(reflection, shift), scale * m_distances.leftCols(references);
    fixed.leftCols<6>() = m_features;
    for(int i = 0; i < most_corrections; ++i)
    {
      for(Eigen::Index k = 0; k < references; ++k)
        fixed.col(6 + k) = scale * m_distances.col(image(result, k));
      Images images = closest_rows(moved, fixed);
      if(images == result)
        break;
      result = std::move(images);
    }
    return result;
  }

  Eigen::MatrixXd reflected(const Eigen::Matrix3d& reflection,
                            const Eigen::RowVector3d& shift) const
  {
    Eigen::MatrixXd result(m_features.rows(), 6);
    result << (m_features.leftCols<3>() * reflection.transpose()).rowwise() + shift,
      m_features.rightCols<3>() * reflection.transpose();
    return result;
  }

  // For each row of `a`, the row of `b` that is closest.
  static Images closest_rows(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
  {
    // Columns of the table belong to rows of a; up to a constant for each of them.
    Eigen::MatrixXd table = -2 * b * a.transpose();
    table.colwise() += b.rowwise().squaredNorm();
    Images result(static_cast<std::size_t>(a.rows()));
    for(Eigen::Index i = 0; i < a.rows(); ++i)
      table.col(i).minCoeff(&result[static_cast<std::size_t>(i)]);
    return result;
  }

  // The reflection and the shift that bring the centers of patches nearest to those of their images:
  // the reflection closest to a matrix is minus the rotation closest to its negative.
  std::pair<Eigen::Matrix3d, Eigen::RowVector3d> best_reflection(const Images& images) const
  {
    const Point_matrix centers = m_features.leftCols<3>();
    Point_matrix targets(centers.rows(), 3);
    for(Eigen::Index i = 0; i < targets.rows(); ++i)
      targets.row(i) = centers.row(image(images, i));
    const Eigen::VectorXd shares = m_areas / m_areas.sum();
    const Eigen::RowVector3d center = shares.transpose() * centers;
    const Eigen::RowVector3d target_center = shares.transpose() * targets;
    const Eigen::Matrix3d covariance
      = weighted_product(targets.rowwise() - target_center, shares, centers.rowwise() - center);
    const double size = covariance.cwiseAbs().maxCoeff();
    const Eigen::Matrix3d reflection
      = -rotation_by_traits<Deformation_Eigen_closest_rotation_traits_3>(-covariance
                                                                         / (size > 0 ? size : 1));
    return {reflection, target_center - center * reflection.transpose()};
  }

  const Eigen::VectorXd m_areas;
  Eigen::MatrixXd m_features;  // of patches: center, and weighted mean normal
  Eigen::MatrixXd m_distances; // of patches along the surface
  Images m_images;
  double m_distortion;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_MIRROR_SYMMETRY_H
