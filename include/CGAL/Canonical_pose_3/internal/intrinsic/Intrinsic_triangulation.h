// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_INTRINSIC_TRIANGULATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_INTRINSIC_TRIANGULATION_H

#include <CGAL/boost/graph/properties.h>
#include <CGAL/assertions.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A triangulation defined by its edge lengths. Face `f` has the halfedges 3f, 3f+1, 3f+2 in this
// order; halfedge `h` starts at vertex `origin(h)` and has length `length(h)`, and `twin(h)` is the
// opposite halfedge, or -1 at the border. It is a Delta-complex: after flips, a vertex may be its
// own neighbor, two edges may have the same endpoints, and two edges of a face may be glued to each
// other.
class Intrinsic_triangulation
{
public:
  Intrinsic_triangulation() = default;

  // `origins`, `twins`, `lengths`: one entry per halfedge; the lengths of twins are equal
  Intrinsic_triangulation(std::size_t number_of_vertices, std::vector<int> origins,
                          std::vector<int> twins, std::vector<double> lengths)
    : m_number_of_vertices(number_of_vertices), m_origins(std::move(origins)),
      m_twins(std::move(twins)), m_lengths(std::move(lengths))
  {
    CGAL_precondition(m_origins.size() % 3 == 0);
    CGAL_precondition(m_origins.size() == m_twins.size());
    CGAL_precondition(m_origins.size() == m_lengths.size());
  }

  std::size_t number_of_vertices() const { return m_number_of_vertices; }
  int number_of_faces() const { return number_of_halfedges() / 3; }
  int number_of_halfedges() const { return static_cast<int>(m_origins.size()); }

