// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_LABEL_PATCHES_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_LABEL_PATCHES_H

#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Labels triangles connected by twins, from 0 in the order of the first triangles, and traverses
// each patch breadth first; label_components() does not traverse. Side 3t+k of triangle t has the
// twin `twins[3t+k]`, or Corner_table::NONE.
//
// Calls on_twin(side, is_new) for each side with a twin, where is_new tells whether the triangle of
// the twin is visited for the first time; on_twin may separate twins. Then calls
// on_patch(triangles), in the order of the traversal.
template <class On_twin, class On_patch>
std::vector<std::size_t> label_patches(const std::vector<Corner_table::Index>& twins,
                                       const On_twin& on_twin, const On_patch& on_patch)
{
  constexpr auto none = Corner_table::NONE;
  std::vector<std::size_t> result(twins.size() / 3, none);
  std::vector<std::size_t> patch; // triangles; before `done`: neighbors visited
  std::size_t label = 0;
  for(std::size_t seed = 0; seed < result.size(); ++seed)
  {
    if(result[seed] != none)
      continue;
    patch.assign(1, seed);
    result[seed] = label;
    for(std::size_t done = 0; done < patch.size(); ++done)
      for(std::size_t side = 3 * patch[done], end = side + 3; side < end; ++side)
      {
        if(twins[side] == none)
          continue;
        const std::size_t neighbor = twins[side] / 3;
        const bool is_new = result[neighbor] == none;
        on_twin(side, is_new);
        if(!is_new)
          continue;
        result[neighbor] = label;
        patch.push_back(neighbor);
      }
    on_patch(patch);
    ++label;
  }
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_LABEL_PATCHES_H
