// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_CANONICAL_POSE_PIPELINE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_CANONICAL_POSE_PIPELINE_H

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/Exact_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Gaussian_kernel.h>
#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Squared_distance_kernel.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/cell_stiffness.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Options_constraints.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Solver.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/flipped_faces.h>
#include <CGAL/Canonical_pose_3/internal/soup/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/soup/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/target/check_number_of_landmarks.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <CGAL/Random.h>
#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <cmath>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The steps of canonical_pose_3() for one component, with options in its own rows.
class Canonical_pose_pipeline
{
public:
  Canonical_pose_pipeline(const Posed_component& component, const Options& options,
                          const Solver& solver, const Body_makers& bodies,
                          const Diagnosis_3& diagnosis)
    : m_component(component), m_points(component.points), m_triangles(component.triangles),
      m_options(options), m_solver(solver), m_bodies(bodies)
  {
    for(const char* stage : {"diagnosis", "geodesics", "target", "body", "factorization",
                             "local_steps", "global_steps"})
      m_summary.add_seconds(stage, 0);
    m_summary.input = diagnosis;
  }

  // A surface, in a body that is made here.
  Registration_summary run(Point_matrix& pose)
  {
    if(m_options.body == Options::Body::TETGEN || m_options.body == Options::Body::MESH_3)
      if(!m_summary.input.is_clean())
        throw std::invalid_argument(m_summary.input.first_defect);
    prepare();
    switch(m_options.body)
    {
    case Options::Body::TETGEN:
      return run_in_tetgen_body(pose);
    case Options::Body::MESH_3:
      return run_in_mesh_3_body(pose);
    default:
      return run_in_lattice(pose);
    }
  }

  // The boundary of a body that is there. `origins` tells the surface vertex of the body (the row of
  // its embedding) that each vertex of the surface is.
  template <typename ElasticBody>
  Registration_summary run(const ElasticBody& body, const std::vector<std::size_t>& origins,
                           Point_matrix& pose)
  {
    prepare();
    m_summary.body.kind = "complex";
    return deform(Body_view(body), origins, m_options.stiffness, pose);
  }

  // Fields unless they are given, target and pose of the followers, after run().
  Intermediate_results& results() { return m_results; }

private:
  static constexpr double TOLERATED_VOLUME_RATIO = 1.15;

  template <typename Function>
  void timed(const char* stage, const Function& f)
  {
    Real_timer timer;
    timer.start();
    f();
    m_summary.add_seconds(stage, timer.time());
  }

  // A body each of whose surface vertices is a vertex of the surface.
  template <typename ElasticBody>
  Registration_summary deform_in(const char* kind, const ElasticBody& body, Point_matrix& pose)
  {
    m_summary.body.kind = kind;
    std::vector<std::size_t> origins(static_cast<std::size_t>(m_points.rows()));
    std::iota(origins.begin(), origins.end(), std::size_t(0));
    Eigen::VectorXd stiffness;
    if(m_options.stiffness.size() > 0)
      timed("body", [&] {
        stiffness
          = cell_stiffness(body, vertex_area_shares(m_points, m_triangles), m_options.stiffness);
      });
    return deform(Body_view(body), origins, stiffness, pose);
  }

  Registration_summary run_in_lattice(Point_matrix& pose)
  {
    std::optional<Lattice_body_3> body;
    timed("body", [&] {
      body.emplace(m_points, m_triangles, fields().distances, m_options.lattice_spacing,
                   m_component.caps);
    });
    return deform_in("lattice", *body, pose);
  }

  // Not beside the distances: TetGen and METIS, which CHOLMOD may call, draw from the same std::rand().
  Registration_summary run_in_tetgen_body(Point_matrix& pose)
  {
    if(m_bodies.tetgen == nullptr)
      throw std::runtime_error("the program was built without TetGen");
    std::optional<Conforming_body_3> body;
    timed("body", [&] {
      try
      {
        body = m_bodies.tetgen(m_points, m_triangles);
      }
      catch(const std::runtime_error& error)
      {
        m_summary.warnings.push_back(error.what() + std::string("; the lattice took its place"));
      }
    });
    return body ? deform_in("tetgen", *body, pose) : run_in_lattice(pose);
  }

