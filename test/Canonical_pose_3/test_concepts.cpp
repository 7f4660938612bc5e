// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Shape_distribution_d2_3.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/complex_body.h>
#include <CGAL/Canonical_pose_3/consensus_segmentation.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/extract_boundary.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/k_means_segmentation.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/segmentation_parts.h>
#include <CGAL/Canonical_pose_3/shape_descriptor.h>
#include <CGAL/Canonical_pose_3/sweep_segmentation.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <array>
#include <cstddef>
#include <unordered_map>
#include <vector>

namespace test_concepts {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Points;
using CP::Point_matrix;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

Canonical_pose_test::Tetrahedral_soup bent_bar_soup()
{
  return Canonical_pose_test::tetrahedral_bent_bar(16, 2, 2, 2.5);
}

template <class Mesh_type>
Point_matrix pose_of()
{
  Mesh_type mesh
    = Canonical_pose_test::to_mesh<Mesh_type>(Canonical_pose_test::boundary(bent_bar_soup()));
  const auto summary = CGAL::canonical_pose_3(mesh, get(CGAL::vertex_point, mesh)).summary;
  EXPECT_TRUE(summary.converged());
  return CP::point_matrix(mesh);
}

// A user-defined point, whose coordinates are only accessible through the traits.
class My_point
{
public:
  My_point() = default;

private:
  friend struct My_traits;
  std::array<float, 3> m_coordinates = {};
};

// The minimal requirements of CanonicalPoseTraits_3.
struct My_traits
{
  using FT = float;
  using Point_3 = My_point;

  template <int i>
  struct Compute_coordinate
  {
    FT operator()(const Point_3& p) const { return p.m_coordinates[i]; }
  };
  using Compute_x_3 = Compute_coordinate<0>;
  using Compute_y_3 = Compute_coordinate<1>;
  using Compute_z_3 = Compute_coordinate<2>;
  struct Construct_point_3
  {
    Point_3 operator()(const FT x, const FT y, const FT z) const
    {
      Point_3 p;
      p.m_coordinates = {x, y, z};
      return p;
    }
  };
  Compute_x_3 compute_x_3_object() const { return Compute_x_3(); }
  Compute_y_3 compute_y_3_object() const { return Compute_y_3(); }
  Compute_z_3 compute_z_3_object() const { return Compute_z_3(); }
  Construct_point_3 construct_point_3_object() const { return Construct_point_3(); }
};

// A user-defined complex: cells are structs, vertices are letters.
struct My_complex
{
  std::vector<My_point> points;
  std::vector<std::array<std::size_t, 4>> cells;
};

} // namespace test_concepts

template <>
struct CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3<test_concepts::My_complex>
{
  using Vertex_descriptor = char32_t;
  using Point_3 = test_concepts::My_point;
  using Cell = std::array<char32_t, 4>;

  static std::vector<char32_t> vertices(const test_concepts::My_complex& complex)
  {
    std::vector<char32_t> result;
    for(std::size_t i = 0; i < complex.points.size(); ++i)
      result.push_back(static_cast<char32_t>(U'a' + i));
    return result;
  }
  static std::vector<Cell> cells(const test_concepts::My_complex& complex)
  {
    std::vector<Cell> result;
    for(const auto& c : complex.cells)
      result.push_back({char32_t(U'a' + c[0]), char32_t(U'a' + c[1]), char32_t(U'a' + c[2]),
                        char32_t(U'a' + c[3])});
    return result;
  }
  static const test_concepts::My_point& point(const test_concepts::My_complex& complex,
                                              const char32_t v)
  {
    return complex.points[v - U'a'];
  }
};

