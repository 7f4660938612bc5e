// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_DISJOINT_SETS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_DISJOINT_SETS_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Disjoint sets of the numbers from 0 to n - 1.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(const std::size_t n)
    : m_rank(n, 0), m_parent(n), m_sets(m_rank.data(), m_parent.data())
  {
    std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
  }
  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  void unite(const std::size_t a, const std::size_t b) { m_sets.union_set(a, b); }
  std::size_t representative(const std::size_t a) { return m_sets.find_set(a); }

private:
  std::vector<std::size_t> m_rank, m_parent;
  boost::disjoint_sets<std::size_t*, std::size_t*> m_sets;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_DISJOINT_SETS_H
