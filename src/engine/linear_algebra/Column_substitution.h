// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_COLUMN_SUBSTITUTION_H
#define CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_COLUMN_SUBSTITUTION_H

#include "Supernodal_routines.h"

#include <CGAL/Canonical_pose_3/internal/linear_algebra/Lanes.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The coordinates of points: right-hand sides that are solved for at the same time, so that the
// factor is read once. Each has the same bytes independently of the others.
inline constexpr std::size_t NUMBER_OF_COORDINATES = 3;

// Arrays of numbers, one per coordinate.
struct Coordinate_arrays
{
  double* numbers;
  std::size_t size;

  CGAL_CANONICAL_POSE_3_ROUTINE double* operator[](std::size_t c) const
  {
    return numbers + c * size;
  }
};

// The rows that a substitution changes: those in `x`, up to the row `end`; later ones are collected
// in `sums`, at places[row]. `work`: memory for the rows of any block.
struct Column_substitution_rows
{
  Coordinate_arrays x;
  std::size_t end;
  Coordinate_arrays sums;
  const int* places;
  Coordinate_arrays work;
};

// COUNT consecutive columns of a block, from the column `first` on: vectors hold rows of one column.
template <class Vector, std::size_t COUNT>
class Column_panel
{
public:
  CGAL_CANONICAL_POSE_3_ROUTINE Column_panel(const Supernode& node, std::size_t first)
    : m_node(node), m_first(first), m_values(node.values + first * node.stride)
  {}

  // Solves for the rows of the panel, and subtracts their products from those below.
  CGAL_CANONICAL_POSE_3_ROUTINE void forward(const Coordinate_arrays& rows)
  {
    for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
      for(std::size_t j = 0; j < COUNT; ++j)
      {
        double x = rows[c][m_first + j];
        for(std::size_t i = 0; i < j; ++i)
          x -= value(m_first + j, i) * m_x[i][c];
        rows[c][m_first + j] = m_x[j][c] = x * m_node.inverse_diagonal[m_first + j];
      }
    std::size_t k = m_first + COUNT;
    for(; k + Vector::SIZE <= m_node.stride; k += Vector::SIZE)
      subtract_products<typename Vector::Part>(rows, k);
    for(; k < m_node.stride; ++k)
      subtract_products<Vector_of_1::Part>(rows, k);
  }

  // Subtracts the products of the rows below, and solves for the rows of the panel.
  CGAL_CANONICAL_POSE_3_ROUTINE void backward(const Coordinate_arrays& rows)
  {
    sum_products(rows);
    for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
      for(std::size_t j = COUNT; j-- > 0;)
      {
        double x = rows[c][m_first + j] - m_x[j][c];
        for(std::size_t i = j + 1; i < COUNT; ++i)
          x -= value(m_first + i, j) * rows[c][m_first + i];
        rows[c][m_first + j] = x * m_node.inverse_diagonal[m_first + j];
      }
  }

private:
  using Numbers = typename Vector::Numbers;

  CGAL_CANONICAL_POSE_3_ROUTINE const double& value(std::size_t row, std::size_t j) const
  {
    return m_values[j * m_node.stride + row];
  }

  template <class Part>
  CGAL_CANONICAL_POSE_3_ROUTINE static Part& part(double* numbers)
  {
    return *reinterpret_cast<Part*>(numbers);
  }

  template <class Part>
  CGAL_CANONICAL_POSE_3_ROUTINE static const Part& part(const double* numbers)
  {
    return *reinterpret_cast<const Part*>(numbers);
  }

  template <class Part>
  CGAL_CANONICAL_POSE_3_ROUTINE void subtract_products(const Coordinate_arrays& rows,
                                                       std::size_t k) const
  {
    Part values[COUNT];
    for(std::size_t j = 0; j < COUNT; ++j)
      values[j] = part<Part>(&value(k, j));
    for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
    {
      Part& target = part<Part>(rows[c] + k);
      auto sum = target.numbers;
      for(std::size_t j = 0; j < COUNT; ++j)
        sum -= values[j].numbers * m_x[j][c];
      target.numbers = sum;
    }
  }

