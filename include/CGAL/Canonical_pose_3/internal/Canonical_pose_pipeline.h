// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_CANONICAL_POSE_PIPELINE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_CANONICAL_POSE_PIPELINE_H

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Gaussian_kernel.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Squared_distance_kernel.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/flipped_faces.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>
#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
#include <CGAL/Canonical_pose_3/tetgen_body.h>
#endif

#include <CGAL/Default.h>
#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The steps of canonical_pose_3() on arrays. `origins` tells the surface vertex of the body (the
// row of its embedding) that each vertex of the surface mesh is.
template <typename FactorTraits>
class Canonical_pose_pipeline
{
public:
  Canonical_pose_pipeline(const Point_matrix& points, const std::vector<Index_triangle>& triangles,
                          const Options& options)
    : m_points(points), m_triangles(triangles), m_options(options),
      m_results(options.intermediate_results != nullptr ? *options.intermediate_results
                                                        : m_own_results)
  {
    for(const char* stage : {"diagnosis", "geodesics", "target", "body", "factorization",
                             "local_steps", "global_steps"})
      m_summary.add_seconds(stage, 0);
  }

  // A surface, in a body that is made here.
  Registration_summary run(Point_matrix& pose)
  {
#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
    prepare(m_points.rows());
    std::vector<std::size_t> origins(static_cast<std::size_t>(m_points.rows()));
    std::iota(origins.begin(), origins.end(), std::size_t(0));
    m_summary.body.kind = "tetgen";
    Real_timer timer;
    timer.start();
    const Conforming_body_3 body = tetgen_body_of_clean_surface(m_points, m_triangles);
    m_summary.add_seconds("body", timer.time());
    return deform(body, origins, pose);
#else
    CGAL_USE(pose);
    throw std::runtime_error("a surface needs a body, but the program was built without TetGen");
#endif
  }

  // The boundary of a body that is there.
  Registration_summary run(const Conforming_body_3& body, const std::vector<std::size_t>& origins,
                           Point_matrix& pose)
  {
    prepare(body.embedding().rows());
    m_summary.body.kind = "complex";
    return deform(body, origins, pose);
  }

private:
  template <typename Function>
  void timed(const char* stage, const Function& f)
  {
    Real_timer timer;
    timer.start();
    f();
    m_summary.add_seconds(stage, timer.time());
  }

  // Options are checked before anything that takes time. A spring may name one of n vertices.
  void prepare(const Eigen::Index n)
  {
    m_options.registration.check();
    m_springs = Spring_constraint_adaptor_3(static_cast<std::size_t>(n));
    for(const Spring_3& spring : m_options.springs)
      m_springs.insert(spring);
    if(m_options.number_of_landmarks == 0)
      throw std::invalid_argument("option number_of_landmarks is 0, but must be >= 1");
    timed("diagnosis", [&] { m_summary.input = diagnose(m_points, m_triangles); });
    if(!m_summary.input.is_clean())
      throw std::invalid_argument(m_summary.input.first_defect);
    timed("geodesics", [&] { find_landmarks(); });
    m_length_scale = m_results.landmark_fields->distances.maxCoeff();
    m_summary.target.landmarks = m_results.landmark_fields->landmarks.size();
    m_summary.target.covering_radius = m_results.landmark_fields->covering_radius;
    m_summary.target.max_geodesic = m_length_scale;
  }

  void find_landmarks()
  {
    if(m_results.landmark_fields)
    {
      if(m_results.landmark_fields->distances.cols() == 0)
        throw std::invalid_argument("the distances handed in have no column");
      check_rows(m_results.landmark_fields->distances.rows(), "the distances handed in have ");
      return;
    }
    const Indexed_mesh mesh = indexed_mesh(m_points, m_triangles);
    std::size_t first = extremal_point(m_points, m_triangles);
    if(m_options.random_seed != 0)
      first = static_cast<std::size_t>(
        Random(m_options.random_seed).get_int(0, static_cast<int>(m_points.rows())));
    const Indexed_mesh::Vertex_index vertex(static_cast<Indexed_mesh::size_type>(first));
    const auto find = [&](const auto& geodesics) {
      m_results.landmark_fields
        = farthest_point_landmarks(geodesics, m_options.number_of_landmarks, vertex);
    };
    if(m_options.geodesics == Options::Geodesics::EXACT)
      find(Exact_geodesics_3<Indexed_mesh>(mesh));
    else
      find(Heat_geodesics_3<Indexed_mesh, CGAL::Default, CGAL::Default, FactorTraits>(mesh));
  }

  void check_rows(const Eigen::Index rows, const std::string& what) const
  {
    if(rows != m_points.rows())
      throw std::invalid_argument(what + std::to_string(rows) + " rows, but there are "
                                  + std::to_string(m_points.rows()) + " vertices");
  }

