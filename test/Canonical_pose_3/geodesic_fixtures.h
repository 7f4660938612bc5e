// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_GEODESIC_FIXTURES_H
#define CGAL_CANONICAL_POSE_3_TEST_GEODESIC_FIXTURES_H

// Common fixtures of the tests of the geodesics.

#include "shapes.h"

#include <CGAL/Canonical_pose_3/front_landmarks.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <Eigen/Core>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_test {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// The `i`-th vertex of a mesh.
template <class AnyMesh>
typename boost::graph_traits<AnyMesh>::vertex_descriptor vertex(const AnyMesh& mesh, std::size_t i)
{
  return *std::next(vertices(mesh).begin(), static_cast<std::ptrdiff_t>(i));
}

/// Sources on `icosphere(3)`: more than four blocks of lanes, the last one not full, one source twice.
inline std::vector<Mesh::Vertex_index> sources_on_ball(const Mesh& mesh)
{
  std::vector<Mesh::Vertex_index> sources;
  for(std::size_t i = 0; i < 37; ++i)
    sources.push_back(vertex(mesh, (i * 71) % 642));
  sources.push_back(sources.front());
  return sources;
}

/// A mesh with a point map besides its own, whose points lie elsewhere.
struct Mesh_with_points
{
  using Point_map = Mesh::Property_map<Mesh::Vertex_index, Kernel::Point_3>;

  explicit Mesh_with_points(const Mesh& original)
    : mesh(original),
      points(mesh.add_property_map<Mesh::Vertex_index, Kernel::Point_3>("true").first)
  {
    for(const auto v : mesh.vertices())
    {
      const Kernel::Point_3 p = points[v] = mesh.point(v);
      mesh.point(v) = Kernel::Point_3(std::exp(3 * p.x()), 0.1 * p.y(), p.z() * p.z());
    }
  }

  Mesh mesh;
  Point_map points;
};

// The fronts run on the points that the distances were computed with, whatever those of the mesh are.
template <class Geodesics, class Geodesics_of_map>
void expect_fronts_on_own_points()
{
  const Mesh mesh = torus<Mesh>(40, 20, 2., 0.7);
  const Mesh_with_points other(mesh);
  const auto expected
    = CGAL::Canonical_pose_3::front_landmarks(Geodesics(mesh), 12, vertex(mesh, 5));
  const auto found = CGAL::Canonical_pose_3::front_landmarks(
    Geodesics_of_map(other.mesh, other.points), 12, vertex(other.mesh, 5));
  EXPECT_EQ(found.landmarks, expected.landmarks);
  EXPECT_EQ(found.distances, expected.distances);
}

/// Mean of |d - e| / e over the rows with e > 0.
inline double mean_relative_error(const Eigen::VectorXd& d, const Eigen::VectorXd& e)
{
  double sum = 0, count = 0;
  for(Eigen::Index i = 0; i < d.size(); ++i)
    if(e[i] > 0)
    {
      sum += std::abs(d[i] - e[i]) / e[i];
      count += 1;
    }
  return sum / count;
}

/// Euclidean distances from vertex `source`.
inline Eigen::VectorXd straight_distances(const Points& points, std::size_t source)
{
  const Eigen::Map<const Eigen::Matrix<double, 3, Eigen::Dynamic>> all(
    points[0].data(), 3, static_cast<Eigen::Index>(points.size()));
  return (all.colwise() - all.col(static_cast<Eigen::Index>(source))).colwise().norm().transpose();
}

/// The unit square grid, stretched by `stretch` along x after each inner vertex was moved by up to
/// 0.2 of a cell, the same on every machine: a flat convex surface of bad triangles.
inline Triangle_soup stretched_square(std::size_t n, double stretch)
{
  Triangle_soup soup = plane_grid_soup(n, n, 1., 1.);
  unsigned int state = 1;
  const auto random = [&] { return (state = state * 1664525u + 1013904223u) / 4294967296. - 0.5; };
  for(std::size_t j = 1; j < n; ++j)
    for(std::size_t i = 1; i < n; ++i)
      for(std::size_t k = 0; k < 2; ++k)
        soup.points[j * (n + 1) + i][k] += 0.4 * random() / double(n);
  for(auto& p : soup.points)
    p[0] *= stretch;
  return soup;
}

/// The message if a call throws `Exception`; "nothing" if it does not throw.
template <class Exception, class Call>
std::string message_of(const Call& call)
{
  try
  {
    call();
  }
  catch(const Exception& exception)
  {
    return exception.what();
  }
  return "nothing";
}

/// Points and functors with only the features required by `CanonicalPoseTraits_3`.
namespace archetype {

class Traits;

class Point
{
  friend class Traits;
  Point(double x, double y, double z) : m_x(x), m_y(y), m_z(z) {}
  double m_x, m_y, m_z;
};

class Traits
{
public:
  using FT = double;
  using Point_3 = Point;
  struct Compute_x_3
  {
    double operator()(const Point& p) const { return p.m_x; }
  };
  struct Compute_y_3
  {
    double operator()(const Point& p) const { return p.m_y; }
  };
  struct Compute_z_3
  {
    double operator()(const Point& p) const { return p.m_z; }
  };
  struct Construct_point_3
  {
    Point operator()(double x, double y, double z) const { return Point(x, y, z); }
  };
  Compute_x_3 compute_x_3_object() const { return {}; }
  Compute_y_3 compute_y_3_object() const { return {}; }
  Compute_z_3 compute_z_3_object() const { return {}; }
  Construct_point_3 construct_point_3_object() const { return {}; }
};

} // namespace archetype

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_GEODESIC_FIXTURES_H
