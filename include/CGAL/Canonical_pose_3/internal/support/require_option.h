// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_REQUIRE_OPTION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_REQUIRE_OPTION_H

#include <cmath>
#include <cstdlib>
#include <ios>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Of coordinates and lengths: their powers do not overflow.
inline constexpr double LARGEST_LENGTH = 1e90;

// With as few digits as possible for the same number to be read.
inline std::string shortest_number(const double value)
{
  std::string text;
  for(std::streamsize digits = 6; digits <= 17; ++digits)
  {
    std::ostringstream out;
    out.precision(digits);
    out << value;
    text = out.str();
    if(std::strtod(text.c_str(), nullptr) == value)
      break;
  }
  return text;
}

template <class Value>
std::string shown_value(const Value& value)
{
  if constexpr(std::is_floating_point_v<Value>)
    return shortest_number(value);
  else
    return std::to_string(value);
}

// Throws `std::invalid_argument` that names an option, unless `holds`.
template <class Value>
void require_option(const bool holds, const std::string& name, const Value& value,
                    const std::string& bound)
{
  if(!holds)
    throw std::invalid_argument("option " + name + " is " + shown_value(value) + ", but must be "
                                + bound);
}

inline void require_positive(const std::string& name, const double value)
{
  require_option(value > 0 && std::isfinite(value), name, value, "> 0 and finite");
}

inline void require_nonnegative(const std::string& name, const double value)
{
  require_option(value >= 0 && std::isfinite(value), name, value, ">= 0 and finite");
}

// Of the largest distance: the least spacing of a lattice but 0. A cube of spacing 1 is as large as the
// surface.
inline constexpr double SMALLEST_LATTICE_SPACING = 1e-6;

// Squares and sums of what is in range, and products with other values that are, do not overflow, and
// matrices remain positive definite. 0 is not in range, unless it is `least`.
inline void require_in_range(const std::string& name, const double value, const double least,
                             const double largest, const bool is_zero_allowed = false)
{
  require_option((value >= least && value <= largest) || (is_zero_allowed && value == 0), name,
                 value,
                 (is_zero_allowed && least > 0 ? "0 or from " : "from ") + shortest_number(least)
                   + " to " + shortest_number(largest));
}

inline void require_lattice_spacing(const double value)
{
  require_in_range("lattice_spacing", value, SMALLEST_LATTICE_SPACING, 1, true);
}

// `last`: the last value of the enumeration, whose first one is 0.
template <class Enumeration>
void require_enumerator(const std::string& name, const Enumeration value, const Enumeration last)
{
  const int number = static_cast<int>(value);
  require_option(number >= 0 && number <= static_cast<int>(last), name, number,
                 "one of the enumerators");
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_REQUIRE_OPTION_H
