// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SURFACE_SELF_INTERSECTIONS_H
#define CANONICAL_POSE_3_ENGINE_SURFACE_SELF_INTERSECTIONS_H

#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/surface/Triangle_soup.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/box_intersection_d.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Searches triangles, manifold or not, for pairs that intersect outside their common vertices.
// Polygon_mesh_processing::triangle_soup_self_intersections() of CGAL 6.1 finds the same pairs in 0.7
// (curved surfaces) to 2.2 times (planar ones) the time on one thread, but takes longer on two, and
// cannot be stopped where countless bounding boxes overlap.
class Self_intersections
{
public:
  using Face_pair = std::pair<std::size_t, std::size_t>;

  // There must be no degenerate triangles.
  Self_intersections(const Point_matrix& points, const Triangle_soup& soup) : m_soup(soup)
  {
    m_triangles.reserve(soup.triangles.size());
    for(const Index_triangle& t : soup.triangles)
      m_triangles.emplace_back(point(points, t[0]), point(points, t[1]), point(points, t[2]));
  }

  // Returns sorted pairs of faces, the smaller one first, at most `maximum`. Returns nothing if
  // more than `maximum_of_overlaps` bounding boxes, and more than 200 per face, overlap before the
  // first pair is found.
  std::optional<std::vector<Face_pair>> run(const std::size_t maximum,
                                            const std::size_t maximum_of_overlaps = 10000000)
  {
    sort_boxes();
    m_maximum_of_pairs = maximum;
    m_maximum_of_overlaps = maximum_of_overlaps + 200 * m_triangles.size();
    std::vector<std::vector<Face_pair>> blocks(number_of_blocks(m_boxes.size(), BOXES_PER_BLOCK));
    const auto search = [&](const std::size_t block, const std::size_t begin,
                            const std::size_t end) { search_block(begin, end, blocks[block]); };
    const bool is_complete
      = search_all([&] { for_each_block(m_boxes.size(), search, BOXES_PER_BLOCK); });
    if(!is_complete && blocks.size() > 1) // in order, independently of threads
    {
      blocks.assign(blocks.size(), {});
      search_all([&] {
        for(std::size_t b = 0; b < blocks.size(); ++b)
          search(b, b * BOXES_PER_BLOCK, (std::min)(m_boxes.size(), (b + 1) * BOXES_PER_BLOCK));
      });
    }
    std::vector<Face_pair> pairs;
    for(const std::vector<Face_pair>& block : blocks)
      pairs.insert(pairs.end(), block.begin(), block.end());
    if(!is_complete && pairs.empty())
      return std::nullopt;
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

private:
  using Kernel = Indexed_mesh_kernel;
  using Box = Box_intersection_d::Box_with_info_d<double, 3, std::size_t,
                                                  Box_intersection_d::ID_FROM_BOX_ADDRESS>;
  struct Enough
  {};
  static constexpr std::size_t BOXES_PER_BLOCK = 16384, OVERLAPS_AT_A_TIME = 1024;

  // By lower ends along the axis along which the boxes are shortest relative to the whole.
  void sort_boxes()
  {
    m_boxes.clear();
    m_boxes.reserve(m_triangles.size());
    for(std::size_t t = 0; t < m_triangles.size(); ++t)
      m_boxes.emplace_back(m_triangles[t].bbox(), t);
    constexpr double infinity = (std::numeric_limits<double>::infinity)();
    double least = infinity;
    for(int k = 0; k < 3; ++k)
    {
      double sum = 0, low = infinity, high = -infinity;
      for(const Box& box : m_boxes)
      {
        sum += box.max_coord(k) - box.min_coord(k);
        low = (std::min)(low, box.min_coord(k));
        high = (std::max)(high, box.max_coord(k));
      }
      if(sum / (high - low) < least) // false if flat along this axis
      {
        least = sum / (high - low);
        m_axis = k;
      }
    }
    std::sort(m_boxes.begin(), m_boxes.end(), [this](const Box& a, const Box& b) {
      return std::make_pair(a.min_coord(m_axis), a.info())
             < std::make_pair(b.min_coord(m_axis), b.info());
    });
  }

  // Returns whether the search was completed before the maximum number of pairs or overlaps was
  // reached. This does not depend on the order.
  template <class Function>
  bool search_all(const Function& search)
  {
    m_number_of_pairs = m_number_of_overlaps = 0;
    try
    {
      search();
      return true;
    }
    catch(const Enough&)
    {
      return false;
    }
  }

  // The boxes of a block with each other, and with those of earlier blocks that reach into it.
  void search_block(const std::size_t begin, const std::size_t end, std::vector<Face_pair>& pairs)
  {
    std::vector<const Box*> own, before; // boxes are identified by their addresses
    for(std::size_t i = begin; i < end; ++i)
      own.push_back(&m_boxes[i]);
    for(std::size_t i = 0; i < begin; ++i)
      if(m_boxes[i].max_coord(m_axis) >= m_boxes[begin].min_coord(m_axis))
        before.push_back(&m_boxes[i]);
    std::size_t overlaps = 0;
    const auto visit = [&](const Box* a, const Box* b) {
      const std::size_t f = m_soup.face_of_triangle[a->info()],
                        g = m_soup.face_of_triangle[b->info()];
      if(f != g && do_intersect(a->info(), b->info()))
      {
        pairs.push_back(std::minmax({f, g}));
        if(++m_number_of_pairs >= m_maximum_of_pairs)
          throw Enough();
      }
      if(++overlaps % OVERLAPS_AT_A_TIME == 0
         && (m_number_of_overlaps += OVERLAPS_AT_A_TIME) >= m_maximum_of_overlaps)
        throw Enough();
    };
    box_intersection_d(own.begin(), own.end(), before.begin(), before.end(), visit);
    box_self_intersection_d(own.begin(), own.end(), visit);
  }

  static Kernel::Point_3 point(const Point_matrix& points, const std::size_t v)
  {
    const auto p = points.row(static_cast<Eigen::Index>(v));
    return Kernel::Point_3(p[0], p[1], p[2]);
  }

  bool do_intersect(const std::size_t s, const std::size_t t) const
  {
    const Kernel::Triangle_3 &a = m_triangles[s], &b = m_triangles[t];
    std::array<int, 3> i = {0, 1, 2}, j = {0, 1, 2}; // corners, shared ones first
    const int shared = put_shared_corners_first(m_soup.triangles[s], m_soup.triangles[t], i, j);
    if(are_surely_apart(a, b, i, j, shared))
      return false;
    switch(shared)
    {
    case 0:
      return CGAL::do_intersect(a, b);
    case 1:
      return CGAL::do_intersect(a, Kernel::Segment_3(b[j[1]], b[j[2]]))
             || CGAL::do_intersect(b, Kernel::Segment_3(a[i[1]], a[i[2]]));
    case 2: // folded onto each other
      return CGAL::coplanar(a[i[0]], a[i[1]], a[i[2]], b[j[2]])
             && CGAL::coplanar_orientation(a[i[0]], a[i[1]], a[i[2]], b[j[2]]) == CGAL::POSITIVE;
    default:
      return false;
    }
  }

  // Most neighbors are nearly coplanar, and exact tests then take long. If true, they are separate
  // with a margin far larger than rounding errors; if false, nothing is known.
  static bool are_surely_apart(const Kernel::Triangle_3& a, const Kernel::Triangle_3& b,
                               const std::array<int, 3>& i, const std::array<int, 3>& j,
                               const int shared)
  {
    const auto unit
      = [](const Kernel::Point_3& from, const Kernel::Point_3& to) -> Eigen::Vector3d {
      return Eigen::Vector3d(to.x() - from.x(), to.y() - from.y(), to.z() - from.z()).normalized();
    };
    if(shared == 2) // the third corners on opposite sides of the edge
    {
      const Eigen::Vector3d edge = unit(a[i[0]], a[i[1]]);
      return edge.cross(unit(a[i[0]], a[i[2]])).dot(edge.cross(unit(a[i[0]], b[j[2]]))) < -1e-10;
    }
    // a direction along which all of b is beyond all of a, except for the shared corner
    std::array<Eigen::Vector3d, 9> ways;
    std::size_t n = 0;
    if(shared == 1)
      for(int k = 1; k < 3; ++k)
      {
        ways[n++] = unit(a[i[k]], a[i[0]]);
        ways[n++] = unit(b[j[0]], b[j[k]]);
      }
    else
      for(int k = 0; k < 3; ++k)
        for(int l = 0; l < 3; ++l)
          ways[n++] = unit(a[k], b[l]);
    Eigen::Vector3d direction = std::accumulate(ways.begin() + 1, ways.begin() + n, ways[0]);
    for(int step = 0; step < 8; ++step) // of a perceptron
    {
      std::size_t worst = 0;
      for(std::size_t k = 1; k < n; ++k)
        if(ways[k].dot(direction) < ways[worst].dot(direction))
          worst = k;
      if(ways[worst].dot(direction) > 1e-10 * direction.norm())
        return true;
      direction += ways[worst];
    }
    return false;
  }

  static int put_shared_corners_first(const Index_triangle& s, const Index_triangle& t,
                                      std::array<int, 3>& i, std::array<int, 3>& j)
  {
    int shared = 0;
    for(int k = 0; k < 3; ++k)
      for(int l = shared; l < 3; ++l)
        if(s[i[k]] == t[j[l]])
        {
          std::swap(i[shared], i[k]);
          std::swap(j[shared], j[l]);
          ++shared;
          break;
        }
    return shared;
  }

  const Triangle_soup& m_soup;
  std::vector<Kernel::Triangle_3> m_triangles;
  std::vector<Box> m_boxes;
  int m_axis = 0;
  std::size_t m_maximum_of_pairs = 0, m_maximum_of_overlaps = 0;
  std::atomic<std::size_t> m_number_of_pairs{0}, m_number_of_overlaps{0};
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SURFACE_SELF_INTERSECTIONS_H
