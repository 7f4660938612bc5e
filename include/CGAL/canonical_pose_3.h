// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_H
#define CGAL_CANONICAL_POSE_3_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/internal/body/Indexed_complex.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/linked_bodies.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/options_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/poses.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Real_timer.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <iterator>
#include <type_traits>

namespace CGAL {
inline namespace CGAL_CANONICAL_POSE_3_BODIES {

/*!
\ingroup PkgCanonicalPose3Ref

\brief brings a surface into its detail-preserving canonical pose
\cgalCite{cgal:canonical-s-sdacm-15}.

Multidimensional scaling of geodesic distances to landmarks yields a target point for each vertex. A
tetrahedral body inside the surface is pulled toward these points by an as-rigid-as-possible
registration, which preserves details smaller than the detail length. A shape has nearly the same
canonical pose whether it is bent or straight. The target is mirrored if its
`Canonical_pose_3::target_handedness()` is negative. The pose is positioned by the rigid motion that
fits the target to the input. It follows rigid motions, scaling and relabeling of the input.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam PoseVertexPointMap a model of `WritablePropertyMap` with vertex descriptors of
       `TriangleMesh` as keys and points of the traits as values. It may be the point map of `tmesh`
       itself.
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a polygon mesh. It may have holes, self-intersections, and defects of any kind (see
       `Canonical_pose_3::repair_surface()`); it is repaired internally. Isolated vertices follow
       the body.
\param pose_vertex_point_map receives the pose, if there is one (see `Result::is_usable()`).
\param options the options of the method.
\param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed
       below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices of `tmesh`}
    \cgalParamType{a class model of `ReadablePropertyMap` with vertex descriptors as keys and points
    of the traits as values}
    \cgalParamDefault{`boost::get(CGAL::vertex_point, tmesh)`}
  \cgalParamNEnd
  \cgalParamNBegin{geom_traits}
    \cgalParamDescription{an instance of a geometric traits class}
    \cgalParamType{a class model of `CanonicalPoseTraits_3`}
    \cgalParamDefault{a \cgal Kernel deduced from the point type, using `CGAL::Kernel_traits`}
  \cgalParamNEnd
  \cgalParamNBegin{random_seed}
    \cgalParamDescription{replaces `Options::random_seed`}
    \cgalParamType{unsigned int}
  \cgalParamNEnd
  \cgalParamNBegin{sparse_linear_solver}
    \cgalParamDescription{an instance of a solver whose type replaces `Options::solver`}
    \cgalParamType{a class model of `SparseLinearAlgebraWithBlockFactorTraits_d`}
  \cgalParamNEnd
  \cgalParamNBegin{visitor}
    \cgalParamDescription{replaces `Options::visitor`}
    \cgalParamType{a class model of `RegistrationVisitor_3`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\returns the pose as a matrix, the target, and the summary. Printing the result writes one line. The
         result can be passed to another call, see `Options::given`.

\throws std::invalid_argument if the surface has no area, a coordinate is not finite, there are
       several shapes and the options do not state how to handle them, the requested body
       requires a surface without defects (see `Canonical_pose_3::diagnose()`), or an option is out
       of range; the message states the defect and an element.
\throws std::runtime_error if the solver or the mesher fails, or the program was built without
       support for the requested body.

<em>Complexity:</em> with the default distances, two factorizations of sparse matrices of the size
of the surface and one solve per landmark; one factorization of a matrix of the size of the body;
and one pass over the cells and one solve per iteration.
*/
template <class TriangleMesh, class PoseVertexPointMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!Canonical_pose_3::internal::Is_tetrahedral_complex<TriangleMesh>::value,
                           int> = 0>
Canonical_pose_3::Result
canonical_pose_3(const TriangleMesh& tmesh, PoseVertexPointMap pose_vertex_point_map,
                 const Canonical_pose_3::Options& options = Canonical_pose_3::Options(),
                 const NamedParameters& np = parameters::default_values())
{
  using namespace Canonical_pose_3;
  using parameters::choose_parameter;
  using parameters::get_parameter;
  using Traits = typename GetGeomTraits<TriangleMesh, NamedParameters>::type;

  const Traits traits = choose_parameter<Traits>(get_parameter(np, internal_np::geom_traits));
  const Result result = Canonical_pose_3::internal::pose_of_surface(
    Canonical_pose_3::internal::points_of_parameters(tmesh, np),
    Canonical_pose_3::internal::index_polygons(tmesh),
    Canonical_pose_3::internal::options_of_parameters(options, np),
    Canonical_pose_3::internal::linked_bodies());
  if(result.is_usable())
    put_points(result.pose, tmesh, pose_vertex_point_map, traits);
  return result;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief brings a surface into its detail-preserving canonical pose, with the default options.
*/
template <class TriangleMesh, class PoseVertexPointMap, class T, class Tag, class Base,
          std::enable_if_t<!Canonical_pose_3::internal::Is_tetrahedral_complex<TriangleMesh>::value,
                           int> = 0>
Canonical_pose_3::Result canonical_pose_3(const TriangleMesh& tmesh,
                                          PoseVertexPointMap pose_vertex_point_map,
                                          const Named_function_parameters<T, Tag, Base>& np)
{
  return canonical_pose_3(tmesh, pose_vertex_point_map, Canonical_pose_3::Options(), np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief brings a polygon soup into its detail-preserving canonical pose.

\tparam PointRange a model of `RandomAccessContainer` of points of the traits
\tparam PolygonRange a range of ranges of indices of points
\tparam PosePointRange a model of `BackInsertionSequence` of points of the traits
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param points the points.
\param polygons the faces.
\param pose receives the pose of each point, in the order of `points`, if there is one.
\param options the options of the method.
\param np `geom_traits`, `random_seed`, `sparse_linear_solver` and `visitor`, as for a mesh

\returns as for a mesh.

\throws std::invalid_argument also if a polygon has an invalid index.
*/
template <class PointRange, class PolygonRange, class PosePointRange,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<Canonical_pose_3::internal::Is_range<PosePointRange>::value, int> = 0>
Canonical_pose_3::Result
canonical_pose_3(const PointRange& points, const PolygonRange& polygons, PosePointRange& pose,
                 const Canonical_pose_3::Options& options = Canonical_pose_3::Options(),
                 const NamedParameters& np = parameters::default_values())
{
  using namespace Canonical_pose_3;
  using Point = std::decay_t<decltype(*std::begin(points))>;
  const auto traits = Canonical_pose_3::internal::traits_of_parameters<Point>(np);
  Point_matrix rows(static_cast<Eigen::Index>(std::size(points)), 3);
  Eigen::Index row = 0;
  for(const auto& p : points)
    rows.row(row++) = Canonical_pose_3::internal::to_row(traits, p).transpose();
  const Result result = Canonical_pose_3::internal::pose_of_surface(
    rows, polygons, Canonical_pose_3::internal::options_of_parameters(options, np),
    Canonical_pose_3::internal::linked_bodies());
  if(result.is_usable())
  {
    pose.clear();
    for(row = 0; row < result.pose.rows(); ++row)
      pose.push_back(Canonical_pose_3::internal::from_row(traits, result.pose.row(row)));
  }
  return result;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief brings a polygon soup into its detail-preserving canonical pose, with the default options.
*/
template <class PointRange, class PolygonRange, class PosePointRange, class T, class Tag,
          class Base,
          std::enable_if_t<Canonical_pose_3::internal::Is_range<PosePointRange>::value, int> = 0>
Canonical_pose_3::Result canonical_pose_3(const PointRange& points, const PolygonRange& polygons,
                                          PosePointRange& pose,
                                          const Named_function_parameters<T, Tag, Base>& np)
{
  return canonical_pose_3(points, polygons, pose, Canonical_pose_3::Options(), np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief brings a tetrahedral complex into its detail-preserving canonical pose.

Distances are measured on the boundary of the complex, which must be connected. The cells of the
complex are the body.

\tparam TetrahedralComplex a type for which `Canonical_pose_3::Tetrahedral_complex_traits_3` is
       specialized
\tparam PoseVertexPointMap a model of `WritablePropertyMap` with the vertex descriptors of the
       complex as keys and its points as values
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param complex the complex; it is not changed.
\param pose_vertex_point_map receives the pose, if there is one.
\param options the options of the method.
\param np `geom_traits`, `random_seed`, `sparse_linear_solver` and `visitor`, as for a mesh

\returns as for a mesh.

\throws std::invalid_argument also if a cell has no volume, a cell has an invalid vertex, or three
       cells share a face.
*/
template <class TetrahedralComplex, class PoseVertexPointMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<
            Canonical_pose_3::internal::Is_tetrahedral_complex<TetrahedralComplex>::value, int> = 0>
Canonical_pose_3::Result
canonical_pose_3(const TetrahedralComplex& complex, PoseVertexPointMap pose_vertex_point_map,
                 const Canonical_pose_3::Options& options = Canonical_pose_3::Options(),
                 const NamedParameters& np = parameters::default_values())
{
  using namespace Canonical_pose_3;
  using Point = Canonical_pose_3::internal::Complex_point<TetrahedralComplex>;
  const auto traits = Canonical_pose_3::internal::traits_of_parameters<Point>(np);
  Real_timer timer;
  timer.start();
  const auto indexed = Canonical_pose_3::internal::indexed_complex(complex, traits);
  const double seconds_to_index = timer.time();
  Result result = Canonical_pose_3::internal::pose_of_complex(
    indexed.points, indexed.cells, Canonical_pose_3::internal::options_of_parameters(options, np));
  result.summary.add_seconds("body", seconds_to_index);
  if(result.is_usable())
    for(std::size_t i = 0; i < indexed.vertices.size(); ++i)
      put(pose_vertex_point_map, indexed.vertices[i],
          Canonical_pose_3::internal::from_row(traits,
                                               result.pose.row(static_cast<Eigen::Index>(i))));
  return result;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief brings a tetrahedral complex into its detail-preserving canonical pose, with the default options.
*/
template <class TetrahedralComplex, class PoseVertexPointMap, class T, class Tag, class Base,
          std::enable_if_t<
            Canonical_pose_3::internal::Is_tetrahedral_complex<TetrahedralComplex>::value, int> = 0>
Canonical_pose_3::Result canonical_pose_3(const TetrahedralComplex& complex,
                                          PoseVertexPointMap pose_vertex_point_map,
                                          const Named_function_parameters<T, Tag, Base>& np)
{
  return canonical_pose_3(complex, pose_vertex_point_map, Canonical_pose_3::Options(), np);
}

} // namespace CGAL_CANONICAL_POSE_3_BODIES
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_H
