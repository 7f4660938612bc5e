// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SEGMENTATION_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_SEGMENTATION_OPTIONS_H

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of segmentations.

\sa `consensus_segmentation()`, `sweep_segmentation()`, `k_means_segmentation()`
*/
struct Segmentation_options
{
  /// the number of parts. Each connected component has at least one; there are at most as many as
  /// faces, and fewer if they would be specks. 0: determined automatically.
  std::size_t number_of_parts = 0;

  /// the seed of the votes of `consensus_segmentation()` and of the centers of
  /// `k_means_segmentation()`.
  unsigned int random_seed = 0;

  /// maximum number of threads; 0 for no limit. The result does not depend on it.
  int number_of_threads = 0;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SEGMENTATION_OPTIONS_H
