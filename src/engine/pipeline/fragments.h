// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_FRAGMENTS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_FRAGMENTS_H

#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Parts of an input that touch at vertices count as one if all but the largest are fragments, that
// is, at most this share of it in total.
inline constexpr double SHARE_OF_FRAGMENTS = 0.05;

// For each part, by decreasing size: the part of which it is a fragment, or itself.
// `vertices_of(part, f)` calls f for all vertices of a part, which are less than
// `number_of_vertices`.
template <class VerticesOf>
std::vector<std::size_t> owners_of_fragments(const std::vector<double>& sizes,
                                             const std::size_t number_of_vertices,
                                             const VerticesOf& vertices_of)
{
  const std::size_t n = sizes.size();
  Disjoint_sets groups(n);
  std::vector<std::size_t> part_of_vertex(number_of_vertices, n);
  for(std::size_t p = 0; p < n; ++p)
    vertices_of(p, [&](const std::size_t v) {
      if(part_of_vertex[v] == n)
        part_of_vertex[v] = p;
      groups.unite(p, part_of_vertex[v]);
    });

  const Component_labels labels = label_components(groups);
  std::vector<std::size_t> largest;
  std::vector<double> size_of_rest(n, 0.);
  for(std::size_t p = 0; p < n; ++p)
  {
    largest.push_back(labels.first_items[labels.of_items[p]]);
    if(largest[p] != p)
      size_of_rest[largest[p]] += sizes[p];
  }
  for(std::size_t p = 0; p < n; ++p)
    if(size_of_rest[largest[p]] > SHARE_OF_FRAGMENTS * sizes[largest[p]])
      largest[p] = p;
  return largest;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_FRAGMENTS_H
