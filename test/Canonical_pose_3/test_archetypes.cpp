// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Archetypes: classes with only the requirements of their concepts, run on data.

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Descriptor_index_3.h>
#include <CGAL/Canonical_pose_3/Eigen_factor_traits_d.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/cell_stiffness.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/landmark_fields_function.h>
#include <CGAL/Canonical_pose_3/shape_descriptor.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace test_archetypes {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::to_mesh;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

// A model of ElasticBody_3 whose surface is inside the cells: B has four entries per row. It can be
// moved, for Elastic_body_3, but not copied.
class Hanging_body
{
public:
  Hanging_body(Hanging_body&&) = default;
  Hanging_body()
  {
    const auto soup = Canonical_pose_test::tetrahedral_bent_bar(12, 2, 2, 0.);
    m_points = Canonical_pose_test::to_matrix(soup.points);
    for(const auto& c : soup.cells)
      m_cells.push_back({int(c[0]), int(c[1]), int(c[2]), int(c[3])});
    m_weights
      = Eigen::VectorXd::Constant(Eigen::Index(m_cells.size()), 1. / double(m_cells.size()));
    std::vector<Eigen::Triplet<double>> entries;
    for(std::size_t t = 0; t < m_cells.size(); ++t)
      for(int k = 0; k < 4; ++k)
        entries.emplace_back(int(t), m_cells[t][std::size_t(k)], 0.1 * (k + 1));
    m_embedding.resize(Eigen::Index(m_cells.size()), m_points.rows());
    m_embedding.setFromTriplets(entries.begin(), entries.end());
  }
  const Point_matrix& points() const { return m_points; }
  const std::vector<std::array<int, 4>>& cells() const { return m_cells; }
  const Eigen::VectorXd& cell_weights() const { return m_weights; }
  double volume() const { return 8.; }
  const Eigen::SparseMatrix<double>& embedding() const { return m_embedding; }

private:
  Point_matrix m_points;
  std::vector<std::array<int, 4>> m_cells;
  Eigen::VectorXd m_weights;
  Eigen::SparseMatrix<double> m_embedding;
};

// A model of RegistrationConstraint_3 that pulls a vertex to a point: kappa |x_v - c|^2. It can be
// moved, for Registration_constraint_3, but not copied.
struct Handle
{
  Handle(const int v, const Eigen::RowVector3d& p, const double kappa)
    : vertex(v), position(p), stiffness(kappa)
  {}
  Handle(Handle&&) = default;

  std::size_t matrix_revision() const { return revision; }
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    matrix.emplace_back(vertex, vertex, stiffness);
  }
  void add_to_right_hand_side(const Point_matrix&, Point_matrix& right_hand_side)
  {
    right_hand_side.row(vertex) += stiffness * position;
  }
  double energy(const Point_matrix& points) const
  {
    return stiffness * (points.row(vertex) - position).squaredNorm();
  }

  int vertex;
  Eigen::RowVector3d position;
  double stiffness;
  std::size_t revision = 0;
};

// A model of MdsKernel: -r^2/2 plus a constant, which centering removes. It can neither be default
// constructed nor assigned.
struct Shifted_kernel
{
  explicit Shifted_kernel(const double constant) : m_constant(constant) {}
  double operator()(const double relative_distance) const
  {
    return m_constant - 0.5 * relative_distance * relative_distance;
  }
  bool is_centered() const { return true; }
  const char* name() const { return "shifted"; }

private:
  const double m_constant;
};

// A model of SparseLinearAlgebraWithBlockFactorTraits_d with its own matrix type. It can neither be
// copied nor moved.
class Own_solver
{
public:
  using NT = double;
  using Vector = Eigen::VectorXd;
  class Matrix
  {
  public:
    explicit Matrix(const Eigen::SparseMatrix<double>& entries) : m_entries(entries) {}
    Matrix(const Matrix&) = delete;

  private:
    friend class Own_solver;
    Eigen::SparseMatrix<double> m_entries;
  };

  Own_solver() = default;
  Own_solver(const Own_solver&) = delete;
  bool factor(const Matrix& a, NT& denominator)
  {
    denominator = 1;
    m_ldlt.compute(a.m_entries);
    return m_ldlt.info() == Eigen::Success;
  }
  bool linear_solver(const Eigen::Ref<const Eigen::MatrixXd>& b, Eigen::MatrixXd& x) const
  {
    x = m_ldlt.solve(b);
    return x.allFinite();
  }
  static const char* name() { return "own solver"; }

private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_ldlt;
};

// A model of GeodesicDistances_3: lengths of straight segments. It can neither be copied nor moved.
class Straight_distances
{
public:
  using Triangle_mesh = Mesh;
  using vertex_descriptor = Mesh::Vertex_index;

