// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/surface/examine_surface.h"

#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "dirty_shapes.h"
#include "matchers.h"

namespace test_examine_surface {

// examine_surface() reads both of its results from one topology; diagnose() and repair_surface(), which
// have one each, are the oracle. All must be the same, whatever is shared: nothing was cut or left out
// (ball, STL file), only duplicates were, or polygons and triangles have different edges.

namespace CP = CGAL::Canonical_pose_3;
using namespace Canonical_pose_test;

std::vector<Polygon_soup> soups()
{
  Polygon_soup duplicates = ball(), turned = ball(), indices = ball(), isolated = ball();
  duplicates.polygons.insert(duplicates.polygons.begin() + 3, {ball().polygons[7]});
  std::swap(turned.polygons[4][0], turned.polygons[4][1]);
  indices.polygons.push_back({0, 0, 1});
  indices.polygons.push_back({});
  indices.polygons.push_back({2, 3});
  isolated.points.push_back({{0, 0, 0}});
  return {ball(),           unsewn(ball()),
          quad_cube(),      unsewn(quad_cube()),
          duplicates,       unsewn(duplicates),
          turned,           indices,
          isolated,         pinched_balls(),
          ball_with_fin(),  cubes_with_a_common_edge(),
          moebius_strip(5), merged(ball(), quad_cube(), 5.)};
}

void expect_same(const CP::Diagnosis_3& a, const CP::Diagnosis_3& b)
{
  EXPECT_EQ(a.vertices, b.vertices);
  EXPECT_EQ(a.faces, b.faces);
  EXPECT_EQ(a.components, b.components);
  EXPECT_EQ(a.self_intersections, b.self_intersections);
  EXPECT_EQ(a.first_defect, b.first_defect);
  ASSERT_EQ(a.defects.size(), b.defects.size());
  for(std::size_t i = 0; i < a.defects.size(); ++i)
  {
    EXPECT_EQ(a.defects[i].kind, b.defects[i].kind);
    EXPECT_EQ(a.defects[i].count, b.defects[i].count);
    EXPECT_EQ(a.defects[i].examples, b.defects[i].examples);
    EXPECT_EQ(a.defects[i].message, b.defects[i].message);
  }
}

void expect_same(const CP::Repaired_surface_3& a, const CP::Repaired_surface_3& b)
{
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
  EXPECT_EQ(a.origins, b.origins);
  EXPECT_EQ(a.representatives, b.representatives);
  EXPECT_EQ(a.face_of_triangle, b.face_of_triangle);
  EXPECT_EQ(a.caps, b.caps);
  EXPECT_EQ(a.component_of_triangle, b.component_of_triangle);
  EXPECT_EQ(a.number_of_components, b.number_of_components);
}

template <class Function>
std::string message_of(const Function& f)
{
  try
  {
    f();
  }
  catch(const std::invalid_argument& error)
  {
    return error.what();
  }
  return "";
}

TEST(Examine_surface, is_diagnosis_and_repair)
{
  for(const Polygon_soup& soup : soups())
  {
    const Point_matrix points = to_matrix(soup.points);
    const CP::internal::Examined_surface both
      = CP::internal::examine_surface(points, soup.polygons, true);
    expect_same(both.diagnosis, CP::diagnose(points, soup.polygons));
    expect_same(both.surface, CP::repair_surface(points, soup.polygons));
  }
}

TEST(Examine_surface, refuses_what_they_refuse)
{
  Polygon_soup infinite = ball(), missing = ball(), empty = ball(), flat = ball();
  infinite.points[3][1] = std::numeric_limits<double>::infinity();
  missing.polygons[2][0] = 12;
  empty.polygons.clear();
  flat.points.assign(12, {{1, 2, 3}});
  const std::vector<std::string> messages
    = {"vertex 3 has a coordinate that is not finite", "face 2 names vertex 12, but there are 12",
       "the surface has no face", "the surface has no area: all its faces are degenerate"};
  std::size_t i = 0;
  for(const Polygon_soup& soup : {infinite, missing, empty, flat})
  {
    const Point_matrix points = to_matrix(soup.points);
    EXPECT_EQ(message_of([&] { CP::internal::examine_surface(points, soup.polygons, false); }),
              messages[i]);
    EXPECT_EQ(message_of([&] { CP::repair_surface(points, soup.polygons); }), messages[i]);
    if(i < 2) // the diagnosis lists what others refuse
      EXPECT_EQ(CP::diagnose(points, soup.polygons).first_defect, messages[i]);
    ++i;
  }
}

TEST(Disjoint_sets, labels_are_in_the_order_of_the_first_items)
{
  using CP::internal::Disjoint_sets;
  Disjoint_sets sets(6);
  sets.unite(4, 1);
  sets.unite(5, 4);
  sets.unite(3, 0);
  const auto labels = CP::internal::label_components(sets);
  EXPECT_EQ(labels.of_items, (std::vector<std::size_t>{0, 1, 2, 0, 1, 1}));
  EXPECT_EQ(labels.first_items, (std::vector<std::size_t>{0, 1, 2}));

  const std::vector<std::size_t> members = {Disjoint_sets::NONE, 5, 3, 1, 0};
  const auto of_some = CP::internal::label_components(
    sets, members.size(), [&](const std::size_t i) { return members[i]; });
  EXPECT_EQ(of_some.of_items, (std::vector<std::size_t>{Disjoint_sets::NONE, 0, 1, 0, 1}));
  EXPECT_EQ(of_some.first_items, (std::vector<std::size_t>{1, 2}));
}

} // namespace test_examine_surface
