// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// False contacts. The numbers of vertices, edges and faces tell the number of handles exactly, and the
// merged figure is known without its contact.

#include <CGAL/Canonical_pose_3/cut_contacts.h>
#include <CGAL/Canonical_pose_3/pose_difference.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <gtest/gtest.h>

#include "../../examples/Canonical_pose_3/Articulated_figure.h"
#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_cut_contacts {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;
using Canonical_pose_examples::Articulated_figure;
using CP::Point_matrix;
using CP::Surface_component_3;

template <class Points, class Triangles>
Surface_component_3 component(const Points& points, const Triangles& triangles)
{
  const CP::Repaired_surface_3 repaired = CP::repair_surface(shapes::to_matrix(points), triangles);
  Surface_component_3 result;
  result.points = repaired.points;
  result.triangles = repaired.triangles;
  result.caps = repaired.caps;
  result.face_of_triangle = repaired.face_of_triangle;
  result.origins = result.body_origins = repaired.origins;
  return result;
}

// Twice the number of handles of the surface closed by its caps.
long handles_twice(const Surface_component_3& surface)
{
  std::set<std::pair<std::size_t, std::size_t>> edges;
  std::set<std::size_t> vertices;
  for(const auto* const triangles : {&surface.triangles, &surface.caps})
    for(const auto& t : *triangles)
      for(std::size_t k = 0; k < 3; ++k)
      {
        vertices.insert(t[k]);
        edges.insert(std::minmax(t[k], t[(k + 1) % 3]));
      }
  return 2 - long(vertices.size()) + long(edges.size())
         - long(surface.triangles.size() + surface.caps.size());
}

const Articulated_figure& figure()
{
  static const Articulated_figure instance(2500);
  return instance;
}

CP::Result pose_of(const Articulated_figure::Triangles& triangles, const CP::Options& options)
{
  return shapes::pose_of(figure().points(Articulated_figure::hand_on_knee()), triangles, options);
}

// The curve separates hand and knee; faces, origins and positions remain, and each vertex of the curve
// exists twice.
TEST(Cut_contacts, contact_of_hand_and_knee_is_cut)
{
  const Surface_component_3 merged
    = component(figure().points(Articulated_figure::hand_on_knee()), figure().merged_triangles());
  ASSERT_EQ(handles_twice(merged), 2);
  const Surface_component_3 cut = CP::cut_contacts(merged);
  EXPECT_EQ(handles_twice(cut), 0);
  ASSERT_EQ(cut.contacts.size(), 1u);
  EXPECT_EQ(cut.triangles.size(), merged.triangles.size());
  EXPECT_EQ(cut.face_of_triangle, merged.face_of_triangle);
  ASSERT_GT(cut.points.rows(), merged.points.rows());
  EXPECT_EQ(cut.points.topRows(merged.points.rows()), merged.points);
  ASSERT_EQ(cut.origins.size(), static_cast<std::size_t>(cut.points.rows()));
  std::set<std::size_t> twice;
  for(std::size_t i = static_cast<std::size_t>(merged.points.rows()); i < cut.origins.size(); ++i)
  {
    const auto first = static_cast<Eigen::Index>(
      std::find(merged.origins.begin(), merged.origins.end(), cut.origins[i])
      - merged.origins.begin());
    EXPECT_EQ(cut.points.row(static_cast<Eigen::Index>(i)), merged.points.row(first));
    twice.insert(cut.origins[i]);
  }
  EXPECT_EQ(twice.size(), static_cast<std::size_t>(cut.points.rows() - merged.points.rows()));
  EXPECT_TRUE(twice.count(cut.contacts[0]) == 1);
}

// Shapes without handles, and handles that are wide, such as that of a torus, remain as they are. Inside,
// the edges of the torus are concave.
TEST(Cut_contacts, other_surfaces_do_not_change)
{
  const auto is_unchanged = [](const Surface_component_3& surface) {
    const Surface_component_3 result = CP::cut_contacts(surface);
    return result.points == surface.points && result.triangles == surface.triangles
           && result.caps == surface.caps && result.contacts.empty();
  };
  const shapes::Triangle_soup bar = shapes::bent_bar();
  EXPECT_TRUE(is_unchanged(component(bar.points, bar.triangles)));
  EXPECT_TRUE(is_unchanged(component(figure().points(), figure().triangles())));
  const shapes::Triangle_soup torus = shapes::torus_soup(12, 12, 2., 1.);
  const Surface_component_3 wide = component(torus.points, torus.triangles);
  ASSERT_EQ(handles_twice(wide), 2);
  EXPECT_TRUE(is_unchanged(wide));
}

// The purpose. With the contact cut, the pose is that of the figure without contact up to its 20 or so
// vertices near the contact; otherwise, the hand pulls the leg along.
TEST(Cut_contacts, pose_is_that_without_contact)
{
  CP::Options options;
  options.number_of_rounds = 0;
  const Point_matrix apart = pose_of(figure().triangles(), options).pose;
  const double kept
    = CP::pose_difference(pose_of(figure().merged_triangles(), options).pose, apart);
  options.contacts = CP::Options::Contacts::CUT;
  const CP::Result result = pose_of(figure().merged_triangles(), options);
  EXPECT_LT(CP::pose_difference(result.pose, apart), kept / 3);
  EXPECT_TRUE(std::any_of(
    result.summary.warnings.begin(), result.summary.warnings.end(), [](const std::string& warning) {
      return warning.find("a false contact was cut at vertex") != std::string::npos;
    }));
  EXPECT_EQ(pose_of(figure().triangles(), options).pose, apart);
}

TEST(Cut_contacts, bodies_that_need_a_closed_surface_are_refused)
{
  CP::Options options;
  options.contacts = CP::Options::Contacts::CUT;
  options.body = CP::Options::Body::TETGEN;
  EXPECT_THROW_WITH(pose_of(figure().triangles(), options), std::invalid_argument,
                    "contacts can only be cut");
}

} // namespace test_cut_contacts
