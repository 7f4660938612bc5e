// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SEGMENT_MESH_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SEGMENT_MESH_H

#include <CGAL/Canonical_pose_3/Segmentation_options.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/options_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Writes the part of each face to a property map, and returns the number of parts.
template <class FaceListGraph, class SegmentPropertyMap>
std::size_t put_parts(const std::vector<std::size_t>& parts, const FaceListGraph& mesh,
                      SegmentPropertyMap segment_ids)
{
  using Id = typename boost::property_traits<SegmentPropertyMap>::value_type;
  std::size_t number = 0, index = 0;
  for(const auto f : faces(mesh))
  {
    number = (std::max)(number, parts[index] + 1);
    put(segment_ids, f, static_cast<Id>(parts[index++]));
  }
  return number;
}

// Segments a mesh with a function that returns the hierarchy of the parts.
template <class Function, class TriangleMesh, class SegmentPropertyMap, class NamedParameters>
std::size_t segment_mesh(const Function& segmentation_tree, const TriangleMesh& tmesh,
                         const Point_matrix& pose, SegmentPropertyMap segment_ids,
                         const Segmentation_options& options, const NamedParameters& np)
{
  return put_parts(
    segmentation_tree(points_of_parameters(tmesh, np), index_polygons(tmesh), pose, options)
      .parts(),
    tmesh, segment_ids);
}

// Overload resolution: options and named parameters are no property maps.
template <class T>
using Is_segment_property_map = std::enable_if_t<
  !std::is_same<T, Segmentation_options>::value && !Is_named_parameters<T>::value, int>;

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_SEGMENT_MESH_H
