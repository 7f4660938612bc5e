// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EXAMPLES_ANATOMY_H
#define CGAL_CANONICAL_POSE_3_EXAMPLES_ANATOMY_H

// What the sources of shapes are made of, and the members of `Articulated_shape`.
//
// - The rest shape is the zero set of a smooth union of capsules and ellipsoids.
// - It is meshed once: marching tetrahedra, collapse of short edges down to the requested number of
//   vertices, then rounds of edge flips and tangential smoothing. Collapses preserve the topology,
//   which is the same at every size.
// - A pose bends it along rods through limbs and spine. A rod preserves its length and distributes
//   the angle of a joint over an interval around it, so that geodesics hardly change.
//
// An anatomy provides the static functions `rest_shape(p)`, which is negative inside, and
// `suitable_length(p)`, the relative edge length around `p`. An object is constructed from joint
// angles, and moves a point from the rest pose to that pose.

#include "Articulated_shape.h"

#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace Canonical_pose_examples {

namespace detail {

using Vector = Eigen::Vector3d;

inline double smoothstep(double from, double to, double x)
{
  const double t = (std::min)(1., (std::max)(0., (x - from) / (to - from)));
  return t * t * (3 - 2 * t);
}

/// A bump of height 1 and width about 0.035 around 0.
inline double ridge(double x) { return 1 - smoothstep(0.012, 0.024, std::abs(x)); }

/// Minimum with its crease rounded over the width `k`.
inline double smooth_minimum(double a, double b, double k)
{
  const double h = (std::max)(k - std::abs(a - b), 0.);
  return (std::min)(a, b) - h * h / (4 * k);
}

/// Distance to the segment from `a` to `b`, minus a radius that varies linearly from `ra` to `rb`.
inline double capsule(const Vector& p, const Vector& a, const Vector& b, double ra, double rb)
{
  const Vector ab = b - a;
  const double t = (std::min)(1., (std::max)(0., (p - a).dot(ab) / ab.squaredNorm()));
  return (p - a - t * ab).norm() - (ra + t * (rb - ra));
}

/// Distance to an ellipsoid with axes along x, y, z, accurate to first order near its surface.
inline double ellipsoid(const Vector& p, const Vector& center, const Vector& radii)
{
  const Vector q = (p - center).cwiseQuotient(radii);
  const double norm = q.norm();
  return norm < 1e-9 ? -radii.minCoeff() : norm * (norm - 1) / q.cwiseQuotient(radii).norm();
}

/// `p` after one step of Newton's method toward the surface.
template <class Anatomy>
Vector projected(const Vector& p)
{
  const double f = Anatomy::rest_shape(p), h = 1e-5;
  Vector gradient;
  for(int i = 0; i < 3; ++i)
    gradient[i] = (Anatomy::rest_shape(p + h * Vector::Unit(i)) - f) / h;
  return p - f / gradient.squaredNorm() * gradient;
}

/// Marching tetrahedra over the cubes that intersect the surface; the triangles form a closed
/// 2-manifold.
template <class Anatomy>
class Rest_shape_mesher
{
public:
  std::vector<Vector> points;
  std::vector<std::array<std::size_t, 3>> triangles;

  explicit Rest_shape_mesher(double edge_of_a_cube) : spacing(edge_of_a_cube)
  {
    int size = 1;
    while(size * spacing < 2.1)
      size *= 2;
    visit({{0, 0, 0}}, size);
  }

private:
  using Node = std::array<int, 3>;
  double spacing;
  std::unordered_map<std::uint64_t, double> values;
  std::unordered_map<std::uint64_t, std::size_t> crossings; // key: smaller node, direction

  Vector point(const Node& n) const
  {
    return Vector(-1.0513, -0.1517, -1.0521) + spacing * Vector(n[0], n[1], n[2]);
  }

