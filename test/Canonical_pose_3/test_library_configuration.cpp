// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/call_with_threads.h>
#include <CGAL/Canonical_pose_3/library_configuration.h>

#include <CGAL/version.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <gtest/gtest.h>

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

} // namespace test_library_configuration
