// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_LATTICE_SURFACE_CHORDS_H
#define CANONICAL_POSE_3_ENGINE_LATTICE_SURFACE_CHORDS_H

#include "Surface_rays.h"

#include <CGAL/Canonical_pose_3/internal/lattice/Geodesic_bounds.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>

#include <boost/container/small_vector.hpp>
#include <boost/functional/hash.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A surface sample, and the segment from there through the solid, against the normal, to the exit.
struct Chord
{
  std::size_t face;
  Eigen::Vector3d start, end;
  double length;
  std::optional<std::size_t> exit_vertex; // of the face that is hit; none for a cap
};

// A point on a face.
struct Surface_sample
{
  std::size_t face;
  Eigen::Vector3d point;
};

// Samples a face by rows and columns of points at most `step` apart.
template <class Function>
void for_each_sample(const Row_points& points, const Index_triangle& t, const double step,
                     const Function& f)
{
  std::array<Eigen::Vector3d, 3> corner;
  std::array<double, 3> length;
  for(std::size_t k = 0; k < 3; ++k)
    corner[k] = points.row(static_cast<Eigen::Index>(t[k]));
  for(std::size_t k = 0; k < 3; ++k)
    length[k] = (corner[(k + 1) % 3] - corner[k]).norm();
  const std::size_t base
    = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  if(!(length[base] > step))
  {
    f(Eigen::Vector3d((corner[0] + corner[1] + corner[2]) / 3));
    return;
  }
  const Eigen::Vector3d &a = corner[base], &b = corner[(base + 1) % 3], &c = corner[(base + 2) % 3];
  const double height = (b - a).cross(c - a).norm() / length[base];
  const int rows = static_cast<int>(height / step) + 1;
  for(int i = 0; i < rows; ++i)
  {
    const double s = (i + 0.5) / rows;
    const int columns = static_cast<int>((1 - s) * length[base] / step) + 1;
    for(int j = 0; j < columns; ++j)
    {
      const double r = (j + 0.5) / columns;
      f(Eigen::Vector3d(s * c + (1 - s) * ((1 - r) * a + r * b)));
    }
  }
}

// A bound on the number of samples of all faces in addition to one per face.
class Sample_bound
{
public:
  Sample_bound() = default;
  Sample_bound(const Row_points& points, const std::vector<Index_triangle>& triangles)
  {
    for(const Index_triangle& t : triangles)
    {
      const auto point
        = [&](const std::size_t k) { return points.row(static_cast<Eigen::Index>(t[k])); };
      const Eigen::Vector3d a = point(1) - point(0), b = point(2) - point(0);
      m_twice_area += a.cross(b).norm();
      m_longest_edges += (std::max)({a.norm(), b.norm(), (b - a).norm()});
    }
  }

  double operator()(const double step) const
  {
    return m_twice_area / (step * step) + 3 * m_longest_edges / step;
  }

private:
  double m_twice_area = 0, m_longest_edges = 0; // sums over the triangles
};

// Chooses surface samples, about one per cube of the given edge length and per direction of the
// normal (one of six): the one nearest to the center of the cube, so that the choice does not
// depend on the order of the faces.
inline std::vector<Surface_sample> sample_surface(const Row_points& points,
                                                  const std::vector<Index_triangle>& triangles,
                                                  const double side)
{
  constexpr std::size_t faces_per_block = std::size_t(1) << 16;
  using Cube = std::array<int, 4>;                         // and direction
  using Ranked_sample = std::pair<double, Surface_sample>; // by the distance to the center
  using Samples = std::unordered_map<Cube, Ranked_sample, boost::hash<Cube>>;
  const auto add = [](auto& samples, const Cube& cube, const Ranked_sample& sample) {
    const auto [found, is_new] = samples.try_emplace(cube, sample);
    if(!is_new && sample.first < found->second.first)
      found->second = sample;
  };
  const auto add_face = [&](const std::size_t f, Samples& samples) {
    const Index_triangle& t = triangles[f];
    const auto point
      = [&](const std::size_t k) { return points.row(static_cast<Eigen::Index>(t[k])); };
    const Eigen::Vector3d normal = (point(1) - point(0)).cross(point(2) - point(0));
    int axis;
    if(!(normal.cwiseAbs().maxCoeff(&axis) > 0))
      return;
    for_each_sample(points, t, 0.6 * side, [&](const Eigen::Vector3d& p) {
      const Eigen::Vector3d in_cubes = p / side;
      const Eigen::Vector3d cube = in_cubes.array().floor();
      const double distance = (in_cubes - cube - Eigen::Vector3d::Constant(0.5)).squaredNorm();
      add(samples,
          {static_cast<int>(cube[0]), static_cast<int>(cube[1]), static_cast<int>(cube[2]),
           2 * axis + (normal[axis] > 0 ? 1 : 0)},
          {distance, {f, p}});
    });
  };
  std::vector<Samples> blocks(number_of_blocks(triangles.size(), faces_per_block));
  for_each_block(
    triangles.size(),
    [&](const std::size_t block, const std::size_t begin, const std::size_t end) {
      for(std::size_t f = begin; f < end; ++f)
        add_face(f, blocks[block]);
    },
    faces_per_block);
  std::map<Cube, Ranked_sample> sorted;
  for(const Samples& samples : blocks)
    for(const auto& [cube, sample] : samples)
      add(sorted, cube, sample);
  std::vector<Surface_sample> chosen;
  for(const auto& [cube, sample] : sorted)
    chosen.push_back(sample.second);
  return chosen;
}

