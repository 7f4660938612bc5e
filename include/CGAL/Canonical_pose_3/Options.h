// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_OPTIONS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds what `canonical_pose_3()` computes on the way to the pose.

What is there when the call begins is used, what is not is computed and left here. Rows are the
vertices in the order of `vertices(tmesh)`; for a tetrahedral complex those of its boundary, in the
order of `extract_boundary()`.
*/
struct Intermediate_results
{
  /// landmarks and distances to them.
  std::optional<Landmark_fields_3> landmark_fields;

  /// \f$ n \times 3 \f$, the target in its final place. One that is handed in is neither aligned
  /// nor reflected.
  std::optional<Point_matrix> target;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the weights as the paper prints them, see `Registration_options::set_paper_weights()`.
*/
struct Paper_weights
{
  double alpha = 100; ///< \f$ \alpha \f$, in the inverse of the mesh's unit of length.
  double beta = 10;   ///< \f$ \beta \f$.
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the knobs of `canonical_pose_3()`.
*/
struct Options
{
  /// model of `GeodesicDistances_3` to measure with.
  enum class Geodesics { HEAT, EXACT };

  /// model of `MdsKernel` of the target.
  enum class Kernel { CLASSICAL, GAUSSIAN, UNCENTERED_GAUSSIAN };

  /// linear solver: `AUTOMATIC` is CHOLMOD where the package was configured with it, else Eigen.
  enum class Solver { AUTOMATIC, EIGEN, CHOLMOD };

  /// the distances.
  Geodesics geodesics = Geodesics::HEAT;

  /// number of landmarks, at least 1.
  std::size_t number_of_landmarks = 80;

  /// 0: the first landmark is `extremal_point()`; otherwise it is drawn with this seed. Nothing
  /// else is random.
  unsigned int random_seed = 0;

  /// the kernel.
  Kernel kernel = Kernel::CLASSICAL;

  /// the knobs of the registration.
  Registration_options registration;

  /// if set, these replace detail length, Tikhonov weight and matching weights, and rotations are
  /// computed from the pose after one pass of fairing (or as many as `registration` says, if more),
  /// as the paper does.
  std::optional<Paper_weights> paper_weights;

  /// springs between vertices, by their places in `vertices(tmesh)` or among the vertices of the
  /// complex.
  std::vector<Spring_3> springs;

  /// the linear solver.
  Solver solver = Solver::AUTOMATIC;

  /// upper bound on the number of threads; 0 for none. The result does not depend on it.
  int number_of_threads = 0;

  /// if not null: what to use and where to leave what is computed.
  Intermediate_results* intermediate_results = nullptr;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_OPTIONS_H
