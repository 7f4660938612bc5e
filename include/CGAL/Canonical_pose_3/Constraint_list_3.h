// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CONSTRAINT_LIST_3_H
#define CGAL_CANONICAL_POSE_3_CONSTRAINT_LIST_3_H

#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/internal/registration/Constraint_element_traits.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

#include <CGAL/assertions.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is the base of all constraint adaptors of this package: a list of elements of one type, which
may be added, modified and removed between two registrations.

\tparam Element `Spring_3`, `Directed_pair_3`, `Handle_3` or `Symmetric_pair_3`
*/
template <class Element>
class Constraint_list_3
{
  using Element_traits = internal::Constraint_element_traits<Element>;
  using State = typename internal::Constraint_element_state<Element_traits>::type;

public:
  /// the elements
  using value_type = Element;

  /// constructs an empty list for a surface of `number_of_vertices` vertices.
  explicit Constraint_list_3(const std::size_t number_of_vertices)
    : m_number_of_vertices(number_of_vertices)
  {}

  /// adds an element and returns its index. The matrix changes.
  /// \throws std::invalid_argument if a vertex does not exist, or a value is out of range; the
  ///         message states the index of the element.
  std::size_t insert(const Element& element)
  {
    check(element, m_elements.size());
    m_states.resize(m_elements.size() + 1);
    m_elements.push_back(element);
    ++m_matrix_revision;
    return m_elements.size() - 1;
  }

  /// replaces an element. The matrix changes if vertices or stiffness change.
  /// \pre `index < elements().size()`
  /// \throws std::invalid_argument as `insert()`; the list is then unchanged.
  void replace(const std::size_t index, const Element& element)
  {
    CGAL_precondition(index < m_elements.size());
    check(element, index);
    Element& previous = m_elements[index];
    const bool has_other_vertices
      = internal::vertices_of(element) != internal::vertices_of(previous);
    if(has_other_vertices)
      m_states[index] = State();
    if(has_other_vertices || element.stiffness != previous.stiffness)
      ++m_matrix_revision;
    previous = element;
  }

  /// changes the stiffness of an element. The matrix changes.
  /// \pre `index < elements().size()`
  /// \throws std::invalid_argument unless `stiffness` is in the range of weights, see
  ///         `Registration_options::SMALLEST_WEIGHT`.
  void set_stiffness(const std::size_t index, const double stiffness)
  {
    Element changed = element(index);
    changed.stiffness = stiffness;
    replace(index, changed);
  }

  /// removes an element; the indices of the following elements decrease by one. The matrix changes.
  /// \pre `index < elements().size()`
  void erase(const std::size_t index)
  {
    CGAL_precondition(index < m_elements.size());
    m_elements.erase(m_elements.begin() + static_cast<std::ptrdiff_t>(index));
    m_states.erase(m_states.begin() + static_cast<std::ptrdiff_t>(index));
    ++m_matrix_revision;
  }

  /// returns the elements.
  const std::vector<Element>& elements() const { return m_elements; }

  /// returns an element.
  /// \pre `index < elements().size()`
  const Element& element(const std::size_t index) const
  {
    CGAL_precondition(index < m_elements.size());
    return m_elements[index];
  }

  /// returns a number that changes whenever the matrix does.
  std::size_t matrix_revision() const { return m_matrix_revision; }

protected:
  /// \cond SKIP_IN_MANUAL
  // State of an element; it is removed with the element, and reset if the vertices change.
  State& state(const std::size_t index) { return m_states[index]; }
  /// \endcond

private:
  void check(const Element& element, const std::size_t index) const
  {
    const auto refuse_if = [&](const bool condition, const std::string& defect) {
      if(condition)
        throw std::invalid_argument(Element_traits::name + (' ' + std::to_string(index)) + ' '
                                    + defect);
    };
    for(const std::size_t v : internal::vertices_of(element))
      refuse_if(v >= m_number_of_vertices, "names vertex " + std::to_string(v) + ", but there are "
                                             + std::to_string(m_number_of_vertices));
    using R = Registration_options;
    refuse_if(!(element.stiffness >= R::SMALLEST_WEIGHT && element.stiffness <= R::LARGEST_WEIGHT),
              "has the stiffness " + internal::shortest_number(element.stiffness)
                + ", but it must be from " + internal::shortest_number(R::SMALLEST_WEIGHT) + " to "
                + internal::shortest_number(R::LARGEST_WEIGHT));
    const std::string defect = Element_traits::defect(element);
    refuse_if(!defect.empty(), defect);
  }

  std::size_t m_number_of_vertices;
  std::size_t m_matrix_revision = 0;
  std::vector<Element> m_elements;
  std::vector<State> m_states; // of the elements
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CONSTRAINT_LIST_3_H
