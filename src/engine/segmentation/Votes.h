// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_VOTES_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_VOTES_H

#include "Face_graph.h"
#include "K_means.h"
#include "Lines_of_sight.h"
#include "Patch_graph.h"
#include "Patches.h"
#include "sweep_cuts.h"

#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A geometry of the surface: the given one, or a pose.
struct Viewed_surface
{
  Face_graph graph;
  Eigen::MatrixXd visibility, distances; // of the centers of patches
};

// Segmentations with different methods and parameters, each of which is a vote on which patches
// belong to the same part.
class Votes
{
public:
  // `geometries`: the given one, and the pose, if any. `is_pose_faithful`: whether the pose has about the
  // same inside. `log_thickness`: one value per patch.
  // `is_number_given`: whether the number of parts is requested; otherwise, it is determined by how far
  // votes with the same number of parts agree, so they have just as many.
  Votes(const std::vector<Viewed_surface>& geometries, const bool is_pose_faithful,
        const Patches& patches, const Eigen::VectorXd& log_thickness, const bool is_number_given)
    : m_geometries(geometries), m_patches(patches), m_is_number_given(is_number_given),
      m_compares_poses(is_number_given && is_pose_faithful),
      m_has_limbs(geometries.back().visibility.mean() < LEAST_VISIBILITY_OF_BODY),
      m_areas(patch_areas(geometries[0].graph, patches)),
      m_thickness_of_face(static_cast<Eigen::Index>(patches.patch_of_face.size()))
  {
    for(std::size_t f = 0; f < patches.patch_of_face.size(); ++f)
      m_thickness_of_face[static_cast<Eigen::Index>(f)]
        = log_thickness[static_cast<Eigen::Index>(patches.patch_of_face[f])];
  }

  // The number of parts on which sweeps agree if none is given: their median, or 1 if half of them make
  // no cut.
  std::size_t typical_number_of_parts(const unsigned int seed) const
  {
    std::vector<std::size_t> numbers;
    for(const Vote& vote : sweeps(0, seed))
      numbers.push_back(vote.number_of_parts);
    if(2 * static_cast<std::size_t>(std::count(numbers.begin(), numbers.end(), std::size_t(1)))
       >= numbers.size())
      return 1;
    const auto median = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
    std::nth_element(numbers.begin(), median, numbers.end());
    return *median;
  }

  // The share of the votes, by their weights, in which two patches belong to the same part. Votes have
  // up to half again as many parts as are asked for: where some of several equally good cuts would be
  // made, like those around one of two legs, others make all of them.
  Eigen::MatrixXd similarities(const std::size_t number_of_parts, const unsigned int seed) const
  {
    std::vector<Vote> votes = sweeps(number_of_parts, seed);
    for(Vote& vote : sights(number_of_parts, seed))
      votes.push_back(std::move(vote));
    const Eigen::VectorXd weights = weights_of(votes);
    const auto n = m_areas.size();
    Eigen::MatrixXd result = Eigen::MatrixXd::Zero(n, n);
    for(std::size_t v = 0; v < votes.size(); ++v)
      for(Eigen::Index j = 0; j < n; ++j)
        for(Eigen::Index i = 0; i < n; ++i)
          if(votes[v].part_of_patch[static_cast<std::size_t>(i)]
             == votes[v].part_of_patch[static_cast<std::size_t>(j)])
            result(i, j) += weights[static_cast<Eigen::Index>(v)];
    return result;
  }

  static constexpr double COST_LIMIT = 2.1; // of cuts, if the number of parts is not given

private:
  static constexpr std::size_t NUMBER_OF_SWEEPS = 12, NUMBER_OF_SIGHTS = 8;
  // Cuts around small patches are cheap, so the number of parts is determined with larger ones.
  static constexpr std::size_t PATCHES_OF_SWEEPS = 300, PATCHES_FOR_NUMBER = 200;
  static constexpr std::size_t MOST_PARTS = 64;
  // Of a shape that is one nearly convex body, like a fish, a larger share of pairs of patches see each
  // other; its parts are small, like fins.
  static constexpr double LEAST_VISIBILITY_OF_BODY = .5;

  struct Vote
  {
    std::vector<std::size_t> part_of_patch;
    std::size_t number_of_parts = 0;
  };

  // Number i of a sequence that fills the interval from 0 to 1 evenly, together with those for the
  // other dimensions. (The generalized golden ratio; its solution of x^4 = x + 1.)
  static double evenly_spread(const std::size_t i, const int dimension)
  {
    constexpr double steps[] = {.8191725134, .6710436067, .5497004779};
    const double x = .5 + static_cast<double>(i) * steps[dimension];
    return x - std::floor(x);
  }

