// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/target/check_number_of_landmarks.h"

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "matchers.h"
#include "shapes.h"

namespace test_number_of_landmarks {

namespace CP = CGAL::Canonical_pose_3;

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

CP::Registration_summary summary(const Mesh& mesh, const CP::Options& options)
{
  std::vector<Kernel::Point_3> pose(mesh.num_vertices());
  return CGAL::canonical_pose_3(
           mesh, boost::make_iterator_property_map(pose.begin(), get(boost::vertex_index, mesh)),
           options)
    .summary;
}

// There are at most as many landmarks as vertices, at most 4096, and at most 2^29 distances.
TEST(Number_of_landmarks, bounds)
{
  using CP::internal::check_number_of_landmarks;
  const std::size_t very_many = (std::numeric_limits<std::size_t>::max)();
  EXPECT_NO_THROW(check_number_of_landmarks(80, 1000000));
  EXPECT_NO_THROW(check_number_of_landmarks(very_many, 4096));
  EXPECT_THROW_WITH(check_number_of_landmarks(very_many, 4097), std::invalid_argument, "<= 4096 ");
  EXPECT_NO_THROW(check_number_of_landmarks(4096, 131072));
  EXPECT_THROW_WITH(check_number_of_landmarks(4096, 131073), std::invalid_argument, "<= 4095 ");
  EXPECT_NO_THROW(check_number_of_landmarks(512, 1 << 20));
  EXPECT_THROW_WITH(check_number_of_landmarks(513, 1 << 20), std::invalid_argument,
                    "number_of_landmarks is 513, but must be <= 512 for a surface of 1048576 ");
  EXPECT_NO_THROW(check_number_of_landmarks(1, 0));
}

// A number that would require gigabytes is refused before anything is computed, stating the largest
// number allowed. A small mesh has at most as many landmarks as vertices, or 80 where vertices are added to
// it, regardless of the number.
TEST(Number_of_landmarks, of_the_call)
{
  CP::Options options;
  options.number_of_landmarks = 1000000000;
  EXPECT_THROW_WITH(
    summary(Canonical_pose_test::icosphere<Mesh>(5, 1.), options), std::invalid_argument,
    "number_of_landmarks is 1000000000, but must be <= 4096 for a surface of 10242 vertices");
  options.number_of_rounds = 0;
  const Mesh ball = Canonical_pose_test::icosphere<Mesh>(3, 1.);
  EXPECT_EQ(summary(ball, options).target.landmarks, num_vertices(ball));
  const Mesh bar = Canonical_pose_test::bar<Mesh>(6, 2, 2); // has 58 vertices, and is refined
  for(const auto geodesics : {CP::Options::Geodesics::HEAT, CP::Options::Geodesics::WAVEFRONT})
    for(const std::size_t number :
        {std::size_t(1000000000), (std::numeric_limits<std::size_t>::max)()})
    {
      options.geodesics = geodesics;
      options.number_of_landmarks = number;
      EXPECT_EQ(summary(bar, options).target.landmarks, 80u);
    }
}

} // namespace test_number_of_landmarks
