// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A procedural shape, modified by the bytes, is passed to repair and the one call.

#include "Mutated_soup.h"
#include "checks.h"
#include "poses.h"

#include <cstddef>
#include <cstdint>

using namespace Canonical_pose_fuzz;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  Byte_source bytes(data, size);
  const Mutated_soup soup(bytes);
  check_surface(to_matrix(soup.points), soup.polygons);
  checked_pose(soup.points, soup.polygons, read_options(bytes, soup.points.size()));
  return 0;
}
