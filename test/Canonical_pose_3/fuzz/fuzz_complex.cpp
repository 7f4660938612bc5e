// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A tetrahedral complex that the bytes pinch, split, flatten and take apart is passed to the one call,
// and its result to a second one.

#include "Byte_source.h"
#include "poses.h"
#include "shapes.h"

#include <CGAL/Canonical_pose_3/Indexed_tetrahedra_3.h>
#include <CGAL/Canonical_pose_3/extract_boundary.h>

#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

using namespace Canonical_pose_fuzz;
using Canonical_pose_test::Tetrahedral_soup;

namespace {

using Complex = CGAL::Canonical_pose_3::Indexed_tetrahedra_3<Point_3>;
using Mesh = CGAL::Surface_mesh<Point_3>;

void append(const Tetrahedral_soup& part, const double shift, Tetrahedral_soup& soup)
{
  const std::size_t n = soup.points.size();
  for(const auto& p : part.points)
    soup.points.push_back({{p[0], p[1] + shift, p[2]}});
  for(const auto& c : part.cells)
    soup.cells.push_back({{c[0] + n, c[1] + n, c[2] + n, c[3] + n}});
}

Tetrahedral_soup part(Byte_source& bytes)
{
  using namespace Canonical_pose_test;
  switch(bytes.below(4))
  {
  case 0:
    return {{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, {{{0, 1, 2, 3}}}};
  case 1:
    return tetrahedral_box(1, 1, 1);
  case 2:
    return tetrahedral_bent_bar(5, 1, 1, 1.5);
  default:
    return tetrahedral_box(10, 1, 1, {{10., 1., 1.}});
  }
}

void mutate(Byte_source& bytes, Tetrahedral_soup& soup)
{
  constexpr std::size_t most_vertices = 120;
  const std::size_t v = bytes.below(soup.points.size()), w = bytes.below(soup.points.size());
  const std::size_t t = bytes.below(soup.cells.size()), k = bytes.below(4);
  const auto small = [&] { return (bytes.byte() - 127.5) / 64; };
  switch(bytes.below(11))
  {
  case 0: // a cell with 1 to 4 vertices of the complex
    soup.cells.push_back({{v, v, v, v}});
    for(std::size_t i = 1; i < 4; ++i)
      if(i < k)
        soup.cells.back()[i] = bytes.below(soup.points.size());
      else
      {
        soup.cells.back()[i] = soup.points.size();
        soup.points.push_back({{soup.points[v][0] + small(), soup.points[v][1] + small(),
                                soup.points[v][2] + small()}});
      }
    break;
  case 1: // pinched
    for(auto& c : soup.cells)
      std::replace(c.begin(), c.end(), v, w);
    break;
  case 2:
    if(soup.points.size() < most_vertices)
      append(part(bytes), 4 * small(), soup);
    break;
  case 3:
    if(soup.cells.size() > 1)
      soup.cells.erase(soup.cells.begin() + std::ptrdiff_t(t));
    break;
  case 4:
    soup.cells.push_back(std::array<std::size_t, 4>(soup.cells[t]));
    break;
  case 5:
    std::swap(soup.cells[t][0], soup.cells[t][1]);
    break;
  case 6: // flat, or nearly
    soup.points[v] = soup.points[w];
    soup.points[v][k % 3] += bytes.below(2) == 0 ? 0 : small() * 1e-6;
    break;
  case 7:
    soup.cells[t][k] = v;
    break;
  case 8:
    soup.points[v][k % 3] += small();
    break;
  case 9:
    soup.points[v][k % 3] = bytes.special_number();
    break;
  default:
    soup.points.push_back(soup.points[v]);
  }
}

Complex mutated_complex(Byte_source& bytes)
{
  Tetrahedral_soup soup = part(bytes);
  for(std::size_t n = bytes.below(20); n > 0; --n)
    mutate(bytes, soup);
  Complex complex;
  complex.points = to_points(soup.points);
  complex.cells = soup.cells;
  return complex;
}

Result checked_pose(const Complex& complex, const Options& options)
{
  Result result;
  std::vector<Point_3> pose(complex.points.size());
  is_accepted(
    [&] { result = CGAL::canonical_pose_3(complex, CGAL::make_property_map(pose), options); });
  check_result(result, options, complex.points.size());
  return result;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  Byte_source bytes(data, size);
  const Complex complex = mutated_complex(bytes);
  Options options = read_options(bytes, complex.points.size());
  options.return_landmark_fields = bytes.below(2) == 0;
  options.frame = Options::Frame(bytes.below(2));
  const Result result = checked_pose(complex, options);
  if(!result.is_usable())
    return 0;
  Mesh boundary;
  std::map<Mesh::Vertex_index, std::size_t> origins;
  CGAL::Canonical_pose_3::extract_boundary(complex, boundary,
                                           boost::make_assoc_property_map(origins));
  require(result.target->rows() == Eigen::Index(num_vertices(boundary)),
          "there is a target for each vertex of the boundary");
  options.given = result;
  options.number_of_rounds = 0;
  options.frame = Options::Frame(bytes.below(2));
  const Result again = checked_pose(complex, options);
  require(again.is_usable(), "a result can be given again");
  require(*again.target == *result.target, "a given target remains");
  return 0;
}
