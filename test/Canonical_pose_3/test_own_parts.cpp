// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Gaussian_kernel.h>
#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Vertex_constraints_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_own_parts {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using CP::Point_matrix;
using Triangles = std::vector<std::array<std::size_t, 3>>;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Point_matrix pose(const CP::Options& options)
{
  return shapes::pose_of(shapes::bent_bar(), options).pose;
}

CP::Landmark_fields_3 wavefront_fields(const Point_matrix& points, const Triangles& triangles,
                                       const std::size_t number, const std::size_t first,
                                       const std::vector<std::size_t>& landmarks)
{
  if(!landmarks.empty())
    return CP::landmark_fields_function<CP::Wavefront_geodesics_3<Mesh>>()(
      points, triangles, number, first, landmarks);
  const Mesh mesh = CP::make_triangle_mesh<Mesh>(points, triangles);
  return CP::front_landmarks(CP::Wavefront_geodesics_3<Mesh>(mesh), number,
                             Mesh::Vertex_index(Mesh::size_type(first)));
}

CP::Elastic_body_3 fine_lattice(const Point_matrix& points, const Triangles& triangles,
                                const CP::Landmark_fields_3& fields)
{
  return CP::Lattice_body_3(points, triangles, fields.distances, 0.04);
}

// Built-in choices, passed as user-defined parts, yield the same bytes.
TEST(Own_parts, are_used_as_those_named)
{
  CP::Options named, own;
  named.geodesics = CP::Options::Geodesics::WAVEFRONT;
  named.random_seed = 3;
  named.number_of_landmarks = 20;
  own = named;
  own.geodesics = CP::Options::Geodesics::HEAT;
  own.landmark_fields_function = wavefront_fields;
  EXPECT_EQ(pose(own), pose(named));

  named = own = CP::Options();
  named.kernel = CP::Options::Kernel::GAUSSIAN;
  own.mds_kernel = CP::Gaussian_kernel();
  EXPECT_EQ(pose(own), pose(named));

  named = own = CP::Options();
  named.lattice_spacing = 0.04;
  own.make_body = fine_lattice;
  EXPECT_EQ(pose(own), pose(named));
  const CP::Result result = shapes::pose_of(shapes::bent_bar(), own);
  EXPECT_EQ(result.summary.body.kind, "given");

  named = own = CP::Options();
  named.solver = CP::Options::Solver::EIGEN;
  const auto soup = shapes::bent_bar();
  std::vector<Kernel::Point_3> points, output;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  const CP::Result by_eigen
    = CGAL::canonical_pose_3(points, soup.triangles, output, own,
                             CGAL::parameters::sparse_linear_solver(CP::Eigen_factor_traits_d()));
  EXPECT_EQ(by_eigen.pose, pose(named));
  EXPECT_EQ(by_eigen.summary.solver, shapes::pose_of(soup, named).summary.solver);
  own.linear_solver = CP::Linear_solver(CP::Eigen_factor_traits_d());
  EXPECT_EQ(pose(own), pose(named));
}

// A constraint of the user's own type, in the rows that it is called with, does what the same one does by indices of the
// input.
TEST(Own_parts, constraints)
{
  const auto soup = shapes::with_isolated_vertices(shapes::bar(), 3);
  const CP::Handle_3 handle{40, Eigen::RowVector3d(3, 2, 1), 0.2};
  CP::Options named, own;
  named.constraints.handles = {handle};
  own.constraints.function = [&](const std::vector<std::size_t>& vertices) {
    CP::Handle_constraint_adaptor_3 constraint(vertices.size());
    CP::Handle_3 local = handle;
    local.p = std::size_t(std::find(vertices.begin(), vertices.end(), 40) - vertices.begin());
    constraint.insert(local);
    return std::vector<CP::Registration_constraint_3>{constraint};
  };
  const Point_matrix expected = shapes::pose_of(soup, named).pose;
  EXPECT_EQ(shapes::pose_of(soup, own).pose, expected);
  EXPECT_NE(shapes::pose_of(soup, CP::Options()).pose, expected);

  own.constraints.function = [](const std::vector<std::size_t>& vertices) {
    CP::Handle_constraint_adaptor_3 constraint(vertices.size() + 1);
    constraint.insert({vertices.size(), Eigen::RowVector3d::Zero(), 1});
    return std::vector<CP::Registration_constraint_3>{constraint};
  };
  EXPECT_THROW_WITH(shapes::pose_of(soup, own), std::invalid_argument,
                    "a constraint names surface vertex " + std::to_string(soup.points.size() - 3));
}

