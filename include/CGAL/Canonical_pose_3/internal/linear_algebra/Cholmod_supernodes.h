// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_CHOLMOD_SUPERNODES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_CHOLMOD_SUPERNODES_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Cholmod_factor.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Supernodal_routines.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// A supernodal factor of CHOLMOD, for our own substitutions.
class Cholmod_supernodes
{
public:
  Cholmod_supernodes() = default;

  explicit Cholmod_supernodes(Cholmod_factor_pointer factor)
    : m_factor(std::move(factor)), m_inverse_diagonal(m_factor->n)
  {
    const Supernodal_matrix l = matrix();
    for(std::size_t s = 0; s < l.number_of_blocks; ++s)
    {
      const Supernode node(l, s);
      for(std::size_t j = 0; j < node.columns; ++j)
        m_inverse_diagonal[node.first + j] = 1 / node.values[j * (node.stride + 1)];
    }
  }

  std::size_t number_of_rows() const { return m_factor->n; }

  // The row of the matrix for each row of the factor.
  const Factor_index* order() const { return static_cast<const Factor_index*>(m_factor->Perm); }

  Supernodal_matrix matrix() const
  {
    return {m_factor->nsuper,
            static_cast<const Factor_index*>(m_factor->super),
            static_cast<const Factor_index*>(m_factor->pi),
            static_cast<const Factor_index*>(m_factor->px),
            static_cast<const Factor_index*>(m_factor->s),
            static_cast<const double*>(m_factor->x),
            m_inverse_diagonal.data()};
  }

private:
  Cholmod_factor_pointer m_factor;
  std::vector<double> m_inverse_diagonal;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_CHOLMOD_SUPERNODES_H
