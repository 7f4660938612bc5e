// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_HEAT_GEODESICS_3_H
#define CGAL_CANONICAL_POSE_3_HEAT_GEODESICS_3_H

#include <CGAL/Canonical_pose_3/Mesh_distances_3.h>
#include <CGAL/Canonical_pose_3/internal/heat/Heat_solver.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>
#include <CGAL/boost/graph/properties.h>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Heat_geodesics_3` computes geodesic distances on a triangle mesh by the heat
method \cgalCite{cgal:canonical-cww-ghnac-13}.

The mesh is first replaced by the intrinsic Delaunay triangulation of the same surface: edges are
flipped based on edge lengths alone, so that the surface and its vertices do not change, and long
thin faces do no harm \cgalCite{cgal:canonical-fsbs-aicid-07}. To compensate for nearly degenerate
faces, one tiny number, at most 1e-10 times the mean edge length, is added to all edges of their
component \cgalCite{cgal:canonical-sc-lntm-20}. Both linear systems are factored by the constructor;
a query consists of two substitutions and one pass over the faces. Sources are processed in groups
of eight: eighty of them in one call take about a fifth of the time of eighty calls on one thread,
less on several. `distance_to_nearest()` returns the smallest of the distances from each source: heat
that flows from all of them at once would cost no more than one, but the potential then differs between
the sources (in a square of \f$ 60^2 \f$ cells with 20 sources, a mean error of at least 6.6 instead of
2.9 percent).

The distance is an approximation: its error converges to 0 with the edge length, and the mean error
is usually 1 to 5 percent. It is not exactly symmetric, and not exactly a metric. Use
`Exact_geodesics_3` if this matters and time does not. Flips do not help if the *vertices* of a
surface are much denser in one direction than in the other: from a ratio of about 15 to 1, the steps
of the heat no longer reach across the gaps, and distances are far too short. Remesh such a surface,
or use a longer time step. (The default is the same for all surfaces: nothing that we measured
distinguishes these from uneven surfaces, where a longer step makes the distances worse.)

<em>Boundary.</em> No heat leaves through the boundary (Neumann). The average with the solution that
is 0 on the boundary, which would require a third factorization, was not better: on a square of
\f$ 100^2 \f$ cells, over five sources from the center to a corner, the mean errors are 0.73 percent
without and 0.98 percent with the average; on half of an icosphere of 5 levels, 0.61 and 0.82
percent. Only on very coarse patches is the average better (\f$ 20^2 \f$ cells: 2.6 and 1.9
percent).

<em>Time step.</em> \f$ t = h^2 \f$, where \f$ h \f$ is \f$ \sqrt{c} \f$ times the mean edge length of
the connected component after the flips, or, if this is larger, 1/300 of the length of the longest
of the shortest paths along edges from the first vertex of the component. The latter keeps the heat,
which decays like \f$ \exp(-d/h) \f$, within the range of `double` everywhere, on meshes of any
size. With \f$ c = 1 \f$, compact surfaces need it from about a hundred thousand vertices on, long
thin ones earlier. The <em>time step factor</em> \f$ c \f$ is a parameter of the constructors; it
has no unit, and its default is 1. The larger it is, the smoother the distances: kinks where
shortest paths from two sides meet, and the influence of the boundary, are spread over a width of
about \f$ h \f$. If it is much smaller than 1, errors do not converge to 0 with the edge length.

<em>Units and determinism.</em> Points may be in any unit. Multiplying all coordinates by a power of
two multiplies all distances by it, bit for bit. Distances do not depend on the number of threads,
the other sources of a batch, or the type of the mesh, provided that vertices and faces are in the
same order.

\tparam TriangleMesh, VertexPointMap, Traits see `Mesh_distances_3`, which has the queries
\tparam FactorTraits a model of `SparseLinearAlgebraWithBlockFactorTraits_d`.<br>
        <b>%Default:</b> `Default_factor_traits_d`

\cgalModels `GeodesicDistances_3`

\sa `CGAL::Canonical_pose_3::Exact_geodesics_3`
\sa `CGAL::Canonical_pose_3::farthest_point_landmarks()`
\sa `CGAL::Canonical_pose_3::front_landmarks()`
*/
template <class TriangleMesh, class VertexPointMap = Default, class Traits = Default,
          class FactorTraits = Default>
class Heat_geodesics_3 : public Mesh_distances_3<TriangleMesh, VertexPointMap, Traits>
{
  using Base = Mesh_distances_3<TriangleMesh, VertexPointMap, Traits>;

public:
  using typename Base::Geom_traits;
  using typename Base::Vertex_point_map;

  /// \name Construction
  /// @{

  /*!
  performs the intrinsic Delaunay flips and factors both systems. Points are read from the property
  map `vertex_point` of the mesh; otherwise the same as the other constructor.
  */
  explicit Heat_geodesics_3(const TriangleMesh& tmesh, const double time_step_factor = 1)
    : Heat_geodesics_3(tmesh, get(vertex_point, tmesh), Geom_traits(), time_step_factor)
  {}

  /*!
  performs the intrinsic Delaunay flips and factors both systems.

  \param tmesh the mesh, not a temporary; it must exist and keep its vertices as long as this
         object. Its points are read only by the constructor: later changes have no effect.
  \param vertex_point_map the point of each vertex, in any unit
  \param traits reads the coordinates of the points
  \param time_step_factor the ratio of the time step to the square of the mean edge length; positive
         and at most 1e6, for which the heat is nearly constant on meshes of any size

  \throws std::invalid_argument if `time_step_factor` is out of range or not a number
  \throws std::invalid_argument if the mesh has no face, no face with an area, a face that is not a
          triangle, or a vertex with a coordinate that is not finite. The message states the index
          of the face or vertex.
  \throws std::runtime_error if a system cannot be factored (out of memory)

  <em>Complexity:</em> the flips are linear in practice; factoring takes \f$ O(n^{1.5}) \f$ for
  \f$ n \f$ vertices, with \f$ O(n \log n) \f$ memory.
  */
  Heat_geodesics_3(const TriangleMesh& tmesh, Vertex_point_map vertex_point_map,
                   const Geom_traits& traits = Geom_traits(), const double time_step_factor = 1)
    : Heat_geodesics_3(tmesh, vertex_point_map, traits, internal::make_factor<FactorTraits>,
                       time_step_factor)
  {}

  /// \cond SKIP_IN_MANUAL
  // With a solver chosen at run time.
  Heat_geodesics_3(const TriangleMesh& tmesh, Vertex_point_map vertex_point_map,
                   const Geom_traits& traits, const internal::Factor_maker factor_maker,
                   const double time_step_factor = 1)
    : Base(tmesh, vertex_point_map, traits,
           [&](const internal::Face_corners& corners, const Point_matrix& points) {
             return internal::make_heat_solver(corners, points, time_step_factor, factor_maker);
           })
  {}

  explicit Heat_geodesics_3(const TriangleMesh&&, double = 1) = delete;
  Heat_geodesics_3(const TriangleMesh&&, Vertex_point_map, const Geom_traits& = Geom_traits(),
                   double = 1)
    = delete;
  /// \endcond

  /// @}

  /// \cond SKIP_IN_MANUAL
  const internal::Intrinsic_triangulation& intrinsic_triangulation() const
  {
    return static_cast<const internal::Heat_solver&>(this->solver()).triangulation();
  }
  /// \endcond
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_HEAT_GEODESICS_3_H
