// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// A procedural shape, modified by the bytes, is passed to repair and the one call.

#include "Mutated_soup.h"
#include "checks.h"

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace Canonical_pose_fuzz;
using CGAL::Canonical_pose_3::Options;

namespace {

using Point_3 = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

template <std::size_t n>
double one_of(const std::array<double, n>& numbers, Byte_source& bytes)
{
  return numbers[bytes.below(n)];
}

// Few landmarks, large cells and few iterations: the sanitizers are slow.
Options read_options(Byte_source& bytes, const std::size_t number_of_points)
{
  Options options;
  options.body = Options::Body(bytes.below(4));
  options.components = Options::Components(bytes.below(3));
  options.kernel = Options::Kernel(bytes.below(3));
  options.geodesics = Options::Geodesics(bytes.below(3));
  options.solver = Options::Solver(bytes.below(3));
  options.number_of_landmarks = bytes.below(7);
  options.lattice_spacing = one_of<8>({{0.1, 0.1, 0.2, 0.2, 0.5, 0, 1e-9, -1}}, bytes);
  options.number_of_threads = 1;
  options.registration.number_of_iterations = int(bytes.below(3));
  options.registration.detail_length = one_of<6>({{0.1, 0.1, 0.1, 1e-6, 1e6, 0}}, bytes);
  options.registration.tikhonov = one_of<4>({{0, 0, 10, -1}}, bytes);
  options.registration.fairing_passes = int(bytes.below(2));
  // By default, all inverted cells are untangled. Half of the cells of an unconverged pose may be:
  // this takes minutes in a lattice of usual size.
  options.registration.injective = bytes.below(2) == 1 && options.lattice_spacing != 0;
  const auto vertex = [&] { return bytes.below(number_of_points + 1); };
  const auto length = [&] { return one_of<4>({{0, 0.1, 10, 1e300}}, bytes); };
  const auto vector = [&] { return Eigen::RowVector3d(length(), length(), length()); };
  const auto stiffness = [&] { return one_of<4>({{1, 0, 1e6, -1}}, bytes); };
  for(std::size_t i = bytes.below(4); i > 0; --i)
    switch(bytes.below(4))
    {
    case 0:
      options.constraints.springs.push_back({vertex(), vertex(), length(), stiffness()});
      break;
    case 1:
      options.constraints.directions.push_back({vertex(), vertex(), vector(), stiffness()});
      break;
    case 2:
      options.constraints.handles.push_back({vertex(), vector(), stiffness()});
      break;
    default:
      options.constraints.symmetric_pairs.push_back({vertex(), vertex(), stiffness()});
    }
  options.number_of_rounds = int(bytes.below(3));
  options.number_of_coarse_vertices = 20 * bytes.below(3);
  return options;
}

void check_pose(const Mutated_soup& soup, const Options& options)
{
  std::vector<Point_3> points, pose;
  for(const auto& p : soup.points)
    points.emplace_back(p[0], p[1], p[2]);
  is_accepted([&] {
    const auto summary = CGAL::canonical_pose_3(points, soup.polygons, pose, options).summary;
    if(!summary.is_usable())
      return;
    require(!options.registration.is_injective() || summary.inverted == 0
              || !summary.warnings.empty(),
            "no cell is inverted in injective mode, or there is a warning");
    require(pose.size() == points.size(), "each vertex has a pose");
    for(const Point_3& p : pose)
      require(std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z()),
              "a usable pose is finite");
  });
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  Byte_source bytes(data, size);
  const Mutated_soup soup(bytes);
  Point_matrix points(Eigen::Index(soup.points.size()), 3);
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    points.row(Eigen::Index(v)) << soup.points[v][0], soup.points[v][1], soup.points[v][2];
  check_surface(points, soup.polygons);
  check_pose(soup, read_options(bytes, soup.points.size()));
  return 0;
}
