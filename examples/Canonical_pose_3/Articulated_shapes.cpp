// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The shapes of the examples, compiled once: meshing them takes long to compile, and long to run unless it is optimized.

#include "Articulated_animal.h"
#include "Articulated_figure.h"

namespace Canonical_pose_examples {

template class Articulated_shape<detail::Person>;
template class Articulated_shape<detail::Quadruped>;

} // namespace Canonical_pose_examples
