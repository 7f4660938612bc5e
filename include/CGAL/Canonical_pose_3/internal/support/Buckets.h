// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_BUCKETS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_BUCKETS_H

#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <atomic>
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

  // Buckets whose values are sorted, filled in parallel. `for_each_value(i, put)` calls put(bucket,
  // value) for all values of item i of [0, number_of_items). It is called twice.
  template <class Function>
  static Buckets sorted(const std::size_t number_of_buckets, const std::size_t number_of_items,
                        const Function& for_each_value)
  {
    Buckets result;
    std::vector<std::atomic<std::size_t>> end(number_of_buckets);
    const auto next = [&](const std::size_t bucket) {
      return end[bucket].fetch_add(1, std::memory_order_relaxed);
    };
    const auto for_each_item = [&](const auto& put) {
      for_each_block(number_of_items,
                     [&](std::size_t, const std::size_t first, const std::size_t last) {
                       for(std::size_t i = first; i < last; ++i)
                         for_each_value(i, put);
                     });
    };
    for_each_item([&](const std::size_t bucket, const Value&) { next(bucket); });
    result.m_begin.reserve(number_of_buckets + 1);
    for(std::atomic<std::size_t>& number : end)
    {
      const std::size_t begin = result.m_begin.back();
      result.m_begin.push_back(begin + number);
      number = begin;
    }
    result.m_values.resize(result.m_begin.back());
    for_each_item(
      [&](const std::size_t bucket, const Value& value) { result.m_values[next(bucket)] = value; });
    for_each_block(number_of_buckets,
                   [&](std::size_t, const std::size_t first, const std::size_t last) {
                     for(std::size_t bucket = first; bucket < last; ++bucket)
                       std::sort(result[bucket].begin(), result[bucket].end());
                   });
    return result;
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
