// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_POSE_OF_COMPONENTS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_POSE_OF_COMPONENTS_H

#include "component_options.h"
#include "describe_fields.h"
#include "fields_of_function.h"
#include "interpolated_fields.h"
#include "pose_in_stance.h"
#include "timed.h"
#include "../support/in_parallel.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Limb_direction_3.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/canonical_frame.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <CGAL/Real_timer.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Whether landmarks are vertices of the input.
inline bool are_origins(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                        const std::vector<std::size_t>& landmarks)
{
  return std::all_of(landmarks.begin(), landmarks.end(), [&](const std::size_t landmark) {
    return coarse.vertices[landmark] < surface.origins.size();
  });
}

// Distances from landmarks that are vertices of the input.
inline Landmark_fields_3 fields_of_origins(const Surface_component_3& surface,
                                           const Method_options& options)
{
  const Indexed_mesh mesh = indexed_mesh(surface.points, surface.triangles);
  const Delaunay_surface delaunay(face_corners(mesh, number_vertices(mesh)), surface.points);
  const auto number = static_cast<Eigen::Index>(surface.origins.size());
  const auto first = static_cast<Eigen::Index>(first_landmark(surface, options));
  std::vector<std::size_t> landmarks;
  for(const Eigen::Index row : front_landmarks(
        delaunay.triangulation(), options.number_of_landmarks, first < number ? first : 0, number))
    landmarks.push_back(static_cast<std::size_t>(row));
  return landmark_fields(surface, landmarks, options);
}

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
  if(result.is_usable()
     && (options.stance != Options::Stance::CANONICAL || !options.limb_directions.empty()
         || options.frame == Options::Frame::BODY))
    result = pose_in_stance(surface, coarse, body, options, std::move(result));
  for(const Registration_summary::Stage& stage : result.summary.stages)
    times.add_seconds(stage.first, stage.second);
  result.summary.stages = std::move(times.stages);
  if(options.return_landmark_fields)
    result.landmark_fields = are_origins(surface, coarse, fields.landmarks)
                               ? interpolated_fields(coarse, fields)
                               : fields_of_origins(surface, options);
  return result;
}

// The shares of the vertices of the input in the area. Vertices that were added give theirs to those
// of which they are combinations.
inline Eigen::VectorXd shares_of_vertices(const Prepared_surface_3& prepared)
{
  const auto n = static_cast<std::size_t>(prepared.points.rows());
  Point_matrix points = prepared.points;
  std::vector<Index_triangle> triangles;
  std::vector<Vertex_combination_3> combinations;
  for(const auto& [surface, options] : prepared.components)
  {
    const std::size_t first = n + combinations.size(), number = surface.origins.size();
    const auto index = [&, &surface = surface](const std::size_t v) {
      return v < number
               ? static_cast<std::size_t>(prepared.vertex_map.vertex_of_row[row_of(surface, v)])
               : first + (v - number);
    };
    for(Index_triangle t : surface.triangles)
    {
      std::transform(t.begin(), t.end(), t.begin(), index);
      triangles.push_back(t);
    }
    for(Vertex_combination_3 combination : surface.added)
    {
      std::transform(combination.vertices.begin(), combination.vertices.end(),
                     combination.vertices.begin(), index);
      combinations.push_back(combination);
    }
    points.conservativeResize(points.rows() + static_cast<Eigen::Index>(surface.added.size()), 3);
    points.bottomRows(static_cast<Eigen::Index>(surface.added.size()))
      = surface.points.bottomRows(static_cast<Eigen::Index>(surface.added.size()));
  }
  Eigen::VectorXd shares = vertex_area_shares(points, triangles);
  for(std::size_t i = combinations.size(); i-- > 0;)
    for(std::size_t k = 0; k < 3; ++k)
      shares[static_cast<Eigen::Index>(combinations[i].vertices[k])]
        += combinations[i].weights[k] * shares[static_cast<Eigen::Index>(n + i)];
  return shares.head(static_cast<Eigen::Index>(n));
}

