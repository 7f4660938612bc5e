// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SQUARED_DISTANCE_KERNEL_H
#define CGAL_CANONICAL_POSE_3_SQUARED_DISTANCE_KERNEL_H

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is the kernel of classical multidimensional scaling, \f$ k(r) = -r^2/2 \f$.

With centering, Euclidean distances become the Gram matrix of the points, so a point set in 3D is
recovered exactly from its distances \cgalCite{cgal:canonical-st-glmnd-02}.

\cgalModels `MdsKernel`
*/
struct Squared_distance_kernel
{
  /// returns \f$ -r^2/2 \f$ for the relative distance \f$ r = g/L \f$.
  double operator()(const double relative_distance) const
  {
    return -0.5 * relative_distance * relative_distance;
  }

  /// returns `true`.
  bool is_centered() const { return true; }

  /// returns `"classical"`.
  const char* name() const { return "classical"; }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SQUARED_DISTANCE_KERNEL_H
