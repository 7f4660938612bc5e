// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Keywords.h"

#include "exact_geodesics.h"

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>

#include <pybind11/stl.h>

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Canonical_pose_python {

namespace {

std::string option_of(const char* const name) { return "option " + std::string(name); }

// The value of an integer; of a larger one than `long long` holds, the largest or smallest.
std::optional<long long> integer_of(const py::handle& value)
{
  if(PyIndex_Check(value.ptr()) == 0)
    return std::nullopt;
  const auto integer = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
  if(!integer)
    throw py::error_already_set();
  int overflow = 0;
  const long long number = PyLong_AsLongLongAndOverflow(integer.ptr(), &overflow);
  return overflow == 0  ? number
         : overflow > 0 ? (std::numeric_limits<long long>::max)()
                        : (std::numeric_limits<long long>::min)();
}

// Rows of an array of numbers begin with indices that are whole, but no integers.
std::optional<long long> index_of(const py::object& value)
{
  constexpr double most = 9e15;
  if(PyFloat_Check(value.ptr()) == 0)
    return integer_of(value);
  const double number = value.cast<double>();
  if(number != std::floor(number) || !(std::abs(number) < most))
    return std::nullopt;
  return static_cast<long long>(number);
}

void take_geodesics(Keywords& keywords, Options& options)
{
  static const Canonical_pose_tool::Option_values<std::string> choices
    = {{"heat", "heat"}, {"wavefront", "wavefront"}, {"exact", "exact"}};
  std::string name = "heat";
  keywords.take_choice("geodesics", choices, name);
  Canonical_pose_tool::set_geodesics(options, name);
}

// A constraint: vertices, then numbers, then optionally a stiffness.
struct Constraint_values
{
  std::vector<std::size_t> vertices;
  std::vector<double> numbers;
  double stiffness = 1;

  Eigen::RowVector3d vector() const { return {numbers[0], numbers[1], numbers[2]}; }
};

template <class Type>
Type value_of(const py::handle& value, const std::string& name, const std::string& type)
{
  try
  {
    return value.cast<Type>();
  }
  catch(const py::cast_error&)
  {
    throw py::type_error(name + " must be " + type);
  }
}

std::vector<Constraint_values> take_constraints(Keywords& keywords, const char* const name,
                                                const std::size_t number_of_vertices,
                                                const std::size_t number_of_numbers)
{
  std::vector<Constraint_values> result;
  const py::object values = keywords.take(name);
  if(values.is_none())
    return result;
  if(!py::isinstance<py::iterable>(values))
    throw py::type_error(option_of(name) + " must be a sequence of sequences");
  for(const py::handle value : values)
  {
    const auto element = option_of(name) + ": element " + std::to_string(result.size());
    const auto entries = value_of<std::vector<py::object>>(value, element, "a sequence");
    const std::size_t n = number_of_vertices + number_of_numbers;
    if(entries.size() != n && entries.size() != n + 1)
      throw std::invalid_argument(element + " has " + std::to_string(entries.size())
                                  + " values, but must have " + std::to_string(n) + " or "
                                  + std::to_string(n + 1));
    Constraint_values constraint;
    for(std::size_t i = 0; i < number_of_vertices; ++i)
    {
      const std::optional<long long> vertex = index_of(entries[i]);
      if(!vertex || *vertex < 0)
        throw std::invalid_argument(
          element + " does not begin with "
          + (number_of_vertices == 2 ? "two indices of vertices" : "the index of a vertex"));
      constraint.vertices.push_back(static_cast<std::size_t>(*vertex));
    }
    for(std::size_t i = number_of_vertices; i < n; ++i)
      constraint.numbers.push_back(value_of<double>(entries[i], element, "numbers"));
    if(entries.size() > n)
      constraint.stiffness = value_of<double>(entries[n], element, "numbers");
    result.push_back(std::move(constraint));
  }
  return result;
}

void take_all_constraints(Keywords& keywords, Options& options)
{
  for(const Constraint_values& c : take_constraints(keywords, "spring", 2, 1))
    options.constraints.springs.push_back(
      {c.vertices[0], c.vertices[1], c.numbers[0], c.stiffness});
  for(const Constraint_values& c : take_constraints(keywords, "direction", 2, 3))
    options.constraints.directions.push_back(
      {c.vertices[0], c.vertices[1], c.vector(), c.stiffness});
  for(const Constraint_values& c : take_constraints(keywords, "handle", 1, 3))
    options.constraints.handles.push_back({c.vertices[0], c.vector(), c.stiffness});
  for(const Constraint_values& c : take_constraints(keywords, "symmetric", 2, 0))
    options.constraints.symmetric_pairs.push_back({c.vertices[0], c.vertices[1], c.stiffness});
}

// Values per vertex or cell.
void take_values(Keywords& keywords, Options& options)
{
  if(const py::object values = keywords.take("matching_weights"); !values.is_none())
    options.matching_weights = vector_of(values, "matching_weights");
  if(const py::object values = keywords.take("stiffness"); !values.is_none())
    options.stiffness = vector_of(values, "stiffness");
  if(const py::object values = keywords.take("given_target"); !values.is_none())
    options.given.target = point_matrix_of(values, "given_target");
  if(const py::object values = keywords.take("given_distances"); !values.is_none())
    options.given.landmark_fields
      = CGAL::Canonical_pose_3::landmark_fields(matrix_of(values, "given_distances"));
}

void take_paper_weights(Keywords& keywords, Options& options)
{
  const py::object value = keywords.take("paper_weights");
  if(value.is_none())
    return;
  const auto [alpha, beta]
    = value_of<std::pair<double, double>>(value, "option paper_weights", "two numbers");
  options.paper_weights = CGAL::Canonical_pose_3::Paper_weights{alpha, beta};
}

void take_registration(Keywords& keywords, Options& options)
{
  auto& registration = options.registration;
  registration.detail_length
    = keywords.take_number("detail_length").value_or(registration.detail_length);
  registration.tikhonov = keywords.take_number("tikhonov").value_or(registration.tikhonov);
  keywords.take_integer("iterations", 1, registration.number_of_iterations);
  if(const py::object injective = keywords.take("injective"); !injective.is_none())
    registration.injective = value_of<bool>(injective, "option injective", "True or False");
}

} // namespace

std::optional<double> Keywords::take_number(const char* const name)
{
  const py::object value = take(name);
  if(value.is_none())
    return std::nullopt;
  if(PyNumber_Check(value.ptr()) == 0)
    throw py::type_error(option_of(name) + " must be a number");
  const double number = py::float_(value);
  if(!std::isfinite(number))
    throw std::invalid_argument(option_of(name) + " is not finite");
  return number;
}

std::optional<long long> Keywords::integer(const char* const name, const long long least,
                                           const unsigned long long most)
{
  const py::object value = take(name);
  if(value.is_none())
    return std::nullopt;
  const std::optional<long long> number = integer_of(value);
  if(!number)
    throw py::type_error(option_of(name) + " must be an integer");
  if(*number < least || static_cast<unsigned long long>(*number) > most)
    throw std::invalid_argument(
      option_of(name) + " is " + std::string(py::str(value))
      + (*number < least ? ", but must be >= " + std::to_string(least) : ", which is too large"));
  return number;
}

std::string Keywords::string(const char* const name, const py::object& value)
{
  if(!py::isinstance<py::str>(value))
    throw py::type_error(option_of(name) + " must be a string");
  return value.cast<std::string>();
}

void Keywords::check_is_empty() const
{
  for(const auto& keyword : m_values)
    throw py::type_error("there is no option " + std::string(py::str(keyword.first)));
}

Options options_of(const py::dict& values)
{
  Keywords keywords(values);
  Options options;
  take_registration(keywords, options);
  take_geodesics(keywords, options);
  take_paper_weights(keywords, options);
  keywords.take_choice("body", Canonical_pose_tool::BODIES, options.body);
  keywords.take_choice("kernel", Canonical_pose_tool::KERNELS, options.kernel);
  keywords.take_choice("components", Canonical_pose_tool::COMPONENTS, options.components);
  keywords.take_choice("contacts", Canonical_pose_tool::CONTACTS, options.contacts);
  keywords.take_choice("frame", Canonical_pose_tool::FRAMES, options.frame);
  keywords.take_choice("solver", Canonical_pose_tool::SOLVERS, options.solver);
  keywords.take_choice("target_mode", Canonical_pose_tool::TARGET_MODES, options.target_mode);
  keywords.take_integer("landmarks", 1, options.number_of_landmarks);
  keywords.take_integer("seed", 0, options.random_seed);
  keywords.take_integer("threads", 0, options.number_of_threads);
  if(const std::optional<double> spacing = keywords.take_number("spacing"))
  {
    constexpr double least = Options::SMALLEST_LATTICE_SPACING;
    if(!(*spacing >= least && *spacing <= 1))
      throw std::invalid_argument("option spacing is " + std::string(py::str(py::float_(*spacing)))
                                  + ", but must be from " + std::string(py::str(py::float_(least)))
                                  + " to 1");
    options.lattice_spacing = *spacing;
  }
  int rounds = -1;
  keywords.take_integer("rounds", 0, rounds);
  if(rounds >= 0)
    options.number_of_rounds = rounds;
  take_values(keywords, options);
  take_all_constraints(keywords, options);
  keywords.check_is_empty();
  listen_to_signals(options);
  return options;
}

void listen_to_signals(Options& options)
{
  options.visitor = [](const CGAL::Canonical_pose_3::Registration_progress&) {
    const py::gil_scoped_acquire lock;
    if(PyErr_CheckSignals() != 0)
      throw Python_exception();
    return true;
  };
}

} // namespace Canonical_pose_python
