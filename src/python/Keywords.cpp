// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Keywords.h"

#include "exact_geodesics.h"
#include "method_options.h"
#include "option_values.h"

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Limb_direction_3.h>

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_python {

namespace {

std::string option_of(const char* const name) { return "option " + std::string(name); }

// The keyword of an option of the program.
std::string keyword_of(std::string name)
{
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

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

void take_geodesics(Keywords& keywords, Options& options)
{
  const py::object value = keywords.take("geodesics");
  if(value.is_none())
    return;
  const auto name = value_of<std::string>(value, "option geodesics", "a string");
  if(name != "heat" && name != "wavefront" && name != "exact")
    throw std::invalid_argument("option geodesics is '" + name
                                + "', but must be one of exact, heat, wavefront");
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

// An option with one value, as a text that the program would take.
std::string text_of(const py::object& value, const Canonical_pose_tool::Method_option& option)
{
  using Type = Canonical_pose_tool::Method_option::Type;
  const auto refuse = [&](const char* const type) {
    throw py::type_error("option " + keyword_of(option.name) + " must be " + type);
  };
  switch(option.type)
  {
  case Type::CHOICE:
    if(!py::isinstance<py::str>(value))
      refuse("a string");
    return value.cast<std::string>();
  case Type::INTEGER:
    if(PyIndex_Check(value.ptr()) == 0 || PyBool_Check(value.ptr()) != 0)
      refuse("an integer");
    return py::str(py::module_::import("operator").attr("index")(value));
  default:
    if(PyNumber_Check(value.ptr()) == 0)
      refuse("a number");
    return py::repr(py::float_(value));
  }
}

void take_method_option(const py::object& value, const Canonical_pose_tool::Method_option& option,
                        Options& options)
{
  if(value.is_none())
    return;
  if(const std::string text = text_of(value, option); !option.set(options, text))
    throw std::invalid_argument("option " + keyword_of(option.name) + " is "
                                + std::string(py::repr(value)) + ", but must be " + option.range);
}

void take_method_options(Keywords& keywords, Options& options)
{
  for(const Canonical_pose_tool::Method_option& option : Canonical_pose_tool::method_options())
    take_method_option(keywords.take(keyword_of(option.name).c_str()), option, options);
}

// The entries of an element of `stance`: limb, direction, "straight" or "as-is"; or "stance" and its name.
void take_limb_direction(const std::vector<py::object>& entries, const std::string& element,
                         Options& options)
{
  using namespace Canonical_pose_tool;
  if(entries.empty())
    throw std::invalid_argument(element + " is empty");
  CGAL::Canonical_pose_3::Limb_direction_3 result;
  if(py::isinstance<py::str>(entries[0]))
  {
    const auto name = entries[0].cast<std::string>();
    if(name == "stance" && entries.size() == 2)
    {
      const auto stance = value_of<std::string>(entries[1], element, "the name of a stance");
      if(!method_option("stance").set(options, stance))
        throw std::invalid_argument(element + " names the stance '" + stance + "', but must name "
                                    + range_of_values(STANCES));
      return;
    }
    const auto found = LIMBS.find(name);
    if(found == LIMBS.end())
      throw std::invalid_argument(element + " names the limb '" + name + "', but must name "
                                  + range_of_values(LIMBS) + ", or the index of a vertex");
    result.limb = found->second;
  }
  else
  {
    const std::optional<long long> vertex = index_of(entries[0]);
    if(!vertex || *vertex < 0)
      throw std::invalid_argument(
        element + " begins neither with the name of a limb nor with the index of a vertex");
    result.limb = static_cast<std::size_t>(*vertex);
  }
  if(entries.size() != 4 && entries.size() != 5)
    throw std::invalid_argument(element + " has " + std::to_string(entries.size())
                                + " values, but must have 4 or 5");
  for(std::size_t k = 0; k < 3; ++k)
    result.direction[static_cast<Eigen::Index>(k)]
      = value_of<double>(entries[k + 1], element, "numbers after the limb");
  if(entries.size() == 5)
  {
    const auto form
      = value_of<std::string>(entries[4], element, "'straight' or 'as-is' at its end");
    if(form != "straight" && form != "as-is")
      throw std::invalid_argument(element + " ends in '" + form
                                  + "', but must end in 'straight' or 'as-is'");
    result.is_straightened = form == "straight";
  }
  options.limb_directions.push_back(result);
}

// The name of a stance; or a sequence of limbs with their directions, or a dict, whose items are such elements.
void take_stance(Keywords& keywords, Options& options)
{
  const Canonical_pose_tool::Method_option& option = Canonical_pose_tool::method_option("stance");
  const py::object value = keywords.take("stance");
  if(value.is_none())
    return;
  if(py::isinstance<py::str>(value))
    return take_method_option(value, option, options);
  const bool is_dict = py::hasattr(value, "items");
  if(!is_dict && !py::isinstance<py::iterable>(value))
    throw py::type_error("option stance must be a string, a sequence or a dict");
  std::size_t number = 0;
  for(const py::handle item : is_dict ? py::object(value.attr("items")()) : value)
  {
    const auto element = "option stance: element " + std::to_string(number++);
    auto entries = value_of<std::vector<py::object>>(item, element, "a sequence");
    if(is_dict && !py::isinstance<py::str>(entries[1]))
    {
      const auto rest = value_of<std::vector<py::object>>(entries[1], element, "a sequence");
      entries.pop_back();
      entries.insert(entries.end(), rest.begin(), rest.end());
    }
    take_limb_direction(entries, element, options);
  }
}

} // namespace

void Keywords::check_is_empty() const
{
  for(const auto& keyword : m_values)
    throw py::type_error("there is no option " + std::string(py::str(keyword.first)));
}

Options options_of(const py::dict& values)
{
  Keywords keywords(values);
  Options options;
  take_stance(keywords, options);
  take_method_options(keywords, options);
  take_geodesics(keywords, options);
  take_paper_weights(keywords, options);
  if(const py::object injective = keywords.take("injective"); !injective.is_none())
    options.registration.injective = value_of<bool>(injective, "option injective", "True or False");
  take_values(keywords, options);
  take_all_constraints(keywords, options);
  options.visitor = visitor_of(keywords.take("progress"));
  keywords.check_is_empty();
  return options;
}

CGAL::Canonical_pose_3::Registration_visitor visitor_of(const py::object& progress)
{
  if(!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw py::type_error("option progress must be a function");
  // It keeps no reference, since it is copied without the lock.
  return [function = py::handle(progress)](const CGAL::Canonical_pose_3::Registration_progress& p) {
    const py::gil_scoped_acquire lock;
    if(PyErr_CheckSignals() != 0)
      throw Python_exception();
    if(function.is_none())
      return true;
    try
    {
      const py::object result
        = function(p.iteration, p.round, p.component, p.energy, p.energy_match, p.energy_arap,
                   p.energy_constraints, p.largest_move);
      const int goes_on = result.is_none() ? 1 : PyObject_IsTrue(result.ptr());
      if(goes_on < 0)
        throw py::error_already_set();
      return goes_on > 0;
    }
    catch(py::error_already_set& error)
    {
      error.restore();
      throw Python_exception();
    }
  };
}

} // namespace Canonical_pose_python
