// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "engine/energy/Arap_energy.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include "matchers.h"
#include "shapes.h"

namespace test_arap_energy {

namespace CP = CGAL::Canonical_pose_3;
namespace shapes = Canonical_pose_test;

std::atomic<std::size_t> allocated_bytes{0};

using Energy = CP::internal::Arap_energy;

Energy energy(const shapes::Tetrahedral_soup& body)
{
  std::vector<std::array<int, 4>> cells;
  for(const auto& c : body.cells)
    cells.push_back({int(c[0]), int(c[1]), int(c[2]), int(c[3])});
  const Eigen::Index n = Eigen::Index(cells.size());
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(n, 1, 2) / double(n);
  return Energy(shapes::to_matrix(body.points), cells, weights, Eigen::VectorXd());
}

Eigen::SparseMatrix<double> plain_matrix(const Energy& energy, const Eigen::Index n)
{
  std::vector<Eigen::Triplet<double>> entries;
  for(std::size_t t = 0; t < energy.number_of_cells(); ++t)
  {
    const CP::internal::Elastic_cell cell = energy.cell(t);
    const Eigen::Matrix4d products = cell.weight * cell.gradients * cell.gradients.transpose();
    for(int i = 0; i < 4; ++i)
      for(int j = 0; j < 4; ++j)
        entries.emplace_back(cell.vertices[std::size_t(i)], cell.vertices[std::size_t(j)],
                             products(i, j));
  }
  Eigen::SparseMatrix<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// All faces of a ball, joined to its center.
shapes::Tetrahedral_soup star(const unsigned int subdivisions)
{
  const shapes::Triangle_soup sphere = shapes::icosphere_soup(subdivisions, 1.);
  shapes::Tetrahedral_soup result;
  result.points = sphere.points;
  result.points.push_back({{0., 0., 0.}});
  for(const auto& t : sphere.triangles)
    result.cells.push_back({{sphere.points.size(), t[0], t[1], t[2]}});
  return result;
}

} // namespace test_arap_energy

[[gnu::noinline]] void* operator new(const std::size_t size)
{
  test_arap_energy::allocated_bytes += size;
  if(void* const memory = std::malloc(size > 0 ? size : 1))
    return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* const memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* const memory, std::size_t) noexcept
{
  std::free(memory);
}

namespace test_arap_energy {

// The matrix is defined by its sum over the cells. In the star, every cell contains the center,
// whose column is full; the box has more columns than a block.
TEST(Arap_energy, matrix_is_the_sum_over_the_cells)
{
  for(const shapes::Tetrahedral_soup& body :
      {star(4), shapes::tetrahedral_box(16, 12, 10, {{1., 2., 3.}})})
  {
    const Energy e = energy(body);
    const Eigen::SparseMatrix<double> matrix = e.matrix(0.25);
    const Eigen::SparseMatrix<double> expected
      = 0.25 * plain_matrix(e, Eigen::Index(body.points.size()));
    ASSERT_EQ(matrix.nonZeros(), expected.nonZeros());
    EXPECT_LE((matrix - expected).norm(), 1e-14 * expected.norm());
  }
}

// An affine function has the same gradient in all cells: the quadratic form of x is the sum of the weights,
// and constants are in the kernel.
TEST(Arap_energy, matrix_on_affine_functions)
{
  const shapes::Tetrahedral_soup body = star(3);
  const Energy e = energy(body);
  const Eigen::SparseMatrix<double> matrix = e.matrix(1);
  double weights = 0;
  for(std::size_t t = 0; t < e.number_of_cells(); ++t)
    weights += e.cell(t).weight;
  const CP::Point_matrix points = shapes::to_matrix(body.points);
  EXPECT_NEAR(points.col(0).dot(matrix * points.col(0)), weights, 1e-11 * weights);
  EXPECT_LE((matrix * Eigen::VectorXd::Ones(points.rows())).norm(), 1e-11 * matrix.norm());
}

// A cell has 16 entries, each stored at most a few times, and 4 corners: the bytes per cell are
// bounded. A vector of all vertices for each block of columns would take 7 000 bytes per cell here.
TEST(Arap_energy, memory_of_the_matrix_is_linear_in_the_cells)
{
  shapes::Tetrahedral_soup separate_cells;
  for(std::size_t v = 0; v < 100000; v += 4)
  {
    const double x = double(v);
    for(const std::array<double, 3> p :
        {std::array<double, 3>{{x, 0., 0.}}, {{x + 1, 0., 0.}}, {{x, 1., 0.}}, {{x, 0., 1.}}})
      separate_cells.points.push_back(p);
    separate_cells.cells.push_back({{v, v + 1, v + 2, v + 3}});
  }
  for(const shapes::Tetrahedral_soup& body : {separate_cells, shapes::tetrahedral_box(40, 30, 30)})
  {
    const Energy e = energy(body);
    const std::size_t before = allocated_bytes;
    e.matrix(1);
    EXPECT_LE(double(allocated_bytes - before) / double(e.number_of_cells()), 1200);
  }
}

} // namespace test_arap_energy
