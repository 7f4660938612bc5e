// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_SHORTEST_NUMBERS_H
#define CGAL_CANONICAL_POSE_3_TOOL_SHORTEST_NUMBERS_H

#include <algorithm>
#include <array>
#include <charconv>
#include <ios>
#include <locale>
#include <ostream>

namespace Canonical_pose_tool {

#ifdef __cpp_lib_to_chars // not in all libraries of C++17
// Writes numbers with the fewest digits from which the same numbers are read, and in a fraction of
// the time of 17 digits.
class Shortest_numbers : public std::num_put<char>
{
  iter_type do_put(iter_type out, std::ios_base&, char_type, const double x) const override
  {
    std::array<char, 32> text;
    return std::copy(text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr,
                     out);
  }
};
#endif

inline void use_shortest_numbers(std::ostream& out)
{
  out.precision(17);
#ifdef __cpp_lib_to_chars
  out.imbue(std::locale(out.getloc(), new Shortest_numbers));
#endif
}

// The same number, without the cost of formatting by a stream.
inline void write_shortest(std::ostream& out, const double x)
{
#ifdef __cpp_lib_to_chars
  std::array<char, 32> text;
  out.write(text.data(),
            std::to_chars(text.data(), text.data() + text.size(), x).ptr - text.data());
#else
  out << x;
#endif
}

// With a blank before each.
template <class Numbers>
void write_numbers(std::ostream& out, const Numbers& numbers)
{
  for(const auto x : numbers)
    out << ' ' << x;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_SHORTEST_NUMBERS_H
