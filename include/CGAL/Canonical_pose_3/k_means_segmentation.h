// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_K_MEANS_SEGMENTATION_H
#define CGAL_CANONICAL_POSE_3_K_MEANS_SEGMENTATION_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Segmentation_options.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/options_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/segment_mesh.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/// \ingroup PkgCanonicalPose3Ref
/// what `k_means_segmentation()` clusters.
enum class K_means_weights {
  VERTICES, ///< the vertices, all of them with the same weight: as in the paper.
  AREAS ///< the centroids of the faces, weighted by their areas; does not depend on the density of the mesh.
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief clusters positions by \f$ k \f$-means, and returns the cluster of each polygon: that with the
center nearest to its centroid.

This is the segmentation of the paper (Section 8.1) if the positions are those of the canonical pose.
Its parts are the cells of a Voronoi diagram; they need not be connected, and they ignore concave
regions. For better ones, see `consensus_segmentation()`.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.
\param options `number_of_parts`, which must be given, and `random_seed` are used.
\param weights what is clustered.

\returns the part of each polygon, numbered from 0 in the order of the first polygons. There are fewer
         parts than requested if there are fewer different positions.

\throws std::invalid_argument if the number of parts is not given, that of threads is negative, there is
        no polygon, a coordinate is not finite, or a polygon has an invalid row.

<em>Complexity:</em> \f$ O(kn) \f$ per iteration of Lloyd's algorithm.

\cgalCite{cgal:canonical-s-sdacm-15}
*/
std::vector<std::size_t> k_means_parts(const Point_matrix& points, const Face_list& polygons,
                                       const Segmentation_options& options,
                                       K_means_weights weights = K_means_weights::VERTICES);

/*!
\ingroup PkgCanonicalPose3Ref

\brief divides a surface by \f$ k \f$-means of the positions of a pose, as in the paper.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam PoseVertexPointMap a model of `ReadablePropertyMap` with vertex descriptors of `TriangleMesh`
       as keys and points of the traits as values
\tparam SegmentPropertyMap a model of `WritablePropertyMap` with face descriptors of `TriangleMesh` as
       keys and an integer type as values
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh a polygon mesh.
\param pose_vertex_point_map the positions: the canonical pose, or the points of the mesh.
\param segment_ids receives the part of each face, numbered from 0.
\param options `number_of_parts`, which must be given, and `random_seed` are used.
\param weights what is clustered.
\param np `geom_traits`, as for `CGAL::canonical_pose_3()`

\returns the number of parts.

\throws std::invalid_argument as above.

\sa `k_means_parts()`
*/
template <class TriangleMesh, class PoseVertexPointMap, class SegmentPropertyMap,
          class NamedParameters = parameters::Default_named_parameters>
std::size_t
k_means_segmentation(const TriangleMesh& tmesh, PoseVertexPointMap pose_vertex_point_map,
                     SegmentPropertyMap segment_ids, const Segmentation_options& options,
                     const K_means_weights weights = K_means_weights::VERTICES,
                     const NamedParameters& np = parameters::default_values())
{
  return internal::put_parts(
    k_means_parts(internal::points_of_parameters(tmesh, np.vertex_point_map(pose_vertex_point_map)),
                  internal::index_polygons(tmesh), options, weights),
    tmesh, segment_ids);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same with the default weights.
*/
template <class TriangleMesh, class PoseVertexPointMap, class SegmentPropertyMap, class T,
          class Tag, class Base>
std::size_t
k_means_segmentation(const TriangleMesh& tmesh, PoseVertexPointMap pose_vertex_point_map,
                     SegmentPropertyMap segment_ids, const Segmentation_options& options,
                     const Named_function_parameters<T, Tag, Base>& np)
{
  return k_means_segmentation(tmesh, pose_vertex_point_map, segment_ids, options,
                              K_means_weights::VERTICES, np);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_K_MEANS_SEGMENTATION_H