// Vertex descriptors are the indices of the vertices in their order; those of a mesh with removed vertices are not.
template <class Triangle_mesh>
void expect_indices(const Triangle_mesh& mesh)
{
  using Point = typename boost::property_traits<
    typename boost::property_map<Triangle_mesh, CGAL::vertex_point_t>::type>::value_type;
  CP::Vertex_constraints_3<Triangle_mesh> constraints(mesh);
  const std::vector<typename boost::graph_traits<Triangle_mesh>::vertex_descriptor> v(
    vertices(mesh).begin(), vertices(mesh).end());
  constraints.add_spring(v[3], v[5], 0.5, 2);
  constraints.add_direction(v[4], v[1], Point(1, 2, 3) - Point(0, 0, 0));
  constraints.add_handle(v[6], Point(4, 5, 6), 0.25);
  constraints.add_symmetric_pair(v[7], v[0]);
  const CP::Constraints_3& c = constraints.constraints();
  EXPECT_EQ(c.springs.at(0).p, 3u);
  EXPECT_EQ(c.springs.at(0).q, 5u);
  EXPECT_EQ(c.springs.at(0).rest_length, 0.5);
  EXPECT_EQ(c.springs.at(0).stiffness, 2);
  EXPECT_EQ(c.directions.at(0).p, 4u);
  EXPECT_EQ(c.directions.at(0).vector, Eigen::RowVector3d(1, 2, 3));
  EXPECT_EQ(c.handles.at(0).p, 6u);
  EXPECT_EQ(c.handles.at(0).position, Eigen::RowVector3d(4, 5, 6));
  EXPECT_EQ(c.symmetric_pairs.at(0).q, 0u);
}

TEST(Own_parts, constraints_by_vertex_descriptors)
{
  const auto soup = shapes::bent_bar();
  const Point_matrix points = shapes::to_matrix(soup.points);
  Mesh mesh = CP::make_triangle_mesh<Mesh>(points, soup.triangles);
  mesh.remove_vertex(mesh.add_vertex());
  expect_indices(mesh);
  const Mesh::Vertex_index removed = mesh.add_vertex();
  mesh.add_vertex();
  mesh.remove_vertex(removed);
  CP::Vertex_constraints_3<Mesh> constraints(mesh);
  EXPECT_THROW_WITH(constraints.add_spring(Mesh::Vertex_index(0), removed, 1),
                    std::invalid_argument, "does not have");
  expect_indices(CP::make_triangle_mesh<CGAL::Polyhedron_3<Kernel>>(points, soup.triangles));

  using Complex = CP::Indexed_tetrahedra_3<Kernel::Point_3>;
  Complex complex;
  complex.points.assign(5, Kernel::Point_3(0, 0, 0));
  CP::Vertex_constraints_3<Complex> on_complex(complex);
  on_complex.add_spring(1, 4, 2.);
  EXPECT_EQ(on_complex.constraints().springs.at(0).q, 4u);
}

// Parts receive the repaired surface, one component at a time; in rounds, they receive its pose, in
// which it has the same vertices.
TEST(Own_parts, of_components)
{
  CP::Options options = shapes::each_component();
  options.number_of_rounds = 0;
  std::vector<Eigen::Index> sizes;
  options.landmark_fields_function
    = [&](const Point_matrix& points, const Triangles& triangles, const std::size_t number,
          const std::size_t first, const std::vector<std::size_t>& landmarks) {
        sizes.push_back(points.rows());
        return wavefront_fields(points, triangles, number, first, landmarks);
      };
  const auto bars = shapes::unsewn(shapes::merged(shapes::small_bar(), shapes::bar(), 20.));
  const std::vector<Eigen::Index> expected{Eigen::Index(shapes::small_bar().points.size()),
                                           Eigen::Index(shapes::bar().points.size())};
  EXPECT_TRUE(shapes::pose_of(bars, options).is_usable());
  EXPECT_EQ(sizes, expected);

  sizes.clear();
  options.number_of_rounds = 1;
  EXPECT_TRUE(shapes::pose_of(bars, options).is_usable());
  EXPECT_GE(sizes.size(), 2 * expected.size());
  sizes.erase(std::unique(sizes.begin(), sizes.end()), sizes.end());
  EXPECT_EQ(sizes, expected);
}

// Invalid results are refused.

// Throws in its n-th call.
class Throwing_in
{
public:
  explicit Throwing_in(const int n) : m_n(n) {}

  void operator()()
  {
    if(++m_calls == m_n)
      throw std::invalid_argument("of the user");
  }
  int calls() const { return m_calls; }

private:
  int m_n, m_calls = 0;
};

struct Throwing_kernel : CP::Gaussian_kernel
{
  explicit Throwing_kernel(Throwing_in& tick) : tick(&tick) {}

  double operator()(const double distance) const
  {
    (*tick)();
    return CP::Gaussian_kernel::operator()(distance);
  }

