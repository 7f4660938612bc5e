// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_OF_PARAMETERS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_OF_PARAMETERS_H

#include <CGAL/Canonical_pose_3/Linear_solver.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

template <class T, class = void>
struct Is_range : std::false_type
{};

template <class T>
struct Is_range<T, std::void_t<decltype(std::begin(std::declval<T&>()))>> : std::true_type
{};

// The options, unless replaced by named parameters.
template <class NamedParameters>
Options options_of_parameters(Options options, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using parameters::get_parameter_reference;
  options.random_seed
    = choose_parameter(get_parameter(np, internal_np::random_seed), options.random_seed);
  options.visitor = choose_parameter(get_parameter(np, internal_np::visitor), options.visitor);
  // By reference, since it need not be copyable.
  using Solver
    = std::decay_t<decltype(get_parameter_reference(np, internal_np::sparse_linear_solver))>;
  if constexpr(!std::is_same<Solver, internal_np::Param_not_found>::value)
    options.linear_solver
      = Linear_solver(get_parameter_reference(np, internal_np::sparse_linear_solver));
  return options;
}

// Without named parameters they are not copied, since they may hold all distances.
inline const Options& options_of_parameters(const Options& options,
                                            const parameters::Default_named_parameters&)
{
  return options;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_OF_PARAMETERS_H
