// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CALL_WITH_THREADS_H
#define CGAL_CANONICAL_POSE_3_CALL_WITH_THREADS_H

#include <functional>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief calls a function in this thread; functions of the package that it calls use at most the given number of threads.

It is for what has no option of its own, such as descriptors and classes of distances; for the others, there is
`Options::number_of_threads`. It does not concern other threads of the program.

\param number_of_threads largest number; 0: as many as there are. Without TBB, there is one in any case.
\param function what is called. Its exceptions pass through.

\throws std::invalid_argument if the number is negative.

\sa `library_configuration()`
*/
void call_with_threads(int number_of_threads, const std::function<void()>& function);

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CALL_WITH_THREADS_H
