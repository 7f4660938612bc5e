// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_VIEW_DESCRIPTOR_3_H
#define CGAL_CANONICAL_POSE_3_VIEW_DESCRIPTOR_3_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {

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
  static std::size_t size() { return NUMBER_OF_VIEWS * NUMBER_OF_MOMENTS; }

  /*!
  describes a shape.

  \param points \f$ n \times 3 \f$, positions.
  \param polygons sequences of rows of `points`.

  \throws std::invalid_argument if a coordinate is not finite, a polygon has an invalid row, or no face
          has an area.

  <em>Complexity:</em> \f$ O(n \log n) \f$.
  */
  Eigen::VectorXd operator()(const Point_matrix& points, const Face_list& polygons) const;

  /// returns the shape distances of `query` to the columns of `others`: sums of absolute differences, the
  /// least one over the 48 positions.
  static Eigen::VectorXd distances(const Eigen::VectorXd& query,
                                   const Eigen::Ref<const Eigen::MatrixXd>& others);

private:
  static constexpr Eigen::Index NUMBER_OF_VIEWS = 26, NUMBER_OF_MOMENTS = 64; // of each view
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_VIEW_DESCRIPTOR_3_H