  static std::uint64_t key(const Node& n, int direction = 0)
  {
    return ((std::uint64_t(n[0]) << 40) | (std::uint64_t(n[1]) << 20) | std::uint64_t(n[2])) << 3
           | std::uint64_t(direction);
  }

  double value(const Node& n)
  {
    const auto found = values.insert({key(n), 0.});
    if(found.second)
      found.first->second = Anatomy::rest_shape(point(n));
    return found.first->second;
  }

  void visit(const Node& low, int size)
  {
    if(size == 1)
      return march(low);
    const Vector center = point(low) + Vector::Constant(spacing * size / 2.);
    if(std::abs(Anatomy::rest_shape(center)) > 2 * spacing * size) // its slope is below 2
      return;
    const int half = size / 2;
    for(int corner = 0; corner < 8; ++corner)
      visit({{low[0] + half * (corner & 1), low[1] + half * (corner >> 1 & 1),
              low[2] + half * (corner >> 2)}},
            half);
  }

  std::size_t crossing(const Node& a, const Node& b)
  {
    const Node& low = a < b ? a : b;
    const int direction
      = std::abs(a[0] - b[0]) + 2 * std::abs(a[1] - b[1]) + 4 * std::abs(a[2] - b[2]);
    const auto found = crossings.insert({key(low, direction), points.size()});
    if(found.second)
    {
      const double t = value(a) / (value(a) - value(b));
      points.push_back((1 - t) * point(a) + t * point(b));
    }
    return found.first->second;
  }

  /// The six Kuhn tetrahedra of one cube.
  void march(const Node& low)
  {
    for(int a = 0; a < 3; ++a)
      for(int turn = 1; turn <= 2; ++turn)
      {
        std::array<Node, 4> tetrahedron = {{low, low, low, {{low[0] + 1, low[1] + 1, low[2] + 1}}}};
        ++tetrahedron[1][a];
        ++tetrahedron[2][a];
        ++tetrahedron[2][(a + turn) % 3];
        if(turn == 2)
          std::swap(tetrahedron[1], tetrahedron[2]); // odd permutations of the axes are inverted
        cut(tetrahedron);
      }
  }

  /// The one or two triangles of a positively oriented tetrahedron, oriented outward.
  void cut(std::array<Node, 4>& t)
  {
    int inside = 0;
    bool odd = false;
    for(int i = 0; i < 4; ++i)
      if(value(t[i]) < 0)
      {
        for(int j = i; j > inside; --j, odd = !odd)
          std::swap(t[j], t[j - 1]);
        ++inside;
      }
    if(inside == 0 || inside == 4)
      return;
    if(odd && inside == 3)
      std::swap(t[0], t[1]);
    else if(odd)
      std::swap(t[2], t[3]);
    auto cross = [&](int i, int j) { return crossing(t[i], t[j]); };
    if(inside == 1)
      triangles.push_back({{cross(0, 1), cross(0, 2), cross(0, 3)}});
    else if(inside == 3)
      triangles.push_back({{cross(0, 3), cross(1, 3), cross(2, 3)}});
    else
    {
      triangles.push_back({{cross(0, 2), cross(0, 3), cross(1, 3)}});
      triangles.push_back({{cross(0, 2), cross(1, 3), cross(1, 2)}});
    }
  }
};

/// Cost of a collapse: edge length relative to the suitable length.
template <class Mesh, class Anatomy>
struct Relative_length_cost
{
  template <class Profile, class Placement>
  auto operator()(const Profile& profile, const Placement& placement) const
  {
    auto cost = CGAL::Surface_mesh_simplification::Edge_length_cost<Mesh>()(profile, placement);
    const auto& p = profile.p0();
    const double suitable = Anatomy::suitable_length(Vector(p.x(), p.y(), p.z()));
    if(cost)
      *cost /= suitable * suitable;
    return cost;
  }
};

struct Number_of_edges_reached
{
  std::size_t requested;

