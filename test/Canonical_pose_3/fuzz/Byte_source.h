// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_FUZZ_BYTE_SOURCE_H
#define CGAL_CANONICAL_POSE_3_FUZZ_BYTE_SOURCE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace Canonical_pose_fuzz {

/// Numbers from the bytes of the fuzzer; zeros when none are left.
class Byte_source
{
public:
  Byte_source(const std::uint8_t* data, const std::size_t size) : m_data(data), m_end(data + size)
  {}

  bool is_empty() const { return m_data == m_end; }

  std::uint8_t byte() { return is_empty() ? std::uint8_t(0) : *m_data++; }

  /// A number below n, 0 if n is 0.
  std::size_t below(const std::size_t n) { return n == 0 ? 0 : byte() % n; }

  double special_number()
  {
    using Limits = std::numeric_limits<double>;
    const std::array<double, 12> numbers
      = {{0., -0., Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max(),
          Limits::lowest(), Limits::min(), Limits::denorm_min(), 1e150, 1e-150, 1e15}};
    return numbers[below(numbers.size())];
  }

private:
  const std::uint8_t* m_data;
  const std::uint8_t* m_end;
};

} // namespace Canonical_pose_fuzz

#endif // CGAL_CANONICAL_POSE_3_FUZZ_BYTE_SOURCE_H
