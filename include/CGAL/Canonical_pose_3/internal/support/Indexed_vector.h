// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_INDEXED_VECTOR_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_INDEXED_VECTOR_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Indices of one kind are an enumeration with std::size_t as its type. They do not convert to those
// of another kind, so what is indexed by the one cannot be indexed by the other.

template <class Index, class Value>
class Indexed_vector
{
public:
  Indexed_vector() = default;
  explicit Indexed_vector(const std::size_t n, const Value& value = Value()) : m_values(n, value) {}

  // The values are indices, too.
  static Indexed_vector of_numbers(const std::vector<std::size_t>& numbers)
  {
    Indexed_vector result;
    for(const std::size_t number : numbers)
      result.m_values.push_back(Value(number));
    return result;
  }

  std::size_t size() const { return m_values.size(); }

  Value& operator[](const Index i) { return m_values[static_cast<std::size_t>(i)]; }
  const Value& operator[](const Index i) const { return m_values[static_cast<std::size_t>(i)]; }

  // Calls f(i) for each index.
  template <class Function>
  void for_each_index(const Function& f) const
  {
    for(std::size_t i = 0; i < size(); ++i)
      f(Index(i));
  }

  auto begin() const { return m_values.begin(); }
  auto end() const { return m_values.end(); }

private:
  std::vector<Value> m_values;
};

// Each index, as an index of the same or another kind.
template <class Index, class Value = Index>
Indexed_vector<Index, Value> identity_map(const std::size_t n)
{
  Indexed_vector<Index, Value> result(n);
  for(std::size_t i = 0; i < n; ++i)
    result[Index(i)] = Value(i);
  return result;
}

// The rows of a matrix.
template <class Index, class Matrix>
class Indexed_rows
{
public:
  explicit Indexed_rows(Matrix& matrix) : m_matrix(matrix) {}

  auto operator[](const Index i) const { return m_matrix.row(static_cast<Eigen::Index>(i)); }

private:
  Matrix& m_matrix;
};

template <class Index, class Matrix>
Indexed_rows<Index, Matrix> rows_by(Matrix& matrix)
{
  return Indexed_rows<Index, Matrix>(matrix);
}

template <class Index, class Matrix>
Point_matrix rows_at(const Indexed_rows<Index, Matrix>& rows, const std::vector<Index>& indices)
{
  Point_matrix result(static_cast<Eigen::Index>(indices.size()), 3);
  Eigen::Index row = 0;
  for(const Index i : indices)
    result.row(row++) = rows[i];
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_INDEXED_VECTOR_H
