// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EXTRACT_BOUNDARY_H
#define CGAL_CANONICAL_POSE_3_EXTRACT_BOUNDARY_H

#include <CGAL/Canonical_pose_3/internal/body/Indexed_complex.h>
#include <CGAL/Canonical_pose_3/internal/surface/boundary_triangles.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/helpers.h>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief extracts the boundary of a tetrahedral complex as a surface, and maps its vertices to those
of the complex.

The boundary consists of the faces of exactly one cell, oriented outward. Where it is not a
2-manifold (because cells share only a vertex or an edge), vertices are duplicated, so several
vertices of the surface may correspond to the same vertex of the complex.

\tparam Complex a type for which `Tetrahedral_complex_traits_3` is specialized
\tparam TriangleMesh a model of `MutableFaceGraph` whose points are of the type of those of the complex
\tparam OriginMap a model of `WritablePropertyMap` with the vertex descriptor of `TriangleMesh` as
       key type and that of the complex as value type
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param complex the complex.
\param tmesh receives the boundary.
\param origin_map receives the vertex of the complex of each vertex of `tmesh`.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{receives the points of the vertices of `tmesh`}
    \cgalParamType{a class model of `WritablePropertyMap` with vertex descriptors as keys and points
    of the complex as values}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{reads the coordinates of the points of the complex}
    \cgalParamType{a class model of `CanonicalPoseTraits_3`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\pre `tmesh` is empty.

\throws std::invalid_argument if a face belongs to more than two cells, or a cell has a vertex that
       is not in the complex or a repeated vertex; the message states the index of the cell.

<em>Complexity:</em> \f$ O(m \log m) \f$ for \f$ m \f$ cells.
*/
template <class Complex, class TriangleMesh, class OriginMap,
          class NamedParameters = parameters::Default_named_parameters>
void extract_boundary(const Complex& complex, TriangleMesh& tmesh, OriginMap origin_map,
                      const NamedParameters& np = parameters::default_values())
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  CGAL_precondition(is_empty(tmesh));
  const auto indexed = internal::indexed_complex(
    complex, internal::traits_of_parameters<internal::Complex_point<Complex>>(np));
  std::vector<internal::Index_triangle> triangles
    = internal::boundary_triangles(indexed.points, indexed.cells);
  std::vector<std::size_t> origins;
  internal::make_boundary_manifold(triangles, origins);

  std::vector<vertex_descriptor> vertex_of_row;
  auto point_map = choose_parameter(get_parameter(np, internal_np::vertex_point),
                                    get_property_map(vertex_point, tmesh));
  for(const std::size_t origin : origins)
  {
    const vertex_descriptor v = add_vertex(tmesh);
    put(point_map, v,
        Tetrahedral_complex_traits_3<Complex>::point(complex, indexed.vertices[origin]));
    put(origin_map, v, indexed.vertices[origin]);
    vertex_of_row.push_back(v);
  }
  for(const internal::Index_triangle& t : triangles)
    Euler::add_face(std::array<vertex_descriptor, 3>{vertex_of_row[t[0]], vertex_of_row[t[1]],
                                                     vertex_of_row[t[2]]},
                    tmesh);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_EXTRACT_BOUNDARY_H
