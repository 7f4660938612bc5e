// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_OPTIONS_CONSTRAINTS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_OPTIONS_CONSTRAINTS_H

#include <CGAL/Canonical_pose_3/Constraints_3.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/Registration_constraint_base.h>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The constraints given by options, in the form required by the registrar.
class Options_constraints
{
public:
  // `number_of_vertices`: number of vertices to which the constraints may refer.
  // Throws `std::invalid_argument` under the same conditions as `Constraint_list_3::insert()`.
  Options_constraints(const Constraints_3& constraints, const std::size_t number_of_vertices)
    : m_function(constraints.function), m_springs(number_of_vertices),
      m_directions(number_of_vertices), m_handles(number_of_vertices),
      m_symmetric_pairs(number_of_vertices)
  {
    insert(constraints.springs, m_springs);
    insert(constraints.directions, m_directions);
    insert(constraints.handles, m_handles);
    insert(constraints.symmetric_pairs, m_symmetric_pairs);
  }

  // Adds the nonempty lists. `vertices`: vertex of the input for each surface vertex of the body.
  void add_to(Arap_registration& registration, const std::vector<std::size_t>& vertices)
  {
    const auto add = [&](auto& constraint) {
      registration.add_constraint(
        std::make_unique<Registration_constraint_model<std::decay_t<decltype(constraint)>>>(
          constraint));
    };
    const auto add_list = [&](auto& adaptor) {
      if(!adaptor.elements().empty())
        add(adaptor);
    };
    add_list(m_springs);
    add_list(m_directions);
    add_list(m_handles);
    add_list(m_symmetric_pairs);
    if(m_function)
      m_of_function = m_function(vertices);
    for(Registration_constraint_3& constraint : m_of_function)
      add(constraint);
  }

private:
  template <class Elements, class Adaptor>
  static void insert(const Elements& elements, Adaptor& adaptor)
  {
    for(const auto& element : elements)
      adaptor.insert(element);
  }

  const Constraints_function m_function;
  std::vector<Registration_constraint_3> m_of_function;
  Spring_constraint_adaptor_3 m_springs;
  Direction_constraint_adaptor_3 m_directions;
  Handle_constraint_adaptor_3 m_handles;
  Symmetry_constraint_adaptor_3 m_symmetric_pairs;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_OPTIONS_CONSTRAINTS_H
