// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "arrays.h"

#include "formats/Text_cursor.h"
#include "formats/readers.h"

#include <CGAL/Canonical_pose_3/set_interruption_check.h>

#include <chrono>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

namespace Canonical_pose_python {

namespace {

using Canonical_pose_tool::Element;
using Canonical_pose_tool::Face_list;

std::string shape_of(const py::array& array)
{
  if(array.ndim() == 1 && array.size() == 0)
    return "empty";
  std::string result;
  for(py::ssize_t k = 0; k < array.ndim(); ++k)
    result += (k > 0 ? " x " : "") + std::to_string(array.shape(k));
  return result.empty() ? "a single number" : result;
}

// An array of any type.
py::array any_array(const py::object& values, const std::string& name)
{
  const py::object array = values.is_none() ? values : py::array::ensure(values);
  if(!array || array.is_none())
    throw std::invalid_argument(name + " must be an array of numbers");
  if(py::module_::import("numpy").attr("ma").attr("is_masked")(values).cast<bool>())
    throw std::invalid_argument(name + " must not have masked elements");
  return array;
}

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Integers = py::array_t<long long, py::array::c_style | py::array::forcecast>;

// An array of numbers with the given number of dimensions.
Numbers numbers_of(const py::object& values, const py::ssize_t dimensions, const std::string& name)
{
  const py::array array = any_array(values, name);
  if(std::strchr("fiu", array.dtype().kind()) == nullptr)
    throw std::invalid_argument(name + " must be an array of numbers");
  if(array.ndim() != dimensions)
    throw std::invalid_argument(name + " must have " + std::to_string(dimensions)
                                + (dimensions == 1 ? " dimension" : " dimensions") + ", but is "
                                + shape_of(array));
  return Numbers(array);
}

// The value as an integer of Python.
py::object integer_of(const py::handle& value, const std::string& name)
{
  const bool is_bool = PyBool_Check(value.ptr()) != 0
                       || py::isinstance(value, py::module_::import("numpy").attr("bool_"));
  auto result = py::reinterpret_steal<py::object>(is_bool ? nullptr : PyNumber_Index(value.ptr()));
  if(!result)
  {
    PyErr_Clear();
    throw py::type_error(name + " must be integers, the indices of vertices, but one is "
                         + std::string(py::repr(value)));
  }
  return result;
}

// NumPy takes True for 1.
void check_are_integers(const py::handle& values, const std::string& name)
{
  if(PyLong_CheckExact(values.ptr()) != 0) // most are, and this is fast
    return;
  if(!py::isinstance<py::sequence>(values))
    integer_of(values, name);
  else if(!py::hasattr(values, "__array__"))
    for(const py::handle value : values)
      check_are_integers(value, name);
}

// Of Python's numbers.
Integers integers_of_objects(const py::array& array, const std::string& name)
{
  Integers result(std::vector<py::ssize_t>(array.shape(), array.shape() + array.ndim()));
  long long* next = result.mutable_data();
  const py::list values = array.attr("ravel")().attr("tolist")();
  for(const py::handle value : values)
  {
    int overflow = 0;
    *next++ = PyLong_AsLongLongAndOverflow(integer_of(value, name).ptr(), &overflow);
    if(overflow != 0)
      throw std::invalid_argument(name + " names vertex " + std::string(py::str(value))
                                  + ", which is too " + (overflow > 0 ? "large" : "small"));
  }
  return result;
}

Integers integers_of(const py::object& values, const std::string& name)
{
  const py::array array = any_array(values, name);
  if(array.size() > 0 && array.dtype().kind() == 'O')
    return integers_of_objects(array, name);
  if(!py::hasattr(values, "__array__") && array.size() > 0
     && std::strchr("iub", array.dtype().kind()) != nullptr)
    check_are_integers(values, name);
  if(array.size() > 0 && std::strchr("iu", array.dtype().kind()) == nullptr)
    throw std::invalid_argument(name + " must be integers, the indices of vertices");
  const Integers result(array);
  if(array.dtype().kind() == 'u')
    for(const long long* index = result.data(); index != result.data() + result.size(); ++index)
      if(*index < 0)
        throw std::invalid_argument(name + " names vertex "
                                    + std::to_string(static_cast<unsigned long long>(*index))
                                    + ", which is too large");
  return result;
}

void check_number_of_columns(const py::array& array, const py::ssize_t columns,
                             const std::string& name)
{
  if(array.shape(1) != columns)
    throw std::invalid_argument(name + " must be n x " + std::to_string(columns) + ", but is "
                                + shape_of(array));
}

std::vector<std::size_t> face_of(const long long* const corners, const py::ssize_t number,
                                 const Mesh_file& mesh, const Element& face)
{
  Canonical_pose_tool::check_is_polygon(number, face);
  std::vector<std::size_t> result;
  for(py::ssize_t k = 0; k < number; ++k)
    result.push_back(Canonical_pose_tool::vertex_index(mesh, corners[k], mesh.points.size(), face));
  return result;
}

std::vector<std::array<std::size_t, 4>> cells_of(const py::object& values, const Mesh_file& mesh)
{
  const Integers cells = integers_of(values, "cells");
  if(cells.ndim() != 2)
    throw std::invalid_argument("cells must have 2 dimensions, but is " + shape_of(cells));
  check_number_of_columns(cells, 4, "cells");
  std::vector<std::array<std::size_t, 4>> result(static_cast<std::size_t>(cells.shape(0)));
  for(std::size_t t = 0; t < result.size(); ++t)
    for(std::size_t k = 0; k < 4; ++k)
      result[t][k] = Canonical_pose_tool::vertex_index(
        mesh, cells.at(static_cast<py::ssize_t>(t), static_cast<py::ssize_t>(k)),
        mesh.points.size(), Element{"cell", t});
  return result;
}

} // namespace

// Faces with the same number of corners each are a matrix, others a sequence of sequences.
Face_list faces_of(const py::object& given, const Mesh_file& mesh)
{
  const py::object values
    = py::hasattr(given, "__array__") ? py::object(any_array(given, "faces")) : given;
  Face_list result;
  if(py::isinstance<py::array>(values) && py::array(values).dtype().kind() != 'O')
  {
    const Integers faces = integers_of(values, "faces");
    if(faces.size() == 0)
      return result;
    if(faces.ndim() != 2)
      throw std::invalid_argument("faces must have 2 dimensions, but is " + shape_of(faces));
    for(py::ssize_t f = 0; f < faces.shape(0); ++f)
      result.push_back(face_of(faces.data(f, 0), faces.shape(1), mesh,
                               Element{"face", static_cast<std::size_t>(f)}));
    return result;
  }
  if(!py::isinstance<py::sequence>(values) || py::isinstance<py::str>(values))
    throw std::invalid_argument("faces must be an array or a sequence of sequences");
  for(const py::handle value : values)
  {
    const Element face{"face", result.size()};
    const Integers corners = integers_of(py::reinterpret_borrow<py::object>(value), face.name());
    if(corners.ndim() != 1)
      throw std::invalid_argument(face.name() + " must be a sequence of indices of vertices");
    result.push_back(face_of(corners.data(), corners.size(), mesh, face));
  }
  return result;
}

int& Uninterrupted::number_in_thread()
{
  static thread_local int number = 0;
  return number;
}

void let_signals_interrupt()
{
  using Clock = std::chrono::steady_clock;
  static const std::thread::id main_thread = std::this_thread::get_id();
  CGAL::Canonical_pose_3::set_interruption_check([] {
    static Clock::time_point next;
    if(std::this_thread::get_id() != main_thread || Uninterrupted::number_in_thread() > 0
       || Clock::now() < next)
      return;
    constexpr std::chrono::milliseconds interval(50);
    next = Clock::now() + interval;
    const py::gil_scoped_acquire lock;
    if(PyErr_CheckSignals() != 0)
      throw Python_exception();
  });
}

std::vector<std::array<double, 3>> points_of(const py::object& values, const std::string& name,
                                             const Mesh_file& mesh)
{
  const Numbers numbers = numbers_of(values, 2, name);
  check_number_of_columns(numbers, 3, name);
  std::vector<std::array<double, 3>> points(static_cast<std::size_t>(numbers.shape(0)));
  if(!points.empty())
    std::memcpy(points.data(), numbers.data(), points.size() * sizeof(points.front()));
  for(std::size_t i = 0; i < points.size(); ++i)
    Canonical_pose_tool::check_is_finite(mesh, points[i], Element{"vertex", i});
  return points;
}

Point_matrix point_matrix_of(const py::object& values, const std::string& name)
{
  const std::vector<std::array<double, 3>> points = points_of(values, name);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  return Rows::Map(points.empty() ? nullptr : points.front().data(),
                   static_cast<Eigen::Index>(points.size()), 3);
}

Eigen::MatrixXd matrix_of(const py::object& values, const std::string& name)
{
  const Numbers numbers = numbers_of(values, 2, name);
  using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  return Rows::Map(numbers.data(), numbers.shape(0), numbers.shape(1));
}

Eigen::VectorXd vector_of(const py::object& values, const std::string& name)
{
  const Numbers numbers = numbers_of(values, 1, name);
  return Eigen::VectorXd::Map(numbers.data(), numbers.size());
}

Mesh_file mesh_of(const py::object& vertices, const py::object& faces, const py::object& cells,
                  const bool is_checked)
{
  if(faces.is_none() == cells.is_none())
    throw std::invalid_argument(faces.is_none() ? "either faces or cells are needed"
                                                : "both faces and cells are given");
  Mesh_file mesh;
  mesh.is_checked = is_checked;
  mesh.points = points_of(vertices, "vertices", mesh);
  mesh.is_tetrahedral = !cells.is_none();
  if(mesh.is_tetrahedral)
  {
    mesh.cells = cells_of(cells, mesh);
    mesh.point_references.assign(mesh.points.size(), 0);
    mesh.cell_references.assign(mesh.cells.size(), 0);
  }
  else
    mesh.faces = faces_of(faces, mesh);
  return mesh;
}

Mesh_file surface_of(const py::object& vertices, const py::object& faces)
{
  return mesh_of(vertices, faces, py::none());
}

std::vector<std::size_t> vertices_of(const py::object& values, const std::size_t n,
                                     const std::string& name)
{
  const Integers indices = integers_of(values, name);
  if(indices.ndim() != 1)
    throw std::invalid_argument(name + " must have 1 dimension, but is " + shape_of(indices));
  std::vector<std::size_t> result;
  for(py::ssize_t i = 0; i < indices.size(); ++i)
    result.push_back(
      Canonical_pose_tool::vertex_index(Mesh_file(), indices.at(i), n, Element{name.c_str()}));
  return result;
}

py::array array_of(std::vector<std::size_t> values)
{
  // Signed, as NumPy's own indices; no value is that large.
  static_assert(sizeof(py::ssize_t) == sizeof(std::size_t));
  auto owner = std::make_unique<std::vector<std::size_t>>(std::move(values));
  const auto* const data = reinterpret_cast<const py::ssize_t*>(owner->data());
  const std::size_t size = owner->size();
  const py::capsule keeper(owner.release(),
                           [](void* const p) { delete static_cast<std::vector<std::size_t>*>(p); });
  return py::array_t<py::ssize_t>(size, data, keeper);
}

} // namespace Canonical_pose_python
