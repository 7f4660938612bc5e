// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_INDEX_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_INDEX_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Any function of an index, which must outlive this object. TBB's loops take long to compile, so
// they are instantiated for this type only.
class Index_function
{
public:
  template <class Function>
  explicit Index_function(const Function& f)
    : m_function(&f), m_call([](const void* function, const std::size_t i) {
        (*static_cast<const Function*>(function))(i);
      })
  {}

  void operator()(const std::size_t i) const { m_call(m_function, i); }

private:
  const void* m_function;
  void (*m_call)(const void*, std::size_t);
};

inline void for_each_index(const std::size_t n, const Index_function f)
{
#ifdef CGAL_LINKED_WITH_TBB
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n),
                    [f](const tbb::blocked_range<std::size_t>& indices) {
                      for(std::size_t i = indices.begin(); i != indices.end(); ++i)
                        f(i);
                    });
#else
  for(std::size_t i = 0; i < n; ++i)
    f(i);
#endif
}

// Calls f(i) for all i < n, in parallel if TBB is available.
template <class Function>
void for_each_index(const std::size_t n, const Function& f)
{
  for_each_index(n, Index_function(f));
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_INDEX_H
