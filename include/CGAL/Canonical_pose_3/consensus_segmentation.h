// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_CONSENSUS_SEGMENTATION_H
#define CGAL_CANONICAL_POSE_3_CONSENSUS_SEGMENTATION_H

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

\brief divides a surface into a hierarchy of parts, by the votes of several segmentations.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.
\param pose the canonical pose of the points, or any other pose, or an empty matrix if there is none.
\param options the options.

\returns the hierarchy of the parts, with one leaf per polygon of the input in their order.

\throws std::invalid_argument if a coordinate is not finite, a polygon has an invalid row, no face has
        an area, the pose has another number of rows, is not finite or has no area, or an option is
        out of range.

<em>Complexity:</em> \f$ O(n \log n) \f$; surfaces of more than 25 000 faces are simplified to 20 000
first.

\sa `consensus_segmentation()`
*/
Segmentation_tree_3
consensus_segmentation_tree(const Point_matrix& points, const Face_list& polygons,
                            const Point_matrix& pose = Point_matrix(0, 3),
                            const Segmentation_options& options = Segmentation_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief divides a surface into the parts that people would name.

Twenty segmentations, of the surface and of its pose by turns, vote on which faces belong to the same
part: sweep cuts with different preferences (see `sweep_segmentation()`), and clusters of faces that
see each other through the inside. If the number of parts is given, they have up to half again as many,
and the sides of sweep cuts have at least 0.035 of the area, or half of the mean area of the parts if
that is less; 0.01, or a fifth, if the shape has no limbs but is one body, where more than half of all
points see each other. Cuts then run along what is concave in the surface and in the pose, since bent
joints are concave in one of them only, and every third sweep of a shape with limbs ignores concave
edges. If the shape has a mirror symmetry, in spite of bent limbs, votes count for both of its sides.
Votes that agree with those of other kinds count more. Faces are merged by the share of common votes, and
boundaries are moved such that they are short and run along concave edges. A pose with less than a
fifth of the volume of the surface (both scaled to the same area), or of its lines of sight, does not
vote. A pose with more than 1.1 times the volume, such as that of a cup, whose wall bulges, does not
vote if the number of parts is not given, and is not compared with the surface if it is. If the number
is not given, components that are concave nowhere and have no neck, such as bars, are not divided.
Each component with less than a three-hundredth of the area is one part, and does not take part.

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

\sa `consensus_segmentation_tree()`
*/
template <class TriangleMesh, class PoseVertexPointMap, class SegmentPropertyMap,
          class NamedParameters = parameters::Default_named_parameters,
          internal::Is_segment_property_map<SegmentPropertyMap> = 0>
std::size_t consensus_segmentation(const TriangleMesh& tmesh,
                                   PoseVertexPointMap pose_vertex_point_map,
                                   SegmentPropertyMap segment_ids,
                                   const Segmentation_options& options = Segmentation_options(),
                                   const NamedParameters& np = parameters::default_values())
{
  return internal::segment_mesh(
    consensus_segmentation_tree, tmesh,
    internal::points_of_parameters(tmesh, np.vertex_point_map(pose_vertex_point_map)), segment_ids,
    options, np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same without a pose.
*/
template <class TriangleMesh, class SegmentPropertyMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t consensus_segmentation(const TriangleMesh& tmesh, SegmentPropertyMap segment_ids,
                                   const Segmentation_options& options = Segmentation_options(),
                                   const NamedParameters& np = parameters::default_values())
{
  return internal::segment_mesh(consensus_segmentation_tree, tmesh, Point_matrix(0, 3), segment_ids,
                                options, np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same with the default options.
*/
template <class TriangleMesh, class PoseVertexPointMap, class SegmentPropertyMap, class T,
          class Tag, class Base, internal::Is_segment_property_map<SegmentPropertyMap> = 0>
std::size_t consensus_segmentation(const TriangleMesh& tmesh,
                                   PoseVertexPointMap pose_vertex_point_map,
                                   SegmentPropertyMap segment_ids,
                                   const Named_function_parameters<T, Tag, Base>& np)
{
  return consensus_segmentation(tmesh, pose_vertex_point_map, segment_ids, Segmentation_options(),
                                np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same without a pose, with the default options.
*/
template <class TriangleMesh, class SegmentPropertyMap, class T, class Tag, class Base>
std::size_t consensus_segmentation(const TriangleMesh& tmesh, SegmentPropertyMap segment_ids,
                                   const Named_function_parameters<T, Tag, Base>& np)
{
  return consensus_segmentation(tmesh, segment_ids, Segmentation_options(), np);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_CONSENSUS_SEGMENTATION_H
