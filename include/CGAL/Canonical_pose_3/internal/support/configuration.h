// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_CONFIGURATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_CONFIGURATION_H

#include <Eigen/Core>

#include <boost/preprocessor/cat.hpp>

// Inline namespaces are named after the libraries with which this translation unit is compiled, and
// after the alignment of Eigen's matrices, which depends on the target processor: different
// functions have different symbols, so parts of a program may be configured differently. Everything
// is in CGAL_CANONICAL_POSE_3_CONFIGURATION; everything that depends on the available bodies is in
// CGAL_CANONICAL_POSE_3_BODIES as well.
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
#define CGAL_CANONICAL_POSE_3_SOLVER with_cholmod
#else
#define CGAL_CANONICAL_POSE_3_SOLVER with_eigen
#endif

#ifdef CGAL_LINKED_WITH_TBB
#define CGAL_CANONICAL_POSE_3_THREADS _tbb
#else
#define CGAL_CANONICAL_POSE_3_THREADS _one_thread
#endif

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

#define CGAL_CANONICAL_POSE_3_CONFIGURATION                                                        \
  BOOST_PP_CAT(BOOST_PP_CAT(CGAL_CANONICAL_POSE_3_SOLVER, CGAL_CANONICAL_POSE_3_THREADS),          \
               BOOST_PP_CAT(_aligned_, EIGEN_MAX_ALIGN_BYTES))
#define CGAL_CANONICAL_POSE_3_BODIES                                                               \
  BOOST_PP_CAT(with_lattice,                                                                       \
               BOOST_PP_CAT(CGAL_CANONICAL_POSE_3_TETGEN, CGAL_CANONICAL_POSE_3_MESH_3))

// Functions that take long to compile are inline or, if CGAL_CANONICAL_POSE_3_COMPILED is defined,
// in the library Canonical_pose_3::compiled, whose source defines CGAL_CANONICAL_POSE_3_SOURCE.
#ifdef CGAL_CANONICAL_POSE_3_SOURCE
#define CGAL_CANONICAL_POSE_3_INLINE
#else
#define CGAL_CANONICAL_POSE_3_INLINE inline
#endif

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_CONFIGURATION_H