  explicit Straight_distances(const Mesh& mesh) : m_mesh(mesh), m_points(CP::point_matrix(mesh)) {}
  Straight_distances(const Straight_distances&) = delete;
  const Mesh& triangle_mesh() const { return m_mesh; }
  std::size_t index(const Mesh::Vertex_index v) const { return v; }
  Eigen::VectorXd distances(const Mesh::Vertex_index source) const
  {
    return (m_points.rowwise() - m_points.row(source)).rowwise().norm();
  }
  template <class VertexRange>
  Eigen::MatrixXd distances(const VertexRange& sources) const
  {
    Eigen::MatrixXd result(m_points.rows(), 0);
    for(const Mesh::Vertex_index source : sources)
    {
      result.conservativeResize(Eigen::NoChange, result.cols() + 1);
      result.rightCols(1) = distances(source);
    }
    return result;
  }
  template <class VertexDistanceMap>
  void distances(const Mesh::Vertex_index source, VertexDistanceMap map) const
  {
    const Eigen::VectorXd values = distances(source);
    for(const Mesh::Vertex_index v : vertices(m_mesh))
      put(map, v, values[v]);
  }

private:
  const Mesh& m_mesh;
  Point_matrix m_points;
};

// A model of RegistrationVisitor_3 with a state of its own. It cannot be assigned.
struct Visitor
{
  bool operator()(const CP::Registration_progress&) { return ++own_calls < 3 && ++*all_calls > 0; }

  int* const all_calls;
  int own_calls = 0;
};

// A model of ShapeDescriptor_3: powers of the number of points. It can neither be default
// constructed nor assigned.
class Powers
{
public:
  explicit Powers(const std::size_t size) : m_size(size) {}
  std::string name() const { return "powers"; }
  int version() const { return 1; }
  std::size_t size() const { return m_size; }
  Eigen::VectorXd operator()(const Point_matrix& points, const CP::Face_list& polygons) const
  {
    EXPECT_FALSE(polygons.empty());
    Eigen::VectorXd result(m_size);
    for(std::size_t i = 0; i < m_size; ++i)
      result[Eigen::Index(i)] = std::pow(points.rows(), double(i));
    return result;
  }
  Eigen::VectorXd distances(const Eigen::VectorXd& query,
                            const Eigen::Ref<const Eigen::MatrixXd>& others) const
  {
    return (others.colwise() - query).colwise().norm().transpose();
  }

private:
  const std::size_t m_size;
};

Canonical_pose_test::Triangle_soup bent_bar()
{
  return Canonical_pose_test::boundary(Canonical_pose_test::tetrahedral_bent_bar(16, 2, 2, 2.5));
}

template <class... Arguments>
Point_matrix pose_of_bar(const Arguments&... arguments)
{
  Mesh mesh = to_mesh<Mesh>(bent_bar());
  return CGAL::canonical_pose_3(mesh, mesh.points(), arguments...).pose;
}

// Inverted cells remain, so that the result is a minimum.
CP::Registration_options to_the_end()
{
  CP::Registration_options options;
  options.injective = false;
  options.number_of_iterations = 5000;
  options.energy_tolerance = 1e-14;
  options.move_tolerance = 1e-10;
  return options;
}

// Rows of B sum to 1, so a rigid motion of the body also moves the surface: a rigid target is
// reached with energy 0 although no body vertex has its own target.
TEST(Archetypes, body_on_which_the_surface_hangs)
{
  const Hanging_body body;
  const Point_matrix surface = body.embedding() * body.points();
  CP::Tetrahedral_arap_registrar_3<Hanging_body> registrar(body, uniform_weights(surface), 8.,
                                                           to_the_end());
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2., Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const Point_matrix target = surface * rotation.transpose();
  registrar.set_target(target);
  Point_matrix pose;
  const CP::Registration_summary summary = registrar.register_to_target(pose);
  EXPECT_TRUE(summary.converged());
  EXPECT_LT(summary.energy, 1e-12);
  EXPECT_LT((registrar.surface_points(pose) - target).norm(), 1e-4);
  EXPECT_LT((pose - body.points() * rotation.transpose()).norm(), 1e-4);
  EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
}