// Finds where the ray from a sample against the normal leaves the part of the solid bounded by the
// sample. Usually this is the first exit. Where parts of the solid overlap, entries and exits along
// the line of the ray are paired such that they are hardly farther from each other by geodesics
// than along the ray.
class Exit_search
{
public:
  using Hit = Surface_rays::Hit;

  Exit_search(const Surface_rays& rays, const Geodesic_bounds& bounds,
              const std::vector<Index_triangle>& triangles)
    : m_rays(rays), m_bounds(bounds), m_triangles(triangles)
  {}

  std::optional<Hit> operator()(const Surface_sample& sample, const Eigen::Vector3d& inward) const
  {
    std::optional<Hit> exit;
    m_rays.trace(sample.point, inward, sample.face, [&](const Hit& hit) {
      if(hit.is_exit)
        exit = hit;
      return false;
    });
    const Hit start = {0, sample.face, false};
    if(!exit || detour(start, *exit) > PLAUSIBLE_DETOUR)
      exit = exit_of_pair(crossings(sample, inward));
    if(exit && is_impossible(start, *exit))
      exit.reset();
    return exit;
  }

private:
  // Entries and exits on a line, in its direction.
  using Crossings = boost::container::small_vector<Hit, 16>;

  static constexpr double PLAUSIBLE_DETOUR = 1.6;

  // From the sample, and entries before it into parts that it is in, to where the ray leaves all of them.
  Crossings crossings(const Surface_sample& sample, const Eigen::Vector3d& inward) const
  {
    Crossings result = {{0, sample.face, false}};
    int number_of_left_parts = 0;
    m_rays.trace(sample.point, -inward, sample.face, [&](const Hit& hit) {
      if(!hit.is_exit)
        ++number_of_left_parts;
      else if(number_of_left_parts > 0)
        --number_of_left_parts;
      else
        result.push_back({-hit.distance, hit.face, false});
      return true;
    });
    auto depth = static_cast<std::ptrdiff_t>(result.size());
    m_rays.trace(sample.point, inward, sample.face, [&](const Hit& hit) {
      depth += hit.is_exit ? -1 : 1;
      result.push_back(hit);
      return depth > 0;
    });
    return result;
  }

  // The pairs of entries and exits of which that of the sample, the first entry, is sought.
  class Pairing
  {
  public:
    Pairing(const Exit_search& search, const Crossings& crossings)
      : m_search(search), m_crossings(crossings), m_is_open(crossings.size(), false)
    {
      pair_from(0, 0, 0);
    }

    std::size_t exit() const { return m_exit; } // 0: none

  private:
    void pair_from(const std::size_t i, const double cost, const std::size_t exit)
    {
      if(!(cost < m_least_cost))
        return;
      if(i == m_crossings.size())
      {
        if(exit != 0)
        {
          m_least_cost = cost;
          m_exit = exit;
        }
        return;
      }
      if(!m_crossings[i].is_exit)
      {
        m_is_open[i] = true;
        pair_from(i + 1, cost, exit);
        m_is_open[i] = false;
        return;
      }
      for(std::size_t entry = 0; entry < i; ++entry)
        if(m_is_open[entry])
        {
          m_is_open[entry] = false;
          const double detour = m_search.detour(m_crossings[entry], m_crossings[i]);
          pair_from(i + 1, cost + std::log((std::max)(detour / PLAUSIBLE_DETOUR, 1.)),
                    entry == 0 ? i : exit);
          m_is_open[entry] = true;
        }
    }

    const Exit_search& m_search;
    const Crossings& m_crossings;
    boost::container::small_vector<bool, 16> m_is_open;
    double m_least_cost = std::numeric_limits<double>::infinity();
    std::size_t m_exit = 0;
  };

