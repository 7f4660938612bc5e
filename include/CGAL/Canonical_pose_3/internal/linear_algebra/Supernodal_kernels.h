// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_SUPERNODAL_KERNELS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_SUPERNODAL_KERNELS_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lanes.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// A lower triangular matrix in dense blocks of columns with the same rows below the diagonal, as
// CHOLMOD stores it: block s has the columns first_columns[s] .. first_columns[s+1]-1, the rows
// rows[first_rows[s]] .. rows[first_rows[s+1]-1], of which the first are the columns themselves, and
// its values, column by column, begin at values[first_values[s]].
struct Supernodal_matrix
{
  std::size_t number_of_blocks;
  const int* first_columns;
  const int* first_rows;
  const int* first_values;
  const int* rows;
  const double* values;
  const double* inverse_diagonal;
};

// One block of the matrix.
struct Supernode
{
  CGAL_CANONICAL_POSE_3_KERNEL Supernode(const Supernodal_matrix& l, std::size_t s)
    : first(static_cast<std::size_t>(l.first_columns[s])),
      columns(static_cast<std::size_t>(l.first_columns[s + 1]) - first),
      stride(static_cast<std::size_t>(l.first_rows[s + 1] - l.first_rows[s])),
      rows(l.rows + l.first_rows[s]), values(l.values + l.first_values[s]),
      inverse_diagonal(l.inverse_diagonal + first)
  {}

  std::size_t first, columns, stride;
  const int* rows;
  const double* values;
  const double* inverse_diagonal;
};

// Solves L x = b in place. Blocks of rows that are 0, as they are for an impulse outside of the path
// from its row to the root of the elimination tree, cost nothing.
struct Forward_substitution
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_KERNEL static void run(const Supernodal_matrix* l, double* x)
  {
    for(std::size_t s = 0; s < l->number_of_blocks; ++s)
    {
      const Supernode node(*l, s);
      double* const own = x + NUMBER_OF_LANES * node.first;
      if(is_zero(own, NUMBER_OF_LANES * node.columns))
        continue;
      solve_triangle<Vector>(node, own);
      std::size_t i = node.columns;
      for(; i + Vector::ROWS <= node.stride; i += Vector::ROWS)
        update<Vector, Vector::ROWS>(node, i, own, x);
      for(; i < node.stride; ++i)
        update<Vector, 1>(node, i, own, x);
    }
  }

private:
  CGAL_CANONICAL_POSE_3_KERNEL static bool is_zero(const double* x, std::size_t size)
  {
    for(std::size_t i = 0; i < size; ++i)
      if(x[i] != 0)
        return false;
    return true;
  }

  template <class Vector>
  CGAL_CANONICAL_POSE_3_KERNEL static void solve_triangle(const Supernode& node, double* own)
  {
    using Numbers = typename Vector::Numbers;
    constexpr std::size_t parts = NUMBER_OF_LANES / Vector::SIZE;
    for(std::size_t j = 0; j < node.columns; ++j)
    {
      Numbers* const x = reinterpret_cast<Numbers*>(own + NUMBER_OF_LANES * j);
      for(std::size_t p = 0; p < parts; ++p)
        x[p] *= node.inverse_diagonal[j];
      for(std::size_t i = j + 1; i < node.columns; ++i)
      {
        Numbers* const y = reinterpret_cast<Numbers*>(own + NUMBER_OF_LANES * i);
        for(std::size_t p = 0; p < parts; ++p)
          y[p] -= node.values[i + j * node.stride] * x[p];
      }
    }
  }

  // ROWS rows from row i of the block on, all of its columns
  template <class Vector, std::size_t ROWS>
  CGAL_CANONICAL_POSE_3_KERNEL static void update(const Supernode& node, std::size_t i,
                                                  const double* own, double* x)
  {
    using Numbers = typename Vector::Numbers;
    constexpr std::size_t parts = NUMBER_OF_LANES / Vector::SIZE;
    for(std::size_t p = 0; p < parts; ++p)
    {
      Numbers sums[ROWS];
      for(std::size_t k = 0; k < ROWS; ++k)
        sums[k] = reinterpret_cast<const Numbers*>(
          x + NUMBER_OF_LANES * static_cast<std::size_t>(node.rows[i + k]))[p];
      for(std::size_t j = 0; j < node.columns; ++j)
      {
        const Numbers factor = reinterpret_cast<const Numbers*>(own + NUMBER_OF_LANES * j)[p];
        const double* const values = node.values + i + j * node.stride;
        for(std::size_t k = 0; k < ROWS; ++k)
          sums[k] -= values[k] * factor;
      }
      for(std::size_t k = 0; k < ROWS; ++k)
        reinterpret_cast<Numbers*>(
          x + NUMBER_OF_LANES * static_cast<std::size_t>(node.rows[i + k]))[p]
          = sums[k];
    }
  }
};

