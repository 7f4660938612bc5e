// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_SUPERNODES_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_SUPERNODES_H

#include "Cholmod_factor.h"
#include "Supernodal_routines.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
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
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_CHOLMOD_SUPERNODES_H
