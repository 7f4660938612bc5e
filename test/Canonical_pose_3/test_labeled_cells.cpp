// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Labeled_cells_3.h>
#include <CGAL/Canonical_pose_3/complex_body.h>
#include <CGAL/Canonical_pose_3/extract_boundary.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>

#include <boost/property_map/property_map.hpp>

#include <gtest/gtest.h>

#include "c3t3.h"
#include "matchers.h"

#include <map>
#include <set>
#include <stdexcept>
#include <vector>

namespace test_labeled_cells {

namespace CP = CGAL::Canonical_pose_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Tetrahedra = CP::Indexed_tetrahedra_3<Point>;
using Canonical_pose_test::C3t3;
using Selection = CP::Labeled_cells_3<Tetrahedra>;

// A bar of 3 x 1 x 1 cubes, labeled 1, 2, 4 along it, meshed by Mesh_3.
const C3t3& bar()
{
  static const C3t3 result = [] {
    const auto label = [](const Point& p) {
      const bool is_inside
        = p.x() > 0 && p.x() < 3 && p.y() > 0 && p.y() < 1 && p.z() > 0 && p.z() < 1;
      return !is_inside ? 0 : p.x() < 1 ? 1 : p.x() < 2 ? 2 : 4;
    };
    return Canonical_pose_test::make_c3t3(label, Kernel::Sphere_3(Point(1.5, 0.5, 0.5), 9.), 0.05);
  }();
  return result;
}

template <class Complex>
Tetrahedra indexed(const Complex& complex)
{
  using Traits = CP::Tetrahedral_complex_traits_3<Complex>;
  Tetrahedra result;
  std::map<typename Traits::Vertex_descriptor, std::size_t> index;
  for(const auto v : Traits::vertices(complex))
  {
    index.emplace(v, index.size());
    result.points.push_back(Traits::point(complex, v));
  }
  for(const auto& c : Traits::cells(complex))
    result.cells.push_back({index[c[0]], index[c[1]], index[c[2]], index[c[3]]});
  const auto labels = Traits::labels(complex);
  result.labels.assign(labels.begin(), labels.end());
  return result;
}

// The selection contains the cells with the label: its volume is the sum of theirs, and (by the
// divergence theorem) that inside its boundary. The parts add up to the complex.
TEST(Labeled_cells, volume_is_that_of_the_cells)
{
  const double whole = CP::complex_body(bar()).volume();
  EXPECT_NEAR(CP::complex_body(CP::Labeled_cells_3(bar(), {1, 2, 4, 2})).volume(), whole,
              1e-12 * whole);
  for(const int label : {1, 2, 4})
  {
    double expected = 0;
    for(auto c = bar().cells_in_complex_begin(); c != bar().cells_in_complex_end(); ++c)
      if(c->subdomain_index() == label)
        expected += bar().triangulation().tetrahedron(C3t3::Cell_handle(c)).volume();
    const CP::Labeled_cells_3 selection(bar(), label);
    EXPECT_NEAR(CP::complex_body(selection).volume(), expected, 1e-12 * expected);
    Mesh surface;
    std::map<Mesh::Vertex_index, C3t3::Vertex_handle> origin;
    CP::extract_boundary(selection, surface, boost::make_assoc_property_map(origin));
    EXPECT_TRUE(CGAL::is_closed(surface));
    EXPECT_NEAR(CGAL::Polygon_mesh_processing::volume(surface), expected, 1e-10 * expected);
  }
  EXPECT_NEAR(whole, 3., 0.3);
}

// A complex, its triangulation and the arrays created from it have the same cells: each selection
// is the same body and has the same pose, bit by bit. The pose is written to vertices of the
// complex, and only to those of the selection.
TEST(Labeled_cells, of_all_complexes_agree)
{
  const Tetrahedra tetrahedra = indexed(bar());
  const std::set<int> labels = {4, 2};
  const CP::Labeled_cells_3 of_complex(bar(), labels);
  const CP::Labeled_cells_3 of_triangulation(bar().triangulation(), labels);
  const CP::Labeled_cells_3 of_arrays(tetrahedra, labels);
  const CP::Conforming_body_3 body = CP::complex_body(of_arrays);
  EXPECT_EQ(CP::complex_body(of_complex).points(), body.points());
  EXPECT_EQ(CP::complex_body(of_complex).cells(), body.cells());
  EXPECT_EQ(CP::complex_body(of_triangulation).points(), body.points());
  EXPECT_EQ(CP::complex_body(of_triangulation).cells(), body.cells());

  CP::Options options;
  options.number_of_landmarks = 10;
  std::map<C3t3::Vertex_handle, Point> pose;
  EXPECT_TRUE(
    CGAL::canonical_pose_3(of_complex, boost::make_assoc_property_map(pose), options).is_usable());
  std::map<std::size_t, Point> pose_of_arrays;
  CGAL::canonical_pose_3(CP::Labeled_cells_3(tetrahedra, labels),
                         boost::make_assoc_property_map(pose_of_arrays), options);
  ASSERT_EQ(pose.size(), pose_of_arrays.size());
  const auto vertices = CP::Tetrahedral_complex_traits_3<C3t3>::vertices(bar());
  for(const auto& [v, p] : pose_of_arrays)
    EXPECT_EQ(pose[vertices[v]], p);
  EXPECT_EQ(pose.size(), static_cast<std::size_t>(body.points().rows()));
}

// A selection is a complex with labels.
TEST(Labeled_cells, of_a_selection)
{
  Tetrahedra box;
  box.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-1, 0, 0}, {0, -1, 0}};
  box.cells = {{{0, 1, 2, 3}}, {{4, 1, 2, 3}}, {{0, 5, 2, 3}}, {{0, 1, 6, 3}}};
  box.labels = {0, 1, 2, 2};
  const Selection two(box, std::vector<int>{0, 2});
  EXPECT_EQ(two.labels(), (std::vector<int>{0, 2, 2}));
  const CP::Labeled_cells_3<Selection> one(two, 2);
  EXPECT_EQ(one.cells(), Selection(box, 2).cells());
  EXPECT_EQ(one.vertices(), (std::vector<std::size_t>{0, 1, 2, 3, 5, 6}));
  EXPECT_EQ(indexed(one).labels, std::vector<int>(2, 2));
}

TEST(Labeled_cells, bad_input_is_named)
{
  EXPECT_THROW_WITH(CP::Labeled_cells_3(bar(), 3), std::invalid_argument,
                    "no cell of the complex has label 3");
  EXPECT_THROW_WITH(CP::Labeled_cells_3(bar(), {1, 7}), std::invalid_argument, "label 7");
  EXPECT_THROW_WITH(CP::Labeled_cells_3(bar(), std::set<int>()), std::invalid_argument,
                    "there is no label");
  EXPECT_THROW_WITH(CP::Labeled_cells_3(bar().triangulation(), 0), std::invalid_argument,
                    "label 0");
  Tetrahedra box = indexed(bar());
  box.labels.clear();
  EXPECT_THROW_WITH(Selection(box, 1), std::invalid_argument, "has 0 labels, but");
  EXPECT_EQ(CP::internal::name_of_label('\1'), "label 1");
}

} // namespace test_labeled_cells
