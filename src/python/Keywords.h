// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_PYTHON_KEYWORDS_H
#define CGAL_CANONICAL_POSE_3_PYTHON_KEYWORDS_H

#include "arrays.h"
#include "option_values.h"

#include <CGAL/Canonical_pose_3/Options.h>

#include <pybind11/pybind11.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace Canonical_pose_python {

using CGAL::Canonical_pose_3::Options;

// Keyword arguments, which are taken one after the other. None stands for the default.
// Exceptions are std::invalid_argument if a value is out of range, and TypeError if it has a wrong
// type.
class Keywords
{
public:
  explicit Keywords(const py::dict& values) : m_values(values.attr("copy")()) {}

  // None if there is no such keyword.
  py::object take(const char* const name)
  {
    return m_values.contains(name) ? py::object(m_values.attr("pop")(name)) : py::none();
  }

  std::optional<double> take_number(const char* name);

  template <class Integer>
  void take_integer(const char* const name, const long long least, Integer& result)
  {
    // Larger integers than `long long` holds have arrived as its largest one.
    constexpr auto most
      = (std::min)(static_cast<unsigned long long>((std::numeric_limits<Integer>::max)()),
                   static_cast<unsigned long long>((std::numeric_limits<long long>::max)()) - 1);
    if(const std::optional<long long> value = integer(name, least, most))
      result = static_cast<Integer>(*value);
  }

  template <class Value>
  void take_choice(const char* const name, const Canonical_pose_tool::Option_values<Value>& choices,
                   Value& result)
  {
    const py::object value = take(name);
    if(value.is_none())
      return;
    const auto choice = choices.find(string(name, value));
    if(choice != choices.end())
    {
      result = choice->second;
      return;
    }
    std::string names;
    for(const auto& known : choices)
      names += (names.empty() ? "" : ", ") + known.first;
    throw std::invalid_argument("option " + std::string(name) + " is '" + string(name, value)
                                + "', but must be one of " + names);
  }

  // Throws TypeError if there is a keyword that was not taken.
  void check_is_empty() const;

private:
  std::optional<long long> integer(const char* name, long long least, unsigned long long most);
  static std::string string(const char* name, const py::object& value);

  py::dict m_values;
};

// What the keywords of `pose` say.
Options options_of(const py::dict& keywords);

// Lets the signals of Python stop a registration, such as that of Ctrl+C.
void listen_to_signals(Options& options);

} // namespace Canonical_pose_python

#endif // CGAL_CANONICAL_POSE_3_PYTHON_KEYWORDS_H
