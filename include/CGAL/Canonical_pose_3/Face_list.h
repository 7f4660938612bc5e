// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_FACE_LIST_H
#define CGAL_CANONICAL_POSE_3_FACE_LIST_H

#include <boost/iterator/iterator_facade.hpp>
#include <boost/range/iterator_range.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the faces of a polygon soup: one array of vertices, 12 bytes per triangle.

Any range of ranges of indices is converted to it, for instance
`std::vector<std::array<int, 3>>`.
*/
class Face_list
{
  template <class Range>
  using Vertex_of_range
    = std::decay_t<decltype(*std::begin(*std::begin(std::declval<const Range&>())))>;

public:
  /// unsigned integer type of the vertices.
  using Index = std::uint32_t;
  /// range of vertices; it refers to the list.
  using Face = boost::iterator_range<const Index*>;

  /// iterator over the faces.
  class const_iterator
    : public boost::iterator_facade<const_iterator, const Face, std::random_access_iterator_tag,
                                    Face, std::ptrdiff_t>
  {
  public:
    const_iterator() = default;

  private:
    friend class boost::iterator_core_access;
    friend class Face_list;
    const_iterator(const Face_list& list, const std::size_t f) : m_list(&list), m_face(f) {}

    Face dereference() const { return (*m_list)[m_face]; }
    bool equal(const const_iterator& other) const { return m_face == other.m_face; }
    void increment() { ++m_face; }
    void decrement() { --m_face; }
    void advance(const std::ptrdiff_t n) { m_face += static_cast<std::size_t>(n); }
    std::ptrdiff_t distance_to(const const_iterator& other) const
    {
      return static_cast<std::ptrdiff_t>(other.m_face) - static_cast<std::ptrdiff_t>(m_face);
    }

    const Face_list* m_list = nullptr;
    std::size_t m_face = 0;
  };

  using iterator = const_iterator;
  using value_type = Face;
  using size_type = std::size_t;

  /// creates an empty list.
  Face_list() = default;

  /// holds the faces of a range of ranges of indices.
  /// \throws std::invalid_argument as `push_back()`
  template <class Range, class Vertex = Vertex_of_range<Range>,
            std::enable_if_t<!std::is_base_of<Face_list, Range>::value
                               && std::is_constructible<std::size_t, Vertex>::value
                               && !std::is_floating_point<Vertex>::value, // positions are no faces
                             int> = 0>
  Face_list(const Range& faces)
  {
    using Iterator = decltype(std::begin(faces));
    if constexpr(std::is_base_of<std::random_access_iterator_tag,
                                 typename std::iterator_traits<Iterator>::iterator_category>::value)
      reserve(static_cast<std::size_t>(std::end(faces) - std::begin(faces)));
    for(const auto& face : faces)
      push_back(face);
  }

  /// holds these faces.
  /// \throws std::invalid_argument as `push_back()`
  Face_list(const std::initializer_list<std::initializer_list<std::size_t>> faces)
  {
    for(const std::initializer_list<std::size_t>& face : faces)
      push_back(face);
  }

  /// appends a face, with any number of vertices.
  /// \throws std::invalid_argument if an index is negative, or does not fit into `Index`.
  template <class Range>
  void push_back(const Range& face)
  {
    const std::size_t begin = m_vertices.size();
    for(const auto& vertex : face)
    {
      const auto v = static_cast<std::size_t>(vertex);
      if(v > (std::numeric_limits<Index>::max)())
      {
        m_vertices.resize(begin);
        throw std::invalid_argument("face " + std::to_string(size()) + " names vertex "
                                    + std::to_string(v) + ", but indices are less than 4294967296");
      }
      m_vertices.push_back(static_cast<Index>(v));
    }
    const bool is_triangle = m_vertices.size() == begin + 3;
    if(m_begins.empty() && !is_triangle)
      for(std::size_t c = 0; c <= begin; c += 3)
        m_begins.push_back(c);
    if(!m_begins.empty())
      m_begins.push_back(m_vertices.size());
  }

  /// appends a face, with any number of vertices.
  void push_back(const std::initializer_list<std::size_t> face)
  {
    push_back(boost::make_iterator_range(face.begin(), face.end()));
  }

  /// appends a face of a list, possibly of this one.
  void push_back(const Face& face) { push_back(std::vector<Index>(face.begin(), face.end())); }

  /// allocates memory for a number of triangles.
  void reserve(const std::size_t number_of_triangles)
  {
    m_vertices.reserve(3 * number_of_triangles);
  }

  /// number of faces.
  std::size_t size() const
  {
    return m_begins.empty() ? m_vertices.size() / 3 : m_begins.size() - 1;
  }

  bool empty() const { return size() == 0; }

  /// whether all faces are triangles.
  bool are_triangles() const { return m_begins.empty(); }

  /// the vertices of face `f`. \pre `f < size()`
  Face operator[](const std::size_t f) const
  {
    return {m_vertices.data() + begin_of_face(f), m_vertices.data() + begin_of_face(f + 1)};
  }

  /// the vertices of all faces, one face after the other.
  const std::vector<Index>& vertices() const { return m_vertices; }

  /// index in `vertices()` of the first vertex of face `f`, or their number. \pre `f <= size()`
  std::size_t begin_of_face(const std::size_t f) const
  {
    return m_begins.empty() ? 3 * f : m_begins[f];
  }

  const_iterator begin() const { return {*this, 0}; }
  const_iterator end() const { return {*this, size()}; }

  friend bool operator==(const Face_list& a, const Face_list& b)
  {
    return a.m_vertices == b.m_vertices && a.m_begins == b.m_begins;
  }
  friend bool operator!=(const Face_list& a, const Face_list& b) { return !(a == b); }

private:
  std::vector<Index> m_vertices;
  std::vector<std::size_t> m_begins; // of faces, and the end; none if all are triangles
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_FACE_LIST_H
