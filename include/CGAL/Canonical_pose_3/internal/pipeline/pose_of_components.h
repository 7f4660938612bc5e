// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPONENTS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPONENTS_H

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/canonical_frame.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/fields_of_function.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/describe_fields.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/interpolated_fields.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/timed.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Geometry>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The steps of canonical_pose_3() for one component. `make_body(coarse, fields)` returns a
// `Surface_body_3`.
template <class MakeBody>
Result pose_of_component(const Surface_component_3& surface, const Component_options& options,
                         const MakeBody& make_body)
{
  Registration_summary times;
  for(const char* stage :
      {"diagnosis", "geodesics", "target", "body", "factorization", "local_steps", "global_steps"})
    times.add_seconds(stage, 0);

  const Coarse_surface_3 coarse
    = timed(times, "geodesics", [&] { return coarse_surface(surface, options); });
  const Landmark_fields_3 fields
    = timed(times, "geodesics", [&] { return landmark_fields(coarse, options); });
  std::optional<Landmark_fields_3> target_fields;
  if(options.target_fields_function)
    target_fields = timed(times, "geodesics", [&] {
      return fields_of_function(options.target_fields_function, coarse.surface, options);
    });
  const Surface_body_3 body = timed(times, "body", [&] { return make_body(coarse, fields); });
  const Target_3 target = timed(times, "target", [&] {
    if(options.target_mode == Options::Target_mode::MDS)
      return mds_target(surface, coarse, target_fields ? *target_fields : fields, options);
    Target_3 unfolded = unfolded_target(surface, body, options);
    describe_fields(fields, options, unfolded.summary);
    return unfolded;
  });
  Result result = registered_pose(surface, coarse, fields, target, body, options);
  for(const Registration_summary::Stage& stage : result.summary.stages)
    times.add_seconds(stage.first, stage.second);
  result.summary.stages = std::move(times.stages);
  if(options.return_landmark_fields)
    result.landmark_fields = interpolated_fields(coarse, fields);
  return result;
}

inline void move_to_canonical_frame(const Prepared_surface_3& prepared, Result& result)
{
  std::vector<std::array<std::size_t, 3>> triangles;
  for(const Prepared_surface_3::Component& component : prepared.components)
    for(auto t : component.surface.triangles)
    {
      for(std::size_t& v : t)
        v = static_cast<std::size_t>(
          prepared.vertex_map.vertex_of_row[row_of(component.surface, v)]);
      triangles.push_back(t);
    }
  result.motion = canonical_frame(result.pose, vertex_area_shares(prepared.points, triangles));
  for(Point_matrix* points : {&result.pose, &result.pose_of_followers})
    *points = ((*points * result.motion.linear().transpose()).rowwise()
               + result.motion.translation().transpose())
                .eval();
}

// Poses the components one after the other, the smallest first. `make_body(c, coarse, fields)`
// returns the body of component c.
template <class MakeBody>
Result pose_of_components(const Prepared_surface_3& prepared, const Options& options,
                          const MakeBody& make_body)
{
  std::vector<Result> results(prepared.components.size());
  for(std::size_t c = results.size(); c-- > 0;)
  {
    const auto& [surface, local_options] = prepared.components[c];
    results[c]
      = pose_of_component(surface, local_options,
                          [&, c](const Coarse_surface_3& coarse, const Landmark_fields_3& fields) {
                            return make_body(c, coarse, fields);
                          });
    if(!results[c].is_usable())
      break;
  }
  Result result = joined_result(prepared, results);
  if(result.is_usable())
  {
    if(options.given.target && result.summary.rounds.empty())
      result.target = options.given.target;
    if(options.given.landmark_fields && options.return_landmark_fields)
      result.landmark_fields = options.given.landmark_fields;
    if(options.frame == Options::Frame::CANONICAL)
      move_to_canonical_frame(prepared, result);
  }
  return result;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPONENTS_H
