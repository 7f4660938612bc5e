// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_REGISTRATION_SUMMARY_H
#define CGAL_CANONICAL_POSE_3_REGISTRATION_SUMMARY_H

#include <CGAL/Canonical_pose_3/Diagnosis_3.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief describes the outcome of a registration and of the preceding stages.

`Tetrahedral_arap_registrar_3` sets the members about the registration, `canonical_pose_3()` sets
all members.
*/
struct Registration_summary
{
  /// why the iteration stopped.
  enum Termination {
    NOT_RUN,         ///< the registration has not run.
    CONVERGED,       ///< the stopping inequalities of `Registration_options` hold.
    ITERATION_LIMIT, ///< the maximum number of iterations was reached, or inverted cells were
                     ///< untangled without reaching a minimum of the energy; the pose is usable.
    CANCELED,        ///< the visitor stopped the iteration; the pose is the best one so far.
    NOT_FINITE       ///< numbers overflowed; there is no pose.
  };

  /// describes the target of the registration.
  struct Target
  {
    /// name of the kernel; `"given"` for a given target, `"unfolding"` if there was none.
    std::string kernel;
    std::size_t landmarks = 0;  ///< number of landmarks.
    double covering_radius = 0; ///< largest distance of a vertex to its nearest landmark.
    /// stress over the landmarks, see `Landmark_mds_target_builder_3::stress()`.
    double stress = 0;
    /// the six leading eigenvalues (fewer if there are fewer landmarks).
    std::vector<double> eigenvalues;
    double max_geodesic = 0; ///< \f$ L \f$, the largest distance to a landmark.
    double scale = 1;        ///< factor by which the target of a compact shape was shrunk.
    bool reflected = false;  ///< whether the target was mirrored.
    /// whether the choice between the target and its mirror image is safe, see
    /// `Target_handedness_3`; `true` for a given target.
    bool is_handedness_certain = true;
    /// that of the symmetry by which the target was made symmetric, see `Intrinsic_symmetry_3`; none without a clear one.
    std::optional<double> symmetry_distortion;
  };

  /// describes the elastic body.
  struct Body
  {
    std::string kind; ///< `"lattice"`, `"tetgen"`, `"mesh_3"`, or `"complex"`, or `"given"` for
                      ///< that of `Options::make_body`.
    std::size_t vertices = 0;   ///< number of body vertices.
    std::size_t tetrahedra = 0; ///< number of cells.
  };

  /// describes a round, see `Method_options::number_of_rounds`.
  struct Round
  {
    /// stress of the refined target, see `Smacof_target_builder_3::stress()`.
    double stress = 0;
    /// energy of the pose on which distances were measured, with half the detail length.
    double energy = 0;
    /// median edge strain of this pose.
    double median_edge_strain = 0;
    /// running time.
    double seconds = 0;
  };

  /// describes a component without a pose of its own, see `Method_options::Components`. Components
  /// are numbered by decreasing size, those with a pose included.
  struct Follower
  {
    /// the component.
    std::size_t component = 0;
    /// its first vertex in the input.
    std::size_t vertex = 0;
    /// the component with a pose that it follows, or itself if it keeps its place.
    std::size_t leader = 0;
    /// whether it moves rigidly; otherwise, it is deformed with the body.
    bool is_rigid = false;
  };

  /// a stage of the pipeline with its running time in seconds.
  using Stage = std::pair<std::string, double>;

  /// \name Iteration
  /// @{

  /// why the iteration stopped.
  Termination termination = NOT_RUN;
  /// number of completed iterations.
  int iterations = 0;

  /// @}

  /// \name Energies
  /// @{

  /// the energy \f$ E \f$ of the result, dimensionless.
  double energy = 0;
  /// its matching term, or its unfolding term, which is negative.
  double energy_match = 0;
  /// its as-rigid-as-possible term.
  double energy_arap = 0;
  /// the terms of the constraints.
  double energy_constraints = 0;
  /// the energy at the start and after each iteration; if inverted cells were untangled, followed
  /// by that of the result, which may be higher.
  std::vector<double> energy_history;

  /// @}

  /// \name Quality of the pose
  /// @{

  /// number of cells that are inverted (or flat) in the result.
  std::size_t inverted = 0;
  /// number of surface faces whose normal is rotated by more than 90 degrees relative to the
  /// rotation of their cell.
  std::size_t flipped_faces = 0;
  /// volume of the result divided by that of the rest pose.
  double volume_ratio = 0;
  /// median over the edges of the surface of \f$ | \log(\text{length in the result} / \text{length
  /// at rest}) | \f$.
  double median_edge_strain = 0;

  /// @}

  /// \name Solver and running times
  /// @{

  /// name of the linear solver.
  std::string solver;
  /// running time of each stage, in the order of the pipeline.
  std::vector<Stage> stages;

  /// @}

  /// \name Input, target, rounds and body
  /// @{

  /// diagnosis of the surface.
  Diagnosis_3 input;
  /// the target.
  Target target;
  /// the rounds before the final registration, of the largest component.
  std::vector<Round> rounds;
  /// the body.
  Body body;
  /// the components without a pose of their own, including pieces and fragments.
  std::vector<Follower> followers;
  /// warnings, one line each, about a usable result.
  std::vector<std::string> warnings;

  /// @}

  /// returns whether the stopping inequalities hold.
  bool converged() const { return termination == CONVERGED; }

  /// returns whether there is a pose.
  bool is_usable() const { return termination != NOT_RUN && termination != NOT_FINITE; }

  /// returns the sum of the running times of all stages.
  double total_seconds() const
  {
    double sum = 0;
    for(const Stage& stage : stages)
      sum += stage.second;
    return sum;
  }

  /// adds `seconds` to the stage `name`, which is appended if it does not exist.
  void add_seconds(const std::string& name, const double seconds)
  {
    const auto stage
      = std::find_if(stages.begin(), stages.end(), [&](const Stage& s) { return s.first == name; });
    if(stage != stages.end())
      stage->second += seconds;
    else
      stages.emplace_back(name, seconds);
  }

  /// returns a report in one line.
  std::string brief_report() const
  {
    static const char* const names[]
      = {"not run", "converged", "iteration limit reached", "canceled", "not finite"};
    std::ostringstream out;
    out.precision(4);
    out << names[termination] << " after " << iterations << " iterations, energy " << energy << ", "
        << inverted << " of " << body.tetrahedra << " cells inverted";
    if(median_edge_strain > 0) // measured
      out << ", median edge strain " << median_edge_strain;
    if(!target.eigenvalues.empty()) // no given target
      out << ", stress " << target.stress;
    out << ", " << total_seconds() << " s (" << solver << ')';
    return out.str();
  }
};

/// \relates Registration_summary
/// writes `Registration_summary::brief_report()`.
inline std::ostream& operator<<(std::ostream& out, const Registration_summary& summary)
{
  return out << summary.brief_report();
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_REGISTRATION_SUMMARY_H
