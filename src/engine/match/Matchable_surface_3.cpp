// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../descriptors/Shape_spectrum.h"
#include "../support/Point_search.h"
#include "../surface/root_of_area.h"
#include "../surface/selected_components.h"
#include "Matchable_data.h"

#include <CGAL/Canonical_pose_3/Matchable_surface_3.h>
#include <CGAL/Canonical_pose_3/canonical_frame.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace matching {
namespace {

constexpr std::size_t COARSE_VERTICES = 4000, NUMBER_OF_NEARBY = 96;
constexpr double SMALL_AREA = .05; // of that of the largest component

Shape_spectrum spectrum_of(const Surface_component_3& surface)
{
  return {surface, static_cast<Eigen::Index>(Matchable_surface_3::NUMBER_OF_FUNCTIONS) - 1};
}

Function_matrix functions_of(const Shape_spectrum& spectrum)
{
  Function_matrix functions(spectrum.mass().size(), spectrum.eigenfunctions().cols() + 1);
  functions << Eigen::VectorXf::Ones(functions.rows()), spectrum.eigenfunctions().cast<float>();
  return functions;
}

// Of each component, to its centroid.
Point_matrix relative_to_centroids(const Point_matrix& points,
                                   const std::vector<std::size_t>& components,
                                   const Eigen::VectorXd& mass)
{
  const auto number
    = static_cast<Eigen::Index>(1 + *std::max_element(components.begin(), components.end()));
  Point_matrix centroids = Point_matrix::Zero(number, 3), result = points;
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(number);
  for(std::size_t v = 0; v < components.size(); ++v)
  {
    const auto row = static_cast<Eigen::Index>(v), c = static_cast<Eigen::Index>(components[v]);
    centroids.row(c) += mass[row] * points.row(row);
    masses[c] += mass[row];
  }
  for(std::size_t v = 0; v < components.size(); ++v)
    if(const auto c = static_cast<Eigen::Index>(components[v]); masses[c] > 0)
      result.row(static_cast<Eigen::Index>(v)) -= centroids.row(c) / masses[c];
  return result;
}

// How far vertices are above the surface whose positions have been smoothed by the heat equation, in units of the root of the
// area: a column for each of several times, down to that in which heat spreads to the next vertices.
Function_matrix reliefs_of(Point_matrix points,
                           const std::vector<std::array<std::size_t, 3>>& triangles,
                           const std::vector<std::size_t>& components,
                           const Shape_spectrum& spectrum)
{
  constexpr std::array<double, 4> times = {5e-3, 2.5e-3, 1.2e-3, 6e-4}; // in units of the area
  constexpr double least_time = 2; // in units of the area of a vertex
  normalize(points);
  const Point_matrix normals = vertex_normals(points, triangles);
  points /= std::sqrt(area(points, triangles));
  points = relative_to_centroids(points, components, spectrum.mass());
  const Point_matrix coefficients
    = spectrum.eigenfunctions().transpose() * (spectrum.mass().asDiagonal() * points);
  const auto count = std::count_if(times.begin(), times.end(), [&](const double time) {
    return time * static_cast<double>(points.rows()) >= least_time;
  });
  Function_matrix result(points.rows(), static_cast<Eigen::Index>(count));
  for(std::size_t k = 0; k < static_cast<std::size_t>(count); ++k)
  {
    const Eigen::VectorXd factors = (-times[k] * spectrum.eigenvalues()).array().exp();
    const Point_matrix smoothed = spectrum.eigenfunctions() * (factors.asDiagonal() * coefficients);
    result.col(static_cast<Eigen::Index>(k))
      = (points - smoothed).cwiseProduct(normals).rowwise().sum().cast<float>();
  }
  return result;
}

// Rows stand for all vertices that were stitched, of which a face has its own.
std::vector<std::array<std::size_t, 3>> corners_of(const Repaired_surface_3& surface,
                                                   const Face_list& polygons)
{
  std::vector<std::array<std::size_t, 3>> result(surface.triangles.size());
  for(std::size_t t = 0; t < result.size(); ++t)
  {
    const Face_list::Face face = polygons[surface.face_of_triangle[t]];
    for(std::size_t k = 0; k < 3; ++k)
      result[t][k] = *std::find_if(face.begin(), face.end(), [&](const std::size_t v) {
        return surface.representatives[v] == surface.origins[surface.triangles[t][k]];
      });
  }
  return result;
}

// `points`: those of the surface, in any unit.
std::vector<double> twice_areas_of_components(const Point_matrix& points,
                                              const Repaired_surface_3& surface)
{
  std::vector<double> result(surface.number_of_components, 0.);
  for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    result[surface.component_of_triangle[t]] += twice_area(points, surface.triangles[t]);
  return result;
}

// The largest component, and those that are near it or near one of these: no shape beside it, and no dirt.
Repaired_surface_3 near_components(const Repaired_surface_3& surface)
{
  constexpr double distance = .1; // in units of the root of the area of the largest component
  if(surface.number_of_components == 1)
    return surface;
  const Coarse_surface_3 coarse = coarse_copy(surface, COARSE_VERTICES);
  Point_matrix points = surface.points;
  normalize(points);
  const double limit = distance * std::sqrt(twice_areas_of_components(points, surface).front() / 2);
  points = rows_at(points, coarse.vertices);
  const Point_search search(points);
  const std::vector<std::size_t> components = components_of_rows(surface);
  std::vector<std::vector<std::size_t>> members(surface.number_of_components); // coarse vertices
  for(std::size_t i = 0; i < coarse.vertices.size(); ++i)
    members[components[coarse.vertices[i]]].push_back(i);
  std::vector<bool> is_near(surface.number_of_components, false);
  is_near.front() = true;
  std::vector<std::size_t> front = members.front();
  while(!front.empty())
  {
    const auto row = static_cast<Eigen::Index>(front.back());
    front.pop_back();
    for(const std::size_t i : search.within(limit, points.row(row)))
      if(const std::size_t c = components[coarse.vertices[i]]; !is_near[c])
      {
        is_near[c] = true;
        front.insert(front.end(), members[c].begin(), members[c].end());
      }
  }
  return selected_components(surface, is_near);
}

// Of the rows: whether they belong to a component that is not small.
std::vector<bool> counted_rows(const Repaired_surface_3& surface,
                               const std::vector<std::size_t>& components)
{
  Point_matrix points = surface.points;
  normalize(points);
  const std::vector<double> areas = twice_areas_of_components(points, surface);
  std::vector<bool> result;
  for(const std::size_t c : components)
    result.push_back(areas[c] >= SMALL_AREA * areas.front());
  return result;
}

} // namespace
} // namespace matching

