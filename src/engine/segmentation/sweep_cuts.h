// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_SWEEP_CUTS_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_SWEEP_CUTS_H

#include "Patch_graph.h"
#include "../linear_algebra/smallest_eigenpairs.h"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// What is preferred among the cuts of a set of patches.
struct Cut_preferences
{
  double exponent; // the cost of a cut is that of its boundary by this power of the smaller area: 0
                   // is the cheapest boundary, 1 the one of smallest conductance
  double least_area; // of both sides
  // A component has cuts only if one of at most this cost has a reason; 0: none is needed.
  double reason_limit = 0;
  // Patches are hardly larger than faces: contours that are as good as others may not run along edges,
  // so a contour is not compared to others.
  bool is_coarse = false;
};

// Splits a set of patches in two: the cheapest of the cuts along level sets of smooth functions,
// which are eigenvectors of the Laplacian of the set and heat kernels of the patches. (Sweep cuts
// are from F. Chung, "The heat kernel as the pagerank of a graph", PNAS 2007.)
class Sweep_cut
{
public:
  static constexpr double NONE = std::numeric_limits<double>::infinity();

  Sweep_cut(const Patch_graph& graph, const std::vector<std::size_t>& patches,
            const Cut_preferences& preferences)
    : m_size(static_cast<Eigen::Index>(patches.size())), m_preferences(preferences),
      m_has_reason(!(preferences.reason_limit > 0)), m_neighbors(patches.size()), m_areas(m_size),
      m_is_inside(patches.size())
  {
    if(m_size < 2)
      return;
    Eigen::MatrixXd laplacian = set_up(graph, patches);
    if(separate_components())
      return;
    const Eigen::VectorXd scale = m_areas.cwiseSqrt().cwiseInverse();
    const std::optional<Eigenpairs> pairs
      = smallest_eigenpairs(scale.asDiagonal() * laplacian * scale.asDiagonal(), RELEVANT_PAIRS);
    if(!pairs)
      return;
    sweep_functions(pairs->values, scale.asDiagonal() * pairs->vectors);
  }

  // NONE if there is no cut, 0 if the set is not connected. Components may be smaller than the least
  // area.
  double cost() const { return m_has_reason ? m_cost : NONE; }

  const Cut_preferences& preferences() const { return m_preferences; }

  // Whether each patch of the set is on the first side.
  const std::vector<bool>& is_on_first_side() const { return m_is_on_first_side; }

private:
  struct Neighbor
  {
    std::size_t patch;
    double cost, shape_cost, length; // of the boundary
  };

  // The boundary of the first patches of a sweep.
  struct Contour
  {
    double area; // of the patches
    double cost, shape_cost, length;
  };

  // The other eigenvectors of the Laplacian have hardly an effect on heat kernels.
  static constexpr Eigen::Index RELEVANT_PAIRS = 60;

  Eigen::MatrixXd set_up(const Patch_graph& graph, const std::vector<std::size_t>& patches)
  {
    const std::size_t outside = patches.size();
    std::vector<std::size_t> index(static_cast<std::size_t>(graph.areas.size()), outside);
    for(std::size_t i = 0; i < patches.size(); ++i)
    {
      index[patches[i]] = i;
      m_areas[static_cast<Eigen::Index>(i)] = graph.areas[static_cast<Eigen::Index>(patches[i])];
    }
    Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(m_size, m_size);
    for(const Patch_graph::Edge& edge : graph.edges)
    {
      const std::size_t a = index[edge.a], b = index[edge.b];
      if(a == outside || b == outside)
        continue;
      m_neighbors[a].push_back({b, edge.cost, edge.shape_cost, edge.length});
      m_neighbors[b].push_back({a, edge.cost, edge.shape_cost, edge.length});
      const auto i = static_cast<Eigen::Index>(a), j = static_cast<Eigen::Index>(b);
      laplacian(i, i) += edge.conductance;
      laplacian(j, j) += edge.conductance;
      laplacian(i, j) -= edge.conductance;
      laplacian(j, i) -= edge.conductance;
    }
    return laplacian;
  }