  Registration_summary run_in_mesh_3_body(Point_matrix& pose)
  {
    if(m_bodies.mesh_3 == nullptr)
      throw std::runtime_error("the program was built without bodies of Mesh_3");
    std::optional<Embedded_body_3> body;
    timed("body", [&] {
      body = m_bodies.mesh_3(m_points, m_triangles, m_length_scale, m_options.lattice_spacing);
    });
    return deform_in("mesh_3", *body, pose);
  }

  void prepare()
  {
    if(!m_options.given->landmark_fields)
    {
      check_number_of_landmarks(m_options.number_of_landmarks,
                                static_cast<std::size_t>(m_points.rows()));
      timed("geodesics", [&] { find_landmarks(); });
    }
    m_length_scale = fields().distances.maxCoeff();
    m_summary.target.landmarks = fields().landmarks.size();
    m_summary.target.covering_radius = fields().covering_radius;
    m_summary.target.max_geodesic = m_length_scale;
  }

  const Landmark_fields_3& fields() const
  {
    return m_options.given->landmark_fields ? *m_options.given->landmark_fields
                                            : *m_results.landmark_fields;
  }

  void find_landmarks()
  {
    const Indexed_mesh mesh = indexed_mesh(m_points, m_triangles);
    std::size_t first = extremal_point(m_points, m_triangles);
    if(m_options.random_seed != 0)
      first = static_cast<std::size_t>(
        Random(m_options.random_seed).get_int(0, static_cast<int>(m_points.rows())));
    const Indexed_mesh::Vertex_index vertex(static_cast<Indexed_mesh::size_type>(first));
    // exact distances take longer than all the rest, and a batch saves nothing
    if(m_options.geodesics == Options::Geodesics::EXACT)
      m_results.landmark_fields = with_faces_of_input(m_component.faces, [&] {
        return farthest_point_landmarks(Exact_geodesics_3<Indexed_mesh>(mesh),
                                        m_options.number_of_landmarks, vertex);
      });
    else if(m_options.geodesics == Options::Geodesics::WAVEFRONT)
      m_results.landmark_fields = front_landmarks(Wavefront_geodesics_3<Indexed_mesh>(mesh),
                                                  m_options.number_of_landmarks, vertex);
    else
      m_results.landmark_fields
        = front_landmarks(Heat_geodesics_3<Indexed_mesh>(mesh, get(vertex_point, mesh), {},
                                                         m_solver.lane_factor_maker),
                          m_options.number_of_landmarks, vertex);
  }

