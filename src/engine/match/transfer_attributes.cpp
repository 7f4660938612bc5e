// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/transfer_attributes.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

using Location = Surface_match_3::Location;
using Coordinates = std::vector<std::array<float, 2>>;

// For each vertex, the first one at the same position.
std::vector<std::size_t> first_vertices(const Point_matrix& points)
{
  std::map<std::array<double, 3>, std::size_t> first;
  std::vector<std::size_t> result;
  for(Eigen::Index v = 0; v < points.rows(); ++v)
    result.push_back(first
                       .emplace(std::array<double, 3>{points(v, 0), points(v, 1), points(v, 2)},
                                static_cast<std::size_t>(v))
                       .first->second);
  return result;
}

// Texture coordinates of the second surface.
class Textured_surface
{
public:
  Textured_surface(const Point_matrix& points, const Face_list& faces,
                   const Coordinates& coordinates)
    : m_points(points), m_faces(faces), m_coordinates(coordinates), m_first_corners(faces.size()),
      m_charts(faces.size())
  {
    std::size_t corners = 0;
    for(std::size_t f = 0; f < faces.size(); ++f)
    {
      m_first_corners[f] = corners;
      corners += faces[f].size();
    }
    CGAL_precondition(corners == coordinates.size());
    join_charts();
  }

  Eigen::Vector3d point(const Location& location) const
  {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for(std::size_t k = 0; k < 3; ++k)
      result += location.weights[k] * corner_point(location, k);
    return result;
  }

  Eigen::Vector2d coordinates(const Location& location) const
  {
    return coordinates(location, location.weights);
  }

  // Of the point of the plane of a triangle that is nearest to a position.
  Eigen::Vector2d extrapolated(const Location& location, const Eigen::Vector3d& position) const
  {
    const Eigen::Vector3d origin = corner_point(location, 0),
                          u = corner_point(location, 1) - origin,
                          v = corner_point(location, 2) - origin, normal = u.cross(v),
                          to_position = position - origin;
    const double squared_area = normal.squaredNorm();
    if(!(squared_area > 0))
      return coordinates(location);
    const double of_u = to_position.cross(v).dot(normal) / squared_area,
                 of_v = u.cross(to_position).dot(normal) / squared_area;
    return coordinates(location, {1 - of_u - of_v, of_u, of_v});
  }

  // The middle of a triangle of a face.
  Location middle(const std::size_t face) const
  {
    const Face_list::Face corners = m_faces[face];
    CGAL_precondition(corners.size() > 2);
    return {face, {corners[0], corners[1], corners[2]}, {1. / 3, 1. / 3, 1. / 3}};
  }

  // The number of the chart to which a face belongs: faces with the same coordinates at a common edge are of the same one.
  std::size_t chart(const std::size_t face) { return m_charts.find_set(face); }

  // The length of the longest side of a triangle.
  double size(const Location& location) const
  {
    double result = 0;
    for(std::size_t k = 0; k < 3; ++k)
      result = (std::max)(result,
                          (corner_point(location, k) - corner_point(location, (k + 1) % 3)).norm());
    return result;
  }

private:
  void join_charts()
  {
    using Corner = std::pair<std::size_t, std::array<float, 2>>; // a vertex and its coordinates
    const std::vector<std::size_t> first = first_vertices(m_points);
    std::map<std::pair<Corner, Corner>, std::size_t> face_of_side;
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      const std::size_t size = m_faces[f].size();
      for(std::size_t k = 0; k < size; ++k)
      {
        const auto corner = [&](const std::size_t l) {
          return Corner(first[m_faces[f][l]], m_coordinates[m_first_corners[f] + l]);
        };
        const auto [found, is_new]
          = face_of_side.emplace(std::minmax({corner(k), corner((k + 1) % size)}), f);
        if(!is_new)
          m_charts.union_set(f, found->second);
      }
    }
  }

  Eigen::Vector3d corner_point(const Location& location, const std::size_t k) const
  {
    return m_points.row(static_cast<Eigen::Index>(location.vertices[k])).transpose();
  }

  Eigen::Vector2d corner_coordinates(const Location& location, const std::size_t k) const
  {
    const Face_list::Face face = m_faces[location.face];
    const auto corner = static_cast<std::size_t>(
      std::find(face.begin(), face.end(), location.vertices[k]) - face.begin());
    CGAL_precondition(corner < face.size());
    const std::array<float, 2>& value = m_coordinates[m_first_corners[location.face] + corner];
    return {value[0], value[1]};
  }

  Eigen::Vector2d coordinates(const Location& location, const std::array<double, 3>& weights) const
  {
    Eigen::Vector2d result = Eigen::Vector2d::Zero();
    for(std::size_t k = 0; k < 3; ++k)
      result += weights[k] * corner_coordinates(location, k);
    return result;
  }

  const Point_matrix& m_points;
  const Face_list& m_faces;
  const Coordinates& m_coordinates;
  std::vector<std::size_t> m_first_corners; // of the faces
  boost::disjoint_sets_with_storage<> m_charts;
};

} // namespace
} // namespace internal

std::vector<std::size_t> matched_faces(const Surface_match_3& match, const Face_list& faces,
                                       const Point_matrix& other_points,
                                       const Face_list& other_faces)
{
  const std::vector<std::size_t> first = internal::first_vertices(other_points);
  const internal::Buckets<std::size_t> at_vertices(first.size(), [&](const auto& put) {
    for(std::size_t f = 0; f < other_faces.size(); ++f)
      for(const std::size_t v : other_faces[f])
        put(first[v], f);
  });
  std::vector<std::size_t> result;
  std::map<std::size_t, double> shares;
  for(const Face_list::Face face : faces)
  {
    shares.clear();
    for(const std::size_t v : face)
      for(std::size_t k = 0; k < 3; ++k)
        if(const double weight = match.locations[v].weights[k]; weight > 0)
          for(const std::size_t f : at_vertices[first[match.locations[v].vertices[k]]])
            shares[f] += weight;
    CGAL_precondition(!shares.empty());
    result.push_back(
      std::max_element(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first);
  }
  return result;
}

std::vector<std::array<float, 2>>
transferred_texture_coordinates(const Surface_match_3& match, const Face_list& faces,
                                const Point_matrix& other_points, const Face_list& other_faces,
                                const std::vector<std::array<float, 2>>& other_coordinates)
{
  constexpr double farthest = 10; // in sizes of the face of the other surface
  internal::Textured_surface other(other_points, other_faces, other_coordinates);
  const std::vector<std::size_t> matched = matched_faces(match, faces, other_points, other_faces);
  std::vector<std::array<float, 2>> result;
  for(std::size_t f = 0; f < faces.size(); ++f)
  {
    const internal::Location location = other.middle(matched[f]);
    const Eigen::Vector3d center = other.point(location);
    bool is_across_seam = false, is_near = true;
    for(const std::size_t v : faces[f])
    {
      const internal::Location& corner = match.locations[v];
      is_across_seam = is_across_seam || other.chart(corner.face) != other.chart(matched[f]);
      is_near = is_near && (other.point(corner) - center).norm() < farthest * other.size(location);
    }
    for(const std::size_t v : faces[f])
    {
      const internal::Location& corner = match.locations[v];
      const Eigen::Vector2d value = !is_across_seam ? other.coordinates(corner)
                                    : is_near ? other.extrapolated(location, other.point(corner))
                                              : other.coordinates(location);
      result.push_back({static_cast<float>(value[0]), static_cast<float>(value[1])});
    }
  }
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
