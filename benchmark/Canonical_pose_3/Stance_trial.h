// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_STANCE_TRIAL_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_STANCE_TRIAL_H

#include "Processor_clock.h"
#include "limb_measures.h"

#include "compute_pose.h" // of the tool

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_benchmark {

using CGAL::Canonical_pose_3::Options;
using CGAL::Canonical_pose_3::Point_matrix;

inline const std::vector<std::pair<std::string, Stance>> STANCES = {
  {"t", Stance::T}, {"a", Stance::A}, {"vitruvian", Stance::VITRUVIAN}, {"stand", Stance::STAND}};

inline const char* name(const Stance stance)
{
  return std::find_if(STANCES.begin(), STANCES.end(),
                      [=](const auto& known) { return known.second == stance; })
    ->first.c_str();
}

/// How a computation ended.
struct Trial_outcome
{
  enum Outcome { FOUND, REFUSED, FAILED };

  Outcome outcome = FAILED;
  std::string reason; ///< why nothing was found

protected:
  template <class Function>
  void run(const Function& function)
  {
    try
    {
      function();
      outcome = FOUND;
    }
    catch(const std::invalid_argument& e)
    {
      reason = e.what();
      outcome = REFUSED;
    }
    catch(const std::exception& e)
    {
      reason = e.what();
    }
  }
};

/// The canonical pose of a mesh.
struct Posed_mesh_of_class : Trial_outcome
{
  Posed_mesh_of_class(std::string name_of_class, std::string name_of_mesh,
                      Canonical_pose_tool::Mesh_file file, const Options& options)
    : class_name(std::move(name_of_class)), name(std::move(name_of_mesh)), mesh(std::move(file))
  {
    Canonical_pose_tool::check_is_surface(mesh);
    const Point_matrix points
      = Canonical_pose_tool::matrix_of(Canonical_pose_tool::points_of(mesh));
    const auto at = [&](const std::size_t vertex) -> Eigen::Vector3d {
      return points.row(static_cast<Eigen::Index>(vertex));
    };
    double area = 0;
    for(const auto& face : mesh.faces)
    {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for(std::size_t i = 2; i < face.size(); ++i)
        sum += (at(face[i - 1]) - at(face[0])).cross(at(face[i]) - at(face[0]));
      area += sum.norm() / 2;
    }
    root_of_area = std::sqrt(area);
    run([&] {
      const Processor_clock clock;
      pose = Canonical_pose_tool::compute_pose(mesh, options).pose;
      seconds = clock.seconds();
    });
  }

  std::string class_name, name;
  Canonical_pose_tool::Mesh_file mesh;
  double root_of_area;
  Point_matrix pose;
  double seconds = 0;
};

/// A stance of a mesh.
struct Stance_trial : Trial_outcome
{
  Stance_trial(std::shared_ptr<const Posed_mesh_of_class> posed_mesh, const Stance stance_to_take,
               Options options)
    : Trial_outcome(*posed_mesh), mesh(std::move(posed_mesh)), stance(stance_to_take)
  {
    if(outcome != FOUND)
      return;
    outcome = FAILED;
    options.stance = stance;
    run([&] {
      const Processor_clock clock;
      Canonical_pose_tool::Result result = Canonical_pose_tool::compute_pose(mesh->mesh, options);
      seconds = clock.seconds();
      limbs = limb_measures(result.skeleton.value(), stance, mesh->root_of_area);
      limbs_of_vertices = Canonical_pose_benchmark::limbs_of_vertices(*result.skeleton);
      is_front_certain = result.skeleton->is_front_certain;
      strain = result.summary.median_edge_strain;
      inverted = result.summary.inverted;
      warnings = result.summary.warnings;
      pose = std::move(result.pose);
    });
  }

  std::shared_ptr<const Posed_mesh_of_class> mesh;
  Stance stance;
  Limb_measures limbs = {};
  std::vector<std::size_t> limbs_of_vertices;
  bool is_front_certain = false;
  double strain = 0;
  std::size_t inverted = 0;
  std::vector<std::string> warnings;
  Point_matrix pose;
  double seconds = 0;
};

inline const char* name(const Stance_trial::Outcome outcome)
{
  static const char* const names[] = {"found", "refused", "failed"};
  return names[outcome];
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_STANCE_TRIAL_H