Matchable_data::Matchable_data(const Repaired_surface_3& repaired, const Face_list& polygons,
                               const Point_matrix& given_pose)
  : number_of_vertices(repaired.representatives.size()),
    surface(matching::near_components(repaired)), corners(matching::corners_of(surface, polygons)),
    coarse(coarse_copy(surface, matching::COARSE_VERTICES))
{
  const std::vector<std::size_t> components = components_of_rows(surface);
  is_counted = matching::counted_rows(surface, components);
  std::vector<std::size_t> coarse_components;
  for(const std::size_t row : coarse.vertices)
    coarse_components.push_back(components[row]);
  const Shape_spectrum spectrum = matching::spectrum_of(coarse.surface);
  functions = matching::functions_of(spectrum);
  reliefs = matching::reliefs_of(coarse.surface.points, coarse.surface.triangles, coarse_components,
                                 spectrum);
  for(std::size_t v = 0; v < coarse.vertices.size(); ++v)
    if(is_counted[coarse.vertices[v]])
      counted.push_back(v);
  const Point_matrix pose_of_rows = rows_at(given_pose, surface.origins);
  Eigen::VectorXd shares = vertex_area_shares(pose_of_rows, surface.triangles);
  for(std::size_t row = 0; row < is_counted.size(); ++row)
    if(!is_counted[row])
      shares[static_cast<Eigen::Index>(row)] = 0;
  const Eigen::Isometry3d frame = canonical_frame(pose_of_rows, shares);
  pose_of_vertices = (frame * given_pose.transpose()).transpose();
  pose = (frame * pose_of_rows.transpose()).transpose();
  lengths_of_axes = (shares.transpose() / shares.sum() * pose.cwiseAbs2()).cwiseSqrt().transpose();
  const double radius = lengths_of_axes.norm();
  for(Point_matrix* const positions : {&pose_of_vertices, &pose})
    *positions /= radius;
  lengths_of_axes /= radius;
  coarse_pose = rows_at(pose, coarse.vertices);
  search.emplace(rows_at(coarse_pose, counted));
  nearby = search->nearest(coarse_pose, matching::NUMBER_OF_NEARBY);
  for(std::vector<std::size_t>& vertices : nearby)
    for(std::size_t& v : vertices)
      v = counted[v];
  normals = vertex_normals(pose, surface.triangles);
  root_of_area = internal::root_of_area(surface.points, surface.triangles);
  std::vector<std::array<std::size_t, 3>> compared;
  std::copy_if(surface.triangles.begin(), surface.triangles.end(), std::back_inserter(compared),
               [&](const std::array<std::size_t, 3>& triangle) { return is_counted[triangle[0]]; });
  const double ratio = internal::root_of_area(surface.points, compared)
                       / internal::root_of_area(repaired.points, repaired.triangles);
  compared_share = ratio * ratio;
}

std::vector<std::size_t> Matchable_data::samples(const std::size_t number) const
{
  const std::size_t step = (std::max)(std::size_t(1), counted.size() / number);
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < counted.size(); i += step)
    result.push_back(counted[i]);
  return result;
}

} // namespace internal

Matchable_surface_3::Matchable_surface_3(const Point_matrix& points, const Face_list& polygons,
                                         const Point_matrix& pose)
{
  internal::check_finite(pose);
  if(pose.rows() != points.rows())
    throw std::invalid_argument("there are " + std::to_string(points.rows())
                                + " vertices, but the pose has " + std::to_string(pose.rows()));
  m_data = std::make_shared<const internal::Matchable_data>(repair_surface(points, polygons),
                                                            polygons, pose);
}

std::size_t Matchable_surface_3::number_of_vertices() const { return m_data->number_of_vertices; }

} // namespace Canonical_pose_3
} // namespace CGAL
