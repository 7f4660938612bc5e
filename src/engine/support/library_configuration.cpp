// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/library_configuration.h>

#include <CGAL/version.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#include <cholmod.h>
#endif
#ifdef CGAL_CANONICAL_POSE_3_USE_SPECTRA
#include <Spectra/Util/Version.h>
#endif
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/version.h>
#endif

#include <Eigen/Core>

#include <boost/version.hpp>

#include <string>

namespace CGAL {
namespace Canonical_pose_3 {

Library_configuration library_configuration()
{
  const auto dotted = [](const int major, const int minor, const int patch) {
    return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
  };
  Library_configuration result;
  result.canonical_pose_3 = CGAL_CANONICAL_POSE_3_VERSION;
  result.cgal = CGAL_VERSION_STR;
  result.eigen = dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
  result.boost = dotted(BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000, BOOST_VERSION % 100);
  result.compiler = __VERSION__;
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
  result.cholmod = dotted(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION);
#endif
#ifdef CGAL_LINKED_WITH_TBB
  result.tbb = TBB_VERSION_STRING;
#endif
#ifdef CGAL_CANONICAL_POSE_3_USE_SPECTRA
  result.spectra = dotted(SPECTRA_MAJOR_VERSION, SPECTRA_MINOR_VERSION, SPECTRA_PATCH_VERSION);
#endif
  return result;
}

namespace internal {

void CGAL_CANONICAL_POSE_3_ALIGNMENT() {}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
