// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The readers of the tool, then the first steps with a mesh. The first byte chooses the format, the
// others are the file.

#include "formats/Cgal_types.h"
#include "checks.h"
#include "formats/Companion_files.h"
#include "formats/Shown_surface.h"
#include "formats/readers.h"

#include <CGAL/Canonical_pose_3/complex_body.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

using namespace Canonical_pose_tool;
namespace CPF = Canonical_pose_fuzz;

namespace {

struct Reader
{
  Format format;
  void (*read)(const std::string&, Mesh_file&);
};

void read_gltf_of_nowhere(const std::string& bytes, Mesh_file& mesh) { read_gltf(bytes, "", mesh); }

const std::array<Reader, 6> READERS = {{{Format::OFF, read_off},
                                        {Format::OBJ, read_obj},
                                        {Format::PLY, read_ply},
                                        {Format::STL, read_stl},
                                        {Format::MEDIT, read_medit},
                                        {Format::GLB, read_gltf_of_nowhere}}};

// Written files are read back identically, apart from STL, which has no order of vertices, and glTF,
// which has single precision.
void check_writer(const Reader& reader, const Mesh_file& mesh)
{
  if(!CPF::is_accepted([&] { check_format_holds(reader.format, mesh); }))
    return;
  std::ostringstream out;
  if(!CPF::is_accepted([&] { write_mesh(out, reader.format, mesh); }))
    return;
  if(reader.format == Format::STL || reader.format == Format::GLB)
    return;
  Mesh_file again;
  CPF::require(CPF::is_accepted([&] { reader.read(out.str(), again); }), "what is written is read");
  CPF::require(again.points == mesh.points && again.faces == mesh.faces && again.cells == mesh.cells
                 && again.point_references == mesh.point_references
                 && again.cell_references == mesh.cell_references,
               "what is written is what is read again");
}

// What is loaded belongs to the vertices, faces and corners, and is written.
void check_appearance(Mesh_file mesh)
{
  load_appearance(mesh);
  const Appearance& appearance = mesh.appearance;
  std::size_t corners = 0;
  for(const CGAL::Canonical_pose_3::Face_list::Face face : mesh.faces)
    corners += face.size();
  const auto belongs = [](const auto& values, const std::size_t number) {
    return values.empty() || values.size() == number;
  };
  CPF::require(belongs(appearance.vertex_colors, mesh.points.size())
                 && belongs(appearance.vertex_opacities, appearance.vertex_colors.size())
                 && belongs(appearance.texture_coordinates, corners)
                 && belongs(appearance.material_of_face, mesh.faces.size()),
               "the appearance is that of the mesh");
  for(const std::size_t material : appearance.material_of_face)
    CPF::require(material < appearance.materials.size(), "materials exist");
  for(const Format format : {Format::OFF, Format::OBJ, Format::PLY, Format::GLB})
  {
    losses(mesh, format);
    std::ostringstream out;
    Companion_files beside{"/nowhere/a.obj"};
    if(!mesh.is_tetrahedral && CPF::is_accepted([&] { check_format_holds(format, mesh); }))
      CPF::is_accepted([&] { write_mesh(out, format, mesh, &beside); });
  }
}

// A file with other positions is read again, with them: exactly, if they are text.
void check_rewriter(const Reader& reader, std::string bytes, Mesh_file mesh)
{
  const Format format = reader.format;
  std::optional<std::string> all;
  if(format == Format::GLB && CPF::is_accepted([&] { all = self_contained_glb(bytes, ""); }) && all)
    bytes = *all;
  if(format == Format::GLB && bytes.compare(0, 4, "glTF") != 0)
    return;
  mesh.source = std::make_shared<const Source_file>(Source_file{format, bytes});
  attributes_of_file(mesh);
  check_appearance(mesh);
  if(!is_rewritable(mesh, format))
    return;
  std::vector<std::array<double, 3>> points = mesh.points;
  for(std::array<double, 3>& p : points)
    p = {p[1], -p[0], p[2]};
  std::ostringstream out;
  if(!CPF::is_accepted([&] { rewrite_mesh(out, mesh, points, {}); }))
    return; // what single precision cannot hold
  Mesh_file again;
  CPF::require(CPF::is_accepted([&] { reader.read(out.str(), again); }), "what is rewritten is read");
  if(reader.format == Format::STL)
    return;
  CPF::require(again.faces == mesh.faces && again.cells == mesh.cells, "faces and cells are the same");
  CPF::require(reader.format == Format::PLY || reader.format == Format::GLB || again.points == points,
               "the positions are those that are written");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, const std::size_t size)
{
  if(size == 0)
    return 0;
  const Reader& reader = READERS[data[0] % READERS.size()];
  const std::string bytes(data + 1, data + size);
  if(bytes.find_first_not_of(" \t\r\n") == std::string::npos)
    return 0; // refused before it is read
  Mesh_file mesh;
  if(!CPF::is_accepted([&] { reader.read(bytes, mesh); }))
  {
    Mesh_file unchecked;
    unchecked.is_checked = false;
    if(CPF::is_accepted([&] { reader.read(bytes, unchecked); }))
      CPF::require(!diagnosis_of(unchecked).defects.empty(), "what only a check refuses has a defect");
    return 0;
  }
  check_writer(reader, mesh);
  check_rewriter(reader, bytes, mesh);
  if(mesh.is_tetrahedral)
    CPF::is_accepted([&] {
      CGAL::Canonical_pose_3::complex_body(tetrahedra_of(mesh));
      mesh = boundary_of(mesh);
    });
  CPF::check_surface(matrix_of(points_of(mesh)), mesh.faces);
  return 0;
}
