// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_STANCE_EXTREMITIES_H
#define CANONICAL_POSE_3_ENGINE_STANCE_EXTREMITIES_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A local maximum of the mean distance to all points of a surface, such as the tip of a limb or of an ear.
struct Extremity
{
  std::size_t vertex;
  double prominence; // relative to the range of the mean distance
};

// The extremities, the most prominent first. The prominence is that of persistent homology: by how much the mean
// distance decreases on the way to a higher maximum.
std::vector<Extremity> extremities(const Surface_component_3& surface,
                                   const Landmark_fields_3& fields);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_STANCE_EXTREMITIES_H
