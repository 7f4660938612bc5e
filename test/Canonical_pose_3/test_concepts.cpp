// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

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
#include <unordered_map>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Points;
using CP::Point_matrix;

namespace {

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

} // namespace

template <>
struct CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3<My_complex>
{
  using Vertex_descriptor = char32_t;
  using Point_3 = My_point;
  using Cell = std::array<char32_t, 4>;

  static std::vector<char32_t> vertices(const My_complex& complex)
  {
    std::vector<char32_t> result;
    for(std::size_t i = 0; i < complex.points.size(); ++i)
      result.push_back(static_cast<char32_t>(U'a' + i));
    return result;
  }
  static std::vector<Cell> cells(const My_complex& complex)
  {
    std::vector<Cell> result;
    for(const auto& c : complex.cells)
      result.push_back({char32_t(U'a' + c[0]), char32_t(U'a' + c[1]), char32_t(U'a' + c[2]),
                        char32_t(U'a' + c[3])});
    return result;
  }
  static const My_point& point(const My_complex& complex, const char32_t v)
  {
    return complex.points[v - U'a'];
  }
};

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