  template <class FT, class Profile>
  bool operator()(const FT&, const Profile&, std::size_t, std::size_t current) const
  {
    return current <= requested;
  }
};

/// One joint of a rod: a rotation that is distributed between two arc lengths.
struct Rod_joint
{
  double center, half_width;
  Eigen::AngleAxisd rotation;
};

/// A straight rod that is bent at its joints, preserving its length.
class Rod
{
public:
  Rod(const Vector& start, const Vector& direction, double arc_length,
      const std::vector<Rod_joint>& joints)
    : length(arc_length)
  {
    Vector bent = start;
    for(int i = 0; i <= STEPS; ++i)
    {
      const double s = length * i / STEPS;
      const Eigen::Matrix3d r = rotation(joints, s);
      frames.push_back(Eigen::Translation3d(bent) * Eigen::Affine3d(r)
                       * Eigen::Translation3d(-start - s * direction));
      bent += length / STEPS * (rotation(joints, s + length / (2 * STEPS)) * direction);
    }
  }

  /// `p` moved with the cross section at arc length `s`.
  Vector operator()(double s, const Vector& p) const
  {
    const double at = STEPS * (std::min)(1., (std::max)(0., s / length));
    const int i = (std::min)(int(at), STEPS - 1);
    return (i + 1 - at) * (frames[i] * p) + (at - i) * (frames[i + 1] * p);
  }

private:
  static constexpr int STEPS = 500;
  double length;
  std::vector<Eigen::Affine3d> frames;

  static Eigen::Matrix3d rotation(const std::vector<Rod_joint>& joints, double s)
  {
    Eigen::Matrix3d r = Eigen::Matrix3d::Identity();
    for(const Rod_joint& j : joints)
    {
      const double share = smoothstep(j.center - j.half_width, j.center + j.half_width, s);
      r *= Eigen::AngleAxisd(share * j.rotation.angle(), j.rotation.axis()).toRotationMatrix();
    }
    return r;
  }
};

/// The rods of a right and a left limb, both as for the left side.
class Pair_of_rods
{
public:
  Pair_of_rods(const Rod& right_rod, const Rod& left_rod) : right(right_rod), left(left_rod) {}

  /// `p` moved with the cross section at arc length `s`; between the limbs, the two motions are
  /// blended.
  Vector operator()(double s, const Vector& p) const
  {
    const Vector mirror(-1, 1, 1);
    const double share = smoothstep(-0.05, 0.05, p.x());
    return share * left(s, p)
           + (1 - share) * Vector(mirror.cwiseProduct(right(s, mirror.cwiseProduct(p))));
  }

private:
  Rod right, left;
};

inline Eigen::AngleAxisd about(const Vector& axis, double degrees)
{
  return Eigen::AngleAxisd(degrees * 3.14159265358979323846 / 180, axis);
}

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

inline Vector vector(const Mesh::Point& p) { return Vector(p.x(), p.y(), p.z()); }

inline Mesh::Vertex_index index(std::size_t i) { return Mesh::Vertex_index(Mesh::size_type(i)); }

template <class Anatomy>
Mesh coarse_mesh(std::size_t number_of_vertices)
{
  // Fine enough to separate the fingers, and to leave a choice of collapses.
  const double spacing = (std::min)(0.012, 2.0 / std::sqrt(double(number_of_vertices)));
  const Rest_shape_mesher<Anatomy> mesher(spacing);
  Mesh mesh;
  for(const Vector& p : mesher.points)
    mesh.add_vertex(Mesh::Point(p.x(), p.y(), p.z()));
  for(const auto& t : mesher.triangles)
    mesh.add_face(index(t[0]), index(t[1]), index(t[2]));
  namespace SMS = CGAL::Surface_mesh_simplification;
  SMS::edge_collapse(mesh, Number_of_edges_reached{3 * number_of_vertices - 6},
                     CGAL::parameters::get_cost(Relative_length_cost<Mesh, Anatomy>())
                       .get_placement(SMS::Midpoint_placement<Mesh>()));
  mesh.collect_garbage();
  return mesh;
}

/// Flips the edges whose opposite angles sum to more than 180 degrees.
inline void flip_edges(Mesh& mesh)
{
  for(Mesh::Edge_index e : mesh.edges())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(e), g = mesh.opposite(h);
    const Mesh::Vertex_index a = mesh.target(mesh.next(h)), b = mesh.target(mesh.next(g));
    const Vector p = vector(mesh.point(mesh.source(h))), q = vector(mesh.point(mesh.target(h)));
    const Vector pa = p - vector(mesh.point(a)), qa = q - vector(mesh.point(a));
    const Vector pb = p - vector(mesh.point(b)), qb = q - vector(mesh.point(b));
    const double cotangents = pa.dot(qa) / pa.cross(qa).norm() + pb.dot(qb) / pb.cross(qb).norm();
    if(cotangents < -1e-3 && mesh.degree(mesh.source(h)) > 3 && mesh.degree(mesh.target(h)) > 3
       && mesh.halfedge(a, b) == Mesh::null_halfedge())
      CGAL::Euler::flip_edge(h, mesh);
  }
}