namespace test_concepts {

// Everything runs on the same arrays for any mesh type: two data structures with equal vertices and
// faces yield the same bytes. So do kernels with the same coordinates.
TEST(Concepts, meshes_and_kernels_give_the_same_pose)
{
  const Point_matrix pose = pose_of<Mesh>();
  EXPECT_EQ(pose_of<CGAL::Polyhedron_3<Kernel>>(), pose);
  EXPECT_EQ(
    pose_of<CGAL::Surface_mesh<CGAL::Exact_predicates_exact_constructions_kernel::Point_3>>(),
    pose);
  EXPECT_LT(Canonical_pose_test::relative_rms(
              pose_of<CGAL::Surface_mesh<CGAL::Simple_cartesian<float>::Point_3>>(), pose),
            1e-2);
}

// Input points and pose in external property maps; removed vertices must not count.
TEST(Concepts, own_point_map_and_removed_elements)
{
  const Point_matrix pose = pose_of<Mesh>();
  Mesh mesh;
  const auto extra = mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  const auto soup = Canonical_pose_test::boundary(bent_bar_soup());
  std::unordered_map<Mesh::Vertex_index, Kernel::Point_3> input, output;
  std::vector<Mesh::Vertex_index> vertices;
  for(const auto& p : soup.points)
  {
    vertices.push_back(mesh.add_vertex());
    input[vertices.back()] = Kernel::Point_3(p[0], p[1], p[2]);
  }
  for(const auto& t : soup.triangles)
    mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
  mesh.remove_vertex(extra);
  CGAL::canonical_pose_3(mesh, boost::make_assoc_property_map(output),
                         CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(input)));
  ASSERT_EQ(output.size(), vertices.size());
  for(std::size_t i = 0; i < vertices.size(); ++i)
    for(int k = 0; k < 3; ++k)
      EXPECT_EQ(output[vertices[i]][k], pose(static_cast<Eigen::Index>(i), k));
}

// A complex and points with only the requirements of the concepts are run on data, and agree with
// indexed tetrahedra up to the single precision of these points.
TEST(Concepts, own_complex_and_own_traits)
{
  const auto soup = bent_bar_soup();
  CP::Indexed_tetrahedra_3<Kernel::Point_3> indexed;
  My_complex mine;
  for(const auto& p : soup.points)
  {
    indexed.points.emplace_back(p[0], p[1], p[2]);
    mine.points.push_back(My_traits::Construct_point_3()(float(p[0]), float(p[1]), float(p[2])));
  }
  indexed.cells = mine.cells = soup.cells;
  std::vector<Kernel::Point_3> pose(soup.points.size());
  const auto summary = CGAL::canonical_pose_3(indexed, CGAL::make_property_map(pose)).summary;
  EXPECT_TRUE(summary.converged());
  EXPECT_EQ(summary.body.kind, "complex");

  std::unordered_map<char32_t, My_point> my_pose;
  CGAL::canonical_pose_3(mine, boost::make_assoc_property_map(my_pose),
                         CGAL::parameters::geom_traits(My_traits()));
  ASSERT_EQ(my_pose.size(), pose.size());
  Point_matrix a(static_cast<Eigen::Index>(pose.size()), 3), b = a;
  for(std::size_t i = 0; i < pose.size(); ++i)
  {
    a.row(static_cast<Eigen::Index>(i)) = CP::internal::to_row(Kernel(), pose[i]);
    b.row(static_cast<Eigen::Index>(i))
      = CP::internal::to_row(My_traits(), my_pose[char32_t(U'a' + i)]);
  }
  EXPECT_LT(Canonical_pose_test::relative_rms(a, b), 1e-2);
}

using My_mesh = CGAL::Surface_mesh<My_point>;
using Double_mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

My_complex my_complex()
{
  const auto soup = bent_bar_soup();
  My_complex result;
  for(const auto& p : soup.points)
    result.points.push_back(My_traits::Construct_point_3()(float(p[0]), float(p[1]), float(p[2])));
  result.cells = soup.cells;
  return result;
}

// The boundary, and the same one with points of a kernel and the same coordinates.
struct Boundaries
{
  Boundaries()
  {
    CP::extract_boundary(my_complex(), mine, boost::make_assoc_property_map(origins),
                         CGAL::parameters::geom_traits(My_traits()));
    for(const auto v : vertices(mine))
    {
      const Eigen::Vector3d p = CP::internal::to_row(My_traits(), mine.point(v));
      twin.add_vertex(CGAL::Simple_cartesian<double>::Point_3(p[0], p[1], p[2]));
    }
    for(const auto f : faces(mine))
      twin.add_face(mine.vertices_around_face(mine.halfedge(f)));
  }

