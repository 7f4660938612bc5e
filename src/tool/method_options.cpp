// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "method_options.h"
#include "option_values.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

using CGAL::Canonical_pose_3::Registration_options;
using Type = Method_option::Type;

template <class Value>
std::string text_of(const Value value)
{
  std::ostringstream out;
  out << value;
  return out.str();
}

template <class Value>
std::string text_of(const std::optional<Value>& value)
{
  return value ? text_of(*value) : std::string();
}

// `member(options)` is what an option sets.
template <class Value, class Member>
Method_option choice(const char* const name, const Option_values<Value>& values, const Member member,
                     const char* const help)
{
  std::vector<std::string> names;
  for(const auto& value : values)
    names.push_back(value.first);
  return {name,
          help,
          Type::CHOICE,
          names,
          range_of_values(values),
          [&values, member](Options& options, const std::string& text) {
            const auto found = values.find(text);
            if(found != values.end())
              member(options) = found->second;
            return found != values.end();
          },
          [&values, member](const Options& options) {
            return std::find_if(
                     values.begin(), values.end(),
                     [&](const auto& value) { return value.second == member(options); })
              ->first;
          }};
}

template <class Integer, class Member>
Method_option integer(const char* const name, const Integer least, const Member member,
                      const char* const help)
{
  return {name,
          help,
          Type::INTEGER,
          {},
          range_of_counts(least),
          [least, member](Options& options, const std::string& text) {
            const std::optional<Integer> value = count_of<Integer>(text);
            if(!value || *value < least)
              return false;
            member(options) = *value;
            return true;
          },
          [member](const Options& options) { return text_of(member(options)); }};
}

template <class Member>
Method_option number(const char* const name, const double least, const double largest,
                     const Member member, const char* const help)
{
  return {name,
          help,
          Type::NUMBER,
          {},
          "a number from " + text_of(least) + " to " + text_of(largest),
          [least, largest, member](Options& options, const std::string& text) {
            const std::optional<double> value = real_of(text);
            if(!value || *value < least || *value > largest)
              return false;
            member(options) = *value;
            return true;
          },
          [member](const Options& options) { return text_of(member(options)); }};
}

} // namespace

// clang-format off
#define MEMBER(name) [](auto& options) -> auto& { return options.name; }
// clang-format on

const std::vector<Method_option>& method_options()
{
  using R = Registration_options;
  static const std::vector<Method_option> options = {
    choice("body", BODIES, MEMBER(body), "elastic body inside a surface"),
    number("spacing", Options::SMALLEST_LATTICE_SPACING, 1, MEMBER(lattice_spacing),
           "spacing of the lattice, as a fraction of the largest geodesic distance"),
    choice(
      "target-mode", TARGET_MODES, MEMBER(target_mode),
      "target by scaling of distances, or by moving vertices away from each other, which needs "
      "none"),
    choice("kernel", KERNELS, MEMBER(kernel), "kernel of the target"),
    integer("landmarks", std::size_t(1), MEMBER(number_of_landmarks), "number of landmarks"),
    number("detail-length", R::SMALLEST_DETAIL_LENGTH, R::LARGEST_DETAIL_LENGTH,
           MEMBER(registration.detail_length),
           "features smaller than this fraction of the largest geodesic distance keep their shape"),
    number("tikhonov", 0, R::LARGEST_WEIGHT, MEMBER(registration.tikhonov),
           "weight that keeps an iterate close to the previous one"),
    integer("iterations", 1, MEMBER(registration.number_of_iterations),
            "maximum number of iterations"),
    integer(
      "rounds", 0, MEMBER(number_of_rounds),
      "maximum number of times that distances are measured again on the pose; default: 3, or 0 "
      "with a given target, paper weights, unfolding or the uncentered kernel"),
    choice(
      "symmetry", SYMMETRIES, MEMBER(symmetry),
      "targets are made symmetric where the shape has a clear symmetry, or remain as they are"),
    choice("components", COMPONENTS, MEMBER(components),
           "treatment of several connected components"),
    choice("contacts", CONTACTS, MEMBER(contacts),
           "handles of a surface that look like false contacts of its parts"),
    choice("solver", SOLVERS, MEMBER(solver), "linear solver"),
    integer("seed", 0u, MEMBER(random_seed),
            "seed that draws the first landmark; 0: the vertex farthest from the centroid"),
    integer("threads", 0, MEMBER(number_of_threads),
            "maximum number of threads; 0: all processors"),
    choice("stance", STANCES, MEMBER(stance),
           "canonical, or for persons t, a or vitruvian, for animals with four legs stand"),
    choice("frame", FRAMES, MEMBER(frame),
           "position of the pose: near the input, canonical: principal axes, or body: upright, the "
           "front "
           "toward +z; auto: body with a stance, input otherwise")};
  return options;
}

#undef MEMBER

const Method_option& method_option(const std::string& name)
{
  const std::vector<Method_option>& options = method_options();
  const auto found
    = std::find_if(options.begin(), options.end(),
                   [&](const Method_option& option) { return option.name == name; });
  if(found == options.end())
    throw std::out_of_range("there is no option " + name);
  return *found;
}

} // namespace Canonical_pose_tool