  CGAL_CANONICAL_POSE_3_ROUTINE void sum_products(const Coordinate_arrays& rows)
  {
    Numbers sums[COUNT][NUMBER_OF_COORDINATES] = {};
    std::size_t k = m_first + COUNT;
    for(; k + Vector::SIZE <= m_node.stride; k += Vector::SIZE)
    {
      Numbers x[NUMBER_OF_COORDINATES];
      for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
        x[c] = part<typename Vector::Part>(rows[c] + k).numbers;
      for(std::size_t j = 0; j < COUNT; ++j)
      {
        const Numbers values = part<typename Vector::Part>(&value(k, j)).numbers;
        for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
          sums[j][c] += values * x[c];
      }
    }
    for(std::size_t j = 0; j < COUNT; ++j)
      for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
      {
        double sum = 0;
        if constexpr(Vector::SIZE == 1)
          sum = sums[j][c];
        else
          for(std::size_t i = 0; i < Vector::SIZE; ++i)
            sum += sums[j][c][i];
        for(std::size_t i = k; i < m_node.stride; ++i)
          sum += value(i, j) * rows[c][i];
        m_x[j][c] = sum;
      }
  }

  const Supernode& m_node;
  const std::size_t m_first;
  const double* const m_values;
  double m_x[COUNT][NUMBER_OF_COORDINATES]; // rows of the panel
};

// Columns that are processed at the same time.
inline constexpr std::size_t COLUMNS_OF_A_PANEL = 4;

// Solves L x = b in place, for the blocks from `first` to `last`.
struct Forward_column_substitution
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void run(const Supernodal_matrix* l, std::size_t first,
                                                std::size_t last,
                                                const Column_substitution_rows* rows)
  {
    for(std::size_t s = first; s <= last; ++s)
    {
      const Supernode node(*l, s);
      const Coordinate_arrays& work = rows->work;
      for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
      {
        for(std::size_t k = 0; k < node.columns; ++k)
          work[c][k] = rows->x[c][node.first + k];
        for(std::size_t k = node.columns; k < node.stride; ++k)
          work[c][k] = 0;
      }
      std::size_t j = 0;
      for(; j + COLUMNS_OF_A_PANEL <= node.columns; j += COLUMNS_OF_A_PANEL)
        Column_panel<Vector, COLUMNS_OF_A_PANEL>(node, j).forward(work);
      for(; j < node.columns; ++j)
        Column_panel<Vector, 1>(node, j).forward(work);
      for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
      {
        for(std::size_t k = 0; k < node.columns; ++k)
          rows->x[c][node.first + k] = work[c][k];
        for(std::size_t k = node.columns; k < node.stride; ++k)
        {
          const auto row = static_cast<std::size_t>(node.rows[k]);
          if(row < rows->end)
            rows->x[c][row] += work[c][k];
          else
            rows->sums[c][rows->places[row]] += work[c][k];
        }
      }
    }
  }
};

// Solves L'x = b in place, for the blocks from `last` to `first`.
struct Backward_column_substitution
{
  template <class Vector>
  CGAL_CANONICAL_POSE_3_ROUTINE static void run(const Supernodal_matrix* l, std::size_t first,
                                                std::size_t last,
                                                const Column_substitution_rows* rows)
  {
    for(std::size_t s = last + 1; s-- > first;)
    {
      const Supernode node(*l, s);
      const Coordinate_arrays& work = rows->work;
      for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
        for(std::size_t k = 0; k < node.stride; ++k)
          work[c][k] = rows->x[c][node.rows[k]];
      std::size_t j = node.columns;
      for(; j % COLUMNS_OF_A_PANEL > 0; --j)
        Column_panel<Vector, 1>(node, j - 1).backward(work);
      for(; j > 0; j -= COLUMNS_OF_A_PANEL)
        Column_panel<Vector, COLUMNS_OF_A_PANEL>(node, j - COLUMNS_OF_A_PANEL).backward(work);
      for(std::size_t c = 0; c < NUMBER_OF_COORDINATES; ++c)
        for(std::size_t k = 0; k < node.columns; ++k)
          rows->x[c][node.first + k] = work[c][k];
    }
  }
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LINEAR_ALGEBRA_COLUMN_SUBSTITUTION_H
