// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_file.h"
#include "Shortest_numbers.h"
#include "Shown_surface.h"

#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <cstddef>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

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

// With normals and colors of the vertices, if there are.
void write_off(std::ostream& out, const Mesh_file& mesh)
{
  const std::vector<Color>& colors = mesh.appearance.vertex_colors;
  const std::vector<unsigned char>& opacities = mesh.appearance.vertex_opacities;
  const std::vector<std::array<float, 3>> normals = normals_of_vertices(mesh);
  out << (colors.empty() ? "" : "C") << (normals.empty() ? "" : "N") << "OFF\n"
      << mesh.points.size() << ' ' << mesh.faces.size() << " 0\n";
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const std::array<double, 3>& p = mesh.points[v];
    out << p[0] << ' ' << p[1] << ' ' << p[2];
    if(!normals.empty())
      write_numbers(out, normals[v]);
    if(!colors.empty())
      write_numbers(out, std::array<int, 4>{colors[v][0], colors[v][1], colors[v][2],
                                            opacities.empty() ? 255 : opacities[v]});
    out << '\n';
  }
  for(const Face_list::Face face : mesh.faces)
  {
    out << face.size();
    write_numbers(out, face);
    out << '\n';
  }
}

} // namespace

void check_format_holds(const Format format, const Mesh_file& mesh)
{
  if(format == Format::GLTF)
    throw std::invalid_argument("files .gltf are read, but not written; choose .glb");
  const std::size_t most_corners_of_ply = 255; // their number is a byte
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const std::size_t corners = mesh.faces[f].size();
    const auto defect = [&] {
      return ", but face " + std::to_string(f) + " has " + std::to_string(corners) + " corners";
    };
    if(format == Format::STL && corners != 3)
      throw std::invalid_argument("STL holds triangles only" + defect());
    if(format == Format::PLY && corners > most_corners_of_ply)
      throw std::invalid_argument("PLY holds faces of at most "
                                  + std::to_string(most_corners_of_ply) + " corners" + defect());
  }
}

void write_mesh(std::ostream& out, const Format format, const Mesh_file& mesh,
                Companion_files* const beside)
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  use_shortest_numbers(out);
  if(format == Format::MEDIT)
    return write_medit(out, mesh);
  if(format == Format::VTU)
    return write_vtu(out, mesh, {});
  if(format == Format::GLB
     || format == Format::PLY) // CGAL's writer of PLY refers to temporary faces
  {
    Shown_surface surface;
    surface.mesh = mesh;
    const Appearance& appearance = mesh.appearance;
    if(!appearance.texture_coordinates.empty()
       || !appearance.normals.empty()) // copies are found again
      for(std::size_t v = 0; v < mesh.points.size(); ++v)
        surface.origins.push_back(v);
    return format == Format::GLB ? write_glb(out, surface) : write_ply(out, surface, beside);
  }
  if(format == Format::OFF)
    return write_off(out, mesh);
  if(format == Format::OBJ)
    return write_obj(out, mesh, beside);
  std::vector<Point> points;
  for(const std::array<double, 3>& p : mesh.points)
    points.emplace_back(p[0], p[1], p[2]);
  CGAL::IO::write_STL(out, points, mesh.faces, CGAL::parameters::stream_precision(17));
}

} // namespace Canonical_pose_tool