inline void move(const Eigen::Isometry3d& motion, Result& result)
{
  result.motion = motion;
  for(Point_matrix* points : {&result.pose, &result.pose_of_followers})
    *points = ((*points * result.motion.linear().transpose()).rowwise()
               + result.motion.translation().transpose())
                .eval();
  if(!result.skeleton)
    return;
  for(Skeleton_3::Joint& joint : result.skeleton->joints)
    joint.position = (motion * joint.position.transpose()).transpose();
  result.skeleton->frame = result.skeleton->frame * motion.inverse();
}

// Whether options contain functions or models of the user, which may have a state.
inline bool have_functions(const Options& options)
{
  return options.visitor || options.make_body || options.landmark_fields_function
         || options.target_fields_function || options.mds_kernel || options.linear_solver
         || options.constraints.function;
}

// Calls f(c) for each component and, if it throws, keeps the exception: one after the other, the
// smallest first, until one is not usable, or in parallel. `f` returns whether the next is called.
template <class Function>
void for_each_component(const std::size_t n, const bool in_order, const Function& f)
{
  std::vector<std::exception_ptr> exceptions(n);
  std::vector<char> is_last(n, 0);
  const auto call = [&](const std::size_t c) {
    try
    {
      is_last[c] = !f(c);
    }
    catch(...)
    {
      exceptions[c] = std::current_exception();
    }
  };
  if(!in_order)
    for_each_index(n, [&](const std::size_t c) { isolated([&] { call(c); }); });
  for(std::size_t c = n; c-- > 0;)
  {
    if(in_order)
      call(c);
    if(exceptions[c])
      std::rethrow_exception(exceptions[c]);
    if(is_last[c])
      break;
  }
}

// The stages of components that were posed in parallel, in proportion to the time that passed.
inline void share_time(const double seconds, std::vector<Result>& results)
{
  double sum = 0;
  for(const Result& result : results)
    sum += result.summary.total_seconds();
  if(sum > seconds)
    for(Result& result : results)
      for(Registration_summary::Stage& stage : result.summary.stages)
        stage.second *= seconds / sum;
}

// Poses the components: one after the other, the smallest first, if there are functions of the user,
// otherwise in parallel. `make_body(c, coarse, fields)` returns the body of component c.
template <class MakeBody>
Result pose_of_components(const Prepared_surface_3& prepared, const Options& options,
                          const MakeBody& make_body)
{
  std::vector<Result> results(prepared.components.size());
  Real_timer timer;
  timer.start();
  for_each_component(results.size(), results.size() == 1 || have_functions(options),
                     [&](const std::size_t c) {
                       const auto& [surface, own_options] = prepared.components[c];
                       std::optional<Component_options> watched;
                       if(options.visitor)
                       {
                         watched = own_options;
                         watched->visitor = [&, c](Registration_progress progress) {
                           progress.component = c;
                           return options.visitor(progress);
                         };
                       }
                       try
                       {
                         results[c] = pose_of_component(
                           surface, watched ? *watched : own_options,
                           [&, c](const Coarse_surface_3& coarse, const Landmark_fields_3& fields) {
                             return make_body(c, coarse, fields);
                           });
                       }
                       catch(const Limb_direction_error& error) // the index is a local one
                       {
                         throw Limb_direction_error(
                           limb_directions_of(Component_index(c), options.limb_directions,
                                              prepared.vertex_map)[error.index()],
                           error.defect());
                       }
                       return results[c].is_usable();
                     });
  if(results.size() > 1)
    share_time(timer.time(), results);
  Result result = joined_result(prepared, results);
  if(result.is_usable())
  {
    if(const Result& largest = results.front(); largest.skeleton)
      result.skeleton = with_weights_at(result.pose, largest.pose, *largest.skeleton);
    if(options.given.target && result.summary.rounds.empty())
      result.target = options.given.target;
    if(options.given.landmark_fields && options.return_landmark_fields)
      result.landmark_fields = options.given.landmark_fields;
    if(options.frame == Options::Frame::CANONICAL)
      move(canonical_frame(result.pose, shares_of_vertices(prepared)), result);
    else if(options.frame != Options::Frame::INPUT && result.skeleton)
      move(result.skeleton->frame, result);
  }
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_POSE_OF_COMPONENTS_H
