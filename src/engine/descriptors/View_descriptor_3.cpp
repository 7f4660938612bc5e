// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Depth_image.h"
#include "Zernike_basis.h"
#include "described_surface.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/View_descriptor_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline std::vector<Eigen::Vector3i> sides_of_cube()
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
inline std::vector<std::vector<Eigen::Index>> positions_of_cube()
{
  const std::vector<Eigen::Vector3i> all = sides_of_cube();
  std::vector<std::vector<Eigen::Index>> result;
  std::array<int, 3> axes = {0, 1, 2};
  do
    for(int signs = 0; signs < 8; ++signs)
    {
      result.emplace_back(all.size());
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
inline Point_matrix in_frame(Point_matrix points, const std::vector<Index_triangle>& triangles)
{
  normalize(points);
  const Principal_axes frame(points, vertex_area_shares(points, triangles));
  points = (points.rowwise() - frame.centroid) * frame.axes;
  return points / std::sqrt(points.rowwise().squaredNorm().maxCoeff());
}

} // namespace internal

Eigen::VectorXd View_descriptor_3::operator()(const Point_matrix& points,
                                              const Face_list& polygons) const
{
  constexpr Eigen::Index width = 64;
  static_assert(NUMBER_OF_MOMENTS == internal::Zernike_basis::SIZE, "");
  static const internal::Zernike_basis basis(width);
  const Repaired_surface_3 surface = internal::described_surface(points, polygons);
  const Point_matrix framed = internal::in_frame(surface.points, surface.triangles);
  Eigen::MatrixXd images(width * width, NUMBER_OF_VIEWS);
  const std::vector<Eigen::Vector3i> sides = internal::sides_of_cube();
  internal::for_each_index(sides.size(), [&](const std::size_t i) {
    images.col(static_cast<Eigen::Index>(i)) = internal::depth_image(
      framed, surface.triangles, sides[i].cast<double>().normalized(), width);
  });
  return basis.magnitudes(images).reshaped();
}

Eigen::VectorXd View_descriptor_3::distances(const Eigen::VectorXd& query,
                                             const Eigen::Ref<const Eigen::MatrixXd>& others)
{
  constexpr Eigen::Index size = NUMBER_OF_MOMENTS;
  const std::vector<std::vector<Eigen::Index>> positions = internal::positions_of_cube();
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

} // namespace Canonical_pose_3
} // namespace CGAL
