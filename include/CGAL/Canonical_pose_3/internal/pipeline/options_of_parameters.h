// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_OF_PARAMETERS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_OF_PARAMETERS_H

#include <CGAL/Canonical_pose_3/Linear_solver.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

template <class T, class = void>
struct Is_range : std::false_type
{};

template <class T>
struct Is_range<T, std::void_t<decltype(std::begin(std::declval<T&>()))>> : std::true_type
{};

// The given traits, or those of the points.
template <class Point, class NamedParameters>
auto traits_of_parameters(const NamedParameters& np)
{
  using Given = std::decay_t<decltype(parameters::get_parameter(np, internal_np::geom_traits))>;
  if constexpr(std::is_same<Given, internal_np::Param_not_found>::value)
    return typename Kernel_traits<Point>::Kernel();
  else
    return Given(parameters::get_parameter(np, internal_np::geom_traits));
}

// The points of a mesh, read with the given map and traits.
template <class TriangleMesh, class NamedParameters>
Point_matrix points_of_parameters(const TriangleMesh& tmesh, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;
  return point_matrix(tmesh,
                      choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, tmesh)),
                      choose_parameter<Traits>(get_parameter(np, internal_np::geom_traits)));
}

// The options, unless replaced by named parameters.
template <class NamedParameters>
Options options_of_parameters(Options options, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  options.random_seed
    = choose_parameter(get_parameter(np, internal_np::random_seed), options.random_seed);
  options.visitor = choose_parameter(get_parameter(np, internal_np::visitor), options.visitor);
  using Solver = std::decay_t<decltype(get_parameter(np, internal_np::sparse_linear_solver))>;
  if constexpr(!std::is_same<Solver, internal_np::Param_not_found>::value)
    options.linear_solver = Linear_solver(get_parameter(np, internal_np::sparse_linear_solver));
  return options;
}

// Without named parameters they are not copied, since they may hold all distances.
inline const Options& options_of_parameters(const Options& options,
                                            const parameters::Default_named_parameters&)
{
  return options;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_OPTIONS_OF_PARAMETERS_H
