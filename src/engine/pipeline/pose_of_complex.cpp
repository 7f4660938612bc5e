// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Complex_parts.h"
#include "component_options.h"
#include "component_roles.h"
#include "describe_fields.h"
#include "pose_of_components.h"
#include "refine_components.h"
#include "../surface/examine_surface.h"
#include "../surface/refined_surface.h"
#include "../support/Thread_limit.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/poses.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/support/Indexed_vector.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Real_timer.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline std::vector<Complex_part> all_parts(const Complex_parts& parts)
{
  std::vector<Complex_part> result;
  for(std::size_t i = 0; i < parts.size(); ++i)
    result.push_back(parts[i]);
  return result;
}

// The roles of the parts. Those without a boundary, such as a cell that exists twice, have no area.
inline std::vector<Component_role> roles_of_parts(const std::vector<Complex_part>& parts,
                                                  const Options& options)
{
  std::vector<Surface_component_3> surfaces;
  for(const Complex_part& part : parts)
    surfaces.push_back(part.surface);
  const std::vector<Component_role> result = Component_roles::find(
    surfaces, std::vector<bool>(parts.size(), false), options.components, false);
  const std::size_t n = posed_components(result).size();
  if(n == 0)
    throw std::invalid_argument("the boundary of the complex has no area");
  if(n > 1 && refuses_several(options.components))
    throw refusal_of_several("the complex has " + std::to_string(n) + " connected components",
                             result, [&](const std::size_t p) { return surfaces[p].body_origins; });
  return result;
}

// The boundary of a complex, with the options assigned to the parts to be posed.
inline Prepared_surface_3
prepared_complex(const Point_matrix& points, const std::vector<std::array<int, 4>>& cells,
                 const Complex_parts& parts, const std::vector<Complex_part>& all,
                 const std::vector<Component_role>& roles, const Options& options)
{
  std::vector<Surface_component_3> surfaces;
  for(const Complex_part& part : all)
    surfaces.push_back(part.surface);
  std::vector<std::array<std::size_t, 4>> unsigned_cells(cells.size());
  for(std::size_t t = 0; t < cells.size(); ++t)
    std::copy(cells[t].begin(), cells[t].end(), unsigned_cells[t].begin());
  Vertex_map rows;
  rows.representatives = identity_map<Vertex_index>(static_cast<std::size_t>(points.rows()));
  rows.representative_rows = identity_map<Row_index>(parts.boundary_vertices().size());
  rows.vertex_of_row
    = Indexed_vector<Row_index, Vertex_index>::of_numbers(parts.boundary_vertices());
  rows.row_name = "boundary vertex";
  Prepared_surface_3 result = prepared(
    examine_boundary(points, unsigned_cells, options.searches_self_intersections), points,
    std::move(surfaces), std::move(rows), roles, options);
  refine(result.components);
  const std::vector<std::size_t> posed = posed_components(roles);
  for(std::size_t c = 0; c < posed.size(); ++c)
  {
    auto& [surface, local] = result.components[c];
    const Complex_part& part = all[posed[c]];
    if(options.stiffness.size() > 0)
      local.stiffness = values_at(options.stiffness, part.cells);
    if(options.matching_weights.size() > 0 && !surface.added.empty())
    {
      const auto number = static_cast<Eigen::Index>(surface.added.size());
      const Eigen::VectorXd of_surface
        = with_added(surface, values_at(local.matching_weights, part.surface_vertices));
      local.matching_weights.conservativeResize(local.matching_weights.size() + number);
      local.matching_weights.tail(number) = of_surface.tail(number);
    }
  }
  return result;
}

// For each vertex of a surface, its row in the embedding of the body.
inline std::vector<std::size_t> body_rows(const Complex_part& part,
                                          const Surface_component_3& surface)
{
  std::vector<std::size_t> result = part.surface_vertices;
  for(std::size_t i = 0; i < surface.added.size(); ++i)
    result.push_back(part.surface.body_origins.size() + i);
  return result;
}

// A body of cells. The vertices that were added to its surface move with the vertices of the cells.
// `rows`: of the other vertices of the surface.
inline Embedded_body_3 body_of_part(const Point_matrix& points,
                                    std::vector<std::array<int, 4>> cells,
                                    const std::vector<std::size_t>& rows,
                                    const Surface_component_3& surface)
{
  if(surface.added.empty())
    return Conforming_body_3(points, std::move(cells), static_cast<std::size_t>(points.rows()));
  std::vector<Eigen::Triplet<double>> entries;
  for(int i = 0; i < points.rows(); ++i)
    entries.emplace_back(i, i, 1);
  std::vector<std::map<std::size_t, double>> weights;
  for(const std::size_t row : rows)
    weights.push_back({{row, 1.}});
  int row = static_cast<int>(points.rows());
  for(const Vertex_combination_3& combination : surface.added)
  {
    weights.emplace_back();
    for(std::size_t k = 0; k < 3; ++k)
      for(const auto& [vertex, weight] : weights[combination.vertices[k]])
        weights.back()[vertex] += combination.weights[k] * weight;
    for(const auto& [vertex, weight] : weights.back())
      entries.emplace_back(row, static_cast<int>(vertex), weight);
    ++row;
  }
  Eigen::SparseMatrix<double> embedding(row, points.rows());
  embedding.setFromTriplets(entries.begin(), entries.end());
  return Embedded_body_3(points, std::move(cells), std::move(embedding));
}

// canonical_pose_3() for tetrahedra, which form the body.
Result pose_of_complex(const Point_matrix& points, const std::vector<std::array<int, 4>>& cells,
                       const Options& options)
{
  if(const Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return pose_of_complex(points, cells, options); });
  check_options(options, static_cast<std::size_t>(points.rows()));
  if(options.contacts == Options::Contacts::CUT)
    throw std::invalid_argument("contacts of a tetrahedral complex cannot be cut");
  checked_stiffness(options.stiffness, cells.size());
  Real_timer timer;
  timer.start();
  const Conforming_body_3 body(points, cells, static_cast<std::size_t>(points.rows()));
  const Complex_parts parts(body.points(), body.cells(), body.cell_weights());
  const std::vector<Complex_part> all = all_parts(parts);
  const std::vector<Component_role> roles = roles_of_parts(all, options);
  const std::vector<std::size_t> posed = posed_components(roles);
  const double seconds_for_body = timer.time();
  Options used = options;
  if(options.target_mode == Options::Target_mode::UNFOLDING && !options.return_landmark_fields
     && options.number_of_rounds.value_or(0) == 0)
    used.number_of_landmarks = (std::min)(std::size_t(2), options.number_of_landmarks); // for L
  const Prepared_surface_3 prepared = prepared_complex(points, cells, parts, all, roles, used);
  const double seconds_for_diagnosis = timer.time() - seconds_for_body;

  Result result = pose_of_components(
    prepared, used,
    [&](const std::size_t c, const Coarse_surface_3&, const Landmark_fields_3& fields) {
      const Complex_part& part = all[posed[c]];
      const std::vector<std::size_t>& vertices = part.surface.body_origins;
      return Surface_body_3{"complex",
                            body_of_part(rows_at(points, vertices), parts.local_cells(part),
                                         part.surface_vertices, prepared.components[c].surface),
                            length_scale(fields, prepared.components[c].options),
                            body_rows(part, prepared.components[c].surface),
                            prepared.components[c].options.stiffness,
                            {}};
    });
  result.summary.add_seconds("diagnosis", seconds_for_diagnosis);
  result.summary.add_seconds("body", seconds_for_body);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
