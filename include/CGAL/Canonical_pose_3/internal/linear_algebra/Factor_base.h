// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_FACTOR_BASE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_FACTOR_BASE_H

#include <CGAL/Default.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A solver for sparse symmetric positive definite systems, chosen at run time; see the concept
// `SparseLinearAlgebraWithBlockFactorTraits_d`.
class Factor_base
{
public:
  virtual ~Factor_base() = default;
  virtual bool factor(const Eigen::SparseMatrix<double>& matrix) = 0;
  virtual bool solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
                     Eigen::MatrixXd& solutions) const = 0;
  virtual const char* name() const = 0;
};

// Makes a solver without a matrix.
using Factor_maker = std::unique_ptr<Factor_base> (*)();

template <class FactorTraits>
class Factor_model final : public Factor_base
{
public:
  bool factor(const Eigen::SparseMatrix<double>& matrix) override
  {
    typename FactorTraits::NT denominator;
    return m_traits.factor(typename FactorTraits::Matrix(matrix), denominator);
  }

  bool solve(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
             Eigen::MatrixXd& solutions) const override
  {
    return m_traits.linear_solver(right_hand_sides, solutions);
  }

  const char* name() const override { return FactorTraits::name(); }

private:
  FactorTraits m_traits;
};

// Whether T is a model of `SparseLinearAlgebraWithBlockFactorTraits_d`.
template <class T, class = void>
struct Is_factor_traits : std::false_type
{};

template <class T>
struct Is_factor_traits<
  T, std::void_t<decltype(std::declval<T&>().factor(std::declval<const typename T::Matrix&>(),
                                                    std::declval<typename T::NT&>())
                            ? 1
                            : 0),
                 decltype(std::declval<const T&>().linear_solver(
                            std::declval<const Eigen::Ref<const Eigen::MatrixXd>&>(),
                            std::declval<Eigen::MatrixXd&>())
                            ? 1
                            : 0)>>
  : std::bool_constant<
      std::is_default_constructible<T>::value
      && std::is_constructible<typename T::Matrix, const Eigen::SparseMatrix<double>&>::value
      && std::is_convertible<decltype(T::name()), const char*>::value>
{};

// The solver of `Default_factor_traits_d`.
std::unique_ptr<Factor_base> make_default_factor();

template <class FactorTraits>
std::unique_ptr<Factor_base> make_factor()
{
  if constexpr(std::is_same<FactorTraits, Default>::value)
    return make_default_factor();
  else
    return std::make_unique<Factor_model<FactorTraits>>();
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_FACTOR_BASE_H