  Throwing_in* tick;
};

// What a function of the user throws reaches the user, in whichever call of it, and is not mistaken for
// what our own distances throw on a bad pose.
TEST(Own_parts, exceptions_pass_through)
{
  using Part = std::function<void(CP::Options&, Throwing_in&)>;
  const auto fields = [](Throwing_in& tick) {
    return [&tick](const Point_matrix& points, const Triangles& triangles, const std::size_t number,
                   const std::size_t first, const std::vector<std::size_t>& landmarks) {
      tick();
      return wavefront_fields(points, triangles, number, first, landmarks);
    };
  };
  for(const Part& part : std::vector<Part>{
        [&](CP::Options&options, Throwing_in&tick) {
          options.landmark_fields_function = fields(tick);
        },
        [&](CP::Options&options, Throwing_in&tick) {
          options.target_fields_function = fields(tick);
        },
        [](CP::Options&options, Throwing_in&tick) {
          options.make_body = [&tick](const Point_matrix& points, const Triangles& triangles,
                                      const CP::Landmark_fields_3& landmark_fields) {
            tick();
            return fine_lattice(points, triangles, landmark_fields);
          };
        },
        [](CP::Options&options, Throwing_in&tick) {
          options.constraints.function = [&tick](const std::vector<std::size_t>&) {
            tick();
            return std::vector<CP::Registration_constraint_3>();
          };
        },
        [](CP::Options&options, Throwing_in&tick) {
          options.visitor = [&tick](const CP::Registration_progress&) {
            tick();
            return true;
          };
        },
        [](CP::Options&options, Throwing_in&tick) { options.mds_kernel = Throwing_kernel(tick); }})
  {
    CP::Options options;
    options.number_of_landmarks = 12;
    Throwing_in never(0);
    part(options, never);
    pose(options);
    ASSERT_GT(never.calls(), 0);
    for(const int call : {1, 2, 3, 4, (never.calls() + 1) / 2, never.calls()})
      if(call <= never.calls())
      {
        Throwing_in once(call);
        part(options, once);
        EXPECT_THROW_WITH(pose(options), std::invalid_argument, "of the user");
      }
  }
}

// Faces of a pose that have no area end the rounds. The distances, exact ones of this package, are
// measured on a pose that is made flat.
TEST(Own_parts, faces_without_area_end_the_rounds)
{
  CP::Options options;
  options.number_of_landmarks = 12;
  options.landmark_fields_function = [](Point_matrix points, const Triangles& triangles,
                                        const std::size_t number, const std::size_t first,
                                        const std::vector<std::size_t>& landmarks) {
    if(!landmarks.empty())
      points.rightCols(2).setZero();
    return CP::landmark_fields_function<CP::Exact_geodesics_3<Mesh>>()(points, triangles, number,
                                                                       first, landmarks);
  };
  const CP::Result result = shapes::pose_of(shapes::bent_bar(), options);
  EXPECT_TRUE(result.summary.rounds.empty());
  EXPECT_TRUE(std::any_of(
    result.summary.warnings.begin(), result.summary.warnings.end(), [](const std::string& w) {
      return w.find("distances on the pose could not be computed: face") != std::string::npos;
    }));
}

// A function may measure on another mesh, with more faces: its faces are not those of the input.
TEST(Own_parts, faces_of_another_mesh_keep_their_number)
{
  CP::Options options;
  options.landmark_fields_function = [](const Point_matrix&, const Triangles&,
                                        const std::size_t number, const std::size_t first,
                                        const std::vector<std::size_t>& landmarks) {
    Triangles triangles;
    Point_matrix points = Point_matrix::Zero(30000, 3);
    for(std::size_t t = 0; t < 10000; ++t)
    {
      triangles.push_back({{3 * t, 3 * t + 1, 3 * t + 2}});
      points(static_cast<Eigen::Index>(3 * t), 0) = t < 9999 ? 1 : 0;
      points(static_cast<Eigen::Index>(3 * t + 1), 1) = 1;
    }
    return CP::landmark_fields_function<CP::Exact_geodesics_3<Mesh>>()(points, triangles, number,
                                                                       first, landmarks);
  };
  EXPECT_THROW_WITH(pose(options), std::invalid_argument, "face 9999 is degenerate");
}

