// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The implementation of tinygltf, see CMakeLists.txt.

#include <nlohmann/json.hpp>

#include <fstream> // missing in the header

#define TINYGLTF_IMPLEMENTATION
#include <tiny_gltf.h>
