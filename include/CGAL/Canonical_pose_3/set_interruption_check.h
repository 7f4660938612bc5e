// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SET_INTERRUPTION_CHECK_H
#define CGAL_CANONICAL_POSE_3_SET_INTERRUPTION_CHECK_H

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief sets a function that the loops of the package call, in all threads that work for them, so that it can
end them by an exception: for instance if somebody has asked for that.

The exception passes through the function of the package that was called, which has no result. Classes should not be
used any more after one of their functions that is not `const` was ended in this way. The function is called many times
per second, but not while a single source is processed by `Exact_geodesics_3`, or a matrix is factored.

\param check what is called, in the whole program; null, as in the beginning, for nothing. It must be fast, and several
       threads may call it at the same time.

\sa `Registration_visitor`, which can end a registration with a result
*/
void set_interruption_check(void (*check)());

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SET_INTERRUPTION_CHECK_H