  // The component of the first patch, if it is not the whole set.
  bool separate_components()
  {
    std::vector<bool> is_reached(m_neighbors.size(), false);
    std::vector<std::size_t> reached(1, 0);
    is_reached[0] = true;
    for(std::size_t i = 0; i < reached.size(); ++i)
      for(const Neighbor& neighbor : m_neighbors[reached[i]])
        if(!is_reached[neighbor.patch])
        {
          is_reached[neighbor.patch] = true;
          reached.push_back(neighbor.patch);
        }
    if(reached.size() == m_neighbors.size())
      return false;
    m_cost = 0;
    m_has_reason = true;
    m_is_on_first_side = std::move(is_reached);
    return true;
  }

  // `functions`: eigenvectors, orthonormal with respect to areas.
  void sweep_functions(const Eigen::VectorXd& eigenvalues, const Eigen::MatrixXd& functions)
  {
    constexpr Eigen::Index number_of_eigenvectors = 6, number_of_sources = 80;
    constexpr double times[] = {.3, 1, 3}; // by the inverse of the smallest positive eigenvalue
    constexpr double least_eigenvalue = 1e-12;
    for(Eigen::Index k = 1; k < (std::min)(m_size, number_of_eigenvectors + 1); ++k)
      sweep(functions.col(k));
    // Patches are sorted such that the first ones are spread over the set.
    const auto sources = functions.topRows((std::min)(m_size, number_of_sources)).transpose();
    for(const double time : times)
    {
      const double scale = time / (std::max)(eigenvalues[1], least_eigenvalue);
      const Eigen::MatrixXd kernels
        = functions * (-scale * eigenvalues.array()).exp().matrix().asDiagonal() * sources;
      for(Eigen::Index k = 0; k < kernels.cols(); ++k)
        sweep(kernels.col(k));
    }
  }

  void sweep(const Eigen::Ref<const Eigen::VectorXd>& function)
  {
    constexpr double improvement = 1e-9; // that is no rounding error
    m_order.resize(m_is_inside.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t(0));
    std::sort(m_order.begin(), m_order.end(), [&](const std::size_t a, const std::size_t b) {
      const double x = function[static_cast<Eigen::Index>(a)];
      const double y = function[static_cast<Eigen::Index>(b)];
      return x != y ? x < y : a < b;
    });
    measure_contours();
    const double total = m_areas.sum();
    const double longest
      = m_cost * std::pow(total / 2, m_preferences.exponent); // of a cut that is cheaper
    double cost = NONE;
    std::size_t best = 0;
    for(std::size_t i = 0; i + 1 < m_contours.size(); ++i)
    {
      const Contour& contour = m_contours[i];
      const double smaller = (std::min)(contour.area, (std::max)(total - contour.area, 1e-15));
      if((contour.cost > longest && m_has_reason) || smaller < m_preferences.least_area)
        continue;
      const double c = (std::max)(contour.cost, 0.) / std::pow(smaller, m_preferences.exponent);
      m_has_reason = m_has_reason || (c <= m_preferences.reason_limit && has_reason(i));
      if(c < cost)
      {
        cost = c;
        best = i;
      }
    }
    if(!(cost < (1 - improvement) * m_cost))
      return;
    m_cost = cost;
    m_is_on_first_side.assign(m_order.size(), false);
    for(std::size_t i = 0; i <= best; ++i)
      m_is_on_first_side[m_order[i]] = true;
  }

  void measure_contours()
  {
    std::fill(m_is_inside.begin(), m_is_inside.end(), false);
    m_contours.clear();
    Contour contour = {0, 0, 0, 0};
    for(const std::size_t patch : m_order)
    {
      m_is_inside[patch] = true;
      contour.area += m_areas[static_cast<Eigen::Index>(patch)];
      for(const Neighbor& neighbor : m_neighbors[patch])
      {
        const bool is_removed = m_is_inside[neighbor.patch];
        contour.cost += is_removed ? -neighbor.cost : neighbor.cost;
        contour.shape_cost += is_removed ? -neighbor.shape_cost : neighbor.shape_cost;
        contour.length += is_removed ? -neighbor.length : neighbor.length;
      }
      m_contours.push_back(contour);
    }
  }