  // Which geometry a vote is on.
  const Viewed_surface& geometry(const std::size_t vote) const
  {
    return m_geometries[vote % m_geometries.size()];
  }

  // The number of parts of a vote, the same for a vote on each geometry.
  std::size_t number_of_parts_of_vote(const std::size_t vote,
                                      const std::size_t requested_number) const
  {
    const double step = m_is_number_given ? static_cast<double>(vote / 2 % 3) / 4 : 0;
    return static_cast<std::size_t>(
      std::lround((1 + step) * static_cast<double>(requested_number)));
  }

  // A vote counts more if it agrees with votes of other kinds: with another method, or on another
  // geometry. Those of the same kind make the same mistakes. The weights add up to 1.
  Eigen::VectorXd weights_of(const std::vector<Vote>& votes) const
  {
    constexpr double least_weight = .3;
    const auto kind = [this](const std::size_t vote) {
      return std::make_pair(vote < NUMBER_OF_SWEEPS,
                            (vote < NUMBER_OF_SWEEPS ? vote : vote - NUMBER_OF_SWEEPS)
                              % m_geometries.size());
    };
    Eigen::VectorXd result(static_cast<Eigen::Index>(votes.size()));
    for(std::size_t v = 0; v < votes.size(); ++v)
    {
      double sum = 0;
      std::size_t number = 0;
      for(std::size_t other = 0; other < votes.size(); ++other)
        if(kind(v) != kind(other))
        {
          sum += (std::max)(agreement(votes[v], votes[other]), 0.);
          ++number;
        }
      result[static_cast<Eigen::Index>(v)] = least_weight + sum / static_cast<double>(number);
    }
    return result / result.sum();
  }

  // On whether two points of the surface belong to the same part: 1 if the votes are the same, about 0
  // if it is chance. (Cohen's kappa.)
  double agreement(const Vote& a, const Vote& b) const
  {
    const auto size = [](const Vote& vote) {
      return static_cast<Eigen::Index>(
        *std::max_element(vote.part_of_patch.begin(), vote.part_of_patch.end()) + 1);
    };
    Eigen::MatrixXd common = Eigen::MatrixXd::Zero(size(a), size(b));
    for(std::size_t p = 0; p < a.part_of_patch.size(); ++p)
      common(static_cast<Eigen::Index>(a.part_of_patch[p]),
             static_cast<Eigen::Index>(b.part_of_patch[p]))
        += m_areas[static_cast<Eigen::Index>(p)];
    const double total = m_areas.sum() * m_areas.sum();
    const double of_a = common.rowwise().sum().squaredNorm() / total;
    const double of_b = common.colwise().sum().squaredNorm() / total;
    const double chance = of_a + of_b - 2 * of_a * of_b;
    return chance > 0 ? 1 - (of_a + of_b - 2 * common.squaredNorm() / total) / chance : 0;
  }

  std::vector<Vote> sweeps(const std::size_t number_of_parts, const unsigned int seed) const
  {
    constexpr double share_with_normals = .7;
    std::vector<std::size_t> first_faces;
    Random_numbers random(seed);
    for(std::size_t i = 0; i < NUMBER_OF_SWEEPS; ++i)
      first_faces.push_back(m_patches.centers[random.below(m_patches.size())]);
    std::vector<Vote> result(NUMBER_OF_SWEEPS);
    for_each_index(NUMBER_OF_SWEEPS, [&](const std::size_t i) {
      Boundary_preferences preferences;
      preferences.edge_concavity = .2 + .3 * evenly_spread(i, 0);
      const double w = evenly_spread(i, 2) / share_with_normals;
      preferences.patch_concavity = w < 1 ? .3 + .7 * w : 0;
      preferences.thickness_ratio = m_is_number_given || i / 2 % 2 == 0 ? .4 : 0;
      if(m_compares_poses)
        preferences.least_of_concavity = .3;
      if(m_compares_poses && m_has_limbs && i % 3 == 0) // intrinsic
      {
        preferences.edge_concavity = (std::numeric_limits<double>::max)();
        preferences.patch_concavity = 0;
      }
      const double exponent = m_is_number_given ? .45 : .6 + .2 * evenly_spread(i, 1);
      result[i] = sweep(geometry(i).graph, preferences, exponent,
                        number_of_parts_of_vote(i, number_of_parts), first_faces[i]);
    });
    return result;
  }

