// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_VIEW_DESCRIPTOR_3_H
#define CGAL_CANONICAL_POSE_3_VIEW_DESCRIPTOR_3_H

#include <CGAL/Canonical_pose_3/internal/descriptors/Depth_image.h>
#include <CGAL/Canonical_pose_3/internal/descriptors/Zernike_basis.h>
#include <CGAL/Canonical_pose_3/internal/descriptors/described_surface.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief describes a shape by pictures of it from 26 sides.

The shape is moved to its principal axes, by area, and scaled to the unit ball. Of each of 26 depth images, from the
directions of the faces, edges and vertices of a cube, it contains the absolute values of 64 Zernike moments, which do
not change when an image is rotated (as the light field descriptor of D. Chen et al., "On visual similarity based 3D model
retrieval", 2003). Two shapes are compared in the best of the 48 positions in which their axes coincide. It depends on
the pose: for a descriptor of the shape, describe its canonical pose.

\cgalModels `ShapeDescriptor_3`

\sa `shape_descriptor()`, `Descriptor_index_3`
*/
class View_descriptor_3
{
public:
  /// returns the name, under which values are stored.
  static std::string name() { return "views"; }

  /// returns the version: values of different versions cannot be compared.
  static int version() { return 1; }

  /// returns the number of values.
  static std::size_t size() { return NUMBER_OF_VIEWS * internal::Zernike_basis::SIZE; }

  /*!
  describes a shape.

  \param points \f$ n \times 3 \f$, positions.
  \param polygons sequences of rows of `points`.

  \throws std::invalid_argument if a coordinate is not finite, a polygon has an invalid row, or no face
          has an area.

  <em>Complexity:</em> \f$ O(n \log n) \f$.
  */
  Eigen::VectorXd operator()(const Point_matrix& points,
                             const std::vector<std::vector<std::size_t>>& polygons) const
  {
    constexpr Eigen::Index width = 64;
    static const internal::Zernike_basis basis(width);
    const Repaired_surface_3 surface = internal::described_surface(points, polygons);
    const Point_matrix framed = in_frame(surface.points, surface.triangles);
    Eigen::MatrixXd images(width * width, NUMBER_OF_VIEWS);
    const std::vector<Eigen::Vector3i> sides = View_descriptor_3::sides();
    internal::for_each_index(sides.size(), [&](const std::size_t i) {
      images.col(static_cast<Eigen::Index>(i)) = internal::depth_image(
        framed, surface.triangles, sides[i].cast<double>().normalized(), width);
    });
    return basis.magnitudes(images).reshaped();
  }

  /// returns the distances of `query` to the columns of `others`: sums of absolute differences, the
  /// least one over the 48 positions.
  static Eigen::VectorXd distances(const Eigen::VectorXd& query,
                                   const Eigen::Ref<const Eigen::MatrixXd>& others)
  {
    constexpr Eigen::Index size = internal::Zernike_basis::SIZE;
    const std::vector<std::array<Eigen::Index, NUMBER_OF_VIEWS>> positions
      = View_descriptor_3::positions();
    Eigen::MatrixXd turned(query.size(), static_cast<Eigen::Index>(positions.size()));
    for(std::size_t i = 0; i < positions.size(); ++i)
      for(Eigen::Index view = 0; view < NUMBER_OF_VIEWS; ++view)
        turned.col(static_cast<Eigen::Index>(i)).segment(view * size, size)
          = query.segment(positions[i][static_cast<std::size_t>(view)] * size, size);
    Eigen::VectorXd result(others.cols());
    internal::for_each_index(static_cast<std::size_t>(others.cols()), [&](const std::size_t i) {
      const auto j = static_cast<Eigen::Index>(i);
      result[j] = (turned.colwise() - others.col(j)).cwiseAbs().colwise().sum().minCoeff();
    });
    return result;
  }

private:
  static constexpr Eigen::Index NUMBER_OF_VIEWS = 26;

  static std::vector<Eigen::Vector3i> sides()
  {
    std::vector<Eigen::Vector3i> result;
    for(int x = -1; x <= 1; ++x)
      for(int y = -1; y <= 1; ++y)
        for(int z = -1; z <= 1; ++z)
          if(x != 0 || y != 0 || z != 0)
            result.emplace_back(x, y, z);
    return result;
  }

  // For each symmetry of the cube, the side to which each side is moved.
  static std::vector<std::array<Eigen::Index, NUMBER_OF_VIEWS>> positions()
  {
    const std::vector<Eigen::Vector3i> all = sides();
    std::vector<std::array<Eigen::Index, NUMBER_OF_VIEWS>> result;
    std::array<int, 3> axes = {0, 1, 2};
    do
      for(int signs = 0; signs < 8; ++signs)
      {
        result.emplace_back();
        for(std::size_t i = 0; i < all.size(); ++i)
        {
          Eigen::Vector3i moved;
          for(int k = 0; k < 3; ++k)
            moved[k] = ((signs >> k) & 1 ? -1 : 1) * all[i][axes[static_cast<std::size_t>(k)]];
          result.back()[i] = std::find(all.begin(), all.end(), moved) - all.begin();
        }
      }
    while(std::next_permutation(axes.begin(), axes.end()));
    return result;
  }

  // The points by principal axes of the surface, in the unit ball around its centroid.
  static Point_matrix in_frame(Point_matrix points,
                               const std::vector<internal::Index_triangle>& triangles)
  {
    internal::normalize(points);
    const internal::Principal_axes frame(points, vertex_area_shares(points, triangles));
    points = (points.rowwise() - frame.centroid) * frame.axes;
    return points / std::sqrt(points.rowwise().squaredNorm().maxCoeff());
  }
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_VIEW_DESCRIPTOR_3_H
