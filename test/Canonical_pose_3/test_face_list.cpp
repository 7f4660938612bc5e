// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include "matchers.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <forward_list>
#include <limits>
#include <list>
#include <stdexcept>
#include <type_traits>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using CP::Face_list;
using Vectors = std::vector<std::vector<std::size_t>>;

namespace {

Vectors vectors_of(const Face_list& faces)
{
  Vectors result;
  for(const Face_list::Face face : faces)
    result.emplace_back(face.begin(), face.end());
  return result;
}

TEST(Face_lists, hold_what_they_were_made_of)
{
  // Whether or not there are offsets, which the first face that is no triangle creates: the faces are exactly those
  // appended, in their order.
  for(const Vectors& faces :
      {Vectors(), Vectors{{0, 1, 2}}, Vectors{{0, 1, 2}, {2, 1, 3}}, Vectors{{3, 2, 1, 0}},
       Vectors{{0, 1, 2}, {2, 1, 3}, {0, 1, 2, 3, 4}, {4, 2, 1}, {}, {0, 1}}, Vectors{{}},
       Vectors{{}, {0, 1, 2}}})
  {
    const Face_list list = faces;
    EXPECT_EQ(vectors_of(list), faces);
    ASSERT_EQ(list.size(), faces.size());
    EXPECT_EQ(list.empty(), faces.empty());
    std::size_t corners = 0;
    for(std::size_t f = 0; f < faces.size(); ++f)
    {
      EXPECT_EQ(list.begin_of_face(f), corners);
      corners += faces[f].size();
    }
    EXPECT_EQ(list.begin_of_face(faces.size()), corners);
    EXPECT_EQ(list.vertices().size(), corners);
    Face_list appended;
    for(const std::vector<std::size_t>& face : faces)
      appended.push_back(face);
    EXPECT_EQ(appended, list);
  }
}

TEST(Face_lists, are_made_of_any_range_of_ranges)
{
  static_assert(std::is_convertible<std::vector<std::vector<int>>, Face_list>::value, "indices");
  static_assert(!std::is_convertible<std::vector<std::array<double, 3>>, Face_list>::value,
                "positions would be truncated without a word");
  static_assert(!std::is_convertible<CGAL::Canonical_pose_3::Point_matrix, Face_list>::value,
                "as well");
  static_assert(!std::is_convertible<std::vector<int>, Face_list>::value, "this is one face");
  const Face_list expected = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_TRUE(expected.are_triangles());
  EXPECT_EQ(Face_list(std::vector<std::array<int, 3>>{{0, 1, 2}, {2, 1, 3}}), expected);
  EXPECT_EQ(Face_list(std::list<std::forward_list<short>>{{0, 1, 2}, {2, 1, 3}}), expected);
  const unsigned char faces[2][3] = {{0, 1, 2}, {2, 1, 3}};
  EXPECT_EQ(Face_list(faces), expected);
  EXPECT_NE(Face_list({{0, 1, 2}}), expected);
  EXPECT_NE(Face_list({{0, 1, 2, 2, 1, 3}}), expected); // the same vertices in a row
}

TEST(Face_lists, append_a_face_of_theirs)
{
  // What is appended is in the array that grows.
  Face_list list = {{7, 8, 9}};
  for(std::size_t n = 1; n < 1000; ++n)
    list.push_back(list[n - 1]);
  EXPECT_EQ(list, Face_list(Vectors(1000, {7, 8, 9})));
}

TEST(Face_lists, refuse_indices_that_do_not_fit)
{
  Face_list list = {{0, 1, 2}, {2, 1, (std::numeric_limits<Face_list::Index>::max)()}};
  const Face_list before = list;
  EXPECT_THROW_WITH(list.push_back({0, 1, std::size_t(1) << 32}), std::invalid_argument,
                    "face 2 names vertex 4294967296, but indices are less than 4294967296");
  EXPECT_THROW_WITH(list.push_back(std::vector<int>{0, -1}), std::invalid_argument,
                    "face 2 names vertex 18446744073709551615");
  EXPECT_EQ(list, before);
}

TEST(Face_lists, refuse_more_corners_than_can_be_numbered)
{
  EXPECT_NO_THROW(CP::internal::Corner_table::check_number_of_corners(4294967295));
  EXPECT_THROW_WITH(CP::internal::Corner_table::check_number_of_corners(4294967296),
                    std::invalid_argument, "the faces have 4294967296 corners");
}

} // namespace
