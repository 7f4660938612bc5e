// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_COMPLEX_BODY_H
#define CGAL_CANONICAL_POSE_3_COMPLEX_BODY_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/internal/body/Indexed_complex.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief creates an elastic body from a tetrahedral complex: vertex \f$ i \f$ of the complex, in the
order of the range of the traits, is vertex \f$ i \f$ of the body, and all vertices are part of its
embedding.

\tparam Complex a type for which `Tetrahedral_complex_traits_3` is specialized
\tparam Traits a model of `CanonicalPoseTraits_3`, by default the kernel of the points

\throws std::invalid_argument see `Conforming_body_3::Conforming_body_3()`; also if a cell has a
       vertex that is not in the complex.

<em>Complexity:</em> linear.

\sa `extract_boundary()`
*/
template <class Complex,
          class Traits = typename Kernel_traits<internal::Complex_point<Complex>>::Kernel>
Conforming_body_3 complex_body(const Complex& complex, const Traits& traits = Traits())
{
  auto indexed = internal::indexed_complex(complex, traits);
  const std::size_t n = indexed.vertices.size();
  return Conforming_body_3(std::move(indexed.points), std::move(indexed.cells), n);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_COMPLEX_BODY_H
