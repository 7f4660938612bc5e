// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Coarse_match.h"
#include "Matchable_data.h"
#include "Surface_projection.h"
#include "edge_strain.h"
#include "pose_rotations.h"

#include <CGAL/Canonical_pose_3/Match_options.h>
#include <CGAL/Canonical_pose_3/Matchable_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_match_3.h>
#include <CGAL/Canonical_pose_3/call_with_threads.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/match_surfaces.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace matching {
namespace {

using Indices = std::vector<std::size_t>;
using Location = Surface_match_3::Location;

constexpr std::size_t NONE = (std::numeric_limits<std::size_t>::max)();

// For each vertex of the input, the row that stands for it.
Indices rows_of_vertices(const Matchable_data& shape)
{
  Indices row_of_origin(shape.number_of_vertices, NONE), result;
  for(std::size_t row = 0; row < shape.surface.origins.size(); ++row)
    row_of_origin[shape.surface.origins[row]] = row;
  for(std::size_t v = 0; v < shape.number_of_vertices; ++v)
    result.push_back(row_of_origin[shape.surface.representatives[v]]);
  return result;
}

// Of a pose of all rows, at the vertices for which rows stand, and at those without faces. Of several rows of a vertex, the last
// one counts.
std::vector<Location> locations(const Matchable_data& shape, const Point_matrix& pose,
                                const Point_matrix& normals, const Point_matrix& pose_of_vertices,
                                const Surface_projection& projection)
{
  const Indices rows = rows_of_vertices(shape);
  const std::vector<Location> of_rows = projection.locations(pose, normals);
  std::vector<Location> result(shape.number_of_vertices);
  Indices unknown;
  for(std::size_t v = 0; v < result.size(); ++v)
    if(rows[v] != NONE)
      result[v] = of_rows[rows[v]];
    else
      unknown.push_back(v);
  const std::vector<Location> of_unknown = projection.locations(rows_at(pose_of_vertices, unknown));
  for(std::size_t i = 0; i < unknown.size(); ++i)
    result[unknown[i]] = of_unknown[i];
  return result;
}

// Which vertices of the input are on components that are not small.
std::vector<bool> counted_vertices(const Matchable_data& shape)
{
  std::vector<bool> has_row(shape.number_of_vertices, false), result;
  for(std::size_t row = 0; row < shape.surface.origins.size(); ++row)
    if(shape.is_counted[row])
      has_row[shape.surface.origins[row]] = true;
  for(std::size_t v = 0; v < shape.number_of_vertices; ++v)
    result.push_back(has_row[shape.surface.representatives[v]]);
  return result;
}

// Of values at these vertices.
double mean_of_counted(const Matchable_data& shape, const Eigen::VectorXd& values)
{
  const std::vector<bool> is_counted = counted_vertices(shape);
  Eigen::VectorXd result(values.size());
  Eigen::Index number = 0;
  for(std::size_t v = 0; v < shape.number_of_vertices; ++v)
    if(is_counted[v])
      result[number++] = values[static_cast<Eigen::Index>(v)];
  return result.head(number).mean();
}

// At the vertices for which rows stand; 0 at the other ones.
Point_matrix points_of_vertices(const Matchable_data& shape)
{
  const Indices rows = rows_of_vertices(shape);
  Point_matrix result = Point_matrix::Zero(static_cast<Eigen::Index>(rows.size()), 3);
  for(std::size_t v = 0; v < rows.size(); ++v)
    if(rows[v] != NONE)
      result.row(static_cast<Eigen::Index>(v))
        = shape.surface.points.row(static_cast<Eigen::Index>(rows[v]));
  return result;
}

// Of the vertices of the other surface, which have to be in faces of what is matched.
std::vector<Location>
locations_of_landmarks(const std::vector<std::pair<std::size_t, std::size_t>>& landmarks,
                       const Matchable_data& other)
{
  std::vector<Location> result;
  if(landmarks.empty())
    return result;
  std::map<std::size_t, Location> location_of; // vertices of the other surface
  for(std::size_t t = 0; t < other.corners.size(); ++t)
    for(std::size_t k = 0; k < 3; ++k)
    {
      Location location = {other.surface.face_of_triangle[t], other.corners[t], {}};
      location.weights[k] = 1;
      location_of.emplace(location.vertices[k], location);
    }
  for(const auto& [v, w] : landmarks)
  {
    const auto found = location_of.find(w);
    if(found == location_of.end())
      throw std::invalid_argument(
        "the landmark " + std::to_string(v) + ", " + std::to_string(w) + " cannot be used: vertex "
        + std::to_string(w)
        + " of the other surface has no face, or is on a component far from the largest one");
    result.push_back(found->second);
  }
  return result;
}

void locate(const Matchable_data& a, const Matchable_data& b, const Coarse_match& match,
            const Eigen::Matrix3d& rotation, const Match_options& options,
            const std::vector<Location>& of_landmarks, Surface_match_3& result)
{
  const Point_matrix moves
    = a.coarse.interpolated(Point_matrix(match.position() - a.coarse_pose * rotation)),
    pose = a.pose * rotation + moves, normals = vertex_normals(pose, a.surface.triangles);
  const Surface_projection projection(b, b.pose, b.normals);
  result.locations = locations(a, pose, normals, a.pose_of_vertices * rotation, projection);
  result.locations_of_other
    = locations(b, b.pose, b.normals, b.pose_of_vertices, Surface_projection(a, pose, normals));
  for(std::size_t l = 0; l < of_landmarks.size(); ++l)
    result.locations[options.landmarks[l].first] = of_landmarks[l];
  result.round_trips
    = (result.interpolated(result.interpolated_at_other(a.pose_of_vertices)) - a.pose_of_vertices)
        .rowwise()
        .norm();
  result.mean_round_trip = mean_of_counted(a, result.round_trips);
  result.edge_strain = edge_strain(
    a.surface.points, a.root_of_area,
    rows_at(result.interpolated(points_of_vertices(b)), a.surface.origins), b.root_of_area,
    a.surface.triangles,
    [&](const std::array<std::size_t, 3>& triangle) { return a.is_counted[triangle[0]]; });
}

// The coarse vertices that are counted and nearest to vertices of the input.
Indices coarse_vertices(const Matchable_data& shape, const Indices& vertices)
{
  Indices result;
  for(const Indices& nearest : shape.search->nearest(rows_at(shape.pose_of_vertices, vertices), 1))
    result.push_back(shape.counted[nearest[0]]);
  return result;
}

struct Candidate
{
  Pose_rotation rotation;
  std::unique_ptr<Coarse_match> match;
  double cost;
};

// Of the rotations that bring the poses nearly as close as the best one, those with the best matches, the best first. They are
// compared with few functions, and as long as these do not tell, with more.
std::vector<Candidate> candidates(const Matchable_data& a, const Matchable_data& b,
                                  const Match_options& options)
{
  constexpr double largest_ratio = 2, hopeless_ratio = 2, clear_ratio = 1.3;
  constexpr double least_distance = .05; // between points of a surface and others of the same one
  constexpr std::size_t most_candidates = 16;
  constexpr std::array<Eigen::Index, 3> few_functions = {8, 14, 28};
  constexpr Eigen::Index more_functions = 60;
  Indices landmarks_of_a, landmarks_of_b;
  const std::vector<bool> is_counted_of_a = counted_vertices(a),
                          is_counted_of_b = counted_vertices(b);
  for(const auto& [v, w] : options.landmarks)
    if(is_counted_of_a[v] && is_counted_of_b[w])
    {
      landmarks_of_a.push_back(v);
      landmarks_of_b.push_back(w);
    }
  landmarks_of_a = coarse_vertices(a, landmarks_of_a);
  landmarks_of_b = coarse_vertices(b, landmarks_of_b);
  std::vector<Candidate> result;
  const auto refine = [](Candidate& candidate, const Eigen::Index number_of_functions) {
    candidate.match->refine(number_of_functions);
    candidate.cost = candidate.match->cost();
  };
  const auto sort = [&] {
    std::stable_sort(result.begin(), result.end(),
                     [](const Candidate& c, const Candidate& d) { return c.cost < d.cost; });
  };
  const std::vector<Pose_rotation> rotations = pose_rotations(a, b);
  const double largest_distance
    = largest_ratio * (std::max)(rotations.front().distance, least_distance);
  for(const Pose_rotation& rotation : rotations)
    if(rotation.distance <= largest_distance && result.size() < most_candidates)
      result.push_back({rotation,
                        std::make_unique<Coarse_match>(a, b, rotation.matrix, options,
                                                       landmarks_of_a, landmarks_of_b),
                        0});
  for(const Eigen::Index number : few_functions)
  {
    if(result.size() == 1)
      break;
    for(Candidate& candidate : result)
      refine(candidate, number);
    sort();
    while(result.back().cost > hopeless_ratio * result.front().cost)
      result.pop_back();
  }
  if(result.size() > 1 && result[1].cost < clear_ratio * result[0].cost)
  {
    refine(result[0], more_functions);
    refine(result[1], more_functions);
    result.resize(2);
    sort();
  }
  return result;
}

Surface_match_3 match(const Matchable_data& a, const Matchable_data& b,
                      const Match_options& options)
{
  constexpr double certain_ratio = 1.1;
  constexpr Eigen::Index all_functions = 100;
  const std::vector<Location> of_landmarks = locations_of_landmarks(options.landmarks, b);
  const std::vector<Candidate> sorted = candidates(a, b, options);
  Coarse_match& best = *sorted.front().match;
  const Eigen::Matrix3d& rotation = sorted.front().rotation.matrix;
  best.refine(all_functions);
  best.deform();
  Surface_match_3 result;
  result.mean_distance = sorted.front().rotation.distance;
  result.is_rotation_certain
    = sorted.size() == 1 || sorted[1].cost > certain_ratio * sorted[0].cost;
  result.functional_map = best.functional_map();
  result.scale = a.root_of_area / b.root_of_area;
  result.compared_share = a.compared_share;
  result.compared_share_of_other = b.compared_share;
  locate(a, b, best, rotation, options, of_landmarks, result);
  return result;
}

} // namespace
} // namespace matching
} // namespace internal

