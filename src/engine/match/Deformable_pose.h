// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_MATCH_DEFORMABLE_POSE_H
#define CANONICAL_POSE_3_ENGINE_MATCH_DEFORMABLE_POSE_H

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Elastic_body_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/body_of_surface.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/SparseCore>

#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// What is deformed to deform a surface: only its largest component is; others follow.
struct Deformable_body
{
  Deformable_body(const Point_matrix& points, const Face_list& faces)
    : prepared(prepare_surface(points, faces, options())), component(prepared.components.front()),
      body(body_of(component)),
      followers(Body_deformer_3<Elastic_body_3>(body.body, component.surface.triangles)
                  .embedding(component.options.followers))
  {}
  Deformable_body(const Deformable_body&) = delete;
  Deformable_body& operator=(const Deformable_body&) = delete;

  const Prepared_surface_3 prepared;
  const Prepared_surface_3::Component& component;
  const Surface_body_3 body;
  const Eigen::SparseMatrix<double> followers;

private:
  static Options options()
  {
    Options result;
    result.components = Options::Components::LARGEST;
    result.registration.injective = false;
    return result;
  }

  static Surface_body_3 body_of(const Prepared_surface_3::Component& component)
  {
    const Coarse_surface_3 coarse = coarse_surface(component.surface, component.options);
    return body_of_surface(component.surface, coarse, landmark_fields(coarse, component.options),
                           component.options, Body_makers());
  }
};

// A surface that is deformed, as rigidly as possible, toward targets.
class Deformable_pose
{
public:
  explicit Deformable_pose(const Deformable_body& body)
    : m_body(body),
      m_registrar(
        body.body.body,
        vertex_area_shares(body.component.surface.points, body.component.surface.triangles),
        body.body.length_scale, body.component.options.registration, body.body.stiffness)
  {}

  // Features smaller than this share of the size keep their shape.
  void set_detail_length(const double detail_length)
  {
    m_registrar.set_detail_length(detail_length);
  }

  // The pose for a target with a row per point; starts at the previous one. Nothing changes if it fails.
  Point_matrix registered_to(const Point_matrix& target, const Point_matrix& otherwise)
  {
    const Surface_component_3& surface = m_body.component.surface;
    Point_matrix rows(surface.points.rows(), 3);
    rows.topRows(static_cast<Eigen::Index>(surface.origins.size()))
      = rows_at(target, surface.origins);
    for(const auto& [vertex, others, weights] : surface.added)
    {
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for(std::size_t k = 0; k < 3; ++k)
        sum += weights[k] * rows.row(static_cast<Eigen::Index>(others[k]));
      rows.row(static_cast<Eigen::Index>(vertex)) = sum;
    }
    m_registrar.set_target(rows);
    Result result;
    result.summary = m_registrar.register_to_target(m_positions);
    if(!result.is_usable())
      return otherwise;
    result.pose = m_registrar.surface_points(m_positions);
    result.pose_of_followers = m_body.followers * m_positions;
    result.target = std::move(rows);
    return joined_result(m_body.prepared, {result}).pose;
  }

private:
  const Deformable_body& m_body;
  Tetrahedral_arap_registrar_3<Elastic_body_3> m_registrar;
  Point_matrix m_positions = Point_matrix(0, 3); // of the body
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_MATCH_DEFORMABLE_POSE_H
