// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_ALIGN_TARGET_H
#define CGAL_CANONICAL_POSE_3_ALIGN_TARGET_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief aligns a target rigidly with the corresponding points, after a reflection if requested, and
returns it.

Translation and rotation minimize \f$ \sum_i m_i |R x_i + t - p_i|^2 \f$
\cgalCite{cgal:canonical-k-sbrrsv-76}. The target is never scaled: its scale is determined by the
geodesic distances, so it does not depend on the pose. The signs of the axes of a multidimensional
scaling are arbitrary; `target_handedness()` determines whether to mirror the target.

\param target \f$ n \times 3 \f$, target \f$ x_i \f$ of each point.
\param points \f$ n \times 3 \f$, points \f$ p_i \f$.
\param weights \f$ n \f$ nonnegative weights \f$ m_i \f$, for instance `vertex_area_shares()`.
\param mirrored whether the target is mirrored before it is moved.

\pre The numbers of rows agree, and the sum of the weights is positive.

<em>Complexity:</em> linear.
*/
Point_matrix align_target(const Point_matrix& target, const Point_matrix& points,
                          const Eigen::VectorXd& weights, bool mirrored = false);

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_ALIGN_TARGET_H
