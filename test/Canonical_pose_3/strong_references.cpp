// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A program's own references to functions that the package uses if they exist: see test_symbols.cmake.

#include "engine/support/state_of_the_process.h"

extern "C" {
int openblas_get_num_threads(void);
void openblas_set_num_threads(int);
int omp_get_max_active_levels(void);
void omp_set_max_active_levels(int);
}

int (*get_threads)(void) = openblas_get_num_threads;
void (*set_threads)(int) = openblas_set_num_threads;
int (*get_levels)(void) = omp_get_max_active_levels;
void (*set_levels)(int) = omp_set_max_active_levels;

// Uses those of the package, too.
void use_the_package()
{
  const CGAL::Canonical_pose_3::internal::Single_threaded_blas blas;
  const CGAL::Canonical_pose_3::internal::Openmp_off openmp;
}
