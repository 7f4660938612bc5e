// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_PYTHON_ARRAYS_H
#define CGAL_CANONICAL_POSE_3_PYTHON_ARRAYS_H

#include "formats/Mesh_file.h"

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// From arrays to the types of the library, and back. Numbers that come in are checked and copied
// once, those that go out are not copied. Exceptions are std::invalid_argument.

namespace Canonical_pose_python {

namespace py = pybind11;

using Canonical_pose_tool::Mesh_file;
using CGAL::Canonical_pose_3::Point_matrix;

// Thrown while Python has an exception of its own, such as KeyboardInterrupt. It is not derived from
// std::exception, so that nobody takes it for a failure of the computation.
struct Python_exception
{};

// A surface of `faces` or, if there are any, a tetrahedral mesh of `cells`; see Mesh_file::is_checked.
Mesh_file mesh_of(const py::object& vertices, const py::object& faces, const py::object& cells,
                  bool is_checked = true);

Mesh_file surface_of(const py::object& vertices, const py::object& faces);

// Faces whose vertices are those of `mesh`.
Canonical_pose_tool::Face_list faces_of(const py::object& given, const Mesh_file& mesh);

// `name` is that of the argument, for messages.
std::vector<std::array<double, 3>> points_of(const py::object& values, const std::string& name,
                                             const Mesh_file& mesh = Mesh_file());
Point_matrix point_matrix_of(const py::object& values, const std::string& name);
Eigen::MatrixXd matrix_of(const py::object& values, const std::string& name);
Eigen::VectorXd vector_of(const py::object& values, const std::string& name);

// Indices of `n` vertices.
std::vector<std::size_t> vertices_of(const py::object& values, std::size_t n,
                                     const std::string& name);

py::array array_of(std::vector<std::size_t> values);

// While one exists, signals do not interrupt what the thread computes.
class Uninterrupted
{
public:
  Uninterrupted() { ++number_in_thread(); }
  ~Uninterrupted() { --number_in_thread(); }
  Uninterrupted(const Uninterrupted&) = delete;
  Uninterrupted& operator=(const Uninterrupted&) = delete;

  static int& number_in_thread();
};

// Lets signals such as that of Ctrl+C interrupt what the main thread computes, by Python_exception.
void let_signals_interrupt();

// Calls `compute` without the lock of the interpreter.
template <class Compute>
auto without_lock(const Compute& compute)
{
  try
  {
    const py::gil_scoped_release release;
    return compute();
  }
  catch(const Python_exception&)
  {
    throw py::error_already_set();
  }
}

} // namespace Canonical_pose_python

#endif // CGAL_CANONICAL_POSE_3_PYTHON_ARRAYS_H
