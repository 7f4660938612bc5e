// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SWEEP_SEGMENTATION_H
#define CGAL_CANONICAL_POSE_3_SWEEP_SEGMENTATION_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Segmentation_options.h>
#include <CGAL/Canonical_pose_3/Segmentation_tree_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/options_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/segment_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief divides a surface into a hierarchy of parts, by sweep cuts.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.
\param pose a pose, which is cut instead of the surface; or an empty matrix if there is none.
\param options the options.

\returns the hierarchy of the parts, with one leaf per polygon of the input in their order.

\throws std::invalid_argument if a coordinate is not finite, a polygon has an invalid row, no face has
        an area, the pose has another number of rows, is not finite or has no area, or an option is
        out of range.

<em>Complexity:</em> \f$ O(n \log n) \f$; surfaces of more than 25 000 faces are simplified to 20 000
first.

\sa `sweep_segmentation()`
*/
Segmentation_tree_3 sweep_segmentation_tree(const Point_matrix& points, const Face_list& polygons,
                                            const Point_matrix& pose = Point_matrix(0, 3),
                                            const Segmentation_options& options
                                            = Segmentation_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief divides a surface into parts along concave regions and where it is thin, in a fraction of a second.

The surface is split in two, then one of the parts again, and so on; each time, by the cheapest of
the cuts along level sets of heat kernels and of eigenvectors of the Laplacian, where boundaries cost
their length, less at concave edges, divided by a power of the smaller area. If the number of parts is
not given, components that are concave nowhere and have no neck, such as bars, are not divided. Each
component with less than a three-hundredth of the area is one part.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam PoseVertexPointMap a model of `ReadablePropertyMap` with vertex descriptors of `TriangleMesh`
       as keys and points of the traits as values
\tparam SegmentPropertyMap a model of `WritablePropertyMap` with face descriptors of `TriangleMesh` as
       keys and an integer type as values
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a polygon mesh. It may have several components, holes, self-intersections, and defects of
       any kind (see `repair_surface()`); each face gets a part.
\param pose_vertex_point_map the pose of each vertex, for example from `CGAL::canonical_pose_3()`.
\param segment_ids receives the part of each face, numbered from 0 in the order of the first faces.
\param options the options of the method.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`

\returns the number of parts.

\throws std::invalid_argument if a coordinate is not finite, no face has an area, or an option is out
        of range.

\sa `sweep_segmentation_tree()`
*/
template <class TriangleMesh, class PoseVertexPointMap, class SegmentPropertyMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Is_segment_property_map<SegmentPropertyMap> = 0>
std::size_t sweep_segmentation(const TriangleMesh& tmesh, PoseVertexPointMap pose_vertex_point_map,
                               SegmentPropertyMap segment_ids,
                               const Segmentation_options& options = Segmentation_options(),
                               const NamedParameters& np = parameters::default_values())
{
  return internal::segment_mesh(
    sweep_segmentation_tree, tmesh,
    internal::points_of_parameters(tmesh, np.vertex_point_map(pose_vertex_point_map)), segment_ids,
    options, np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same without a pose.
*/
template <class TriangleMesh, class SegmentPropertyMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t sweep_segmentation(const TriangleMesh& tmesh, SegmentPropertyMap segment_ids,
                               const Segmentation_options& options = Segmentation_options(),
                               const NamedParameters& np = parameters::default_values())
{
  return internal::segment_mesh(sweep_segmentation_tree, tmesh, Point_matrix(0, 3), segment_ids,
                                options, np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same with the default options.
*/
template <class TriangleMesh, class PoseVertexPointMap, class SegmentPropertyMap, class T,
          class Tag, class Base, internal::Is_segment_property_map<SegmentPropertyMap> = 0>
std::size_t sweep_segmentation(const TriangleMesh& tmesh, PoseVertexPointMap pose_vertex_point_map,
                               SegmentPropertyMap segment_ids,
                               const Named_function_parameters<T, Tag, Base>& np)
{
  return sweep_segmentation(tmesh, pose_vertex_point_map, segment_ids, Segmentation_options(), np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same without a pose, with the default options.
*/
template <class TriangleMesh, class SegmentPropertyMap, class T, class Tag, class Base>
std::size_t sweep_segmentation(const TriangleMesh& tmesh, SegmentPropertyMap segment_ids,
                               const Named_function_parameters<T, Tag, Base>& np)
{
  return sweep_segmentation(tmesh, segment_ids, Segmentation_options(), np);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SWEEP_SEGMENTATION_H
