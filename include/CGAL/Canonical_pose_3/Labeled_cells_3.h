// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_LABELED_CELLS_3_H
#define CGAL_CANONICAL_POSE_3_LABELED_CELLS_3_H

#include <CGAL/Canonical_pose_3/Tetrahedral_complex_traits_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <unordered_set>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The label type of a complex, and whether its traits provide labels.
template <class Complex, class = void>
struct Label_of_complex : std::false_type
{
  using type = int;
};

template <class Complex>
struct Label_of_complex<Complex, std::void_t<decltype(Tetrahedral_complex_traits_3<Complex>::labels(
                                   std::declval<const Complex&>()))>> : std::true_type
{
  using type = std::decay_t<decltype(*std::begin(
    Tetrahedral_complex_traits_3<Complex>::labels(std::declval<const Complex&>())))>;
};

template <class T, class = void>
struct Is_streamable : std::false_type
{};

template <class T>
struct Is_streamable<
  T, std::void_t<decltype(std::declval<std::ostream&>() << std::declval<const T&>())>>
  : std::true_type
{};

template <class Label>
std::string name_of_label(const Label& label)
{
  std::ostringstream result;
  result << "label";
  if constexpr(std::is_integral_v<Label>)
    result << ' ' << +label; // small integers are no characters here
  else if constexpr(Is_streamable<Label>::value)
    result << ' ' << label;
  return result.str();
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief selects the cells with given labels of a tetrahedral complex, for instance an organ of a
segmented image. The selection is a complex itself.

Its vertices are those of the selected cells; cells and vertices are in the order of the complex.
Vertex descriptors are those of the complex, so a property map of its vertices can be used for the
pose. Indices of cells and vertices (in messages, in options per cell or vertex, in the result of
`complex_body()`) are those in the selection.

\tparam Complex a type for which `Tetrahedral_complex_traits_3` is specialized, with labels: see the
        concept `TetrahedralComplexTraits_3`. It is usually deduced, as in
        `canonical_pose_3(Labeled_cells_3(c3t3, 2), pose_map)`.

\sa `Tetrahedral_complex_traits_3`
\sa `complex_body()`
\sa `extract_boundary()`
*/
template <class Complex>
class Labeled_cells_3
{
  using Complex_traits = Tetrahedral_complex_traits_3<Complex>;

  static_assert(
    internal::Label_of_complex<Complex>::value,
    "The cells of this complex have no labels: its Tetrahedral_complex_traits_3 needs a "
    "static member function labels(complex) that returns one label per cell, in the order "
    "of cells(complex).");

public:
  /// the type of the labels: the subdomain index for the complexes of \cgal, `int` for
  /// `Indexed_tetrahedra_3`.
  using Label = typename internal::Label_of_complex<Complex>::type;

  /// the vertices: those of the complex.
  using Vertex_descriptor = typename Complex_traits::Vertex_descriptor;

  /*!
  selects the cells of one label.

  \param complex the complex, not a temporary. It must outlive this object and keep its cells and
         vertices.
  \param label the label.

  \throws std::invalid_argument if no cell has the label, or there is not one label per cell.

  <em>Complexity:</em> linear in the size of the complex.
  */
  Labeled_cells_3(const Complex& complex, const Label& label)
    : Labeled_cells_3(complex, std::vector<Label>(1, label))
  {}

  /*!
  selects the cells of several labels.

  \param complex as above.
  \param labels the labels, possibly with repetitions.

  \throws std::invalid_argument if one of the labels has no cell, or there is no label, or not one
         label per cell.

  <em>Complexity:</em> linear in the size of the complex, times the number of labels.
  */
  Labeled_cells_3(const Complex& complex, const std::vector<Label>& labels) : m_complex(&complex)
  {
    select_cells(labels);
    select_vertices();
  }

  /// selects the cells of several labels.
  /// \tparam LabelRange a range of `Label`
  template <class LabelRange,
            std::enable_if_t<!std::is_convertible<const LabelRange&, Label>::value, int> = 0>
  Labeled_cells_3(const Complex& complex, const LabelRange& labels)
    : Labeled_cells_3(complex, std::vector<Label>(std::begin(labels), std::end(labels)))
  {}

  /// \cond SKIP_IN_MANUAL
  template <class Labels>
  Labeled_cells_3(const Complex&&, const Labels&) = delete;
  Labeled_cells_3(const Complex&&, std::initializer_list<Label>) = delete;
  /// \endcond

  /// returns the complex.
  const Complex& complex() const { return *m_complex; }

  /// returns the vertices of the selected cells.
  const std::vector<Vertex_descriptor>& vertices() const { return m_vertices; }

  /// returns the selected cells.
  const std::vector<std::array<Vertex_descriptor, 4>>& cells() const { return m_cells; }

  /// returns the labels of the selected cells.
  const std::vector<Label>& labels() const { return m_labels; }

private:
  void select_cells(const std::vector<Label>& selected)
  {
    const auto& labels = Complex_traits::labels(*m_complex);
    const auto& cells = Complex_traits::cells(*m_complex);
    const auto number_of_labels = std::distance(std::begin(labels), std::end(labels));
    const auto number_of_cells = std::distance(std::begin(cells), std::end(cells));
    if(number_of_labels != number_of_cells)
      throw std::invalid_argument("the complex has " + std::to_string(number_of_labels)
                                  + " labels, but " + std::to_string(number_of_cells) + " cells");
    if(selected.empty())
      throw std::invalid_argument("there is no label to select cells by");
    for(const Label& label : selected)
      if(std::find(std::begin(labels), std::end(labels), label) == std::end(labels))
        throw std::invalid_argument("no cell of the complex has " + internal::name_of_label(label));
    auto label = std::begin(labels);
    for(const auto& cell : cells)
    {
      if(std::find(selected.begin(), selected.end(), *label) != selected.end())
      {
        m_cells.push_back({vertex(cell[0]), vertex(cell[1]), vertex(cell[2]), vertex(cell[3])});
        m_labels.push_back(*label);
      }
      ++label;
    }
  }

  void select_vertices()
  {
    std::unordered_set<Vertex_descriptor> used;
    for(const auto& cell : m_cells)
      used.insert(cell.begin(), cell.end());
    for(const Vertex_descriptor v : Complex_traits::vertices(*m_complex))
      if(used.count(v) != 0)
        m_vertices.push_back(v);
  }

  template <class Descriptor>
  static Vertex_descriptor vertex(const Descriptor& v)
  {
    return static_cast<Vertex_descriptor>(v);
  }

  const Complex* m_complex;
  std::vector<Vertex_descriptor> m_vertices;
  std::vector<std::array<Vertex_descriptor, 4>> m_cells;
  std::vector<Label> m_labels;
};

/// \cond SKIP_IN_MANUAL

template <class Complex>
struct Tetrahedral_complex_traits_3<Labeled_cells_3<Complex>>
{
  using Vertex_descriptor = typename Tetrahedral_complex_traits_3<Complex>::Vertex_descriptor;
  using Point_3 = typename Tetrahedral_complex_traits_3<Complex>::Point_3;

  static const auto& vertices(const Labeled_cells_3<Complex>& cells) { return cells.vertices(); }

  static const auto& cells(const Labeled_cells_3<Complex>& cells) { return cells.cells(); }

  static const auto& labels(const Labeled_cells_3<Complex>& cells) { return cells.labels(); }

  static decltype(auto) point(const Labeled_cells_3<Complex>& cells, const Vertex_descriptor v)
  {
    return Tetrahedral_complex_traits_3<Complex>::point(cells.complex(), v);
  }
};

/// \endcond

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_LABELED_CELLS_3_H