  Point_matrix find_target(const Eigen::VectorXd& shares)
  {
    if(m_results.target)
    {
      m_summary.target.kernel = "given";
      check_rows(m_results.target->rows(), "the target handed in has ");
      return *m_results.target;
    }
    Point_matrix target;
    switch(m_options.kernel)
    {
    case Options::Kernel::CLASSICAL:
      target = embed(Squared_distance_kernel());
      break;
    case Options::Kernel::GAUSSIAN:
      target = embed(Gaussian_kernel());
      break;
    case Options::Kernel::UNCENTERED_GAUSSIAN:
      target = embed(Gaussian_kernel(false));
      break;
    }
    m_summary.target.reflected = target_handedness(target, m_points, m_triangles, shares) < 0;
    return align_target(target, m_points, shares, m_summary.target.reflected);
  }

  template <typename Kernel>
  Point_matrix embed(const Kernel& kernel)
  {
    Landmark_mds_target_builder_3<Kernel> builder(kernel);
    builder.build(*m_results.landmark_fields);
    m_summary.target.kernel = kernel.name();
    m_summary.target.stress = builder.stress();
    const Eigen::VectorXd& values = builder.eigenvalues();
    m_summary.target.eigenvalues.assign(values.data(),
                                        values.data() + (std::min)(Eigen::Index(6), values.size()));
    if(builder.number_of_positive_eigenvalues() < 3)
      m_summary.warnings.push_back("the target is flat: fewer than three eigenvalues are positive");
    if(!builder.is_determined())
      m_summary.warnings.push_back(
        "the pose is not determined: the fourth eigenvalue is nearly as large as the third");
    return builder.targets();
  }

  Registration_summary deform(const Conforming_body_3& body,
                              const std::vector<std::size_t>& origins, Point_matrix& pose)
  {
    const Eigen::VectorXd shares = vertex_area_shares(m_points, m_triangles);
    timed("target", [&] { m_results.target = find_target(shares); });

    // Copies of a vertex of the body share its target.
    const Eigen::Index n = body.embedding().rows();
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(n), copies = Eigen::VectorXd::Zero(n);
    Point_matrix target = Point_matrix::Zero(n, 3);
    for(std::size_t i = 0; i < origins.size(); ++i)
    {
      weights[origins[i]] += m_options.paper_weights ? 1 : shares[i];
      copies[origins[i]] += 1;
      target.row(origins[i]) += m_results.target->row(i);
    }
    target = copies.cwiseMax(1).cwiseInverse().asDiagonal() * target;

    Tetrahedral_arap_registrar_3<Conforming_body_3, CGAL::Default, FactorTraits> registrar(
      body, weights, m_length_scale, registration_options(body));
    if(!m_springs.springs().empty())
      registrar.add_constraint(m_springs);
    registrar.set_target(target);
    Point_matrix body_pose;
    take(registrar.register_to_target(body_pose));
    if(m_summary.is_usable())
    {
      pose = body.embedding() * body_pose;
      timed("diagnosis", [&] { measure(body, origins, pose, body_pose); });
    }
    return m_summary;
  }

  Registration_options registration_options(const Conforming_body_3& body) const
  {
    Registration_options result = m_options.registration;
    if(m_options.paper_weights)
    {
      result.set_paper_weights(m_options.paper_weights->alpha, m_options.paper_weights->beta,
                               static_cast<std::size_t>(m_points.rows()), body.volume(),
                               m_length_scale);
      result.fairing_passes = (std::max)(result.fairing_passes, 1);
    }
    return result;
  }

  // Adds what the registrar says to what is known already.
  void take(Registration_summary registered)
  {
    for(const Registration_summary::Stage& stage : registered.stages)
      m_summary.add_seconds(stage.first, stage.second);
    registered.stages = m_summary.stages;
    registered.body.kind = m_summary.body.kind;
    registered.input = m_summary.input;
    registered.target = m_summary.target;
    registered.warnings = m_summary.warnings;
    m_summary = std::move(registered);
  }

  void measure(const Conforming_body_3& body, const std::vector<std::size_t>& origins,
               const Point_matrix& pose, const Point_matrix& body_pose)
  {
    std::vector<Index_triangle> triangles = m_triangles;
    for(Index_triangle& t : triangles)
      for(std::size_t& v : t)
        v = origins[v];
    const Point_matrix rest = body.embedding() * body.points();
    m_summary.median_edge_strain = median_edge_strain(rest, pose, triangles);
    m_summary.flipped_faces = flipped_faces(body, triangles, rest, pose, body_pose);
    if(m_summary.termination == Registration_summary::ITERATION_LIMIT)
      m_summary.warnings.push_back(
        "the registration did not converge within the iterations allowed");
  }

  const Point_matrix& m_points;
  const std::vector<Index_triangle>& m_triangles;
  const Options& m_options;
  Intermediate_results m_own_results;
  Intermediate_results& m_results;
  Registration_summary m_summary;
  Spring_constraint_adaptor_3 m_springs{0};
  double m_length_scale = 0;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_CANONICAL_POSE_PIPELINE_H
