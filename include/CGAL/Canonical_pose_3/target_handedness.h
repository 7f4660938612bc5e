// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TARGET_HANDEDNESS_H
#define CGAL_CANONICAL_POSE_3_TARGET_HANDEDNESS_H

#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief tells whether a target has the handedness of the canonical pose, or its mirror image has.

Distances do not distinguish a target from its mirror image. The choice must be the same for all
poses of a shape, so it must not depend on the pose, unlike the energy of the registration, which
moreover differs by little. Two dimensionless numbers depend on the target only and change their
sign under reflection. Which of them decides is determined by their ratio: for shapes such as
quadrupeds, whose target is inside out if it is mirrored, the volume; for shapes such as humans,
whose target is twisted, the chirality. This is a guess for some first targets, which depend on the
pose; `registered_pose()` decides after the rounds.

\sa `target_handedness()`
*/
struct Target_handedness_3
{
  /// the volume enclosed by the surface in the target, relative to that in the input; 0 if the
  /// volume of the input is at most \f$ 10^{-6} A^{3/2} \f$, where \f$ A \f$ is its area, or within
  /// the error of rounding its coordinates: a flat sheet has no inside (a closed sheet of paper
  /// has, with
  /// \f$ 1.4 \cdot 10^{-4} A^{3/2} \f$).
  double volume_ratio = 0;

  /// the third moment \f$ \sum m_i x_i y_i z_i \f$ along the principal axes of the target, the
  /// longest first, divided by the product of the standard deviations.
  double chirality = 0;

  /// returns whether the chirality decides: it is larger than a multiple of the square of the
  /// volume ratio.
  bool is_decided_by_chirality() const
  {
    return std::abs(chirality) > CHIRALITY_PER_SQUARED_VOLUME * volume_ratio * volume_ratio;
  }

  /// returns whether the mirror image has the handedness of the canonical pose.
  bool is_mirror_image() const
  {
    return (is_decided_by_chirality() ? chirality : volume_ratio) < 0;
  }

  /// returns whether the choice is safe: the number that decides is not close to 0, and the other
  /// one agrees, or their ratio is not close to the limit. If not, and the target is not its own
  /// mirror image, as that of a bar, other poses of the shape may have the other handedness; see
  /// `align_handedness()`.
  bool is_certain() const
  {
    const double squared_volume = volume_ratio * volume_ratio;
    if(is_decided_by_chirality())
      return std::abs(chirality) > LEAST_CHIRALITY
             && (chirality * volume_ratio >= 0
                 || std::abs(chirality) > MARGIN * CHIRALITY_PER_SQUARED_VOLUME * squared_volume);
    return std::abs(volume_ratio) > LEAST_VOLUME
           && (chirality * volume_ratio >= 0
               || MARGIN * std::abs(chirality) < CHIRALITY_PER_SQUARED_VOLUME * squared_volume);
  }

private:
  static constexpr double CHIRALITY_PER_SQUARED_VOLUME = 0.45, MARGIN = 1.2, LEAST_CHIRALITY = 0.02,
                          LEAST_VOLUME = 0.3;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief measures the handedness of a target.

The volume of an open surface is that of the cone over it, with the mean of all points as apex.

\param target \f$ n \times 3 \f$, target of each vertex.
\param points \f$ n \times 3 \f$, points of the input.
\param triangles triples of rows, oriented.
\param weights \f$ n \f$ nonnegative weights, for instance `vertex_area_shares()`.

Target and input may be in any unit, the same for both.

\pre The numbers of rows agree, all coordinates are finite, and the sum of the weights is positive.

\throws std::invalid_argument if a triangle has an invalid row.

<em>Complexity:</em> linear.

\sa `align_target()`
\sa `align_handedness()`
*/
Target_handedness_3 target_handedness(Point_matrix target, Point_matrix points,
                                      const std::vector<std::array<std::size_t, 3>>& triangles,
                                      const Eigen::VectorXd& weights);

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns `target_handedness()` for a target of the vertices of a triangle mesh, weighted by
`vertex_area_shares()`.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param target \f$ n \times 3 \f$, target of each vertex.
\param tmesh the mesh.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`; instead of them, a
       point map.
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Target_handedness_3 target_handedness(const Point_matrix& target, const TriangleMesh& tmesh,
                                      const NamedParameters& np = parameters::default_values())
{
  const Point_matrix points = internal::points_of_parameters(tmesh, np);
  const auto triangles = internal::index_triangles(tmesh);
  return target_handedness(target, points, triangles, vertex_area_shares(points, triangles));
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TARGET_HANDEDNESS_H
