// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Concurrent calls from threads of the user program return the same bytes as sequential calls.

#include "engine/linear_algebra/Sparse_factor.h"

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include "bent_bars.h"
#include "matchers.h"
#include "shapes.h"
#include "sparse_matrices.h"

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace test_concurrent_calls {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;

// Runs the jobs, each of which returns a matrix, sequentially and then repeatedly at once.
void expect_same_bytes(const std::vector<std::function<Eigen::MatrixXd()>>& jobs, const int times)
{
  std::vector<Eigen::MatrixXd> expected, results(jobs.size());
  for(const auto& job : jobs)
    expected.push_back(job());
  for(int i = 0; i < times; ++i)
  {
    std::vector<std::thread> threads;
    for(std::size_t j = 0; j < jobs.size(); ++j)
      threads.emplace_back([&, j] { results[j] = jobs[j](); });
    for(std::thread& thread : threads)
      thread.join();
    for(std::size_t j = 0; j < jobs.size(); ++j)
      EXPECT_EQ(results[j], expected[j]) << "job " << j;
  }
}

// The Laplacian of a grid of n x n x n vertices plus a small diagonal.
Eigen::SparseMatrix<double> volume_matrix(const int n)
{
  std::vector<Eigen::Triplet<double>> entries;
  const auto index = [n](const int i, const int j, const int k) { return (i * n + j) * n + k; };
  for(int i = 0; i < n; ++i)
    for(int j = 0; j < n; ++j)
      for(int k = 0; k < n; ++k)
      {
        const int v = index(i, j, k);
        entries.emplace_back(v, v, 6.1);
        for(const int w : {i + 1 < n ? index(i + 1, j, k) : -1, j + 1 < n ? index(i, j + 1, k) : -1,
                           k + 1 < n ? index(i, j, k + 1) : -1})
          if(w >= 0)
          {
            entries.emplace_back(v, w, -1.);
            entries.emplace_back(w, v, -1.);
          }
      }
  Eigen::SparseMatrix<double> result(n * n * n, n * n * n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// Matrices of volumes are large enough for CHOLMOD to call METIS, which seeds and uses the random
// generator of the process.
TEST(Concurrent_calls, factors_of_volumes)
{
  std::vector<std::function<Eigen::MatrixXd()>> jobs;
  for(const int n : {22, 23, 24, 25})
    jobs.push_back([matrix = volume_matrix(n)] {
      CP::internal::Sparse_factor factor;
      factor.factor(matrix, "the test matrix");
      return factor.solve(shapes::waves(matrix.rows(), 2));
    });
  expect_same_bytes(jobs, 3);
}

TEST(Concurrent_calls, poses)
{
  std::vector<std::function<Eigen::MatrixXd()>> jobs;
  for(const double angle : {1., 2., 3.})
    jobs.push_back([soup = shapes::boundary(shapes::tetrahedral_bent_bar(24, 4, 4, angle))] {
      CP::Options options;
      options.registration.detail_length = 0.03;
      options.registration.injective = true;
      return Eigen::MatrixXd(shapes::pose_of(soup, options).pose);
    });
  jobs.push_back([soup = shapes::tetrahedral_bent_bar(16, 3, 3, 2.)] {
    using Point_3 = CGAL::Simple_cartesian<double>::Point_3;
    CP::Indexed_tetrahedra_3<Point_3> complex;
    for(const auto& p : soup.points)
      complex.points.emplace_back(p[0], p[1], p[2]);
    complex.cells = soup.cells;
    std::vector<Point_3> pose(soup.points.size());
    CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose));
    return Eigen::MatrixXd(shapes::to_matrix(pose));
  });
  expect_same_bytes(jobs, 2);
}

#ifdef CGAL_LINKED_WITH_TBB
// The limit concerns the loops of the call, and not those of other threads of the program: the
// functions of the user run within it, in the thread of the call, and the process is allowed as many
// threads as before. So it is after an exception of the user.
TEST(Concurrent_calls, limit_of_threads_concerns_the_call_only)
{
  const auto allowed = [] {
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  };
  const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
  const shapes::Triangle_soup bar = shapes::bent_bar();
  tbb::task_arena(4).execute([&] {
    ASSERT_EQ(tbb::this_task_arena::max_concurrency(), 4);
    const std::thread::id caller = std::this_thread::get_id();
    CP::Options options;
    const Eigen::MatrixXd expected = shapes::pose_of(bar, options).pose;
    for(const int limit : {1, 2, 4, 9})
    {
      options.number_of_threads = limit;
      int calls = 0, nested_calls = 0;
      options.visitor = [&](const CP::Registration_progress&) {
        EXPECT_EQ(tbb::this_task_arena::max_concurrency(), (std::min)(limit, 4));
        EXPECT_EQ(allowed(), 4u);
        EXPECT_EQ(std::this_thread::get_id(), caller);
        if(++calls == 1) // a call within a call keeps the limit of both
        {
          CP::Options nested;
          nested.number_of_threads = 3;
          nested.visitor = [&](const CP::Registration_progress&) {
            ++nested_calls;
            EXPECT_EQ(tbb::this_task_arena::max_concurrency(), (std::min)(limit, 3));
            return true;
          };
          shapes::pose_of(bar, nested);
        }
        return true;
      };
      EXPECT_EQ(Eigen::MatrixXd(shapes::pose_of(bar, options).pose), expected);
      EXPECT_GT(calls, 0);
      EXPECT_GT(nested_calls, 0);
      EXPECT_EQ(tbb::this_task_arena::max_concurrency(), 4);
    }
    options.number_of_threads = 1;
    options.visitor
      = [](const CP::Registration_progress&) -> bool { throw std::runtime_error("enough"); };
    EXPECT_THROW_WITH(shapes::pose_of(bar, options), std::runtime_error, "enough");
    EXPECT_EQ(tbb::this_task_arena::max_concurrency(), 4);
  });
}
#endif

} // namespace test_concurrent_calls
