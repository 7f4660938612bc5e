// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "solvers.h"

#include "formats/Cgal_types.h"

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/SparseCore>

#include <limits>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>

namespace Canonical_pose_python {

namespace {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_tool::Surface;

Point_matrix points_of_mesh(const Mesh_file& mesh)
{
  return Canonical_pose_tool::matrix_of(Canonical_pose_tool::points_of(mesh));
}

CP::Target_3 first_target(const CP::Prepared_surface_3::Component& component,
                          const CP::Coarse_surface_3& coarse, const CP::Landmark_fields_3& fields)
{
  const auto& [surface, options] = component;
  if(options.target_mode == Options::Target_mode::MDS)
    return CP::mds_target(surface, coarse, fields, options);
  return CP::unfolded_target(surface, CP::surface_body(surface, coarse, fields, options), options);
}

// What comes before the registration of a component.
struct Steps
{
  explicit Steps(const CP::Prepared_surface_3::Component& component)
    : coarse(CP::coarse_surface(component.surface, component.options)),
      fields(CP::landmark_fields(coarse, component.options)),
      target(first_target(component, coarse, fields))
  {}

  CP::Coarse_surface_3 coarse;
  CP::Landmark_fields_3 fields;
  CP::Target_3 target;
};

// The target of each vertex of the input; vertices without a target keep their position.
Result joined_target(const CP::Prepared_surface_3& prepared,
                     const std::vector<CP::Target_3>& targets)
{
  std::vector<Result> results;
  for(std::size_t c = 0; c < targets.size(); ++c)
  {
    Result result;
    result.pose = targets[c].points;
    result.pose_of_followers = prepared.components[c].options.followers;
    result.target = targets[c].points;
    result.summary.target = targets[c].summary;
    result.summary.warnings = targets[c].warnings;
    result.summary.termination = CP::Registration_summary::CONVERGED; // or nothing would be joined
    results.push_back(std::move(result));
  }
  Result joined = CP::joined_result(prepared, results);
  joined.summary.termination = CP::Registration_summary::NOT_RUN;
  return joined;
}

} // namespace

Result first_target(const Mesh_file& surface, const Options& options)
{
  const CP::Prepared_surface_3 prepared
    = CP::prepare_surface(points_of_mesh(surface), surface.faces, options);
  std::vector<CP::Target_3> targets;
  for(const CP::Prepared_surface_3::Component& component : prepared.components)
    targets.push_back(Steps(component).target);
  return joined_target(prepared, targets);
}

// ---- Heat_solver -----------------------------------------------------------------------------------

struct Heat_solver::Data
{
  Data(const Mesh_file& file, const double time_step_factor)
    : Data(file, CP::repair_surface(points_of_mesh(file), file.faces), time_step_factor)
  {}

  Data(const Mesh_file& file, const CP::Repaired_surface_3& surface, const double time_step_factor)
    : mesh(CP::make_triangle_mesh<Surface>(surface.points, surface.triangles)),
      geodesics(mesh, time_step_factor)
  {
    std::vector<std::size_t> first_copies(file.points.size(), surface.origins.size());
    for(std::size_t copy = surface.origins.size(); copy-- > 0;)
      first_copies[surface.origins[copy]] = copy;
    for(const std::size_t v : surface.representatives)
      copies.push_back(first_copies[v]);
  }

  std::vector<Surface::Vertex_index> sources(const std::vector<std::size_t>& vertices) const
  {
    std::vector<Surface::Vertex_index> result;
    for(const std::size_t v : vertices)
    {
      if(copies[v] == mesh.number_of_vertices())
        throw std::invalid_argument("a source names vertex " + std::to_string(v)
                                    + ", which belongs to no face: there are no distances from it");
      result.emplace_back(static_cast<Surface::size_type>(copies[v]));
    }
    return result;
  }

  // From the rows of the repaired surface to those of the input.
  Eigen::MatrixXd rows(const Eigen::MatrixXd& values) const
  {
    Eigen::MatrixXd result
      = Eigen::MatrixXd::Constant(static_cast<Eigen::Index>(copies.size()), values.cols(),
                                  (std::numeric_limits<double>::infinity)());
    for(std::size_t v = 0; v < copies.size(); ++v)
      if(copies[v] != mesh.number_of_vertices())
        result.row(static_cast<Eigen::Index>(v)) = values.row(static_cast<Eigen::Index>(copies[v]));
    return result;
  }