TEST(Own_parts, bad_ones_are_named)
{
  const auto expect_refused = [](const CP::Options& options, const std::string& text) {
    EXPECT_THROW_WITH(pose(options), std::invalid_argument, text);
  };
  CP::Landmark_fields_3 fields;
  CP::Options options;
  options.landmark_fields_function
    = [&](const Point_matrix&, const Triangles&, std::size_t, std::size_t,
          const std::vector<std::size_t>&) { return fields; };
  expect_refused(options, "that the function returned have no column");
  const Eigen::Index n = Eigen::Index(shapes::bent_bar().points.size());
  fields.distances.setOnes(n, 2);
  expect_refused(options, "have 0 landmarks, but 2 columns");
  fields.landmarks = {0, std::size_t(n)};
  expect_refused(options, "have landmark " + std::to_string(n));
  fields.landmarks = {0, 1};
  fields.distances(3, 1) = std::numeric_limits<double>::infinity();
  expect_refused(options, "not finite");
  options.landmark_fields_function = [](const Point_matrix& points, const Triangles& triangles,
                                        const std::size_t number, const std::size_t first,
                                        const std::vector<std::size_t>& landmarks) {
    CP::Landmark_fields_3 result = wavefront_fields(points, triangles, number, first, landmarks);
    if(!landmarks.empty())
      std::reverse(result.landmarks.begin(), result.landmarks.end());
    return result;
  };
  EXPECT_THROW_WITH(pose(options), std::logic_error, "have other landmarks than it was given");

  options = CP::Options();
  options.make_body = [&](const Point_matrix& points, const Triangles& triangles,
                          const CP::Landmark_fields_3& landmark_fields) {
    const Point_matrix doubled = (Point_matrix(2 * points.rows(), 3) << points, points).finished();
    Triangles both = triangles;
    for(auto t : triangles)
    {
      for(std::size_t& v : t)
        v += std::size_t(points.rows());
      both.push_back(t);
    }
    return CP::Lattice_body_3(doubled, both, landmark_fields.distances.replicate(2, 1).eval(),
                              0.04);
  };
  expect_refused(options, "surface vertices for a surface of");
}

// Rows are vertices of the input, regardless of stitching; the distance to another component is
// infinite. A user-defined function is called with the repaired surface.
TEST(Own_parts, distances_on_a_soup)
{
  const auto bars = shapes::unsewn(shapes::merged(shapes::small_bar(), shapes::bar(), 20.));
  const Point_matrix points = shapes::to_matrix(bars.points);
  CP::Options options;
  options.geodesics
    = CP::Options::Geodesics::WAVEFRONT; // lengths of paths: not below Euclidean distances
  const Eigen::MatrixXd d = CP::geodesic_distances(points, bars.polygons, {0}, options);
  std::size_t infinite = 0, zero = 0;
  for(Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const bool is_here = (points.row(i) - points.row(0)).norm() < 15;
    EXPECT_EQ(std::isfinite(d(i, 0)), is_here);
    infinite += is_here ? 0 : 1;
    zero += d(i, 0) == 0 ? 1 : 0;
    if(is_here)
    {
      EXPECT_GE(d(i, 0), (1 - 1e-12) * (points.row(i) - points.row(0)).norm());
    }
  }
  EXPECT_GT(infinite, 0u);
  EXPECT_GT(zero, 1u); // the corners of all faces around the source
  const auto ones = [](const Point_matrix& p, const Triangles&, const std::vector<std::size_t>& s) {
    return Eigen::MatrixXd::Ones(p.rows(), Eigen::Index(s.size())).eval();
  };
  EXPECT_EQ(CP::geodesic_distances(points, bars.polygons, {3, 5}, {}, ones),
            Eigen::MatrixXd::Ones(points.rows(), 2));
  EXPECT_THROW_WITH(CP::geodesic_distances(points, bars.polygons, {bars.points.size()}),
                    std::invalid_argument, "a source names vertex");
}

// A mesh of points and triangles has them in the given order, for any data structure.
template <class Triangle_mesh>
void expect_made()
{
  const auto soup = shapes::bent_bar();
  const Point_matrix points = shapes::to_matrix(soup.points);
  const auto mesh = CP::make_triangle_mesh<Triangle_mesh>(points, soup.triangles);
  EXPECT_EQ(CP::point_matrix(mesh), points);
  EXPECT_EQ(CP::internal::index_triangles(mesh).size(), soup.triangles.size());
  EXPECT_TRUE(CGAL::is_closed(mesh));
  Triangles bad = soup.triangles;
  bad[7][1] = soup.points.size();
  EXPECT_THROW_WITH(CP::make_triangle_mesh<Triangle_mesh>(points, bad), std::invalid_argument,
                    "triangle 7 names vertex");
  bad = soup.triangles;
  bad.push_back(bad[7]);
  EXPECT_THROW_WITH(CP::make_triangle_mesh<Triangle_mesh>(points, bad), std::invalid_argument,
                    "does not fit");
}

TEST(Own_parts, meshes_are_made)
{
  expect_made<Mesh>();
  expect_made<CGAL::Polyhedron_3<CGAL::Simple_cartesian<double>>>();
}

} // namespace test_own_parts
