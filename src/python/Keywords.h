// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_PYTHON_KEYWORDS_H
#define CGAL_CANONICAL_POSE_3_PYTHON_KEYWORDS_H

#include "arrays.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>

#include <pybind11/pybind11.h>

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

  // Throws TypeError if there is a keyword that was not taken.
  void check_is_empty() const;

private:
  py::dict m_values;
};

// What the keywords of `pose` say. They must live as long as the options.
Options options_of(const py::dict& keywords);

// Calls `progress` after each iteration, unless it is None. It must live as long as the visitor, which
// also lets the signals of Python stop a registration, such as that of Ctrl+C.
CGAL::Canonical_pose_3::Registration_visitor visitor_of(const py::object& progress);

} // namespace Canonical_pose_python

#endif // CGAL_CANONICAL_POSE_3_PYTHON_KEYWORDS_H
