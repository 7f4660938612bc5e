// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_BUCKETS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_BUCKETS_H

#include <CGAL/Iterator_range.h>

#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Values sorted into buckets in contiguous memory; each bucket keeps the order of insertion.
template <class Value>
class Buckets
{
public:
  Buckets() = default;

  // `for_each_value(put)` calls put(bucket, value) for all values. It is called twice, and must
  // make the same calls both times.
  template <class Function>
  Buckets(const std::size_t number_of_buckets, const Function& for_each_value)
    : m_begin(number_of_buckets + 1, 0)
  {
    for_each_value([&](const std::size_t bucket, const Value&) { ++m_begin[bucket + 1]; });
    std::partial_sum(m_begin.begin(), m_begin.end(), m_begin.begin());
    m_values.resize(m_begin.back());
    std::vector<std::size_t> end(m_begin.begin(), m_begin.end() - 1);
    for_each_value(
      [&](const std::size_t bucket, const Value& value) { m_values[end[bucket]++] = value; });
  }

  std::size_t number_of_buckets() const { return m_begin.size() - 1; }

  // The values of a bucket.
  Iterator_range<const Value*> operator[](const std::size_t bucket) const
  {
    return {m_values.data() + m_begin[bucket], m_values.data() + m_begin[bucket + 1]};
  }
  Iterator_range<Value*> operator[](const std::size_t bucket)
  {
    return {m_values.data() + m_begin[bucket], m_values.data() + m_begin[bucket + 1]};
  }

  // The values of all buckets, one after the other.
  const std::vector<Value>& values() const { return m_values; }

private:
  std::vector<std::size_t> m_begin = std::vector<std::size_t>(1, 0);
  std::vector<Value> m_values;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_BUCKETS_H
