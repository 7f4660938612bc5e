// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "limb_pairs.h"

#include <Eigen/Core>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

// The shares of the area in rings around each extremity, a column each.
Eigen::MatrixXd areas_of_rings(const Eigen::MatrixXd& distances, const Eigen::VectorXd& shares)
{
  constexpr Eigen::Index number = 8;
  constexpr double width = .05;
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(number, distances.cols());
  for(Eigen::Index i = 0; i < distances.cols(); ++i)
    for(Eigen::Index v = 0; v < distances.rows(); ++v)
      if(const double ring = distances(v, i) / width; ring < static_cast<double>(number))
        result(static_cast<Eigen::Index>(ring), i) += shares[v];
  return result;
}

// How much a map of the extremities that exchanges pairs changes their distances and the areas around them.
class Exchange_cost
{
public:
  Exchange_cost(const Eigen::MatrixXd& between, const Eigen::MatrixXd& rings)
    : m_between(between), m_differences(between.rows(), between.cols())
  {
    for(Eigen::Index i = 0; i < between.rows(); ++i)
      for(Eigen::Index j = 0; j < between.cols(); ++j)
        m_differences(i, j)
          = (rings.col(i) - rings.col(j)).cwiseAbs().sum()
            / (std::max)((rings.col(i) + rings.col(j)).sum(), (std::numeric_limits<double>::min)());
  }

  double operator()(const std::vector<Eigen::Index>& image) const
  {
    double change = 0, difference = 0;
    for(Eigen::Index i = 0; i < m_between.rows(); ++i)
    {
      const Eigen::Index k = image[static_cast<std::size_t>(i)];
      difference += m_differences(i, k);
      for(Eigen::Index j = 0; j < m_between.cols(); ++j)
        change += std::abs(m_between(i, j) - m_between(k, image[static_cast<std::size_t>(j)]));
    }
    return change / m_between.sum() + difference / 4;
  }

private:
  const Eigen::MatrixXd& m_between;
  Eigen::MatrixXd m_differences;
};

// The best exchange of two pairs.
std::vector<Eigen::Index> best_exchange(const Exchange_cost& cost, const Eigen::Index n)
{
  std::vector<Eigen::Index> best, image(static_cast<std::size_t>(n));
  double least = (std::numeric_limits<double>::infinity)();
  const auto exchange = [&](const Eigen::Index a, const Eigen::Index b) {
    std::swap(image[static_cast<std::size_t>(a)], image[static_cast<std::size_t>(b)]);
  };
  std::iota(image.begin(), image.end(), Eigen::Index(0));
  for(Eigen::Index a = 0; a < n; ++a)
    for(Eigen::Index b = a + 1; b < n; ++b)
      for(Eigen::Index c = a + 1; c < n; ++c)
        for(Eigen::Index d = c + 1; d < n; ++d)
        {
          if(c == b || d == b)
            continue;
          exchange(a, b);
          exchange(c, d);
          if(const double value = cost(image); value < least)
          {
            least = value;
            best = image;
          }
          exchange(a, b);
          exchange(c, d);
        }
  return best;
}

// The area around the tip of a limb.
double area_around(const Eigen::Ref<const Eigen::VectorXd>& distances,
                   const Eigen::VectorXd& shares)
{
  constexpr double radius = .3;
  double area = 0;
  for(Eigen::Index v = 0; v < shares.size(); ++v)
    if(distances[v] < radius)
      area += shares[v];
  return area;
}

// Heads have more details than tails, such as ears, and a larger area.
double likelihood_of_head(const Extremity& limb, const Eigen::Ref<const Eigen::VectorXd>& distances,
                          const std::vector<Extremity>& details, const Eigen::VectorXd& shares)
{
  constexpr double radius_of_details = .4, weight_of_details = 20, least_prominence = .005;
  double prominence = 0;
  for(const Extremity& detail : details)
    if(detail.vertex != limb.vertex && detail.prominence > least_prominence
       && distances[static_cast<Eigen::Index>(detail.vertex)] < radius_of_details)
      prominence += detail.prominence;
  return area_around(distances, shares) * (1 + weight_of_details * prominence);
}

} // namespace

Limb_pairs limb_pairs(const std::vector<Extremity>& limbs, const std::vector<Extremity>& details,
                      const Eigen::MatrixXd& distances, const Eigen::VectorXd& shares)
{
  const auto n = static_cast<Eigen::Index>(limbs.size());
  if(n < 5 || n > 6)
    throw std::invalid_argument("no head and four limbs were found, but "
                                + std::to_string(limbs.size())
                                + (limbs.size() == 1 ? " part that sticks" : " parts that stick")
                                + " out, where persons have 5 and animals with a tail 6");
  Eigen::MatrixXd between(n, n);
  for(Eigen::Index i = 0; i < n; ++i)
    between.row(i)
      = distances.row(static_cast<Eigen::Index>(limbs[static_cast<std::size_t>(i)].vertex));
  between = ((between + between.transpose()) / 2).eval();
  const Eigen::MatrixXd rings = areas_of_rings(distances, shares);
  const std::vector<Eigen::Index> image = best_exchange(Exchange_cost(between, rings), n);

  std::vector<std::array<std::size_t, 2>> pairs;
  std::vector<std::size_t> single;
  for(std::size_t i = 0; i < image.size(); ++i)
    if(const auto other = static_cast<std::size_t>(image[i]); other == i)
      single.push_back(i);
    else if(other > i)
      pairs.push_back({i, other});
  Limb_pairs result;
  const auto likelihood = [&](const std::size_t i) {
    return likelihood_of_head(limbs[i], distances.col(static_cast<Eigen::Index>(i)), details,
                              shares);
  };
  result.head = *std::max_element(
    single.begin(), single.end(),
    [&](const std::size_t a, const std::size_t b) { return likelihood(a) < likelihood(b); });
  // A head has 1.7 to three and a half times the area of a limb, or details; fingers are all alike, and the back of a chair is
  // larger.
  constexpr double least_head = 1.65, largest_head = 4.5;
  const auto area = [&](const std::size_t i) {
    return area_around(distances.col(static_cast<Eigen::Index>(i)), shares);
  };
  const double mean_area
    = (area(pairs[0][0]) + area(pairs[0][1]) + area(pairs[1][0]) + area(pairs[1][1])) / 4;
  if(!(likelihood(result.head) >= least_head * mean_area))
    throw std::invalid_argument("no head and four limbs were found, but limbs that are all alike");
  if(!(area(result.head) <= largest_head * mean_area))
    throw std::invalid_argument(
      "no head and four limbs were found, but four limbs and a part that is larger than a head");
  const auto to_head = [&](const std::array<std::size_t, 2>& pair) {
    const auto head = static_cast<Eigen::Index>(result.head);
    return between(static_cast<Eigen::Index>(pair[0]), head)
           + between(static_cast<Eigen::Index>(pair[1]), head);
  };
  const bool is_first = to_head(pairs[0]) <= to_head(pairs[1]);
  result.arms = pairs[is_first ? 0 : 1];
  result.legs = pairs[is_first ? 1 : 0];
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
