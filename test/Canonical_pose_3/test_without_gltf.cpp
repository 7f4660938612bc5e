// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A build without tinygltf says so; whatever the build of this test has, this is linked with the
// readers and writers of such a build.

#include "formats/Mesh_file.h"
#include "formats/Shown_surface.h"
#include "formats/readers.h"

#include <gtest/gtest.h>

#include "matchers.h"

#include <sstream>
#include <stdexcept>

namespace test_without_gltf {

using namespace Canonical_pose_tool;

TEST(Without_gltf, is_refused_by_name)
{
  EXPECT_FALSE(is_gltf_available());
  for(const char* const name : {"a.glb", "a.gltf", "a.GLB"})
    EXPECT_THROW_WITH(format_of(name), std::invalid_argument,
                      std::string("'") + name + "' is glTF, but this program was built without it");
  EXPECT_THROW_WITH(read_mesh_file("a.glb"), std::invalid_argument, "built without it");
  std::ostringstream out;
  EXPECT_THROW_WITH(write_glb(out, Shown_surface()), std::invalid_argument, "built without glTF");
}

} // namespace test_without_gltf
