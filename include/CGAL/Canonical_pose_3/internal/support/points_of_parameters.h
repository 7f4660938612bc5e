// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_POINTS_OF_PARAMETERS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_POINTS_OF_PARAMETERS_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Kernel_traits.h>
#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

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

template <class T>
struct Is_named_parameters : std::false_type
{};

template <class T, class Tag, class Base>
struct Is_named_parameters<Named_function_parameters<T, Tag, Base>> : std::true_type
{};

// The points of a mesh, read with the given map and traits.
template <class TriangleMesh, class T, class Tag, class Base>
Point_matrix points_of_parameters(const TriangleMesh& tmesh,
                                  const Named_function_parameters<T, Tag, Base>& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Traits =
    typename GetGeomTraits<TriangleMesh, Named_function_parameters<T, Tag, Base>>::type;
  return point_matrix(tmesh,
                      choose_parameter(get_parameter(np, internal_np::vertex_point),
                                       get_const_property_map(vertex_point, tmesh)),
                      choose_parameter<Traits>(get_parameter(np, internal_np::geom_traits)));
}

// The points of a mesh, read with a map.
template <class TriangleMesh, class VertexPointMap,
          std::enable_if_t<!Is_named_parameters<VertexPointMap>::value, int> = 0>
Point_matrix points_of_parameters(const TriangleMesh& tmesh, VertexPointMap vertex_point_map)
{
  return point_matrix(tmesh, vertex_point_map);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_POINTS_OF_PARAMETERS_H
