// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_MATCH_POSE_ROTATIONS_H
#define CANONICAL_POSE_3_ENGINE_MATCH_POSE_ROTATIONS_H

#include "Matchable_data.h"

#include <Eigen/Core>

#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Brings a pose near another one.
struct Pose_rotation
{
  Eigen::Matrix3d matrix; // for rows: point * matrix
  double distance;        // mean of nearest points, both ways
};

// Those that bring the poses nearest to each other, from all that bring principal axes of similar lengths onto each other; the
// best first.
std::vector<Pose_rotation> pose_rotations(const Matchable_data& a, const Matchable_data& b);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_MATCH_POSE_ROTATIONS_H