  // Whether a contour runs along what is concave, or is much cheaper than all contours beside it, on
  // both sides: not so anywhere along a bar, where one cut is as good as the next. The thickness is no
  // reason: it differs at the end of a bar.
  bool has_reason(const std::size_t i) const
  {
    constexpr double most_of_length = .85, least_contrast = 2;
    constexpr double width = .3, least_number_of_patches = 8; // of the bands beside the contour
    const Contour& own = m_contours[i];
    if(own.shape_cost <= most_of_length * own.length)
      return true;
    if(m_preferences.is_coarse)
      return false;
    const double total = m_contours.back().area;
    const double band = (std::max)(width * own.length * own.length,
                                   least_number_of_patches * total / static_cast<double>(m_size));
    if((std::min)(own.area, total - own.area) < band)
      return false;
    return std::none_of(m_contours.begin(), m_contours.end(), [&](const Contour& other) {
      return &other != &own && std::abs(other.area - own.area) <= band
             && other.shape_cost < least_contrast * own.shape_cost;
    });
  }

  Eigen::Index m_size;
  Cut_preferences m_preferences;
  bool m_has_reason;
  std::vector<std::vector<Neighbor>> m_neighbors;
  Eigen::VectorXd m_areas;
  double m_cost = NONE;
  std::vector<bool> m_is_on_first_side;
  std::vector<bool> m_is_inside; // of the current sweep, as the next one
  std::vector<std::size_t> m_order;
  std::vector<Contour> m_contours;
};

// The splits of a set of patches.
struct Sweep_partition
{
  std::size_t number_of_parts = 1;
  // Without those that were smaller than the least area when they were split off: the components of
  // the sides of a cut may be small, and they may not be connected.
  std::size_t number_of_large_parts = 1;
  std::vector<std::size_t> part_of_patch;
  // Split i divides part `parent[i]`; its second side becomes part i + 1.
  std::vector<std::size_t> parents;
  std::vector<double> costs;
};

// Splits the part with the cheapest cut until there are as many large parts, and further as long as
// the cost is at most `cost_limit`. `result`: the splits that have been made, if any.
inline Sweep_partition sweep_partition(const Patch_graph& graph, const Cut_preferences& preferences,
                                       const std::size_t least_number_of_parts,
                                       const std::size_t most_number_of_parts,
                                       const double cost_limit, Sweep_partition result = {})
{
  result.part_of_patch.resize(static_cast<std::size_t>(graph.areas.size()), 0);
  std::vector<std::vector<std::size_t>> parts(result.number_of_parts);
  for(std::size_t p = 0; p < result.part_of_patch.size(); ++p)
    parts[result.part_of_patch[p]].push_back(p);
  std::vector<Sweep_cut> cuts;
  for(const std::vector<std::size_t>& part : parts)
    cuts.emplace_back(graph, part, preferences);
  const auto area = [&graph](const std::vector<std::size_t>& patches) {
    double sum = 0;
    for(const std::size_t patch : patches)
      sum += graph.areas[static_cast<Eigen::Index>(patch)];
    return sum;
  };
  while(result.number_of_large_parts < most_number_of_parts)
  {
    const auto cheapest
      = std::min_element(cuts.begin(), cuts.end(), [](const Sweep_cut& a, const Sweep_cut& b) {
          return a.cost() < b.cost();
        });
    const double cost = cheapest->cost();
    if(cost == Sweep_cut::NONE
       || (result.number_of_large_parts >= least_number_of_parts && cost > cost_limit))
      break;
    const auto parent = static_cast<std::size_t>(cheapest - cuts.begin());
    const std::vector<std::size_t> whole = std::move(parts[parent]);
    parts[parent].clear();
    parts.emplace_back();
    for(std::size_t i = 0; i < whole.size(); ++i)
    {
      const bool is_first = cheapest->is_on_first_side()[i];
      (is_first ? parts[parent] : parts.back()).push_back(whole[i]);
      if(!is_first)
        result.part_of_patch[whole[i]] = parts.size() - 1;
    }
    if((std::min)(area(parts[parent]), area(parts.back())) >= preferences.least_area)
      ++result.number_of_large_parts;
    result.parents.push_back(parent);
    result.costs.push_back(cost);
    Cut_preferences of_sides = cheapest->preferences();
    if(cost > 0) // sides of a cut are no components
      of_sides.reason_limit = 0;
    cuts[parent] = Sweep_cut(graph, parts[parent], of_sides);
    cuts.emplace_back(graph, parts.back(), of_sides);
  }
  result.number_of_parts = parts.size();
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_SWEEP_CUTS_H