  const Surface mesh;
  const CP::Heat_geodesics_3<Surface> geodesics;
  // the vertex of the mesh for each one of the input; their number, if it belongs to no face
  std::vector<std::size_t> copies;
};

Heat_solver::Heat_solver(const Mesh_file& surface, const double time_step_factor)
  : m_data(std::make_unique<const Data>(surface, time_step_factor))
{}

Heat_solver::~Heat_solver() = default;

std::size_t Heat_solver::number_of_vertices() const { return m_data->copies.size(); }

Eigen::MatrixXd Heat_solver::distances(const std::vector<std::size_t>& sources) const
{
  return m_data->rows(m_data->geodesics.distances(m_data->sources(sources)));
}

Eigen::VectorXd Heat_solver::distance_to_nearest(const std::vector<std::size_t>& sources) const
{
  return m_data->rows(m_data->geodesics.distance_to_nearest(m_data->sources(sources)));
}

// ---- Registrar -------------------------------------------------------------------------------------

struct Registrar::Data
{
  Data(const Mesh_file& file, const Options& options)
    : prepared(CP::prepare_surface(points_of_mesh(file), file.faces, options)),
      component(only_component()), steps(component),
      body(CP::surface_body(component.surface, steps.coarse, steps.fields, component.options)),
      registrar(body.body, weights(), body.length_scale, component.options.registration,
                body.stiffness),
      followers(CP::Body_deformer_3<CP::Elastic_body_3>(body.body, component.surface.triangles)
                  .embedding(component.options.followers)),
      first_target(*joined_target(prepared, {steps.target}).target)
  {}

  const CP::Prepared_surface_3::Component& only_component() const
  {
    if(prepared.components.size() != 1)
      throw std::invalid_argument("the surface has " + std::to_string(prepared.components.size())
                                  + " components to be posed, but a registrar has one body");
    return prepared.components.front();
  }

  // Of the surface vertices of the body.
  Eigen::VectorXd weights() const
  {
    const CP::Surface_component_3& surface = component.surface;
    Eigen::VectorXd shares = CP::vertex_area_shares(surface.points, surface.triangles);
    if(component.options.matching_weights.size() > 0)
      shares = shares.cwiseProduct(component.options.matching_weights);
    return shares;
  }

  const CP::Prepared_surface_3 prepared;
  const CP::Prepared_surface_3::Component& component;
  const Steps steps;
  const CP::Surface_body_3 body;
  CP::Tetrahedral_arap_registrar_3<CP::Elastic_body_3> registrar;
  const Eigen::SparseMatrix<double> followers; // in the body: vertices that are not on its surface
  const Point_matrix first_target;
  Point_matrix positions = Point_matrix(0, 3); // of the body
  std::mutex mutex;
};

Registrar::Registrar(const Mesh_file& surface, const Options& options)
  : m_data(std::make_unique<Data>(surface, options))
{}

Registrar::~Registrar() = default;

const Point_matrix& Registrar::target() const { return m_data->first_target; }
const Point_matrix& Registrar::body_points() const { return m_data->body.body.points(); }

const std::vector<std::array<int, 4>>& Registrar::body_cells() const
{
  return m_data->body.body.cells();
}

void Registrar::set_detail_length(const double detail_length)
{
  const std::lock_guard<std::mutex> lock(m_data->mutex);
  m_data->registrar.set_detail_length(detail_length);
}

Result Registrar::registered_to(const Point_matrix& target, const bool is_warm,
                                const CP::Registration_visitor& visitor)
{
  Data& data = *m_data;
  const CP::Surface_component_3& surface = data.component.surface;
  if(target.rows() != data.prepared.points.rows())
    throw std::invalid_argument("the target has " + std::to_string(target.rows())
                                + " vertices, but the surface has "
                                + std::to_string(data.prepared.points.rows()));
  const std::lock_guard<std::mutex> lock(data.mutex);
  Point_matrix rows(surface.points.rows(), 3);
  for(std::size_t i = 0; i < surface.origins.size(); ++i)
    rows.row(static_cast<Eigen::Index>(i))
      = target.row(static_cast<Eigen::Index>(surface.origins[i]));
  for(const auto& [vertex, others, weights] : surface.added)
  {
    auto row = rows.row(static_cast<Eigen::Index>(vertex));
    row.setZero();
    for(std::size_t k = 0; k < 3; ++k)
      row += weights[k] * rows.row(static_cast<Eigen::Index>(others[k]));
  }
  data.registrar.set_target(rows);
  Point_matrix positions = is_warm ? data.positions : Point_matrix(0, 3);
  Result result;
  result.summary = data.registrar.register_to_target(positions, visitor);
  if(!result.is_usable())
    throw std::runtime_error("there is no pose: the registration met numbers that are not finite");
  data.positions = std::move(positions);
  result.pose = data.registrar.surface_points(data.positions);
  result.pose_of_followers = data.followers * data.positions;
  result.target = std::move(rows);
  return CP::joined_result(data.prepared, {result});
}

} // namespace Canonical_pose_python
