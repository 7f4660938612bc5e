// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CONSTRAINTS_3_H
#define CGAL_CANONICAL_POSE_3_CONSTRAINTS_3_H

#include <CGAL/Canonical_pose_3/Direction_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Handle_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Registration_constraint_3.h>
#include <CGAL/Canonical_pose_3/Spring_constraint_adaptor_3.h>
#include <CGAL/Canonical_pose_3/Symmetry_constraint_adaptor_3.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/// \ingroup PkgCanonicalPose3Ref
/// returns constraints on the vertices of one component. Row \f$ i \f$ of the constraints corresponds to
/// vertex `vertices[i]` of the input, which occurs once for each of its copies. For a connected surface
/// without defects, `vertices[i]` is `i`.
using Constraints_function
  = std::function<std::vector<Registration_constraint_3>(const std::vector<std::size_t>& vertices)>;

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the constraints of `canonical_pose_3()`.

Vertices are given as indices in the order of `vertices(tmesh)`, of the points of a soup, or of the
vertices of a complex; `Vertex_constraints_3` accepts vertex descriptors instead. All vertices of a
constraint must belong to the same component, and this must be one that is posed. Vectors and
positions are given in the coordinate system of the input (see `align_target()`). Where the input is
not manifold, a vertex has several copies: a constraint acts on all of them in the component with which
the vertex goes (the largest one, if several), and they share its stiffness.
*/
struct Constraints_3
{
  /// springs between pairs of vertices.
  std::vector<Spring_3> springs;

  /// pairs of vertices with a prescribed difference.
  std::vector<Directed_pair_3> directions;

  /// vertices with prescribed positions.
  std::vector<Handle_3> handles;

  /// pairs of vertices that become mirror images with respect to one common plane per component.
  std::vector<Symmetric_pair_3> symmetric_pairs;

  /// if set, returns further constraints, of any type, on each component.
  Constraints_function function;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CONSTRAINTS_3_H