// Solves L'x = b in place.
struct Backward_substitution
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_KERNEL static void run(const Supernodal_matrix* l, double* x)
  {
    for(std::size_t s = l->number_of_blocks; s-- > 0;)
    {
      const Supernode node(*l, s);
      double* const own = x + NUMBER_OF_LANES * node.first;
      std::size_t j = 0;
      for(; j + Vector::ROWS <= node.columns; j += Vector::ROWS)
        gather<Vector, Vector::ROWS>(node, j, own, x);
      for(; j + 2 <= node.columns; j += 2)
        gather<Vector, 2>(node, j, own, x);
      for(; j < node.columns; ++j)
        gather<Vector, 1>(node, j, own, x);
      solve_triangle<Vector>(node, own);
    }
  }

private:
  // COLUMNS columns from column j of the block on, all rows below its triangle
  template <class Vector, std::size_t COLUMNS>
  CGAL_CANONICAL_POSE_3_KERNEL static void gather(const Supernode& node, std::size_t j, double* own,
                                                  const double* x)
  {
    using Numbers = typename Vector::Numbers;
    constexpr std::size_t parts = NUMBER_OF_LANES / Vector::SIZE;
    for(std::size_t p = 0; p < parts; ++p)
    {
      Numbers sums[COLUMNS];
      for(std::size_t k = 0; k < COLUMNS; ++k)
        sums[k] = reinterpret_cast<const Numbers*>(own + NUMBER_OF_LANES * (j + k))[p];
      for(std::size_t i = node.columns; i < node.stride; ++i)
      {
        const Numbers factor = reinterpret_cast<const Numbers*>(
          x + NUMBER_OF_LANES * static_cast<std::size_t>(node.rows[i]))[p];
        const double* const values = node.values + i + j * node.stride;
        for(std::size_t k = 0; k < COLUMNS; ++k)
          sums[k] -= values[k * node.stride] * factor;
      }
      for(std::size_t k = 0; k < COLUMNS; ++k)
        reinterpret_cast<Numbers*>(own + NUMBER_OF_LANES * (j + k))[p] = sums[k];
    }
  }

  template <class Vector>
  CGAL_CANONICAL_POSE_3_KERNEL static void solve_triangle(const Supernode& node, double* own)
  {
    using Numbers = typename Vector::Numbers;
    constexpr std::size_t parts = NUMBER_OF_LANES / Vector::SIZE;
    for(std::size_t j = node.columns; j-- > 0;)
    {
      Numbers* const x = reinterpret_cast<Numbers*>(own + NUMBER_OF_LANES * j);
      for(std::size_t p = 0; p < parts; ++p)
        x[p] *= node.inverse_diagonal[j];
      for(std::size_t i = 0; i < j; ++i)
      {
        Numbers* const y = reinterpret_cast<Numbers*>(own + NUMBER_OF_LANES * i);
        for(std::size_t p = 0; p < parts; ++p)
          y[p] -= node.values[j + i * node.stride] * x[p];
      }
    }
  }
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_LINEAR_ALGEBRA_SUPERNODAL_KERNELS_H
