// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SUPERNODAL_ROUTINES_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SUPERNODAL_ROUTINES_H

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lanes.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A lower triangular matrix in dense blocks of columns with the same rows below the diagonal, as
// CHOLMOD stores it: block s has the columns first_columns[s] .. first_columns[s+1]-1, the rows
// rows[first_rows[s]] .. rows[first_rows[s+1]-1], of which the first are the columns themselves, and
// its values, column by column, start at values[first_values[s]].
struct Supernodal_matrix
{
  std::size_t number_of_blocks;
  const Factor_index* first_columns;
  const Factor_index* first_rows;
  const Factor_index* first_values;
  const Factor_index* rows;
  const double* values;
  const double* inverse_diagonal;
};

// One block of the matrix.
struct Supernode
{
  CGAL_CANONICAL_POSE_3_ROUTINE Supernode(const Supernodal_matrix& l, std::size_t s)
    : first(static_cast<std::size_t>(l.first_columns[s])),
      columns(static_cast<std::size_t>(l.first_columns[s + 1]) - first),
      stride(static_cast<std::size_t>(l.first_rows[s + 1] - l.first_rows[s])),
      rows(l.rows + l.first_rows[s]), values(l.values + l.first_values[s]),
      inverse_diagonal(l.inverse_diagonal + first)
  {}

  // The entries (begin .. end - 1, j .. j_end - 1), numbers within the block, as they are or transposed.
  CGAL_CANONICAL_POSE_3_ROUTINE Lane_block entries(std::size_t begin, std::size_t end,
                                                   std::size_t j, std::size_t j_end) const
  {
    return {rows + begin, end - begin, rows + j, j_end - j, values + begin + j * stride, 1, stride};
  }
  CGAL_CANONICAL_POSE_3_ROUTINE Lane_block transposed_entries(std::size_t begin, std::size_t end,
                                                              std::size_t j,
                                                              std::size_t j_end) const
  {
    return {rows + j, j_end - j, rows + begin, end - begin, values + begin + j * stride, stride, 1};
  }

  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE void divide_by_diagonal(std::size_t j, double* x) const
  {
    for(std::size_t p = 0; p < NUMBER_OF_PARTS<Vector>; ++p)
      part<Vector>(x, first + j, p).numbers *= inverse_diagonal[j];
  }

  std::size_t first, columns, stride;
  const Factor_index* rows;
  const double* values;
  const double* inverse_diagonal;
};

// Solves L x = b in place. Blocks of rows that are 0 have no cost; for an impulse, these are the
// rows that are not on the path from its row to the root of the elimination tree.
struct Forward_substitution
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void run(const Supernodal_matrix* l, double* x)
  {
    for(std::size_t s = 0; s < l->number_of_blocks; ++s)
    {
      const Supernode node(*l, s);
      if(is_zero(x + NUMBER_OF_LANES * node.first, NUMBER_OF_LANES * node.columns))
        continue;
      for(std::size_t j = 0; j < node.columns; ++j)
      {
        node.divide_by_diagonal<Vector>(j, x);
        subtract_product<Vector>(node.entries(j + 1, node.columns, j, j + 1), x);
      }
      subtract_product<Vector>(node.entries(node.columns, node.stride, 0, node.columns), x);
    }
  }

private:
  CGAL_CANONICAL_POSE_3_ROUTINE static bool is_zero(const double* x, std::size_t size)
  {
    for(std::size_t i = 0; i < size; ++i)
      if(x[i] != 0)
        return false;
    return true;
  }
};

// Solves L'x = b in place.
struct Backward_substitution
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void run(const Supernodal_matrix* l, double* x)
  {
    for(std::size_t s = l->number_of_blocks; s-- > 0;)
    {
      const Supernode node(*l, s);
      subtract_product<Vector>(node.transposed_entries(node.columns, node.stride, 0, node.columns),
                               x);
      for(std::size_t j = node.columns; j-- > 0;)
      {
        node.divide_by_diagonal<Vector>(j, x);
        subtract_product<Vector>(node.transposed_entries(j, j + 1, 0, j), x);
      }
    }
  }
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_SUPERNODAL_ROUTINES_H
