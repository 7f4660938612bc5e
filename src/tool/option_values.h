// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_OPTION_VALUES_H
#define CGAL_CANONICAL_POSE_3_TOOL_OPTION_VALUES_H

#include <CGAL/Canonical_pose_3/Limb_direction_3.h>
#include <CGAL/Canonical_pose_3/Options.h>

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <system_error>
#include <type_traits>

// The numbers of the command line. The names of the values that options can have, on the command line and in Python.

namespace Canonical_pose_tool {

using Limb = CGAL::Canonical_pose_3::Limb_direction_3::Limb;
using CGAL::Canonical_pose_3::Options;

template <class Value>
using Option_values = std::map<std::string, Value>;

inline const Option_values<Options::Body> BODIES = {{"auto", Options::Body::AUTOMATIC},
                                                    {"lattice", Options::Body::LATTICE},
                                                    {"tetgen", Options::Body::TETGEN},
                                                    {"mesh", Options::Body::MESH_3}};

inline const Option_values<Options::Components> COMPONENTS
  = {{"auto", Options::Components::AUTOMATIC},
     {"refuse", Options::Components::REFUSE},
     {"largest", Options::Components::LARGEST},
     {"each", Options::Components::EACH}};

inline const Option_values<Options::Contacts> CONTACTS
  = {{"keep", Options::Contacts::KEEP}, {"cut", Options::Contacts::CUT}};

inline const Option_values<Options::Frame> FRAMES = {{"auto", Options::Frame::AUTOMATIC},
                                                     {"input", Options::Frame::INPUT},
                                                     {"canonical", Options::Frame::CANONICAL},
                                                     {"body", Options::Frame::BODY}};

inline const Option_values<Options::Kernel> KERNELS
  = {{"classical", Options::Kernel::CLASSICAL},
     {"gaussian", Options::Kernel::GAUSSIAN},
     {"gaussian-uncentred", Options::Kernel::UNCENTERED_GAUSSIAN}};

inline const Option_values<Options::Solver> SOLVERS = {{"auto", Options::Solver::AUTOMATIC},
                                                       {"eigen", Options::Solver::EIGEN},
                                                       {"cholmod", Options::Solver::CHOLMOD}};

inline const Option_values<Options::Symmetry> SYMMETRIES
  = {{"auto", Options::Symmetry::AUTOMATIC}, {"none", Options::Symmetry::NONE}};

inline const Option_values<Options::Stance> STANCES = {{"canonical", Options::Stance::CANONICAL},
                                                       {"t", Options::Stance::T},
                                                       {"a", Options::Stance::A},
                                                       {"vitruvian", Options::Stance::VITRUVIAN},
                                                       {"stand", Options::Stance::STAND}};

inline const Option_values<Limb> LIMBS = {{"left arm", Limb::LEFT_ARM},
                                          {"right arm", Limb::RIGHT_ARM},
                                          {"left leg", Limb::LEFT_LEG},
                                          {"right leg", Limb::RIGHT_LEG},
                                          {"left front leg", Limb::LEFT_FRONT_LEG},
                                          {"right front leg", Limb::RIGHT_FRONT_LEG},
                                          {"left hind leg", Limb::LEFT_HIND_LEG},
                                          {"right hind leg", Limb::RIGHT_HIND_LEG}};

inline const Option_values<Options::Target_mode> TARGET_MODES
  = {{"mds", Options::Target_mode::MDS}, {"unfold", Options::Target_mode::UNFOLDING}};

// What a value must be, for messages.
template <class Value>
std::string range_of_values(const Option_values<Value>& values)
{
  std::string range = "one of";
  for(const auto& value : values)
    range += (value.first == values.begin()->first ? " " : ", ") + value.first;
  return range;
}

// A count: digits and nothing else.
template <class Integer>
std::optional<Integer> count_of(const std::string& text)
{
  Integer value;
  const char* const end = text.data() + text.size();
  const std::from_chars_result result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end && text[0] != '-' ? std::optional(value)
                                                                         : std::nullopt;
}

// What a count must be, for messages.
template <class Integer>
std::string range_of_counts(const Integer least)
{
  if(std::is_same<Integer, std::size_t>::value) // nobody reaches the largest one
    return least == 1 ? "a positive integer" : "an integer from " + std::to_string(least);
  return "an integer from " + std::to_string(least) + " to "
         + std::to_string((std::numeric_limits<Integer>::max)());
}

// A finite number in the notation of std::from_chars(), which is not in all libraries of C++17: neither
// a plus sign before it nor hexadecimal.
inline std::optional<double> real_of(const std::string& text)
{
  if(text.empty() || text.find_first_not_of("0123456789+-.eE") != std::string::npos
     || text[0] == '+')
    return std::nullopt;
  char* end;
  const double value = std::strtod(text.c_str(), &end);
  return *end == '\0' && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_OPTION_VALUES_H
