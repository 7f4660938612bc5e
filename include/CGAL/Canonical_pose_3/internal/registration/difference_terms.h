// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_DIFFERENCE_TERMS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_DIFFERENCE_TERMS_H

#include <CGAL/Canonical_pose_3/internal/registration/Constraint_element_traits.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The terms of constraints with the energy sum_s kappa_s/2 |b_s^t x - d_s|^2, where b_s^t x is x_p - x_q
// for elements of two vertices and x_p for those of one, and `prescribed(i, b_i^t x)` is d_i.

template <class Element>
Eigen::RowVector3d difference(const Element& element, const Point_matrix& points)
{
  const auto vertices = vertices_of(element);
  Eigen::RowVector3d result = points.row(static_cast<Eigen::Index>(vertices.front()));
  if(vertices.size() == 2)
    result -= points.row(static_cast<Eigen::Index>(vertices.back()));
  return result;
}

// The prescribed value, if it is a member of the elements.
template <class Element>
auto given(const std::vector<Element>& elements, Eigen::RowVector3d Element::*member)
{
  return [&elements, member](const std::size_t i, const Eigen::RowVector3d&) {
    return elements[i].*member;
  };
}

// Appends the entries of 1/2 sum_s kappa_s b_s b_s^t.
template <class Element>
void add_difference_matrix(const std::vector<Element>& elements,
                           std::vector<Eigen::Triplet<double>>& matrix)
{
  for(const Element& element : elements)
    for(const std::size_t row : vertices_of(element))
      for(const std::size_t column : vertices_of(element))
        matrix.emplace_back(static_cast<int>(row), static_cast<int>(column),
                            (row == column ? 0.5 : -0.5) * element.stiffness);
}

// Adds 1/2 sum_s kappa_s b_s d_s^t.
template <class Element, class Prescribed>
void add_difference_right_hand_side(const std::vector<Element>& elements,
                                    const Prescribed& prescribed, const Point_matrix& points,
                                    Point_matrix& right_hand_side)
{
  for(std::size_t i = 0; i < elements.size(); ++i)
  {
    Eigen::RowVector3d term
      = elements[i].stiffness / 2 * prescribed(i, difference(elements[i], points));
    for(const std::size_t v : vertices_of(elements[i]))
    {
      right_hand_side.row(static_cast<Eigen::Index>(v)) += term;
      term = -term;
    }
  }
}

template <class Element, class Prescribed>
double difference_energy(const std::vector<Element>& elements, const Prescribed& prescribed,
                         const Point_matrix& points)
{
  double sum = 0;
  for(std::size_t i = 0; i < elements.size(); ++i)
  {
    const Eigen::RowVector3d d = difference(elements[i], points);
    sum += elements[i].stiffness / 2 * (d - prescribed(i, d)).squaredNorm();
  }
  return sum;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_DIFFERENCE_TERMS_H
