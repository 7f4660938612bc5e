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

#include <boost/preprocessor/cat.hpp>

// The libraries that this translation unit is compiled with name the inline namespace that everything lies
// in: functions that differ have different symbols, so that parts of a program may be configured differently.
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
               BOOST_PP_CAT(CGAL_CANONICAL_POSE_3_TETGEN, CGAL_CANONICAL_POSE_3_MESH_3))

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_CONFIGURATION_H