// A handle of huge stiffness is satisfied; if target and handle are shifted by the same vector, so
// is the entire body.
TEST(Archetypes, constraint)
{
  const Hanging_body body;
  const Point_matrix surface = body.embedding() * body.points();
  CP::Tetrahedral_arap_registrar_3<Hanging_body> registrar(body, uniform_weights(surface), 8.,
                                                           to_the_end());
  Handle handle(0, surface.row(0) + Eigen::RowVector3d(0, 0, 2), 1e6);
  registrar.add_constraint(handle);
  registrar.set_target(surface);
  Point_matrix pose;
  const CP::Registration_summary summary = registrar.register_to_target(pose);
  EXPECT_LT((registrar.surface_points(pose).row(0) - handle.position).norm(), 1e-4);
  EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
  EXPECT_NEAR(summary.energy,
              summary.energy_match + summary.energy_arap + summary.energy_constraints, 1e-15);

  const Eigen::RowVector3d shift(1, 2, 3);
  handle.position += shift;
  registrar.set_target(surface.rowwise() + shift);
  Point_matrix shifted;
  registrar.register_to_target(shifted);
  EXPECT_LT(((shifted.rowwise() - shift) - pose).norm(), 1e-6);

  // A different stiffness changes the matrix and its revision. The surface returns to its target,
  // except for 2e-5 due to the handle at distance 2.
  handle.stiffness = 1e-6;
  ++handle.revision;
  Point_matrix loose;
  registrar.register_to_target(loose);
  const Point_matrix moved = registrar.surface_points(loose).rowwise() - shift;
  EXPECT_LT((moved - surface).rowwise().norm().maxCoeff(), 4e-5);
  EXPECT_NEAR((moved.row(0) + shift - handle.position).norm(), 2, 4e-5);
}

// Centering removes constants: the target is that of classical scaling.
TEST(Archetypes, mds_kernel)
{
  const Point_matrix points = Canonical_pose_test::to_matrix(
    Canonical_pose_test::tetrahedral_box(3, 4, 5, {{1., 2., 4.}}).points);
  CP::Landmark_fields_3 fields;
  fields.distances.resize(points.rows(), 20);
  for(Eigen::Index j = 0; j < 20; ++j)
  {
    fields.landmarks.push_back(std::size_t(6 * j));
    fields.distances.col(j) = (points.rowwise() - points.row(6 * j)).rowwise().norm();
  }
  CP::Landmark_mds_target_builder_3<Shifted_kernel> shifted{Shifted_kernel(3)};
  CP::Landmark_mds_target_builder_3<> classical;
  shifted.build(fields);
  classical.build(fields);
  EXPECT_LT((shifted.targets() - classical.targets()).norm(), 1e-9);
}

// A number per vertex is constant on the cells if it is constant; the surface of the body is where
// it is if the body does not move.
TEST(Archetypes, other_functions_of_bodies)
{
  const Hanging_body body;
  const Point_matrix surface = body.embedding() * body.points();
  const Eigen::Index n = surface.rows();
  EXPECT_LT((CP::cell_stiffness(body, Eigen::VectorXd::Constant(n, 1. / double(n)),
                                Eigen::VectorXd::Constant(n, 3.))
               .array()
             - 3)
              .abs()
              .maxCoeff(),
            1e-12);
  const CP::Body_deformer_3<Hanging_body> deformer(body, {{0, 1, 2}});
  const Point_matrix follower = surface.topRows(1);
  EXPECT_LT((deformer.embedding(follower) * body.points() - follower).norm(), 1e-12);
}

// The solver is a copy of that of the package, so the bytes are the same however it is selected.
TEST(Archetypes, solver)
{
  CP::Options options;
  options.solver = CP::Options::Solver::EIGEN;
  const Point_matrix expected = pose_of_bar(options);
  const Own_solver solver;
  EXPECT_EQ(pose_of_bar(CP::Options(), CGAL::parameters::sparse_linear_solver(solver)), expected);
  EXPECT_EQ(pose_of_bar(CGAL::parameters::random_seed(0).sparse_linear_solver(std::ref(solver))),
            expected);
  options.linear_solver = CP::Linear_solver(solver);
  EXPECT_EQ(pose_of_bar(options), expected);

  const Mesh mesh = to_mesh<Mesh>(bent_bar());
  using CGAL::Default;
  const Mesh::Vertex_index v(7);
  EXPECT_EQ(
    (CP::Heat_geodesics_3<Mesh, Default, Default, Own_solver>(mesh).distances(v)),
    (CP::Heat_geodesics_3<Mesh, Default, Default, CP::Eigen_factor_traits_d>(mesh).distances(v)));

  const Hanging_body body;
  const Point_matrix surface = body.embedding() * body.points();
  CP::Tetrahedral_arap_registrar_3<Hanging_body, Default, Own_solver> registrar(
    body, uniform_weights(surface), 8., to_the_end());
  registrar.set_target(surface);
  Point_matrix pose;
  EXPECT_LT(registrar.register_to_target(pose).energy, 1e-12);
}

