// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_FRONT_LANDMARKS_H
#define CGAL_CANONICAL_POSE_3_FRONT_LANDMARKS_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/target/Landmark_front.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>
#include <CGAL/iterator.h>

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

// The points for which the distances were computed: those of the geodesics, if accessible.
template <class GeodesicDistances>
auto landmark_points(const GeodesicDistances& geodesics, int)
  -> decltype(Point_matrix(geodesics.points()))
{
  return geodesics.points();
}

template <class GeodesicDistances>
Point_matrix landmark_points(const GeodesicDistances& geodesics, ...)
{
  return point_matrix(geodesics.triangle_mesh());
}

// The surface on which the fronts run: that of the geodesics, if accessible.
template <class GeodesicDistances>
auto landmark_triangulation(const GeodesicDistances& geodesics, int)
  -> decltype(geodesics.intrinsic_triangulation())
{
  return geodesics.intrinsic_triangulation();
}

template <class GeodesicDistances>
Intrinsic_triangulation landmark_triangulation(const GeodesicDistances& geodesics, ...)
{
  const auto& tmesh = geodesics.triangle_mesh();
  return Delaunay_surface(face_corners(tmesh, number_vertices(tmesh)),
                          landmark_points(geodesics, 0))
    .triangulation();
}

// At most `l` of the first `number` vertices, each approximately the farthest from the previous ones.
inline std::vector<Eigen::Index> front_landmarks(const Intrinsic_triangulation& triangulation,
                                                 std::size_t l, Eigen::Index first,
                                                 const Eigen::Index number)
{
  Landmark_front front(triangulation);
  std::vector<Eigen::Index> landmarks;
  Eigen::VectorXd nearest
    = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(triangulation.number_of_vertices()),
                                (std::numeric_limits<double>::infinity)());
  Eigen::Index next = first;
  do
  {
    landmarks.push_back(next);
    front.lower(next, nearest);
  } while(nearest.head(number).maxCoeff(&next) > 0 && landmarks.size() < l);
  return landmarks;
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief selects landmarks approximately by farthest point sampling, and returns them with their
distance fields, which are computed in one batch.

Farthest point sampling needs the field of each landmark before the next one can be chosen. Here, a
front runs over the surface from each landmark as far as this landmark is the nearest one, with
approximate distances \cgalCite{cgal:canonical-nk-cgdtm-02}. With `Heat_geodesics_3`, this takes a
quarter to a third of the time. With 80 landmarks, the covering radius was that of farthest point
sampling times 1.01 in the mean (0.97 to 1.04) over ten meshes of 2 775 to 50 000 vertices from
their extremal points, and times 1.04 in the mean (0.96 to 1.13) over the five smallest from six
other vertices each. The fields and the covering radius are computed with `geodesics`.

Otherwise the same as `farthest_point_landmarks()`.

\tparam GeodesicDistances a model of `GeodesicDistances_3` whose mesh is a model of `FaceListGraph`,
        oriented, 2-manifold, and triangulated. The fronts run on the points returned by its member
        function `points()`, a `Point_matrix`, or, if there is no such function, on those of the
        property map `vertex_point` of the mesh. For the models of this package, this is always the
        surface with which they were constructed.
\tparam VertexOutputIterator a model of `OutputIterator` that accepts vertex descriptors

\param geodesics the distances.
\param l the number of landmarks.
\param first the first landmark, see `extremal_point()`.
\param out receives the landmarks in the order in which they are chosen.

\pre `l >= 1`

<em>Complexity:</em> \f$ O(n \log n \log l) \f$ for the fronts, and one batch of fields.

\sa `farthest_point_landmarks()`
\sa `Landmark_mds_target_builder_3`
*/
template <class GeodesicDistances, class VertexOutputIterator = Emptyset_iterator>
Landmark_fields_3 front_landmarks(const GeodesicDistances& geodesics, const std::size_t l,
                                  const typename GeodesicDistances::vertex_descriptor first,
                                  VertexOutputIterator out = VertexOutputIterator())
{
  CGAL_precondition(l >= 1);
  const auto vertex_of_row = internal::vertex_descriptors(geodesics.triangle_mesh());
  const auto& triangulation = internal::landmark_triangulation(geodesics, 0);
  const auto rows
    = internal::front_landmarks(triangulation, l, static_cast<Eigen::Index>(geodesics.index(first)),
                                static_cast<Eigen::Index>(triangulation.number_of_vertices()));
  Landmark_fields_3 result;
  std::vector<typename GeodesicDistances::vertex_descriptor> landmarks;
  for(const Eigen::Index row : rows)
  {
    landmarks.push_back(vertex_of_row[row]);
    result.landmarks.push_back(static_cast<std::size_t>(row));
    *out++ = landmarks.back();
  }
  result.distances = geodesics.distances(landmarks);
  Eigen::VectorXd nearest = result.distances.col(0);
  for(Eigen::Index j = 1; j < result.distances.cols(); ++j)
    nearest = nearest.cwiseMin(result.distances.col(j));
  result.covering_radius = nearest.maxCoeff();
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_FRONT_LANDMARKS_H
