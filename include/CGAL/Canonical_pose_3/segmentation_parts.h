// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SEGMENTATION_PARTS_H
#define CGAL_CANONICAL_POSE_3_SEGMENTATION_PARTS_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/options_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Named_function_parameters.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a part of a segmented surface, with its neighbors.

\sa `segmentation_parts()`
*/
struct Segmentation_part_3
{
  /// a part with a common boundary.
  struct Neighbor
  {
    std::size_t part;       ///< its number.
    double boundary_length; ///< the length of the common boundary.
    Eigen::RowVector3d
      boundary_centroid; ///< the centroid of the common boundary: of a limb, the joint.
  };

  std::size_t number_of_faces = 0; ///< the number of faces.
  double area = 0;                 ///< the area.
  std::vector<Neighbor> neighbors; ///< the neighbors, by increasing number.
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief measures the parts of a segmented polygon soup.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.
\param part_of_polygon the part of each polygon, for example from
       `Segmentation_tree_3::parts()`.

\returns the parts, in the order of their numbers.

\throws std::invalid_argument if there is not one part per polygon, a part is not less than the
       number of polygons, a coordinate is not finite (or so large or small that areas would be 0 or
       infinite), or a polygon has an invalid row; the message states the element.

<em>Complexity:</em> \f$ O(n \log n) \f$.
*/
inline std::vector<Segmentation_part_3>
segmentation_parts(const Point_matrix& points, const Face_list& polygons,
                   const std::vector<std::size_t>& part_of_polygon)
{
  if(part_of_polygon.size() != polygons.size())
    throw std::invalid_argument("there are " + std::to_string(part_of_polygon.size())
                                + " parts of polygons, but " + std::to_string(polygons.size())
                                + " polygons");
  for(std::size_t f = 0; f < polygons.size(); ++f)
    if(part_of_polygon[f] >= polygons.size())
      throw std::invalid_argument("face " + std::to_string(f) + " is in part "
                                  + std::to_string(part_of_polygon[f]) + ", but there are only "
                                  + std::to_string(polygons.size()) + " polygons");
  internal::check_finite(points);
  internal::check_unit(points);
  internal::check_elements(polygons, static_cast<std::size_t>(points.rows()), "face");
  std::vector<Segmentation_part_3> result;
  if(polygons.empty())
    return result;
  result.resize(*std::max_element(part_of_polygon.begin(), part_of_polygon.end()) + 1);
  for(const std::size_t part : part_of_polygon)
    ++result[part].number_of_faces;
  const internal::Triangle_soup soup = internal::triangle_soup(points, polygons);
  for(std::size_t t = 0; t < soup.triangles.size(); ++t)
    result[part_of_polygon[soup.face_of_triangle[t]]].area
      += internal::twice_area(points, soup.triangles[t]) / 2;

  const auto n = static_cast<std::size_t>(points.rows());
  const internal::Corner_table corners(n, polygons);
  std::vector<std::map<std::size_t, Segmentation_part_3::Neighbor>> neighbors(result.size());
  corners.for_each_edge([&](const internal::Corner_table::Edge& sides) {
    const Eigen::RowVector3d from = points.row(static_cast<Eigen::Index>(corners.vertex(sides[0])));
    const Eigen::RowVector3d to = points.row(static_cast<Eigen::Index>(corners.target(sides[0])));
    const double length = (to - from).norm();
    const std::size_t a = part_of_polygon[corners.face(sides[0])];
    for(std::size_t k = 1; k < sides.size(); ++k)
    {
      const std::size_t b = part_of_polygon[corners.face(sides[k])];
      if(a == b)
        continue;
      for(const auto& [part, other] : {std::pair(a, b), std::pair(b, a)})
      {
        auto& neighbor
          = neighbors[part]
              .emplace(other, Segmentation_part_3::Neighbor{other, 0, Eigen::RowVector3d::Zero()})
              .first->second;
        neighbor.boundary_length += length;
        neighbor.boundary_centroid += length * (from + to) / 2;
      }
    }
  });
  for(std::size_t part = 0; part < result.size(); ++part)
    for(auto& [other, neighbor] : neighbors[part])
    {
      if(neighbor.boundary_length > 0)
        neighbor.boundary_centroid /= neighbor.boundary_length;
      result[part].neighbors.push_back(neighbor);
    }
  return result;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief measures the parts of a segmented mesh.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam SegmentPropertyMap a model of `ReadablePropertyMap` with face descriptors of `TriangleMesh` as
       keys and an integer type as values
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh.
\param segment_ids the part of each face, from 0.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`
*/
template <class TriangleMesh, class SegmentPropertyMap,
          class NamedParameters = parameters::Default_named_parameters,
          std::enable_if_t<!std::is_same<TriangleMesh, Point_matrix>::value, int> = 0>
std::vector<Segmentation_part_3>
segmentation_parts(const TriangleMesh& tmesh, SegmentPropertyMap segment_ids,
                   const NamedParameters& np = parameters::default_values())
{
  std::vector<std::size_t> parts;
  for(const auto f : faces(tmesh))
    parts.push_back(static_cast<std::size_t>(get(segment_ids, f)));
  return segmentation_parts(internal::points_of_parameters(tmesh, np),
                            internal::index_polygons(tmesh), parts);
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SEGMENTATION_PARTS_H