// Distances in space of points in space: classical scaling recovers them, so that the target is the
// input.
TEST(Archetypes, distances)
{
  const Mesh mesh = to_mesh<Mesh>(bent_bar());
  const Straight_distances distances(mesh);
  std::vector<Mesh::Vertex_index> chosen;
  const CP::Landmark_fields_3 farthest
    = CP::farthest_point_landmarks(distances, 5, Mesh::Vertex_index(3), std::back_inserter(chosen));
  EXPECT_EQ(farthest.distances, distances.distances(chosen));
  chosen.clear();
  const CP::Landmark_fields_3 by_fronts
    = CP::front_landmarks(distances, 5, Mesh::Vertex_index(3), std::back_inserter(chosen));
  EXPECT_EQ(by_fronts.distances, distances.distances(chosen));

  CP::Options options;
  options.number_of_rounds = 0;
  options.landmark_fields_function = CP::landmark_fields_function<Straight_distances>();
  const Point_matrix points = CP::point_matrix(mesh);
  EXPECT_LT((pose_of_bar(options) - points).norm(), 1e-3 * points.norm());
}

TEST(Archetypes, parts_that_are_chosen_at_run_time)
{
  const Point_matrix expected = pose_of_bar();
  CP::Options options;
  options.mds_kernel = Shifted_kernel(3);
  EXPECT_LT(Canonical_pose_test::relative_rms(pose_of_bar(options), expected), 1e-6);

  options = CP::Options();
  options.make_body
    = [](const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles,
         const CP::Landmark_fields_3& fields) {
        return CP::Lattice_body_3(points, triangles, fields.distances); // converts
      };
  EXPECT_TRUE(pose_of_bar(options).allFinite());

  int calls = 0;
  options = CP::Options();
  options.visitor = Visitor{&calls};
  EXPECT_TRUE(pose_of_bar(options).allFinite());
  EXPECT_EQ(calls, 2);
  EXPECT_TRUE(pose_of_bar(CGAL::parameters::visitor(Visitor{&calls})).allFinite());
  EXPECT_EQ(calls, 4);

  const CP::Elastic_body_3 body{Hanging_body()};
  EXPECT_EQ(body.volume(), 8.);
  CP::Registration_constraint_3 constraint = Handle(0, Eigen::RowVector3d(0, 0, 1), 2.);
  EXPECT_EQ(constraint.energy(Point_matrix::Zero(1, 3)), 2.);
}

TEST(Archetypes, descriptor)
{
  const Mesh mesh = to_mesh<Mesh>(bent_bar());
  const double n = double(num_vertices(mesh));
  const Powers powers(3);
  const Eigen::VectorXd values = CP::shape_descriptor(powers, mesh);
  EXPECT_EQ(values, Eigen::Vector3d(1, n, n * n));
  EXPECT_EQ(CP::shape_descriptor(powers, mesh, CGAL::parameters::vertex_point_map(mesh.points())),
            values);
  CP::Descriptor_index_3<Powers> index(powers);
  EXPECT_EQ(index.insert(2 * values), 0u);
  EXPECT_EQ(index.insert(values), 1u);
  EXPECT_EQ(index.nearest(values, 1).front().shape, 1u);
  EXPECT_EQ(index.distances()(0, 1), values.norm());
}

// Classes that hold a model of a concept are constructed from nothing else. So a function that is
// overloaded for them and other types can be called, and a mistake is reported where it is made.
template <class Holder, class Model>
constexpr void expect_only_models()
{
  static_assert(std::is_constructible<Holder, Model>::value);
  static_assert(std::is_copy_constructible<Holder>::value
                && std::is_copy_assignable<Holder>::value);
  static_assert(!std::is_constructible<Holder, int>::value);
  static_assert(!std::is_constructible<Holder, std::string>::value);
  static_assert(!std::is_constructible<Holder, Eigen::MatrixXd>::value);
}

TEST(Archetypes, only_models_convert)
{
  expect_only_models<CP::Elastic_body_3, Hanging_body>();
  expect_only_models<CP::Elastic_body_3, CP::Lattice_body_3>();
  expect_only_models<CP::Mds_kernel, Shifted_kernel>();
  expect_only_models<CP::Registration_constraint_3, Handle>();
  expect_only_models<CP::Registration_visitor, Visitor>();
  expect_only_models<CP::Linear_solver, const Own_solver&>();
  expect_only_models<CP::Linear_solver, CP::Eigen_factor_traits_d>();
  static_assert(!std::is_constructible<CP::Elastic_body_3, Shifted_kernel>::value);
  static_assert(!std::is_constructible<CP::Mds_kernel, Hanging_body>::value);
  static_assert(!std::is_constructible<CP::Registration_constraint_3, Shifted_kernel>::value);
  static_assert(!std::is_convertible<int (*)(), CP::Body_function>::value);
}

} // namespace test_archetypes
