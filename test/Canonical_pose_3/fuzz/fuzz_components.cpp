// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A soup of many small pieces, next to each other, inside each other or with common vertices, is passed
// to repair and the one call.

#include "Byte_source.h"
#include "checks.h"
#include "poses.h"
#include "shapes.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace Canonical_pose_fuzz;

namespace {

Canonical_pose_test::Triangle_soup piece(Byte_source& bytes)
{
  using namespace Canonical_pose_test;
  switch(bytes.below(8))
  {
  case 0:
    return {{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{{0, 1, 2}}}};
  case 1: // twice the same
    return {{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}}, {{{0, 1, 2}}, {{0, 2, 1}}}};
  case 2: // no area, or nearly
    return {{{{0, 0, 0}}, {{1, 0, 0}}, {{2, 0, bytes.below(2) * 1e-9}}}, {{{0, 1, 2}}}};
  case 3:
    return icosphere_soup(0, 1);
  case 4:
    return plane_grid_soup(2, 2, 1, 1);
  case 5:
    return tube_soup(4, 3, 3, 0.3);
  case 6:
    return boundary(tetrahedral_box(1, 1, 1));
  default:
    return boundary({{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, {{{0, 1, 2, 3}}}});
  }
}

struct Soup
{
  std::vector<std::array<double, 3>> points;
  Polygons polygons;

  explicit Soup(Byte_source& bytes)
  {
    for(std::size_t n = 1 + bytes.below(40); n > 0; --n)
      append(bytes);
  }

  void append(Byte_source& bytes)
  {
    const auto soup = piece(bytes);
    const double scale = std::array<double, 4>{{1, 0.3, 0.05, 1e-4}}[bytes.below(4)];
    std::array<double, 3> shift;
    for(double& x : shift)
      x = double(bytes.below(32)) / 4;
    const std::size_t n = points.size();
    for(const auto& p : soup.points)
      points.push_back(
        {{scale * p[0] + shift[0], scale * p[1] + shift[1], scale * p[2] + shift[2]}});
    for(const auto& t : soup.triangles)
      polygons.push_back({t[0] + n, t[1] + n, t[2] + n});
    if(n > 0 && bytes.below(4) == 0) // a common vertex
      polygons.back()[0] = bytes.below(n);
  }
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  Byte_source bytes(data, size);
  Options options = read_options(bytes, 100);
  if(bytes.below(2) == 0)
    options.constraints = {};
  options.return_landmark_fields = bytes.below(2) == 0;
  options.frame = Options::Frame(bytes.below(2));
  const Soup soup(bytes);
  check_surface(to_matrix(soup.points), soup.polygons);
  const Result result = checked_pose(soup.points, soup.polygons, options);
  if(!result.is_usable())
    return 0;
  require(result.target->rows() == Eigen::Index(soup.points.size()), "each vertex has a target");
  options.given = result;
  options.number_of_rounds = 0;
  require(checked_pose(soup.points, soup.polygons, options).is_usable(),
          "a result can be given again");
  return 0;
}