  Point_matrix find_target(const Eigen::VectorXd& shares)
  {
    if(m_options.given->target)
    {
      m_summary.target.kernel = "given";
      return *m_options.given->target;
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
    std::vector<Index_triangle> closed = m_triangles;
    closed.insert(closed.end(), m_component.caps.begin(), m_component.caps.end());
    m_summary.target.reflected = target_handedness(target, m_points, closed, shares) < 0;
    return align_target(target, m_points, shares, m_summary.target.reflected);
  }

  template <typename Kernel>
  Point_matrix embed(const Kernel& kernel)
  {
    Landmark_mds_target_builder_3<Kernel> builder(kernel);
    builder.build(fields());
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

  // `stiffness`: of the cells, or nothing.
  Registration_summary deform(const Body_view& body, const std::vector<std::size_t>& origins,
                              const Eigen::VectorXd& stiffness, Point_matrix& pose)
  {
    const Eigen::VectorXd shares = vertex_area_shares(m_points, m_triangles);
    timed("target", [&] { m_results.target = find_target(shares); });
    const bool is_size_free = m_summary.target.kernel != "given" && !m_options.paper_weights;

    // Copies of a vertex of the body share its target.
    const Eigen::Index n = body.embedding().rows();
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(n), copies = Eigen::VectorXd::Zero(n);
    for(std::size_t i = 0; i < origins.size(); ++i)
    {
      weights[origins[i]] += m_options.paper_weights ? 1 : shares[i];
      copies[origins[i]] += 1;
    }
    if(m_options.matching_weights.size() > 0)
      weights = weights.cwiseProduct(m_options.matching_weights).eval();
    const auto target_of_body = [&] {
      Point_matrix target = Point_matrix::Zero(n, 3);
      for(std::size_t i = 0; i < origins.size(); ++i)
        target.row(origins[i]) += m_results.target->row(i);
      return Point_matrix(copies.cwiseMax(1).cwiseInverse().asDiagonal() * target);
    };

    check_that_body_is_held(body, weights);
    Options_constraints constraints(m_options, static_cast<std::size_t>(n));
    const auto registration
      = make_arap_registration(body, weights, m_length_scale, registration_options(body), stiffness,
                               default_rotation_routines(), m_solver.factor_maker);
    constraints.add_to(*registration);
    registration->set_target(target_of_body());
    Registration_visitor visitor;
    if(m_options.visitor)
      visitor = [&](Registration_progress progress) { // which counts all iterations
        progress.iteration += m_summary.iterations;
        return m_options.visitor(progress);
      };
    Point_matrix body_pose;
    take(registration->register_to_target(body_pose, visitor));
    if(is_size_free && m_summary.is_usable() && m_summary.volume_ratio > TOLERATED_VOLUME_RATIO
       && m_summary.termination != Registration_summary::CANCELED)
    {
      shrink_target(shares);
      registration->set_target(target_of_body());
      take(registration->register_to_target(body_pose, visitor));
    }
    if(m_summary.is_usable())
    {
      pose = body.embedding() * body_pose;
      timed("diagnosis", [&] { measure(body, origins, pose, body_pose); });
      if(m_options.followers.rows() > 0)
        timed("global_steps", [&] {
          m_results.pose_of_followers
            = Body_deformer_3<Body_view>(body, triangles_of(origins)).embedding(m_options.followers)
              * body_pose;
        });
    }
    return m_summary;
  }

  // Throws with a vertex of the input, where the registrar would name one of the body.
  void check_that_body_is_held(const Body_view& body, const Eigen::VectorXd& weights) const
  {
    if(const auto row = surface_vertex_of_loose_component(body, weights))
      throw std::invalid_argument("all matching weights are 0 in the part around vertex "
                                  + std::to_string(m_component.vertices[*row]));
  }

  // Geodesics lead around a compact body, so that its target is too large: a ball becomes a larger ball.
  // The exponent brings the volume of most shapes below 1.2 times that at rest: it grows about as the
  // 1.5th power of the scale.
  void shrink_target(const Eigen::VectorXd& shares)
  {
    m_summary.target.scale = std::pow(TOLERATED_VOLUME_RATIO / m_summary.volume_ratio, 0.65);
    const Eigen::RowVector3d centroid = shares.transpose() * *m_results.target;
    m_results.target = Point_matrix(
      (m_summary.target.scale * (m_results.target->rowwise() - centroid)).rowwise() + centroid);
  }

  // the triangles as rows of the embedding
  std::vector<Index_triangle> triangles_of(const std::vector<std::size_t>& origins) const
  {
    std::vector<Index_triangle> triangles = m_triangles;
    for(Index_triangle& t : triangles)
      for(std::size_t& v : t)
        v = origins[v];
    return triangles;
  }

  Registration_options registration_options(const Body_view& body) const
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
    registered.iterations += m_summary.iterations;
    registered.body.kind = m_summary.body.kind;
    registered.input = m_summary.input;
    registered.target = m_summary.target;
    registered.warnings.insert(registered.warnings.begin(), m_summary.warnings.begin(),
                               m_summary.warnings.end());
    m_summary = std::move(registered);
  }

  void measure(const Body_view& body, const std::vector<std::size_t>& origins,
               const Point_matrix& pose, const Point_matrix& body_pose)
  {
    const std::vector<Index_triangle> triangles = triangles_of(origins);
    const Point_matrix rest = body.embedding() * body.points();
    m_summary.median_edge_strain = median_edge_strain(rest, pose, triangles);
    m_summary.flipped_faces = flipped_faces(body, triangles, rest, pose, body_pose);
    if(m_summary.termination == Registration_summary::ITERATION_LIMIT)
      m_summary.warnings.push_back(
        "the registration did not converge within the iterations allowed");
    else if(m_summary.termination == Registration_summary::CANCELED)
      m_summary.warnings.push_back("the registration was canceled before it converged");
  }

  const Posed_component& m_component;
  const Point_matrix& m_points;
  const std::vector<Index_triangle>& m_triangles;
  const Options& m_options;
  const Solver m_solver;
  const Body_makers m_bodies;
  Intermediate_results m_results;
  Registration_summary m_summary;
  double m_length_scale = 0;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_CANONICAL_POSE_PIPELINE_H
