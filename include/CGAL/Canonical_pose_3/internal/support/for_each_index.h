// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_INDEX_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_INDEX_H

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
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

void for_each_index(std::size_t n, Index_function f);

// Calls f(i) for all i < n, in parallel if the library was built with TBB.
template <class Function>
void for_each_index(const std::size_t n, const Function& f)
{
  for_each_index(n, Index_function(f));
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_FOR_EACH_INDEX_H
