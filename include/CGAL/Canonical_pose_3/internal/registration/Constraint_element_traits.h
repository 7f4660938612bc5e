// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_CONSTRAINT_ELEMENT_TRAITS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_CONSTRAINT_ELEMENT_TRAITS_H

#include <array>
#include <cstddef>
#include <string>
#include <tuple>
#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The traits of the elements of a constraint for `Constraint_list_3` and the one call; specialized
// next to each element, with
//   const char* name             its name in messages,
//   pointers_to_vertices(e)      an array of pointers to its vertices,
//   std::string defect(e)        describes an out-of-range value; empty if there is none,
// and, if the list stores a state of each element between iterations,
//   State                        its type, whose default-constructed value is the initial state.
template <class Element>
struct Constraint_element_traits;

struct No_constraint_state
{};

template <class Traits, class = void>
struct Constraint_element_state
{
  using type = No_constraint_state;
};

template <class Traits>
struct Constraint_element_state<Traits, std::void_t<typename Traits::State>>
{
  using type = typename Traits::State;
};

// The base of the traits of elements with two vertices p and q.
struct Vertex_pair_traits
{
  template <class Element>
  static std::array<std::size_t*, 2> pointers_to_vertices(Element& e)
  {
    return {{&e.p, &e.q}};
  }
};

// Returns the defect of an element whose vertices must differ.
template <class Element>
std::string coincidence_of_vertices(const Element& e)
{
  return e.p == e.q ? "joins vertex " + std::to_string(e.p) + " to itself" : std::string();
}

template <class Element>
auto vertices_of(Element e)
{
  const auto pointers = Constraint_element_traits<Element>::pointers_to_vertices(e);
  std::array<std::size_t, std::tuple_size<decltype(pointers)>::value> result;
  for(std::size_t i = 0; i < result.size(); ++i)
    result[i] = *pointers[i];
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_CONSTRAINT_ELEMENT_TRAITS_H
