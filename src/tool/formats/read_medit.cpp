// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "readers.h"

#include <array>
#include <cstddef>
#include <cstdlib>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

bool begins_with_one_of(const std::string_view word,
                        const std::initializer_list<std::string_view> beginnings)
{
  for(const std::string_view beginning : beginnings)
    if(word.substr(0, beginning.size()) == beginning)
      return true;
  return false;
}

bool holds_other_cells(const std::string_view keyword)
{
  return begins_with_one_of(
    keyword, {"Hexahedra", "Prisms", "Pyramids", "Polyhedra", "TetrahedraP", "CoarseHexahedra"});
}

// Sections known to contain neither vertices nor cells.
bool is_left_out(const std::string_view keyword)
{
  return begins_with_one_of(
    keyword, {"Triangles", "Quadrilaterals", "Edge", "Corners", "Ridges", "Required", "Normal",
              "Tangent", "VerticesOn", "VertexOn", "SubDomain", "AngleOfCornerBound", "BoundingBox",
              "ExtraVertices", "Periodic", "Parallel", "Iterations", "Time", "Fault_"});
}

bool is_number(const std::string_view word)
{
  char* end;
  std::strtod(word.data(), &end);
  return end == word.data() + word.size();
}

// A file is a sequence of sections, each a keyword followed by numbers.
class Medit_reader
{
public:
  Medit_reader(const std::string& bytes, Mesh_file& mesh) : m_text(bytes), m_mesh(mesh) {}

  void run()
  {
    m_mesh.is_tetrahedral = true;
    if(m_text.word() != "MeshVersionFormatted")
      throw std::invalid_argument("line 1: there is no keyword MeshVersionFormatted");
    m_text.integer(m_text.word(), Element{"the version"});
    for(std::string_view word = m_text.word(); !word.empty(); word = m_text.word())
      if(word == "End")
        m_text.check_is_at_end(Element{"the keyword End"});
      else if(!is_number(word))
        read_section(word);
      else if(!m_is_left_out)
        throw m_text.goes_on_after(m_last);
    for(Element c{"cell", 0}; c.index < m_cells.size(); ++c.index)
    {
      std::array<std::size_t, 4> cell;
      for(std::size_t k = 0; k < 4; ++k)
        cell[k] = vertex_index(m_mesh, m_cells[c.index][k], m_mesh.points.size(), c, 1);
      m_mesh.cells.push_back(cell);
    }
    if(m_mesh.cells.empty())
      throw std::invalid_argument("there are no tetrahedra");
  }

private:
  std::invalid_argument on_line(const std::string& defect) const
  {
    return std::invalid_argument("line " + std::to_string(m_text.line()) + ": " + defect);
  }

  void read_section(const std::string_view keyword)
  {
    m_is_left_out = is_left_out(keyword);
    if(m_is_left_out)
      return;
    if(keyword == "Dimension")
      read_dimension();
    else if(keyword == "Vertices")
      read_vertices();
    else if(keyword == "Tetrahedra")
      read_cells();
    else if(holds_other_cells(keyword))
      refuse_other_cells();
    else if(keyword == "Geometry" || keyword == "Identifier") // with a text between quotes
    {
      m_text.word();
      m_text.skip_line();
    }
    else
      throw on_line("the keyword " + Text_cursor::shown(keyword) + " is unknown");
  }

  void read_dimension()
  {
    m_last = Element{"the dimension"};
    if(m_text.integer(m_text.word(), m_last) != 3)
      throw on_line("the dimension is not 3");
  }

  void read_vertices()
  {
    if(!m_mesh.points.empty())
      throw on_line("there is a second section Vertices");
    m_last = Element{"the number of vertices"};
    const std::size_t n = m_text.count(m_text.word(), m_last);
    for(std::size_t i = 0; i < n; ++i)
    {
      m_last = Element{"vertex", i};
      std::array<double, 3> point;
      for(double& x : point)
        x = m_text.number(m_text.word(), m_last);
      check_is_finite(m_mesh, point, m_last);
      m_mesh.points.push_back(point);
      m_mesh.point_references.push_back(m_text.integer(m_text.word(), m_last));
    }
  }

  void read_cells()
  {
    if(!m_cells.empty())
      throw on_line("there is a second section Tetrahedra");
    m_last = Element{"the number of cells"};
    const std::size_t n = m_text.count(m_text.word(), m_last);
    for(std::size_t i = 0; i < n; ++i)
    {
      m_last = Element{"cell", i};
      std::array<long long, 4> cell;
      for(long long& v : cell)
        v = m_text.integer(m_text.word(), m_last);
      m_cells.push_back(cell);
      m_mesh.cell_references.push_back(m_text.integer(m_text.word(), m_last));
    }
  }

  void refuse_other_cells()
  {
    m_last = Element{"the number of cells"};
    if(m_text.count(m_text.word(), m_last) > 0)
      throw on_line("there are cells that are no tetrahedra");
  }

  Text_cursor m_text;
  Mesh_file& m_mesh;
  std::vector<std::array<long long, 4>> m_cells; // vertices may follow later
  Element m_last{"the version"};                 // what was read
  bool m_is_left_out = false;                    // whether this section is skipped
};

} // namespace

void read_medit(const std::string& bytes, Mesh_file& mesh) { Medit_reader(bytes, mesh).run(); }

} // namespace Canonical_pose_tool
