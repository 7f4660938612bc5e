// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shortest_numbers.h"
#include "Shown_surface.h"

#include <array>
#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

const int VTK_TETRA = 10;

// An array of `tuples` times `components` values; write(tuple) writes those of a tuple.
template <class Function>
void write_array(std::ostream& out, const std::string& type, const std::string& name,
                 const std::size_t tuples, const int components, const Function& write)
{
  out << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
      << components << "\" format=\"ascii\">\n";
  for(std::size_t i = 0; i < tuples; ++i)
  {
    write(i);
    out << '\n';
  }
  out << "</DataArray>\n";
}

void write_label(std::ostream& out, const std::vector<long long>& labels)
{
  write_array(out, "Int64", "label", labels.size(), 1,
              [&](const std::size_t i) { out << labels[i]; });
}

} // namespace

// CGAL's writer takes complexes of Mesh_3 only, and VTK's would bring all of VTK.
void write_vtu(std::ostream& out, const Mesh_file& mesh, const std::vector<Vertex_values>& values)
{
  const std::size_t points = mesh.points.size(), cells = mesh.cells.size();
  use_shortest_numbers(out);
  out << "<?xml version=\"1.0\"?>\n"
         "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
         "<UnstructuredGrid>\n<Piece NumberOfPoints=\""
      << points << "\" NumberOfCells=\"" << cells << "\">\n<Points>\n";
  write_array(out, "Float64", "Points", points, 3, [&](const std::size_t v) {
    const std::array<double, 3>& p = mesh.points[v];
    out << p[0] << ' ' << p[1] << ' ' << p[2];
  });
  out << "</Points>\n<Cells>\n";
  write_array(out, "Int64", "connectivity", cells, 1, [&](const std::size_t c) {
    const std::array<std::size_t, 4>& cell = mesh.cells[c];
    out << cell[0] << ' ' << cell[1] << ' ' << cell[2] << ' ' << cell[3];
  });
  write_array(out, "Int64", "offsets", cells, 1, [&](const std::size_t c) { out << 4 * (c + 1); });
  write_array(out, "UInt8", "types", cells, 1, [&](const std::size_t) { out << VTK_TETRA; });
  out << "</Cells>\n<PointData>\n";
  write_label(out, mesh.point_references);
  for(const Vertex_values& v : values)
    write_array(out, "Float64", v.name, points, 1,
                [&](const std::size_t i) { out << v.values[static_cast<Eigen::Index>(i)]; });
  out << "</PointData>\n<CellData>\n";
  write_label(out, mesh.cell_references);
  out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n";
}

} // namespace Canonical_pose_tool
