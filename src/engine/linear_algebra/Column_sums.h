// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_COLUMN_SUMS_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_COLUMN_SUMS_H

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Entries of a sparse matrix, one column after the other; each is a sum that starts at 0, in the
// order of the calls. A hash table, so that the memory depends on the column with the most entries,
// not on the number of rows.
class Column_sums
{
public:
  // Starts the next column; at most `n` rows will be accessed.
  void start(const std::size_t n)
  {
    ++m_column;
    m_used.clear();
    if(m_slots.size() >= 2 * n)
      return;
    while((std::size_t(1) << m_bits) < 2 * n)
      ++m_bits;
    m_slots.assign(std::size_t(1) << m_bits, Slot());
  }

  double& operator[](const int row)
  {
    std::size_t i = (static_cast<std::uint64_t>(row) * 0x9E3779B97F4A7C15u) >> (64 - m_bits);
    while(m_slots[i].column == m_column && m_slots[i].row != row)
      i = (i + 1) % m_slots.size();
    if(m_slots[i].column != m_column)
    {
      m_slots[i] = {m_column, row, 0};
      m_used.emplace_back(row, i);
    }
    return m_slots[i].sum;
  }

  // Calls f(row, sum) in the order of rows.
  template <class Function>
  void for_each(const Function& f)
  {
    std::sort(m_used.begin(), m_used.end());
    for(const auto& [row, i] : m_used)
      f(row, m_slots[i].sum);
  }

private:
  struct Slot
  {
    std::size_t column = 0;
    int row = 0;
    double sum = 0;
  };

  std::size_t m_column = 0;
  int m_bits = 6;
  std::vector<Slot> m_slots;
  std::vector<std::pair<int, std::size_t>> m_used; // row, slot
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_COLUMN_SUMS_H