/// Moves each vertex to the mean of its neighbors, then back onto the surface.
template <class Anatomy>
void smooth(Mesh& mesh)
{
  for(Mesh::Vertex_index v : mesh.vertices())
  {
    Vector mean = Vector::Zero();
    double weights = 0;
    for(Mesh::Vertex_index w : CGAL::vertices_around_target(v, mesh))
    {
      const Vector p = vector(mesh.point(w));
      const double weight = (p - vector(mesh.point(v))).norm() / Anatomy::suitable_length(p);
      mean += weight * p;
      weights += weight;
    }
    const Vector moved = 0.4 * vector(mesh.point(v)) + 0.6 / weights * mean;
    const Vector p = projected<Anatomy>(projected<Anatomy>(moved));
    mesh.point(v) = Mesh::Point(p.x(), p.y(), p.z());
  }
}

} // namespace detail

template <class Anatomy, class Angles>
Articulated_shape<Anatomy, Angles>::Articulated_shape(const std::size_t number_of_vertices)
{
  using detail::Mesh;
  if(number_of_vertices < 2000 || number_of_vertices > 2000000)
    throw std::invalid_argument("the figure has 2000 to 2000000 vertices");
  Mesh mesh = detail::coarse_mesh<Anatomy>(number_of_vertices);
  for(int round = 0; round < 8; ++round)
  {
    detail::flip_edges(mesh);
    detail::smooth<Anatomy>(mesh);
  }
  for(const Mesh::Vertex_index v : mesh.vertices())
    rest.push_back(detail::vector(mesh.point(v)));
  for(const Mesh::Face_index f : mesh.faces())
  {
    const Mesh::Halfedge_index h = mesh.halfedge(f);
    faces.push_back({{mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))}});
  }
}

template <class Anatomy, class Angles>
auto Articulated_shape<Anatomy, Angles>::points(const Joint_angles& angles) const -> Points
{
  const Anatomy pose(angles);
  Points result;
  result.reserve(rest.size());
  double lowest = 1e9;
  for(const Eigen::Vector3d& p : rest)
  {
    const Eigen::Vector3d q = pose(p);
    result.push_back({{q.x(), q.y(), q.z()}});
    lowest = (std::min)(lowest, q.y());
  }
  for(auto& p : result)
    p[1] -= lowest;
  return result;
}

template <class Anatomy, class Angles>
std::size_t Articulated_shape<Anatomy, Angles>::nearest_vertex(const Eigen::Vector3d& point) const
{
  const auto nearer = [&](const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
    return (p - point).squaredNorm() < (q - point).squaredNorm();
  };
  return std::size_t(std::min_element(rest.begin(), rest.end(), nearer) - rest.begin());
}

} // namespace Canonical_pose_examples

#endif // CGAL_CANONICAL_POSE_3_EXAMPLES_ANATOMY_H
