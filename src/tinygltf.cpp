// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// The implementation of tinygltf, see CMakeLists.txt.

#include <nlohmann/json.hpp>

#include <fstream> // missing in the header

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
