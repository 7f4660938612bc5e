// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_UNFOLDING_H
#define CGAL_CANONICAL_POSE_3_UNFOLDING_H

#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the parameter of the unfolding of a body, which requires no target.

The vertices of the surface are moved away from each other
\cgalCite{cgal:canonical-sk-dpmun-16}. The sum of the squared distances over all pairs of vertices is
proportional to the sum of the squared distances to the centroid, so moving all vertices away from
the centroid has the same effect, with one term per vertex. The distances are not squared: then the
growth is bounded for any weight, and ends of limbs are stretched less.

\sa `Tetrahedral_arap_registrar_3::set_unfolding()`, `unfolded_target()`
*/
struct Unfolding
{
  /// \f$ \mu \f$, weight of the mean distance to the centroid. From \f$ 10^{-9} \f$ to
  /// \f$ 10^9 \f$. A thin straight bar becomes longer by the factor \f$ 1 + \mu / (8 \ell^2) \f$.
  /// Without constraints, only the ratio \f$ \mu / \ell^2 \f$ matters.
  double weight = 0.5;

  /// \throws std::invalid_argument if the weight is out of range.
  void check() const
  {
    internal::require_in_range("unfolding.weight", weight, Registration_options::SMALLEST_WEIGHT,
                               Registration_options::LARGEST_WEIGHT);
  }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_UNFOLDING_H