  My_mesh mine;
  Double_mesh twin;
  std::unordered_map<My_mesh::Vertex_index, char32_t> origins;
};

// Calls f(mesh, map from faces to parts), and returns the parts.
template <class Any_mesh, class Function>
std::vector<std::size_t> parts_of(const Any_mesh& mesh, const Function& f)
{
  std::vector<std::size_t> parts(num_faces(mesh), 99);
  f(mesh, CGAL::make_property_map(parts));
  return parts;
}

// Points without a kernel, on the boundary of a complex and in a map of the user.
TEST(Concepts, boundary_with_own_points)
{
  const Boundaries boundaries;
  const auto soup = Canonical_pose_test::boundary(bent_bar_soup());
  EXPECT_EQ(num_vertices(boundaries.mine), soup.points.size());
  EXPECT_EQ(num_faces(boundaries.mine), soup.triangles.size());
  My_mesh other;
  std::unordered_map<My_mesh::Vertex_index, char32_t> origins;
  std::unordered_map<My_mesh::Vertex_index, My_point> points;
  const My_complex complex = my_complex();
  CP::extract_boundary(complex, other, boost::make_assoc_property_map(origins),
                       CGAL::parameters::vertex_point_map(boost::make_assoc_property_map(points))
                         .geom_traits(My_traits()));
  EXPECT_EQ(origins, boundaries.origins);
  for(const auto v : vertices(other))
    EXPECT_EQ(CP::internal::to_row(My_traits(), points.at(v)),
              CP::internal::to_row(My_traits(), complex.points[origins.at(v) - U'a']));
  EXPECT_EQ(CP::complex_body(complex, My_traits()).points().rows(),
            Eigen::Index(complex.points.size()));
}

