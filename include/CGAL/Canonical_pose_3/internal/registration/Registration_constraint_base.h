// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_REGISTRATION_CONSTRAINT_BASE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_REGISTRATION_CONSTRAINT_BASE_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The base that allows the registrar to hold constraints of any type, see the concept
// `RegistrationConstraint_3`.
class Registration_constraint_base
{
public:
  virtual ~Registration_constraint_base() = default;
  virtual std::size_t matrix_revision() const = 0;
  virtual void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const = 0;
  virtual void add_to_right_hand_side(const Point_matrix& points, Point_matrix& right_hand_side)
    = 0;
  virtual double energy(const Point_matrix& points) const = 0;
  virtual bool is_model_of(const void* constraint) const = 0;
};

template <class Constraint>
class Registration_constraint_model : public Registration_constraint_base
{
public:
  explicit Registration_constraint_model(Constraint& constraint) : m_constraint(constraint) {}

  std::size_t matrix_revision() const override { return m_constraint.matrix_revision(); }

  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const override
  {
    m_constraint.add_to_matrix(matrix);
  }

  void add_to_right_hand_side(const Point_matrix& points, Point_matrix& right_hand_side) override
  {
    m_constraint.add_to_right_hand_side(points, right_hand_side);
  }

  double energy(const Point_matrix& points) const override { return m_constraint.energy(points); }

  bool is_model_of(const void* constraint) const override { return constraint == &m_constraint; }

private:
  Constraint& m_constraint;
};

// Whether T has the functions of `RegistrationConstraint_3`.
template <class T, class = void>
struct Is_registration_constraint : std::false_type
{};

template <class T>
struct Is_registration_constraint<
  T, std::void_t<decltype(std::size_t{std::declval<const T&>().matrix_revision()}),
                 decltype(std::declval<const T&>().add_to_matrix(
                   std::declval<std::vector<Eigen::Triplet<double>>&>())),
                 decltype(std::declval<T&>().add_to_right_hand_side(
                   std::declval<const Point_matrix&>(), std::declval<Point_matrix&>())),
                 decltype(
                   double{std::declval<const T&>().energy(std::declval<const Point_matrix&>())})>>
  : std::true_type
{};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_REGISTRATION_CONSTRAINT_BASE_H
