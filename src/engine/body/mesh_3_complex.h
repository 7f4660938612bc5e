// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_BODY_MESH_3_COMPLEX_H
#define CANONICAL_POSE_3_ENGINE_BODY_MESH_3_COMPLEX_H

#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_criteria_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Polyhedral_mesh_domain_3.h>
#include <CGAL/boost/graph/properties_Surface_mesh_features.h>
#include <CGAL/refine_mesh_3.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <unordered_set>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

using Mesh_3_domain = Polyhedral_mesh_domain_3<Indexed_mesh, Indexed_mesh_kernel>;
using Mesh_3_triangulation = Mesh_triangulation_3<Mesh_3_domain, Default, Sequential_tag>::type;
using Mesh_3_complex = Mesh_complex_3_in_triangulation_3<Mesh_3_triangulation>;

// Returns surface samples that are at least the spacing apart, and nowhere much farther.
inline std::vector<Indexed_mesh::Point> sample_surface(const Point_matrix& points,
                                                       const std::vector<Index_triangle>& triangles,
                                                       const double spacing)
{
  std::vector<Indexed_mesh::Point> samples;
  Delaunay_triangulation_3<Indexed_mesh_kernel> chosen;
  const auto add = [&](const Eigen::RowVector3d& row) {
    const Indexed_mesh::Point p(row[0], row[1], row[2]);
    if(chosen.number_of_vertices() > 0
       && squared_distance(chosen.nearest_vertex(p)->point(), p) < spacing * spacing)
      return;
    chosen.insert(p);
    samples.push_back(p);
  };
  for(Eigen::Index v = 0; v < points.rows(); ++v)
    add(points.row(v));
  for(const Index_triangle& t : triangles)
  {
    const Eigen::RowVector3d a = points.row(t[0]), b = points.row(t[1]), c = points.row(t[2]);
    const double longest = (std::max)({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const int n = static_cast<int>(std::ceil(longest / spacing));
    for(int i = 0; i <= n; ++i)
      for(int j = 0; i + j <= n; ++j)
        add(a + (i * (b - a) + j * (c - a)) / n);
  }
  return samples;
}

inline bool is_flat(const Mesh_3_triangulation& triangulation,
                    const Mesh_3_complex::Cell_handle cell)
{
  const auto tetrahedron = triangulation.tetrahedron(cell);
  double longest = 0;
  for(int i = 0; i < 4; ++i)
    for(int j = 0; j < i; ++j)
      longest = (std::max)(longest, squared_distance(tetrahedron[i], tetrahedron[j]));
  return !(tetrahedron.volume() > 1e-6 * longest * std::sqrt(longest));
}

inline std::vector<Mesh_3_complex::Cell_handle> cells_in_complex(const Mesh_3_complex& complex)
{
  std::vector<Mesh_3_complex::Cell_handle> cells;
  for(auto c = complex.cells_in_complex_begin(); c != complex.cells_in_complex_end(); ++c)
    cells.push_back(c);
  return cells;
}

// Removes flat cells, and all but the largest of the parts connected through faces, from the
// complex.
inline void keep_largest_part(Mesh_3_complex& complex)
{
  using Cells = std::vector<Mesh_3_complex::Cell_handle>;
  for(const auto cell : cells_in_complex(complex))
    if(is_flat(complex.triangulation(), cell))
      complex.remove_from_complex(cell);

  Cells largest;
  std::unordered_set<Mesh_3_complex::Cell_handle> visited;
  const Cells cells = cells_in_complex(complex);
  for(const auto first : cells)
  {
    if(!visited.insert(first).second)
      continue;
    Cells part = {first};
    for(std::size_t i = 0; i < part.size(); ++i)
      for(int k = 0; k < 4; ++k)
      {
        const auto neighbor = part[i]->neighbor(k);
        if(complex.is_in_complex(neighbor) && visited.insert(neighbor).second)
          part.push_back(neighbor);
      }
    if(part.size() > largest.size())
      largest.swap(part);
  }

  visited.clear();
  visited.insert(largest.begin(), largest.end());
  for(const auto cell : cells)
    if(visited.count(cell) == 0)
      complex.remove_from_complex(cell);
}

// Fills the surface. The refinement starts from surface samples: the few initial points that Mesh_3
// would choose by rays from the center miss thin parts.
inline Mesh_3_complex mesh_3_complex(const Point_matrix& points,
                                     const std::vector<Index_triangle>& triangles,
                                     const double size)
{
  using Criteria = Mesh_criteria_3<Mesh_3_triangulation>;
  const Indexed_mesh mesh = indexed_mesh(points, triangles);
  const Mesh_3_domain domain(mesh);
  const Mesh_3_domain::Index index
    = domain.index_from_surface_patch_index(Mesh_3_domain::Surface_patch_index(0, 1));
  Mesh_3_complex complex;
  Mesh_3_triangulation& triangulation = complex.triangulation();
  for(const Indexed_mesh::Point& p : sample_surface(points, triangles, size / 2))
  {
    const auto v = triangulation.insert(Mesh_3_triangulation::Weighted_point(p));
    complex.set_dimension(v, 2);
    complex.set_index(v, index);
  }

  // Mesh_3 requires an initial cell inside.
  const auto cells = triangulation.finite_cell_handles();
  if(std::any_of(cells.begin(), cells.end(), [&](const Mesh_3_complex::Cell_handle cell) {
       return bool(domain.is_in_domain_object()(triangulation.dual(cell)));
     }))
  {
    const Criteria criteria(Criteria::Facet_criteria(0, size, size / 10),
                            Criteria::Cell_criteria(0, size));
    refine_mesh_3(complex, domain, criteria, parameters::no_perturb(), parameters::no_exude());
    keep_largest_part(complex);
  }
  if(complex.number_of_cells_in_complex() == 0)
    throw std::runtime_error("Mesh_3 found the surface too thin for cells of the requested size");
  return complex;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_BODY_MESH_3_COMPLEX_H
