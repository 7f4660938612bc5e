// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SHAPE_DESCRIPTOR_H
#define CGAL_CANONICAL_POSE_3_SHAPE_DESCRIPTOR_H

#include <CGAL/Canonical_pose_3/internal/pipeline/options_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>

#include <CGAL/Named_function_parameters.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief describes a mesh by a vector.

\tparam ShapeDescriptor a model of `ShapeDescriptor_3`
\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param descriptor the descriptor
\param tmesh a polygon mesh. It may have several components, holes, self-intersections, and defects of
       any kind (see `repair_surface()`).
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`. A descriptor that
       depends on the pose, such as `Shape_distribution_d2_3`, is given the map of the pose.

\returns the values of the descriptor.

\throws std::invalid_argument if a coordinate is not finite, or no face has an area.
*/
template <class ShapeDescriptor, class TriangleMesh,
          class NamedParameters = parameters::Default_named_parameters>
Eigen::VectorXd shape_descriptor(const ShapeDescriptor& descriptor, const TriangleMesh& tmesh,
                                 const NamedParameters& np = parameters::default_values())
{
  return descriptor(internal::points_of_parameters(tmesh, np), internal::index_polygons(tmesh));
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SHAPE_DESCRIPTOR_H
