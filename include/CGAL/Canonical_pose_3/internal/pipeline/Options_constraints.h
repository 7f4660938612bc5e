// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_CONSTRAINTS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_CONSTRAINTS_H

#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/Registration_constraint_base.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <cstddef>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The constraints that options name, as the registrar takes them.
class Options_constraints
{
public:
  // `Elements`: `Options` or `Component_values`. `number_of_vertices`: of those that they name.
  // Throws `std::invalid_argument` as `Constraint_list_3::insert()`.
  template <class Elements>
  Options_constraints(const Elements& elements, const std::size_t number_of_vertices)
    : m_springs(number_of_vertices), m_directions(number_of_vertices),
      m_handles(number_of_vertices), m_symmetric_pairs(number_of_vertices)
  {
    insert(elements.springs, m_springs);
    insert(elements.directions, m_directions);
    insert(elements.handles, m_handles);
    insert(elements.symmetric_pairs, m_symmetric_pairs);
  }

  // Adds what is not empty.
  void add_to(Arap_registration& registration)
  {
    const auto add = [&](auto& adaptor) {
      if(!adaptor.elements().empty())
        registration.add_constraint(
          std::make_unique<Registration_constraint_model<std::decay_t<decltype(adaptor)>>>(
            adaptor));
    };
    add(m_springs);
    add(m_directions);
    add(m_handles);
    add(m_symmetric_pairs);
  }

private:
  template <class Elements, class Adaptor>
  static void insert(const Elements& elements, Adaptor& adaptor)
  {
    for(const auto& element : elements)
      adaptor.insert(element);
  }

  Spring_constraint_adaptor_3 m_springs;
  Direction_constraint_adaptor_3 m_directions;
  Handle_constraint_adaptor_3 m_handles;
  Symmetry_constraint_adaptor_3 m_symmetric_pairs;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_CONSTRAINTS_H
