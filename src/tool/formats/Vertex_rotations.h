// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_VERTEX_ROTATIONS_H
#define CGAL_CANONICAL_POSE_3_TOOL_VERTEX_ROTATIONS_H

#include "Mesh_file.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

using Points = std::vector<std::array<double, 3>>;

inline Eigen::Vector3d vector_of(const std::array<double, 3>& p) { return {p[0], p[1], p[2]}; }

// For each vertex, the first one at its position.
inline std::vector<std::size_t> places_of(const Points& points)
{
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::vector<std::size_t> result = order;
  std::stable_sort(order.begin(), order.end(),
                   [&](const std::size_t v, const std::size_t w) { return points[v] < points[w]; });
  for(std::size_t i = 1; i < order.size(); ++i)
    if(points[order[i]] == points[order[i - 1]])
      result[order[i]] = result[order[i - 1]];
  return result;
}

// The direction of the first side that has one, and the normal; nothing if the face has no area.
inline std::optional<Eigen::Matrix3d> frame_of_face(const Face_list::Face face, const Points& points)
{
  const Eigen::Vector3d origin = vector_of(points[face[0]]);
  Eigen::Vector3d side = Eigen::Vector3d::Zero(), normal = Eigen::Vector3d::Zero();
  for(std::size_t k = 1; k < face.size(); ++k)
  {
    const Eigen::Vector3d q = vector_of(points[face[k]]) - origin;
    if(side.isZero(0))
      side = q;
    if(k > 1)
      normal += (vector_of(points[face[k - 1]]) - origin).cross(q);
  }
  const Eigen::Vector3d z = normal.stableNormalized(),
                        x = (side - z.dot(side) * z).stableNormalized();
  if(!z.allFinite() || !x.allFinite() || z.isZero(0) || x.isZero(0))
    return std::nullopt;
  Eigen::Matrix3d result;
  result << x, z.cross(x), z;
  return result;
}

// How a face turns from one position of the vertices to another; 0 if it has no area in one of them.
inline Eigen::Matrix3d rotation_of_face(const Face_list::Face face, const Points& before,
                                        const Points& after)
{
  const auto from = frame_of_face(face, before), to = frame_of_face(face, after);
  return from && to ? Eigen::Matrix3d(*to * from->transpose())
                    : Eigen::Matrix3d(Eigen::Matrix3d::Zero());
}

// The direction of a turned normal, with the length of the normal; the normal itself if there is none.
inline Eigen::Vector3d turned_normal(const Eigen::Vector3d& turned, const Eigen::Vector3d& normal)
{
  const Eigen::Vector3d direction = turned.stableNormalized();
  return direction.allFinite() && direction.squaredNorm() > .5
           ? Eigen::Vector3d(direction * normal.stableNorm())
           : normal;
}

// Directions that differ by a twentieth of a degree are not distinguished.
using Rounded_direction = std::array<long, 3>;

inline Rounded_direction rounded(const Eigen::Vector3d& normal)
{
  const double steps = 1000;
  const Eigen::Vector3d direction = normal.stableNormalized() * steps;
  if(!direction.allFinite())
    return {};
  return {std::lround(direction[0]), std::lround(direction[1]), std::lround(direction[2])};
}

// How normals turn with the faces at a vertex, from one position of the vertices to another. Vertices at the same position
// with the same normal belong together: normals along seams remain equal, and those at a hard edge turn with the
// faces of their side.
class Vertex_rotations
{
public:
  Vertex_rotations(const Mesh_file& mesh, const Points& points,
                   const std::vector<Eigen::Vector3d>& normals)
    : m_place(places_of(mesh.points)), m_sums(mesh.points.size(), Eigen::Matrix3d::Zero())
  {
    std::map<std::pair<std::size_t, Rounded_direction>, std::size_t> groups;
    for(std::size_t v = 0; v < m_place.size(); ++v)
      m_place[v] = groups.try_emplace({m_place[v], rounded(normals[v])}, v).first->second;
    for(const Face_list::Face face : mesh.faces)
    {
      const Eigen::Matrix3d rotation = rotation_of_face(face, mesh.points, points);
      for(const std::size_t v : face)
        m_sums[m_place[v]] += rotation;
    }
  }

  // The normal of a vertex after the rotation.
  Eigen::Vector3d operator()(const std::size_t vertex, const Eigen::Vector3d& normal) const
  {
    return turned_normal(m_sums[m_place[vertex]] * normal, normal);
  }

private:
  std::vector<std::size_t> m_place;
  std::vector<Eigen::Matrix3d> m_sums; // of the rotations of faces
};

// How normals of corners turn: those at the same position with the same normal together.
class Corner_rotations
{
public:
  Corner_rotations(const Mesh_file& mesh, const Points& before, const Points& after)
    : m_mesh(mesh), m_places(places_of(before))
  {
    m_rotations.reserve(mesh.faces.size());
    for(const Face_list::Face face : mesh.faces)
      m_rotations.push_back(rotation_of_face(face, before, after));
  }

  void add(const std::size_t face, const std::size_t corner, const Eigen::Vector3d& normal)
  {
    m_sums.try_emplace(key(face, corner, normal), Eigen::Vector3d::Zero()).first->second
      += m_rotations[face] * normal;
  }

  // Of a normal that was added.
  Eigen::Vector3d operator()(const std::size_t face, const std::size_t corner,
                             const Eigen::Vector3d& normal) const
  {
    return turned_normal(m_sums.at(key(face, corner, normal)), normal);
  }

private:
  using Key = std::pair<std::size_t, Rounded_direction>;

  Key key(const std::size_t face, const std::size_t corner, const Eigen::Vector3d& normal) const
  {
    return {m_places[m_mesh.faces[face][static_cast<std::ptrdiff_t>(corner)]], rounded(normal)};
  }

  const Mesh_file& m_mesh;
  std::vector<std::size_t> m_places;
  std::vector<Eigen::Matrix3d> m_rotations;
  std::map<Key, Eigen::Vector3d> m_sums;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_VERTEX_ROTATIONS_H
