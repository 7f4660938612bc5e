// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_CONFIGURATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_CONFIGURATION_H

#include <Eigen/Core>

#include <boost/preprocessor/cat.hpp>

// A program and the library must agree about the alignment of Eigen's matrices, which depends on the
// target processor: otherwise, linking fails, because this function does not exist.
#define CGAL_CANONICAL_POSE_3_ALIGNMENT                                                            \
  BOOST_PP_CAT(library_has_eigen_max_align_bytes_, EIGEN_MAX_ALIGN_BYTES)

// What depends on the bodies that a program links is in a namespace of their names, since parts of a
// program may link different ones.
#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
#define CGAL_CANONICAL_POSE_3_TETGEN _tetgen
#else
#define CGAL_CANONICAL_POSE_3_TETGEN
#endif

#ifdef CGAL_CANONICAL_POSE_3_USE_MESH_3
#define CGAL_CANONICAL_POSE_3_MESH_3 _mesh_3
#else
#define CGAL_CANONICAL_POSE_3_MESH_3
#endif

#define CGAL_CANONICAL_POSE_3_BODIES                                                               \
  BOOST_PP_CAT(with_lattice,                                                                       \
               BOOST_PP_CAT(CGAL_CANONICAL_POSE_3_TETGEN, CGAL_CANONICAL_POSE_3_MESH_3))

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

void CGAL_CANONICAL_POSE_3_ALIGNMENT();

namespace {
[[gnu::used]] void (*const alignment_of_the_library)() = CGAL_CANONICAL_POSE_3_ALIGNMENT;
} // namespace

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_CONFIGURATION_H