void Match_options::check(const std::size_t number_of_vertices,
                          const std::size_t number_of_vertices_of_other) const
{
  for(const auto& [v, w] : landmarks)
    if(v >= number_of_vertices || w >= number_of_vertices_of_other)
      throw std::invalid_argument("the landmark " + std::to_string(v) + ", " + std::to_string(w)
                                  + " is out of range: there are "
                                  + std::to_string(number_of_vertices) + " and "
                                  + std::to_string(number_of_vertices_of_other) + " vertices");
  for(const bool is_of_other : {false, true})
  {
    std::vector<std::pair<std::size_t, std::size_t>> sorted;
    for(const auto& [v, w] : landmarks)
      sorted.push_back(is_of_other ? std::make_pair(w, v) : std::make_pair(v, w));
    std::sort(sorted.begin(), sorted.end());
    for(std::size_t l = 1; l < sorted.size(); ++l)
      if(sorted[l].first == sorted[l - 1].first && sorted[l].second != sorted[l - 1].second)
        throw std::invalid_argument("the landmarks match vertex " + std::to_string(sorted[l].first)
                                    + (is_of_other ? " of the other surface" : "")
                                    + " with vertices " + std::to_string(sorted[l - 1].second)
                                    + " and " + std::to_string(sorted[l].second));
  }
  if(number_of_functions < 4)
    throw std::invalid_argument("the number of functions is " + std::to_string(number_of_functions)
                                + ", but must be at least 4");
  if(!(pose_weight > 0 && pose_weight <= 1e6))
    throw std::invalid_argument("the weight of the pose must be positive and at most 1e6");
  if(number_of_registrations < 0 || number_of_threads < 0)
    throw std::invalid_argument("numbers of registrations and threads must not be negative");
}

Surface_match_3 match_surfaces(const Matchable_surface_3& surface, const Matchable_surface_3& other,
                               const Match_options& options)
{
  options.check(surface.number_of_vertices(), other.number_of_vertices());
  Surface_match_3 result;
  call_with_threads(options.number_of_threads, [&] {
    result = internal::matching::match(surface.data(), other.data(), options);
  });
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
