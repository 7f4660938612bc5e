// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_LIBRARY_CONFIGURATION_H
#define CGAL_CANONICAL_POSE_3_LIBRARY_CONFIGURATION_H

#include <optional>
#include <string>

/// the version of the headers.
#define CGAL_CANONICAL_POSE_3_VERSION "0.2.0"

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief tells with what the library was compiled.

\sa `library_configuration()`
*/
struct Library_configuration
{
  std::string canonical_pose_3; ///< version of the package.
  std::string cgal;             ///< version of CGAL.
  std::string eigen;            ///< version of Eigen.
  std::string boost;            ///< version of Boost.
  std::string compiler;         ///< name and version of the compiler.
  std::optional<std::string> cholmod; ///< version of CHOLMOD; nothing without it.
  std::optional<std::string> tbb;     ///< version of TBB; nothing without it.
  std::optional<std::string> spectra; ///< version of Spectra; nothing without it.
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns with what the library was compiled: versions, and whether there are a fast sparse solver (CHOLMOD),
threads (TBB), and spectra of surfaces (Spectra).

\sa `call_with_threads()`
*/
Library_configuration library_configuration();

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LIBRARY_CONFIGURATION_H