// Every function of a mesh, with named parameters but without options, and with both: the same
// coordinates yield the same bytes, although the points have no kernel.
TEST(Concepts, own_points_in_every_function_of_meshes)
{
  const Boundaries boundaries;
  const My_mesh& mine = boundaries.mine;
  const Double_mesh& twin = boundaries.twin;
  const auto np = CGAL::parameters::geom_traits(My_traits());
  const auto twin_np = CGAL::parameters::vertex_point_map(twin.points());

  std::unordered_map<My_mesh::Vertex_index, My_point> pose;
  const auto pose_map = boost::make_assoc_property_map(pose);
  const Point_matrix expected = CGAL::canonical_pose_3(twin, Double_mesh(twin).points()).pose;
  EXPECT_EQ(CGAL::canonical_pose_3(mine, pose_map, np).pose, expected);
  EXPECT_EQ(CGAL::canonical_pose_3(mine, pose_map, CP::Options(), np).pose, expected);
  EXPECT_EQ(pose.size(), num_vertices(mine));

  const std::vector<My_point> points(mine.points().begin(), mine.points().end());
  std::vector<std::vector<std::size_t>> polygons;
  for(const auto f : faces(mine))
  {
    polygons.emplace_back();
    for(const auto v : mine.vertices_around_face(mine.halfedge(f)))
      polygons.back().push_back(v);
  }
  std::vector<My_point> pose_points;
  EXPECT_EQ(CGAL::canonical_pose_3(points, polygons, pose_points, np).pose, expected);
  EXPECT_EQ(CGAL::canonical_pose_3(points, polygons, pose_points, CP::Options(), np).pose,
            expected);
  EXPECT_EQ(pose_points.size(), points.size());

  const Point_matrix rows = CP::point_matrix(twin);
  const auto triangles = CP::internal::index_triangles(twin);
  EXPECT_EQ(CP::point_matrix(mine, mine.points(), My_traits()), rows);
  EXPECT_EQ(CP::point_matrix(CP::make_triangle_mesh<My_mesh>(rows, triangles, np), mine.points(),
                             My_traits()),
            rows);
  EXPECT_TRUE(CP::diagnose(mine, np).is_clean());
  EXPECT_EQ(CP::vertex_area_shares(mine, np), CP::vertex_area_shares(twin));
  EXPECT_EQ(CP::target_handedness(rows, mine, np).chirality,
            CP::target_handedness(rows, twin).chirality);
  EXPECT_EQ(std::size_t(CP::extremal_vertex(mine, np)), std::size_t(CP::extremal_vertex(twin)));
  EXPECT_EQ(CP::prepare_surface(mine, np).components.size(), 1u);
  EXPECT_EQ(CP::prepare_surface(mine, CP::Options(), np).components.size(), 1u);
  EXPECT_EQ(CP::Lattice_body_3(mine, Eigen::MatrixXd(rows.rowwise().norm()), np).points(),
            CP::Lattice_body_3(twin, Eigen::MatrixXd(rows.rowwise().norm())).points());
  using CGAL::Default;
  const My_mesh::Vertex_index v(5);
  const Double_mesh::Vertex_index w(5);
  EXPECT_EQ((CP::Heat_geodesics_3<My_mesh, Default, My_traits>(mine).distances(v)),
            CP::Heat_geodesics_3<Double_mesh>(twin).distances(w));
  EXPECT_EQ((CP::Wavefront_geodesics_3<My_mesh, Default, My_traits>(mine).distances(v)),
            CP::Wavefront_geodesics_3<Double_mesh>(twin).distances(w));
  EXPECT_EQ(CP::shape_descriptor(CP::Shape_distribution_d2_3(), mine, np),
            CP::shape_descriptor(CP::Shape_distribution_d2_3(), twin));

  CP::Segmentation_options options;
  options.number_of_parts = 3;
  const auto sweep
    = parts_of(twin, [](const auto& m, auto ids) { CP::sweep_segmentation(m, ids); });
  const auto sweep_of_three
    = parts_of(twin, [&](const auto& m, auto ids) { CP::sweep_segmentation(m, ids, options); });
  const auto consensus
    = parts_of(twin, [](const auto& m, auto ids) { CP::consensus_segmentation(m, ids); });
  const auto k_means = parts_of(
    twin, [&](const auto& m, auto ids) { CP::k_means_segmentation(m, m.points(), ids, options); });
  EXPECT_EQ(parts_of(mine, [&](const auto& m, auto ids) { CP::sweep_segmentation(m, ids, np); }),
            sweep);
  EXPECT_EQ(parts_of(mine,
                     [&](const auto& m, auto ids) {
                       CP::sweep_segmentation(m, ids, options, np);
                       CP::segmentation_parts(m, ids, np);
                     }),
            sweep_of_three);
  EXPECT_EQ(
    parts_of(mine, [&](const auto& m, auto ids) { CP::consensus_segmentation(m, ids, np); }),
    consensus);
  EXPECT_EQ(
    parts_of(mine, [&](const auto& m,
                       auto ids) { CP::k_means_segmentation(m, m.points(), ids, options, np); }),
    k_means);
  EXPECT_EQ(parts_of(mine,
                     [&](const auto& m, auto ids) {
                       CP::k_means_segmentation(m, m.points(), ids, options,
                                                CP::K_means_weights::VERTICES, np);
                     }),
            k_means);

  // with a pose: here, the surface itself
  const auto with_pose = [](const auto& np_of_mesh, const auto&... arguments) {
    return [&](const auto& m, auto ids) {
      std::vector<std::size_t> other(num_faces(m));
      CP::sweep_segmentation(m, m.points(), ids, arguments..., np_of_mesh);
      CP::consensus_segmentation(m, m.points(), CGAL::make_property_map(other), arguments...,
                                 np_of_mesh);
    };
  };
  EXPECT_EQ(parts_of(mine, with_pose(np)), parts_of(twin, with_pose(twin_np)));
  EXPECT_EQ(parts_of(mine, with_pose(np, options)), parts_of(twin, with_pose(twin_np, options)));
}

} // namespace test_concepts
