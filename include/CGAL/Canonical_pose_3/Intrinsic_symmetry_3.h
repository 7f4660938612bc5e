// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTRINSIC_SYMMETRY_3_H
#define CGAL_CANONICAL_POSE_3_INTRINSIC_SYMMETRY_3_H

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a map of a surface to itself that changes distances along it little, such as the one between left and right.

\sa `intrinsic_symmetry()`
*/
struct Intrinsic_symmetry_3
{
  /// the image of each vertex of the coarse surface, among them.
  std::vector<std::size_t> images;

  /// how symmetric the surface is: the root mean square change of distances, relative to that of the distances.
  double distortion = 0;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTRINSIC_SYMMETRY_3_H
