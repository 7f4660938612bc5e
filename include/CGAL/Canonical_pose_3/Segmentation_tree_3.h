// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SEGMENTATION_TREE_3_H
#define CGAL_CANONICAL_POSE_3_SEGMENTATION_TREE_3_H

#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a hierarchy of the parts of a surface: parts of parts.

Segmentations of the same tree are nested: one part more divides a part of the segmentation before.
So the number of parts can be changed without another computation.

\sa `consensus_segmentation_tree()`, `sweep_segmentation_tree()`
*/
struct Segmentation_tree_3
{
  /// two nodes become one. The leaves have the numbers from 0 to `number_of_leaves - 1`; merge `i`
  /// creates node `number_of_leaves + i`.
  struct Merge
  {
    std::array<std::size_t, 2>
      nodes;     ///< the nodes, each of them a leaf or created by an earlier merge.
    double cost; ///< between 0 and 1; merges are sorted by increasing cost.
  };

  /// the leaf of each face, in the order of `faces(tmesh)` or of the polygons.
  std::vector<std::size_t> leaf_of_face;

  /// number of leaves, the smallest parts.
  std::size_t number_of_leaves = 0;

  /// the merges.
  std::vector<Merge> merges;

  /// the number of parts that was requested, or determined automatically.
  std::size_t number_of_parts = 0;

  /// returns the least number of parts, which is the number of connected components.
  std::size_t least_number_of_parts() const { return number_of_leaves - merges.size(); }

  /*!
  returns the part of each face, numbered from 0 in the order of the first faces.

  \param requested_number_of_parts the number of parts; if there are not as many leaves, or more
         connected components, the nearest possible number.

  \throws std::invalid_argument if a face names a leaf, or a merge a node, that does not exist, or
         there are as many merges as leaves.

  <em>Complexity:</em> linear in the number of faces.
  */
  std::vector<std::size_t> parts(const std::size_t requested_number_of_parts) const
  {
    if(merges.size() > number_of_leaves || (merges.size() == number_of_leaves && !merges.empty()))
      throw std::invalid_argument("there are " + std::to_string(merges.size()) + " merges of "
                                  + std::to_string(number_of_leaves) + " leaves");
    for(std::size_t f = 0; f < leaf_of_face.size(); ++f)
      if(leaf_of_face[f] >= number_of_leaves)
        throw std::invalid_argument("face " + std::to_string(f) + " is in leaf "
                                    + std::to_string(leaf_of_face[f]) + ", but there are "
                                    + std::to_string(number_of_leaves));
    const std::size_t number_of_merges
      = number_of_leaves
        - (std::min)((std::max)(requested_number_of_parts, least_number_of_parts()),
                     number_of_leaves);
    internal::Disjoint_sets nodes(number_of_leaves + number_of_merges);
    for(std::size_t i = 0; i < number_of_merges; ++i)
      for(const std::size_t node : merges[i].nodes)
      {
        if(node >= number_of_leaves + i)
          throw std::invalid_argument("merge " + std::to_string(i) + " names node "
                                      + std::to_string(node) + ", but there are "
                                      + std::to_string(number_of_leaves + i));
        nodes.unite(node, number_of_leaves + i);
      }
    return internal::label_components(nodes, leaf_of_face.size(),
                                      [this](const std::size_t f) { return leaf_of_face[f]; })
      .of_items;
  }

  /// returns the part of each face for `number_of_parts`.
  std::vector<std::size_t> parts() const { return parts(number_of_parts); }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SEGMENTATION_TREE_3_H
