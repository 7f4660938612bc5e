// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/call_with_threads.h>
#include <CGAL/Canonical_pose_3/geodesic_distances.h>
#include <CGAL/Canonical_pose_3/library_configuration.h>
#include <CGAL/Canonical_pose_3/set_interruption_check.h>

#include <CGAL/version.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <atomic>
#include <limits>
#include <stdexcept>
#include <string>

namespace test_library_configuration {

namespace CP = CGAL::Canonical_pose_3;

// Tests are compiled with the headers and the options of the library.
TEST(Library_configuration, is_that_of_the_build)
{
  const CP::Library_configuration configuration = CP::library_configuration();
  EXPECT_EQ(configuration.canonical_pose_3, CGAL_CANONICAL_POSE_3_VERSION);
  EXPECT_EQ(configuration.cgal, CGAL_VERSION_STR);
  EXPECT_EQ(configuration.compiler, __VERSION__);
#ifdef CGAL_LINKED_WITH_TBB
  EXPECT_TRUE(configuration.tbb);
#else
  EXPECT_FALSE(configuration.tbb);
#endif
#ifdef CGAL_CANONICAL_POSE_3_USE_CHOLMOD
  EXPECT_TRUE(configuration.cholmod);
#else
  EXPECT_FALSE(configuration.cholmod);
#endif
}

// The number of threads that loops may use, in the function and after it.
TEST(Call_with_threads, is_a_limit)
{
#ifdef CGAL_LINKED_WITH_TBB
  const auto largest = [] { return tbb::this_task_arena::max_concurrency(); };
#else
  const auto largest = [] { return 1; };
#endif
  const int without = largest();
  for(const int number : {0, 1, without, without + 7})
  {
    int within = 0;
    CP::call_with_threads(number, [&] { within = largest(); });
    EXPECT_EQ(within, number > 0 && number < without ? number : without) << number;
    EXPECT_THROW(CP::call_with_threads(number, [] { throw std::domain_error("of the caller"); }),
                 std::domain_error);
    EXPECT_EQ(largest(), without);
  }
  EXPECT_THROW(CP::call_with_threads(-1, [] {}), std::invalid_argument);
}

std::atomic<int> calls_before_interruption{0};

void interrupt()
{
  if(--calls_before_interruption == 0)
    throw std::domain_error("interrupted");
}

// An exception of the check ends a call, wherever it is; calls afterward are not concerned.
TEST(Set_interruption_check, ends_calls)
{
  const Canonical_pose_test::Triangle_soup soup = Canonical_pose_test::icosphere_soup(3, 1);
  const CP::Point_matrix points = Canonical_pose_test::to_matrix(soup.points);
  const auto distances = [&] {
    return CP::geodesic_distances(points, soup.triangles, {0, 17, 100});
  };
  const Eigen::MatrixXd expected = distances();
  calls_before_interruption = (std::numeric_limits<int>::max)();
  CP::set_interruption_check(interrupt);
  EXPECT_EQ(distances(), expected);
  const int number = (std::numeric_limits<int>::max)() - calls_before_interruption;
  ASSERT_GT(number, 10);
  for(const int calls : {1, number / 2, number})
  {
    calls_before_interruption = calls;
    EXPECT_THROW(distances(), std::domain_error) << calls;
  }
  CP::set_interruption_check(nullptr);
  EXPECT_EQ(distances(), expected);
}

} // namespace test_library_configuration
