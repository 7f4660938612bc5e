// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MATCH_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_MATCH_OPTIONS_H

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of `match_surfaces()`.
*/
struct Match_options
{
  /// the largest number of eigenfunctions of the Laplacian by which points are compared, beside
  /// positions and relief. At least 4; both surfaces have at most `Matchable_surface_3::NUMBER_OF_FUNCTIONS`.
  std::size_t number_of_functions = 100;

  /// the weight of positions in the pose, relative to that of the functions, each in units of its residual.
  /// Positive, at most 1e6.
  double pose_weight = 1;

  /// the number of times that the pose of the first surface is registered to that of the second one, at the
  /// points that match. Nonnegative; 0 saves about a third of the time.
  int number_of_registrations = 3;

  /// pairs of a vertex of the first surface and one of the second one that match; each vertex in one pair.
  std::vector<std::pair<std::size_t, std::size_t>> landmarks;

  /// the maximum number of threads; 0: all processors. Results do not depend on it.
  int number_of_threads = 0;

  /*!
  checks the options for surfaces with these numbers of vertices.

  \throws std::invalid_argument if a landmark is no vertex or contradicts another one, or an option is out of
          range.
  */
  void check(std::size_t number_of_vertices, std::size_t number_of_vertices_of_other) const;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MATCH_OPTIONS_H
