// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include "Mesh_file.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <ios>
#include <locale>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

#ifdef __cpp_lib_to_chars // not in all libraries of C++17
// Writes numbers with the fewest digits from which the same numbers are read, and in a fraction of
// the time of 17 digits.
class Shortest_numbers : public std::num_put<char>
{
  iter_type do_put(iter_type out, std::ios_base&, char_type, const double x) const override
  {
    std::array<char, 32> text;
    return std::copy(text.data(), std::to_chars(text.data(), text.data() + text.size(), x).ptr,
                     out);
  }
};
#endif

void use_shortest_numbers(std::ostream& out)
{
  out.precision(17);
#ifdef __cpp_lib_to_chars
  out.imbue(std::locale(out.getloc(), new Shortest_numbers));
#endif
}

// Hues by the golden ratio, so that successive parts differ clearly; brighter and darker by turns.
std::array<int, 3> color_of_part(const std::size_t part)
{
  const double hue = std::fmod(static_cast<double>(part) * 0.618033988749895, 1.);
  const double value = part % 2 == 0 ? 230 : 170;
  constexpr double phases[] = {0, 4, 2};
  std::array<int, 3> color;
  for(std::size_t k = 0; k < 3; ++k)
  {
    const double distance = std::abs(std::fmod(6 * hue + phases[k], 6.) - 3) - 1;
    const double saturated = (std::min)((std::max)(distance, 0.), 1.);
    color[k] = static_cast<int>(value * (.25 + .75 * saturated));
  }
  return color;
}

void write_medit(std::ostream& out, const Mesh_file& mesh)
{
  out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.points.size() << '\n';
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    for(const double x : mesh.points[v])
      out << x << ' ';
    out << mesh.point_references[v] << '\n';
  }
  out << "Tetrahedra\n" << mesh.cells.size() << '\n';
  for(std::size_t c = 0; c < mesh.cells.size(); ++c)
  {
    for(const std::size_t v : mesh.cells[c])
      out << v + 1 << ' ';
    out << mesh.cell_references[c] << '\n';
  }
  out << "End\n";
}

} // namespace

void check_format_holds(const Format format, const Mesh_file& mesh)
{
  const std::size_t most_corners_of_ply = 255; // CGAL writes their number as a byte
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const std::size_t corners = mesh.faces[f].size();
    const std::string defect
      = ", but face " + std::to_string(f) + " has " + std::to_string(corners) + " corners";
    if(format == Format::STL && corners != 3)
      throw std::invalid_argument("STL holds triangles only" + defect);
    if(format == Format::PLY && corners > most_corners_of_ply)
      throw std::invalid_argument("PLY holds faces of at most "
                                  + std::to_string(most_corners_of_ply) + " corners" + defect);
  }
}

void write_colored_ply(std::ostream& out, const Mesh_file& mesh,
                       const std::vector<std::size_t>& part_of_face)
{
  check_format_holds(Format::PLY, mesh);
  use_shortest_numbers(out);
  out << "ply\nformat ascii 1.0\nelement vertex " << mesh.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.faces.size()
      << "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green"
         "\nproperty uchar blue\nproperty int part\nend_header\n";
  for(const std::array<double, 3>& p : mesh.points)
    out << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    out << mesh.faces[f].size();
    for(const std::size_t v : mesh.faces[f])
      out << ' ' << v;
    for(const int c : color_of_part(part_of_face[f]))
      out << ' ' << c;
    out << ' ' << part_of_face[f] << '\n';
  }
}

void write_mesh(std::ostream& out, const Format format, const Mesh_file& mesh)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  use_shortest_numbers(out);
  if(format == Format::MEDIT)
    return write_medit(out, mesh);
  std::vector<Point> points;
  for(const std::array<double, 3>& p : mesh.points)
    points.emplace_back(p[0], p[1], p[2]);
  const auto precision = CGAL::parameters::stream_precision(17);
  switch(format)
  {
  case Format::OBJ:
    CGAL::IO::write_OBJ(out, points, mesh.faces, precision);
    break;
  case Format::PLY:
    CGAL::IO::write_PLY(out, points, mesh.faces, precision);
    break;
  case Format::STL:
    CGAL::IO::write_STL(out, points, mesh.faces, precision);
    break;
  default:
    CGAL::IO::write_OFF(out, points, mesh.faces, precision);
  }
}

} // namespace Canonical_pose_tool
