// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_REQUIRE_OPTION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_REQUIRE_OPTION_H

#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Throws `std::invalid_argument` that names an option, unless `holds`.
template <class Value>
void require_option(const bool holds, const std::string& name, const Value& value,
                    const std::string& bound)
{
  if(holds)
    return;
  std::ostringstream message;
  message << "option " << name << " is " << value << ", but must be " << bound;
  throw std::invalid_argument(message.str());
}

inline void require_positive(const std::string& name, const double value)
{
  require_option(value > 0 && std::isfinite(value), name, value, "> 0 and finite");
}

inline void require_nonnegative(const std::string& name, const double value)
{
  require_option(value >= 0 && std::isfinite(value), name, value, ">= 0 and finite");
}

inline void require_finite(const std::string& name, const double value)
{
  require_option(std::isfinite(value), name, value, "finite");
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
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_REQUIRE_OPTION_H