  // The exit that is paired with the sample, the first of the crossings.
  std::optional<Hit> exit_of_pair(const Crossings& crossings) const
  {
    constexpr std::size_t most = 12; // all pairs of more are too many
    std::size_t exit = 0;
    if(crossings.size() <= most)
      exit = Pairing(*this, crossings).exit();
    else
      for(std::size_t i = 0; i < crossings.size(); ++i)
        if(crossings[i].is_exit
           && (exit == 0
               || detour(crossings[0], crossings[i]) < detour(crossings[0], crossings[exit])))
          exit = i;
    return exit == 0 ? std::nullopt : std::make_optional(crossings[exit]);
  }

  // How much farther an exit is by geodesics than along the ray, but for a short distance.
  double detour(const Hit& entry, const Hit& exit) const
  {
    constexpr double least_distance = .00625;
    return distance(entry, exit) / (exit.distance - entry.distance + least_distance);
  }

  // Whether the exit is certainly on another part, as at a contact that was cut, where parts have
  // coincident borders.
  bool is_impossible(const Hit& entry, const Hit& exit) const
  {
    return distance(entry, exit) > PLAUSIBLE_DETOUR * exit.distance + 0.3;
  }

  // A lower bound of the geodesic distance; 0 to a cap.
  double distance(const Hit& entry, const Hit& exit) const
  {
    return entry.face < m_triangles.size() && exit.face < m_triangles.size()
             ? m_bounds(m_triangles[entry.face][0], m_triangles[exit.face][0])
             : 0;
  }

  const Surface_rays& m_rays;
  const Geodesic_bounds& m_bounds;
  const std::vector<Index_triangle>& m_triangles;
};

// Computes the chords of samples. Unit of length: the largest geodesic distance.
class Chord_finder
{
public:
  Chord_finder(const Row_points& points, const std::vector<Index_triangle>& triangles,
               const std::vector<Index_triangle>& caps, const Geodesic_bounds& bounds)
    : m_points(points), m_triangles(triangles), m_closed(closed(triangles, caps)),
      m_rays(points, m_closed), m_search(m_rays, bounds, triangles)
  {}
  Chord_finder(const Chord_finder&) = delete;
  Chord_finder& operator=(const Chord_finder&) = delete;

  // Samples without exit (near a hole without cap) have no chord.
  std::vector<Chord> operator()(const std::vector<Surface_sample>& samples) const
  {
    std::vector<std::vector<Chord>> blocks(number_of_blocks(samples.size()));
    for_each_block(samples.size(),
                   [&](const std::size_t block, const std::size_t begin, const std::size_t end) {
                     for(std::size_t i = begin; i < end; ++i)
                       find(samples[i], blocks[block]);
                   });
    std::vector<Chord> chords;
    for(const std::vector<Chord>& block : blocks)
      chords.insert(chords.end(), block.begin(), block.end());
    return chords;
  }

private:
  static std::vector<Index_triangle> closed(std::vector<Index_triangle> triangles,
                                            const std::vector<Index_triangle>& caps)
  {
    triangles.insert(triangles.end(), caps.begin(), caps.end());
    return triangles;
  }

  void find(const Surface_sample& sample, std::vector<Chord>& chords) const
  {
    const Index_triangle& t = m_triangles[sample.face];
    const auto point
      = [&](const std::size_t k) { return m_points.row(static_cast<Eigen::Index>(t[k])); };
    const Eigen::Vector3d inward
      = -(point(1) - point(0)).cross(point(2) - point(0)).stableNormalized();
    const std::optional<Surface_rays::Hit> exit = m_search(sample, inward);
    if(!exit)
      return;
    Chord chord{sample.face, sample.point, sample.point + exit->distance * inward, exit->distance,
                std::nullopt};
    if(exit->face < m_triangles.size())
      chord.exit_vertex = m_triangles[exit->face][0];
    chords.push_back(chord);
  }

  const Row_points& m_points;
  const std::vector<Index_triangle>& m_triangles;
  const std::vector<Index_triangle> m_closed;
  const Surface_rays m_rays;
  const Exit_search m_search;
};

// Returns every k-th chord, with k such that their total length is bounded.
inline std::vector<Chord> thinned(std::vector<Chord> chords, const double total_length)
{
  double sum = 0;
  for(const Chord& chord : chords)
    sum += chord.length;
  const std::size_t stride = static_cast<std::size_t>(sum / total_length) + 1;
  std::vector<Chord> result;
  for(std::size_t i = 0; i < chords.size(); i += stride)
    result.push_back(chords[i]);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_LATTICE_SURFACE_CHORDS_H
