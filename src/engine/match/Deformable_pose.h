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

// A surface that is deformed, as rigidly as possible, toward targets. Only its largest component is; others follow.
class Deformable_pose
{
public:
  Deformable_pose(const Point_matrix& points, const Face_list& faces)
    : m_prepared(prepare_surface(points, faces, options())),
      m_component(m_prepared.components.front()),
      m_coarse(coarse_surface(m_component.surface, m_component.options)),
      m_body(body_of_surface(m_component.surface, m_coarse,
                             landmark_fields(m_coarse, m_component.options), m_component.options,
                             Body_makers())),
      m_registrar(m_body.body,
                  vertex_area_shares(m_component.surface.points, m_component.surface.triangles),
                  m_body.length_scale, m_component.options.registration, m_body.stiffness),
      m_followers(Body_deformer_3<Elastic_body_3>(m_body.body, m_component.surface.triangles)
                    .embedding(m_component.options.followers))
  {}
  Deformable_pose(const Deformable_pose&) = delete;
  Deformable_pose& operator=(const Deformable_pose&) = delete;

  // Features smaller than this share of the size keep their shape.
  void set_detail_length(const double detail_length)
  {
    m_registrar.set_detail_length(detail_length);
  }

  // The pose for a target with a row per point; starts at the previous one. Nothing changes if it fails.
  Point_matrix registered_to(const Point_matrix& target, const Point_matrix& otherwise)
  {
    Point_matrix rows(m_component.surface.points.rows(), 3);
    rows.topRows(static_cast<Eigen::Index>(m_component.surface.origins.size()))
      = rows_at(target, m_component.surface.origins);
    for(const auto& [vertex, others, weights] : m_component.surface.added)
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
    result.pose_of_followers = m_followers * m_positions;
    result.target = std::move(rows);
    return joined_result(m_prepared, {result}).pose;
  }

private:
  static Options options()
  {
    Options result;
    result.components = Options::Components::LARGEST;
    result.registration.injective = false;
    return result;
  }

  const Prepared_surface_3 m_prepared;
  const Prepared_surface_3::Component& m_component;
  const Coarse_surface_3 m_coarse;
  const Surface_body_3 m_body;
  Tetrahedral_arap_registrar_3<Elastic_body_3> m_registrar;
  const Eigen::SparseMatrix<double> m_followers;
  Point_matrix m_positions = Point_matrix(0, 3); // of the body
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_MATCH_DEFORMABLE_POSE_H