  Vote sweep(const Face_graph& graph, const Boundary_preferences& preferences,
             const double exponent, const std::size_t number_of_parts,
             const std::size_t first_face) const
  {
    const bool is_given = number_of_parts > 0;
    const Patches own
      = farthest_point_patches(graph, concave_lengths(graph, preferences.edge_concavity),
                               is_given ? PATCHES_OF_SWEEPS : PATCHES_FOR_NUMBER, first_face);
    const Sweep_partition parts = sweep_partition(
      m_compares_poses ? joint_patch_graph(own, preferences)
                       : patch_graph(graph, own, preferences, m_thickness_of_face),
      {exponent, m_is_number_given ? least_area(number_of_parts) : 0, is_given ? 0 : COST_LIMIT,
       are_coarse(own)},
      (std::max)(number_of_parts, std::size_t(1)), is_given ? number_of_parts : MOST_PARTS,
      is_given ? 0 : COST_LIMIT);
    return {largest_parts(graph, own, parts), parts.number_of_large_parts};
  }

  // Of a part. Around eyes or claws, cuts are cheap, and would be made instead of those between limbs.
  double least_area(const std::size_t number_of_parts) const
  {
    const double mean = 1 / static_cast<double>(number_of_parts);
    return m_has_limbs ? (std::min)(.035, .5 * mean) : (std::min)(.01, .2 * mean);
  }

  // With the larger cost of the geometries: what is concave in one of them only is a bent joint.
  Patch_graph joint_patch_graph(const Patches& patches,
                                const Boundary_preferences& preferences) const
  {
    Patch_graph result
      = patch_graph(m_geometries[0].graph, patches, preferences, m_thickness_of_face);
    const Patch_graph of_pose // with the same edges
      = patch_graph(m_geometries[1].graph, patches, preferences, m_thickness_of_face);
    result.areas = (result.areas + of_pose.areas) / 2;
    for(std::size_t e = 0; e < result.edges.size(); ++e)
    {
      Patch_graph::Edge& edge = result.edges[e];
      edge.cost = (std::max)(edge.cost, of_pose.edges[e].cost);
      edge.conductance = (std::max)(edge.conductance, of_pose.edges[e].conductance);
    }
    return result;
  }

  // The part that has the largest share of each of our patches.
  std::vector<std::size_t> largest_parts(const Face_graph& graph, const Patches& own,
                                         const Sweep_partition& parts) const
  {
    Eigen::MatrixXd shares
      = Eigen::MatrixXd::Zero(m_areas.size(), static_cast<Eigen::Index>(parts.number_of_parts));
    for(std::size_t f = 0; f < graph.number_of_faces(); ++f)
      shares(static_cast<Eigen::Index>(m_patches.patch_of_face[f]),
             static_cast<Eigen::Index>(parts.part_of_patch[own.patch_of_face[f]]))
        += graph.areas[static_cast<Eigen::Index>(f)];
    std::vector<std::size_t> result(m_patches.size());
    for(std::size_t p = 0; p < result.size(); ++p)
    {
      Eigen::Index largest;
      shares.row(static_cast<Eigen::Index>(p)).maxCoeff(&largest);
      result[p] = static_cast<std::size_t>(largest);
    }
    return result;
  }

  std::vector<Vote> sights(const std::size_t number_of_parts, const unsigned int seed) const
  {
    std::vector<Vote> result(NUMBER_OF_SIGHTS);
    for_each_index(NUMBER_OF_SIGHTS, [&](const std::size_t i) {
      const double step = static_cast<double>(i / 2) / (NUMBER_OF_SIGHTS / 2 - 1);
      Random_numbers random(seed + 1 + static_cast<unsigned int>(i));
      const std::size_t number = number_of_parts_of_vote(i, number_of_parts);
      result[i]
        = {spectral_clusters(affinities(geometry(i), .2 + .3 * step), m_areas, number, random),
           number};
    });
    return result;
  }

  // Large for patches that see each other, or are close to each other.
  static Eigen::MatrixXd affinities(const Viewed_surface& surface, const double range)
  {
    constexpr double nearby = .06, weight_of_nearby = .2;
    const auto gaussian = [&](const double scale) -> Eigen::ArrayXXd {
      return (-surface.distances.array().square() / (2 * scale * scale)).exp();
    };
    Eigen::MatrixXd result
      = surface.visibility.array() * gaussian(range) + weight_of_nearby * gaussian(nearby);
    result.diagonal().setZero();
    return result;
  }

  const std::vector<Viewed_surface>& m_geometries;
  const Patches& m_patches;
  const bool m_is_number_given, m_compares_poses, m_has_limbs;
  const Eigen::VectorXd m_areas;
  Eigen::VectorXd m_thickness_of_face;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_VOTES_H