  static int next(int h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static int previous(int h) { return h % 3 == 0 ? h + 2 : h - 1; }

  int origin(int h) const { return m_origins[static_cast<std::size_t>(h)]; }
  int target(int h) const { return origin(next(h)); }
  int twin(int h) const { return m_twins[static_cast<std::size_t>(h)]; }
  double length(int h) const { return m_lengths[static_cast<std::size_t>(h)]; }
  bool is_border(int h) const { return twin(h) < 0; }

  // one halfedge represents each edge
  bool is_edge_representative(int h) const { return twin(h) < h; }

  // Kahan's ordering of Heron's formula. The slack of the triangle inequality is kept positive, so
  // that the area is positive for positive lengths, regardless of rounding.
  double twice_area(int f) const
  {
    std::array<double, 3> s = {length(3 * f), length(3 * f + 1), length(3 * f + 2)};
    std::sort(s.begin(), s.end());
    const double slack
      = (std::max)(s[0] - (s[2] - s[1]), std::numeric_limits<double>::epsilon() * s[0]);
    const double p = (s[2] + (s[1] + s[0])) * slack;
    const double q = (s[0] + (s[2] - s[1])) * (s[2] + (s[1] - s[0]));
    return 0.5 * std::sqrt(p) * std::sqrt(q);
  }

  // cotangent of the angle of the face of `h` opposite to `h`
  double opposite_cotangent(int h) const
  {
    const double a = length(h);
    double b = length(next(h)), c = length(previous(h));
    if(b < c)
      std::swap(b, c);
    return (c * c + (b - a) * (b + a)) / (2 * twice_area(h / 3));
  }

  // sum of the cotangents of the angles opposite to the edge; only one at the border
  double cotangent_sum(int h) const
  {
    return opposite_cotangent(h) + (is_border(h) ? 0. : opposite_cotangent(twin(h)));
  }

  // The position of the third corner of the face of `h` if `h` runs from (0,0) to (length(h),0).
  std::pair<double, double> apex(int h) const
  {
    const double a = length(h), b = length(next(h)), c = length(previous(h));
    return {0.5 * (a + ((c - b) / a) * (c + b)), twice_area(h / 3) / a};
  }

  // An edge is locally Delaunay if the sum of its opposite angles is at most pi, that is, if its
  // cotangent sum is nonnegative. The tolerance keeps cocircular pairs from flipping back and
  // forth.
  bool is_locally_delaunay(int h) const
  {
    if(is_border(h) || twin(h) / 3 == h / 3)
      return true;
    const double u = opposite_cotangent(h), v = opposite_cotangent(twin(h));
    return u + v >= -DELAUNAY_TOLERANCE * (1 + std::abs(u) + std::abs(v));
  }

  // Adds the same number to the lengths of all edges of a component, the smallest one such that all
  // its faces satisfy the triangle inequality with slack `relative_slack` times the mean edge
  // length of the component (Sharp & Crane 2020). Components without nearly degenerate faces do not
  // change. Returns the number of modified components.
  int mollify(const std::vector<int>& component_of_vertex, int number_of_components,
              double relative_slack = MOLLIFICATION_SLACK)
  {
    auto means = mean_edge_lengths(component_of_vertex, number_of_components);
    // a component whose points all coincide has no length scale
    std::replace(means.begin(), means.end(), 0., 1.);
    std::vector<double> missing(means.size(), 0.);
    for(int h = 0; h < number_of_halfedges(); ++h)
    {
      const auto c = component(component_of_vertex, h);
      const double slack = length(next(h)) + length(previous(h)) - length(h);
      missing[c] = (std::max)(missing[c], relative_slack * means[c] - slack);
    }
    for(int h = 0; h < number_of_halfedges(); ++h)
      m_lengths[static_cast<std::size_t>(h)] += missing[component(component_of_vertex, h)];
    return static_cast<int>(
      std::count_if(missing.begin(), missing.end(), [](double d) { return d > 0; }));
  }

  // Mean over the edges, one number per component; 0 for a component without edges.
  std::vector<double> mean_edge_lengths(const std::vector<int>& component_of_vertex,
                                        int number_of_components) const
  {
    std::vector<double> sums(static_cast<std::size_t>(number_of_components), 0.);
    std::vector<double> counts(sums.size(), 0.);
    for(int h = 0; h < number_of_halfedges(); ++h)
      if(is_edge_representative(h))
      {
        const auto c = component(component_of_vertex, h);
        sums[c] += length(h);
        counts[c] += 1;
      }
    for(std::size_t c = 0; c < sums.size(); ++c)
      if(counts[c] > 0)
        sums[c] /= counts[c];
    return sums;
  }

  // Flips edges until all are locally Delaunay (Bobenko & Springborn 2007; Fisher et al. 2007) and
  // returns the number of flips. The number is finite in exact arithmetic; since rounding may undo
  // a flip between nearly cocircular faces of very different sizes, it is also bounded, far above
  // the number required by any mesh. The triangulation is valid whenever the loop stops.
  std::size_t flip_to_delaunay()
  {
    const std::size_t bound = 10000 + 100 * m_origins.size();
    std::deque<int> queue;
    for(int h = 0; h < number_of_halfedges(); ++h)
      if(is_edge_representative(h) && !is_border(h))
        queue.push_back(h);
    std::size_t flips = 0;
    while(!queue.empty() && flips < bound)
    {
      const int h = queue.front();
      queue.pop_front();
      if(is_locally_delaunay(h))
        continue;
      const int t = twin(h);
      flip(h);
      ++flips;
      for(int side : {next(h), previous(h), next(t), previous(t)})
        queue.push_back(side);
    }
    return flips;
  }

  // Replaces the edge of `h` by the other diagonal of its two faces, unfolded into the plane.
  // \pre The edge has two different faces, whose union is strictly convex at the ends of the edge:
  // this holds for every edge that is not locally Delaunay.
  void flip(int h)
  {
    const int t = twin(h);
    CGAL_precondition(t >= 0 && t / 3 != h / 3);
    const auto [x_above, y_above] = apex(h);
    const auto [x_below, y_below] = apex(t);
    const double diagonal = std::hypot(x_above - (length(h) - x_below), y_above + y_below);
    const std::array<int, 4> from = {previous(t), next(h), previous(h), next(t)};
    const std::array<int, 4> to = {next(h), previous(h), next(t), previous(t)};
    const int above = origin(previous(h)), below = origin(previous(t));
    move_halfedges(from, to);
    set(h, above, t, diagonal);
    set(t, below, h, diagonal);
  }

  // Total area, the sum of one positive number per face.
  double area() const
  {
    double sum = 0;
    for(int f = 0; f < number_of_faces(); ++f)
      sum += 0.5 * twice_area(f);
    return sum;
  }

private:
  static constexpr double DELAUNAY_TOLERANCE = 1e-11;
  static constexpr double MOLLIFICATION_SLACK = 1e-10;

  std::size_t component(const std::vector<int>& component_of_vertex, int h) const
  {
    return static_cast<std::size_t>(component_of_vertex[static_cast<std::size_t>(origin(h))]);
  }

  void set(int h, int origin_of_h, int twin_of_h, double length_of_h)
  {
    m_origins[static_cast<std::size_t>(h)] = origin_of_h;
    m_twins[static_cast<std::size_t>(h)] = twin_of_h;
    m_lengths[static_cast<std::size_t>(h)] = length_of_h;
  }

  // Moves all four at once, since they may be twins of each other.
  void move_halfedges(const std::array<int, 4>& from, const std::array<int, 4>& to)
  {
    const auto moved = [&](int h) {
      const auto it = std::find(from.begin(), from.end(), h);
      return it == from.end() ? h : to[static_cast<std::size_t>(it - from.begin())];
    };
    std::array<int, 4> origins, twins;
    std::array<double, 4> lengths;
    for(std::size_t i = 0; i < 4; ++i)
    {
      origins[i] = origin(from[i]);
      twins[i] = moved(twin(from[i]));
      lengths[i] = length(from[i]);
    }
    for(std::size_t i = 0; i < 4; ++i)
      set(to[i], origins[i], twins[i], lengths[i]);
    for(std::size_t i = 0; i < 4; ++i)
      if(twins[i] >= 0)
        m_twins[static_cast<std::size_t>(twins[i])] = to[i];
  }

  std::size_t m_number_of_vertices = 0;
  std::vector<int> m_origins;
  std::vector<int> m_twins;
  std::vector<double> m_lengths;
};

// The corners of the faces of a mesh as rows of the vertices, three per face, and the twins.
struct Face_corners
{
  std::vector<int> origins;
  std::vector<int> twins;
};

// Every face starts at its vertex with the smallest row, so that meshes that differ only in the
// halfedge stored with a face, such as a mesh and its copy of another type, yield the same bytes.
// `vertex_rows`: readable property map from vertices to rows.
template <class TriangleMesh, class VertexRowMap>
Face_corners face_corners(const TriangleMesh& tmesh, const VertexRowMap& vertex_rows)
{
  using halfedge_descriptor = typename boost::graph_traits<TriangleMesh>::halfedge_descriptor;
  std::vector<halfedge_descriptor> sides;
  Face_corners corners;
  for(auto f : faces(tmesh))
  {
    halfedge_descriptor h = halfedge(f, tmesh);
    if(next(next(next(h, tmesh), tmesh), tmesh) != h || next(h, tmesh) == h)
      throw std::invalid_argument("face " + std::to_string(sides.size() / 3)
                                  + " is not a triangle");
    const auto row
      = [&](halfedge_descriptor g) { return static_cast<int>(get(vertex_rows, source(g, tmesh))); };
    const halfedge_descriptor n = next(h, tmesh), p = prev(h, tmesh);
    if(row(n) < row(h) && row(n) <= row(p))
      h = n;
    else if(row(p) < row(h) && row(p) < row(n))
      h = p;
    for(int i = 0; i < 3; ++i, h = next(h, tmesh))
    {
      sides.push_back(h);
      corners.origins.push_back(row(h));
    }
  }
  auto numbers = halfedge_number_map(tmesh, 0);
  for(const halfedge_descriptor h : sides)
    put(numbers, opposite(h, tmesh), sides.size()); // if it has no face
  for(std::size_t i = 0; i < sides.size(); ++i)
    put(numbers, sides[i], i);
  for(const halfedge_descriptor h : sides)
  {
    const std::size_t twin = get(numbers, opposite(h, tmesh));
    corners.twins.push_back(twin == sides.size() ? -1 : static_cast<int>(twin));
  }
  return corners;
}

// Lengths of the halfedges; those of twins are bitwise equal.
inline std::vector<double> side_lengths(const Face_corners& corners, const Point_matrix& points)
{
  std::vector<double> lengths(corners.origins.size());
  for(int h = 0; h < static_cast<int>(lengths.size()); ++h)
  {
    const int t = corners.twins[static_cast<std::size_t>(h)];
    const int n = Intrinsic_triangulation::next(h);
    const Eigen::Vector3d side = points.row(corners.origins[static_cast<std::size_t>(n)])
                                 - points.row(corners.origins[static_cast<std::size_t>(h)]);
    lengths[static_cast<std::size_t>(h)] = t >= 0 && t < h ? lengths[static_cast<std::size_t>(t)]
                                                           : std::hypot(side[0], side[1], side[2]);
  }
  return lengths;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_INTRINSIC_INTRINSIC_TRIANGULATION_H
