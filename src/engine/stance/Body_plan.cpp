// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Body_plan.h"
#include "extremities.h"
#include "limb_pairs.h"
#include "relief_in_front.h"
#include "../surface/root_of_area.h"
#include "../target/aligning_motion.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <CGAL/number_type_config.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

// The prominent extremities, but only one of those that are close to each other, such as the ears. `distances`: a column for
// each of them.
std::vector<std::size_t> without_neighbors(const std::vector<Extremity>& extremities,
                                           const Eigen::MatrixXd& distances)
{
  constexpr double least_distance = .41; // by the median
  const auto between = [&](const std::size_t i, const std::size_t j) {
    return distances(static_cast<Eigen::Index>(extremities[i].vertex),
                     static_cast<Eigen::Index>(j));
  };
  std::vector<double> all;
  for(std::size_t i = 0; i < extremities.size(); ++i)
    for(std::size_t j = i + 1; j < extremities.size(); ++j)
      all.push_back(between(i, j));
  if(all.empty())
    return {};
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < extremities.size(); ++i)
    if(std::none_of(result.begin(), result.end(),
                    [&](const std::size_t j) { return between(i, j) < least_distance * *middle; }))
      result.push_back(i);
  return result;
}

// The area of a ring, by its width: the girth.
double girth_at(const Eigen::VectorXd& distances, const Eigen::VectorXd& shares,
                const double distance)
{
  constexpr double width = .04;
  double area = 0;
  for(Eigen::Index v = 0; v < distances.size(); ++v)
    if(std::abs(distances[v] - distance) <= width)
      area += shares[v];
  return area / (2 * width);
}

// Where a limb ends at the trunk: where its girth exceeds that before, by the median, by a factor.
double distance_of_root(const Eigen::VectorXd& distances, const Eigen::VectorXd& shares,
                        const double factor = 2)
{
  constexpr double step = .02, first = .06, least = .2, largest = 1.6;
  std::vector<double> girths;
  for(double distance = first; distance < largest; distance += step)
  {
    const double value = girth_at(distances, shares, distance);
    girths.push_back(value);
    if(distance < least)
      continue;
    std::vector<double> sorted = girths;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    if(value > factor * *middle)
      return distance;
  }
  return largest;
}

// Where hands, feet or the tip of a tail begin: where the limbs are thinnest.
void set_ends(const std::vector<Limb*>& limbs, const Eigen::VectorXd& shares)
{
  constexpr double step = .02, first = .12, last = .36;
  const double root = (limbs.front()->root + limbs.back()->root) / 2,
               least = (std::min)(first, .3 * root),
               largest = (std::max)((std::min)(last, .5 * root), 1.2 * least);
  double end = least, smallest = (std::numeric_limits<double>::infinity)();
  for(double distance = least; distance < largest; distance += step)
  {
    double girths = 0;
    for(const Limb* const limb : limbs)
      girths += girth_at(limb->distances, shares, distance);
    if(girths < smallest)
    {
      smallest = girths;
      end = distance;
    }
  }
  for(Limb* const limb : limbs)
    limb->end = end;
}

// The neck, from the head to the trunk: from where its girth is least between larger ones, to where it exceeds that by far.
std::pair<double, double> distances_of_neck(const Limb& head, const Eigen::VectorXd& shares,
                                            const bool is_person)
{
  constexpr double step = .02, first = .1, reach = .3, factor = 1.6;
  const double last = is_person ? .36 : .6, without = is_person ? .24 : .36;
  std::vector<double> girths;
  for(double distance = first; distance <= last + reach; distance += step)
    girths.push_back(girth_at(head.distances, shares, distance));
  const auto length = static_cast<std::size_t>(reach / step),
             number = static_cast<std::size_t>((last - first) / step);
  const auto at = [&](const std::size_t i) { return first + step * static_cast<double>(i); };
  std::size_t end = static_cast<std::size_t>((without - first) / step);
  double largest = 1, before = girths[0];
  for(std::size_t i = 1; i < number; ++i)
  {
    before = (std::max)(before, girths[i]);
    const auto next = girths.begin() + static_cast<std::ptrdiff_t>(i);
    const double after = *std::max_element(next, next + static_cast<std::ptrdiff_t>(length)),
                 ratio = (std::min)(before, after) / girths[i];
    if(ratio > largest)
    {
      largest = ratio;
      end = i;
    }
  }
  std::size_t root = end + 2;
  while(root < end + length && root + 1 < girths.size() && girths[root] < factor * girths[end])
    ++root;
  return {at(end), at(root)};
}

} // namespace

Body_plan::Body_plan(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                     const Point_matrix& pose, const Measure_distances& measure)
  : m_triangles(surface.triangles), m_unit(root_of_area(pose, surface.triangles)),
    m_unit_of_rest(root_of_area(surface.points, surface.triangles)),
    m_rest(surface.points / m_unit_of_rest), m_pose(pose / m_unit),
    m_shares(vertex_area_shares(pose, surface.triangles))
{
  m_shares /= m_shares.sum();
  find_limbs(coarse, measure);
  set_joints();
  check_proportions();
  set_frames(surface, coarse, measure);
}

double Body_plan::girth(const Limb& limb, const double distance) const
{
  return girth_at(limb.distances, m_shares, distance);
}

Eigen::RowVector3d Body_plan::center(const Point_matrix& points, const Limb& limb,
                                     const double distance, double width) const
{
  for(;; width *= 2)
  {
    double sum = 0;
    Eigen::RowVector3d result = Eigen::RowVector3d::Zero();
    for(Eigen::Index v = 0; v < points.rows(); ++v)
      if(std::abs(limb.distances[v] - distance) <= width)
      {
        sum += m_shares[v];
        result += m_shares[v] * points.row(v);
      }
    if(sum > 0)
      return result / sum;
  }
}

Eigen::RowVector3d Body_plan::end_joint(const Point_matrix& points, const Limb& limb) const
{
  constexpr double width = .05, largest_share = .15;
  const double length = limb.root - limb.end, to_first = (std::min)(width, largest_share * length),
               to_second = length / 2;
  const Eigen::RowVector3d first = center(points, limb, limb.end + to_first),
                           second = center(points, limb, limb.end + to_second);
  return first + to_first / (to_second - to_first) * (first - second);
}

Eigen::Quaterniond Body_plan::rotation_to_rest(const Point_matrix& points, const Limb& limb,
                                               const double distance) const
{
  constexpr double width = .05;
  std::vector<Eigen::Index> ring;
  for(Eigen::Index v = 0; v < limb.distances.size(); ++v)
    if(std::abs(limb.distances[v] - distance) <= width)
      ring.push_back(v);
  const Eigen::VectorXd shares = m_shares(ring);
  if(!(shares.sum() > 0))
    return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(
    aligning_motion(points(ring, Eigen::all), m_rest(ring, Eigen::all), shares).linear());
}

bool Body_plan::is_like(const Limb& limb, const Limb& other) const
{
  const double largest_ratio = m_kind == Skeleton_3::Kind::PERSON ? 1.17 : 1.8;
  const Eigen::VectorXd shares = vertex_area_shares(m_rest, m_triangles);
  const auto area = [&](const Limb& of) {
    return (of.distances.array() < of.root).select(shares.array(), 0).sum();
  };
  const double one = area(limb), two = area(other);
  return (std::max)(one, two) <= largest_ratio * (std::min)(one, two);
}

std::vector<double> Body_plan::stretches_of_rest(
  const Point_matrix& points, const std::vector<Eigen::Vector3d>& directions,
  const Eigen::VectorXd& values, const std::function<std::size_t(double mean)>& group_of) const
{
  constexpr double largest_projection = 1.01, largest_stretch = 4;
  const std::size_t number = directions.size();
  std::vector<double> sums(number, 0), weights(number, 0);
  for(const auto& t : m_triangles)
  {
    const std::array<Eigen::Index, 3> v
      = {static_cast<Eigen::Index>(t[0]), static_cast<Eigen::Index>(t[1]),
         static_cast<Eigen::Index>(t[2])};
    const std::size_t k = group_of((values[v[0]] + values[v[1]] + values[v[2]]) / 3);
    if(k >= number)
      continue;
    const auto edges_of = [&](const Point_matrix& corners) {
      Eigen::Matrix<double, 3, 2> edges;
      edges << (corners.row(v[1]) - corners.row(v[0])).transpose(),
        (corners.row(v[2]) - corners.row(v[0])).transpose();
      return edges;
    };
    const Eigen::Matrix<double, 3, 2> edges = edges_of(points);
    const Eigen::Matrix2d products = edges.transpose() * edges;
    const double area = std::sqrt(products.determinant());
    if(!(area > 0))
      continue;
    const Eigen::Vector2d in_plane = products.inverse() * (edges.transpose() * directions[k]);
    const double along = (edges * in_plane).norm();
    if(!(along <= largest_projection)) // of a needle
      continue;
    sums[k]
      += area * along * (std::min)((edges_of(m_rest) * in_plane).norm(), largest_stretch * along);
    weights[k] += area * along * along;
  }
  for(std::size_t k = 0; k < number; ++k)
    sums[k] = weights[k] > 0 ? sums[k] / weights[k] * m_unit_of_rest / m_unit : 1;
  return sums;
}

void Body_plan::find_limbs(const Coarse_surface_3& coarse, const Measure_distances& measure)
{
  constexpr double least_prominence = .15;
  constexpr std::size_t most_limbs = 16;
  const Surface_component_3 posed = coarse.posed(m_pose);
  const std::vector<Extremity> all = extremities(posed, measure(posed, {}));
  std::vector<Extremity> limbs;
  for(const Extremity& extremity : all)
    if(extremity.prominence > least_prominence && limbs.size() < most_limbs)
      limbs.push_back(extremity);
  std::vector<std::size_t> tips;
  for(const Extremity& limb : limbs)
    tips.push_back(limb.vertex);
  Eigen::MatrixXd distances = measure(posed, tips).distances;
  const std::vector<std::size_t> kept = without_neighbors(limbs, distances);
  Eigen::MatrixXd distances_of_kept(distances.rows(), static_cast<Eigen::Index>(kept.size()));
  std::vector<Extremity> kept_limbs;
  for(std::size_t i = 0; i < kept.size(); ++i)
  {
    kept_limbs.push_back(limbs[kept[i]]);
    distances_of_kept.col(static_cast<Eigen::Index>(i))
      = distances.col(static_cast<Eigen::Index>(kept[i]));
  }
  Eigen::VectorXd shares = vertex_area_shares(posed.points, posed.triangles);
  shares /= shares.sum();
  const Limb_pairs pairs = limb_pairs(kept_limbs, all, distances_of_kept, shares);
  const auto limb = [&](const std::size_t i) {
    Limb result;
    result.distances
      = coarse.interpolated(Eigen::VectorXd(distances_of_kept.col(static_cast<Eigen::Index>(i))));
    result.tip = coarse.vertices[kept_limbs[i].vertex];
    result.root = distance_of_root(result.distances, m_shares);
    return result;
  };
  m_limbs = {limb(pairs.arms[0]), limb(pairs.arms[1]), limb(pairs.legs[0]), limb(pairs.legs[1])};
  for(std::size_t i = 0; i < kept.size(); ++i)
    if(i != pairs.arms[0] && i != pairs.arms[1] && i != pairs.legs[0] && i != pairs.legs[1])
      m_others.insert(i == pairs.head ? m_others.begin() : m_others.end(), limb(i));
}

// From between the joints of the legs to between those of the arms.
void Body_plan::set_trunk()
{
  m_origin = (joint(m_limbs[2]) + joint(m_limbs[3])) / 2;
  m_axis = (joint(m_limbs[0]) + joint(m_limbs[1])) / 2 - m_origin;
  m_length_of_trunk = m_axis.norm();
  m_axis /= m_length_of_trunk;
}

// To the first limb of a pair from the second one, orthogonal to the trunk.
Eigen::RowVector3d Body_plan::direction_across(const std::size_t pair) const
{
  const auto ends = [&](const Limb& limb) -> Eigen::RowVector3d {
    return m_pose.row(static_cast<Eigen::Index>(limb.tip)) + joint(limb);
  };
  return orthogonal_to_trunk(ends(m_limbs[2 * pair]) - ends(m_limbs[2 * pair + 1]));
}

// The way from one tip of a pair to the other leads past both joints. Those of a person are as far from the other limbs and the head as
// their partners, whatever the lengths of limbs are. Those of an animal are above its thighs, which are thicker than the rest of its legs.
void Body_plan::set_joints()
{
  constexpr double least_cosine = .6, length_of_legs = .97, length_with_thighs = .95;
  const auto between = [&](const Limb& limb, const Limb& other) {
    return (limb.distances[static_cast<Eigen::Index>(other.tip)]
            + other.distances[static_cast<Eigen::Index>(limb.tip)])
           / 2;
  };
  for(const std::size_t i : {0, 2})
  {
    Limb &limb = m_limbs[i], &other = m_limbs[i + 1];
    limb.root = other.root = (std::min)((limb.root + other.root) / 2, between(limb, other) / 2);
  }
  set_trunk();
  // The canonical pose of a person is twisted: its four limbs are as long as the trunk, and keep away from each other.
  m_kind = std::abs(direction_across(0).dot(direction_across(1))) < least_cosine
             ? Skeleton_3::Kind::PERSON
             : Skeleton_3::Kind::FOUR_LEGGED;
  if(m_kind == Skeleton_3::Kind::PERSON)
  {
    for(const std::size_t i : {2, 3})
      m_limbs[i].root = length_of_legs * between(m_limbs[2], m_limbs[3]) / 2;
    for(const std::size_t i : {0, 2})
    {
      Limb &limb = m_limbs[i], &other = m_limbs[i + 1];
      double longer = between(limb, head()) - between(other, head());
      for(const std::size_t j : {2 - i, 3 - i})
        longer += between(limb, m_limbs[j]) - between(other, m_limbs[j]);
      longer = std::clamp(longer / 3, -limb.root, limb.root);
      limb.root += longer / 2;
      other.root -= longer / 2;
    }
    set_trunk();
  }
  else
  {
    for(const std::size_t i : {0, 2})
      m_limbs[i].root = m_limbs[i + 1].root
        = (std::max)(m_limbs[i].root, length_with_thighs * between(m_limbs[i], m_limbs[i + 1]) / 2);
    set_trunk();
  }
  for(const std::size_t i : {0, 2})
    set_ends({&m_limbs[i], &m_limbs[i + 1]}, m_shares);
  constexpr double factor_of_tail = 1.6, least_length_of_neck = .08;
  Limb& head = m_others[0];
  const bool is_person = m_kind == Skeleton_3::Kind::PERSON;
  std::tie(head.end, head.root) = distances_of_neck(head, m_shares, is_person);
  if(is_person)
    head.root = (std::max)(head.root, head.end + least_length_of_neck);
  else // the neck ends before the legs
  {
    for(std::size_t i = 0; i < 2; ++i)
      for(Eigen::Index v = 0; v < head.distances.size(); ++v)
        if(share_of_limb(m_limbs[i], v) > .5)
          head.root = (std::min)(head.root, head.distances[v]);
    head.end = (std::min)(head.end, head.root - least_length_of_neck);
  }
  for(std::size_t i = 1; i < m_others.size(); ++i)
  {
    m_others[i].root = distance_of_root(m_others[i].distances, m_shares, factor_of_tail);
    set_ends({&m_others[i]}, m_shares);
  }
}

// Limbs are longer than the way around them. Fingers have no trunk between them, and the back of a chair is flat.
void Body_plan::check_proportions() const
{
  const bool is_person = m_kind == Skeleton_3::Kind::PERSON;
  const double largest_girth = is_person ? .7 : .9; // of the length of a limb
  const double least_trunk = is_person ? .15 : .3;
  constexpr double radius_of_head = .3, least_depth = .62; // of the width
  const auto refuse_if = [](const bool condition, const std::string& found) {
    if(condition)
      throw std::invalid_argument("no head and four limbs were found, but " + found);
  };
  double sum = 0;
  for(const Limb& limb : m_limbs)
    sum += girth(limb, (limb.end + limb.root) / 2) / limb.root;
  refuse_if(!(sum / 4 <= largest_girth), "limbs that are thicker than long");
  refuse_if(!(m_length_of_trunk >= least_trunk), "limbs without a trunk between them");
  const Principal_axes axes(
    m_pose, (head().distances.array() < radius_of_head).select(m_shares.array(), 0).matrix());
  refuse_if(!(axes.variances[2] >= least_depth * least_depth * axes.variances[1]),
            "four limbs and a part that is flat");
}

std::size_t Body_plan::nose() const
{
  constexpr double largest_distance = .03; // from the plane between left and right
  const double angle = 40 * CGAL_PI / 180;
  const Eigen::RowVector3d neck = center(m_pose, head(), head().end),
                           along = (neck - center(m_pose, head(), head().root)).normalized(),
                           up = m_frames[0].row(1),
                           down = (up.dot(along) * along - up).normalized(),
                           direction = std::cos(angle) * along + std::sin(angle) * down;
  std::size_t result = head().tip;
  double farthest = 0;
  for(Eigen::Index v = 0; v < m_pose.rows(); ++v)
  {
    const Eigen::RowVector3d from_neck = m_pose.row(v) - neck;
    if(head().distances[v] < head().end && from_neck.dot(direction) > farthest
       && std::abs(m_frames[0].row(0).dot(from_neck)) < largest_distance)
    {
      farthest = from_neck.dot(direction);
      result = static_cast<std::size_t>(v);
    }
  }
  return result;
}

// Whether the first leg is on the side of the second arm: the way along the surface of the input is shorter on the same side.
bool Body_plan::are_legs_on_other_sides(const Coarse_surface_3& coarse,
                                        const Measure_distances& measure) const
{
  constexpr double width = .03;
  constexpr std::size_t most_sources = 12;
  Surface_component_3 rest = coarse.surface;
  rest.points /= m_unit_of_rest;
  const auto ring = [&](const Limb& limb, const double distance) {
    for(double w = width;; w *= 2)
    {
      std::vector<std::size_t> result;
      for(std::size_t i = 0; i < coarse.vertices.size(); ++i)
        if(std::abs(limb.distances[static_cast<Eigen::Index>(coarse.vertices[i])] - distance) <= w)
          result.push_back(i);
      if(!result.empty())
        return result;
    }
  };
  std::vector<std::size_t> sources;
  std::array<std::size_t, 3> first = {0, 0, 0};
  for(std::size_t arm = 0; arm < 2; ++arm)
  {
    const std::vector<std::size_t> all = ring(m_limbs[arm], m_limbs[arm].root);
    const std::size_t step = all.size() / most_sources + 1;
    for(std::size_t i = 0; i < all.size(); i += step)
      sources.push_back(all[i]);
    first[arm + 1] = sources.size();
  }
  const Eigen::MatrixXd distances = measure(rest, sources).distances;
  const auto mean = [&](const std::size_t arm, const std::size_t leg) {
    const std::vector<std::size_t> targets = ring(m_limbs[leg], m_limbs[leg].root - width);
    double sum = 0;
    for(const std::size_t v : targets)
      sum += distances
               .block(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(first[arm]), 1,
                      static_cast<Eigen::Index>(first[arm + 1] - first[arm]))
               .minCoeff();
    return sum / static_cast<double>(targets.size());
  };
  return mean(0, 3) + mean(1, 2) < mean(0, 2) + mean(1, 3);
}

// From the ankle in the input, relative to the shin, as it is in the pose.
Eigen::Vector3d Body_plan::direction_of_toes(const Limb& limb) const
{
  constexpr double length = .2;
  const Eigen::VectorXd weights
    = ((limb.distances.array() > limb.end && limb.distances.array() < limb.end + length)
         .cast<double>()
       * m_shares.array())
        .matrix();
  const Eigen::Matrix3d rotation = aligning_motion(m_pose, m_rest, weights).linear();
  const Eigen::Vector3d toes
    = rotation.transpose()
      * (m_rest.row(static_cast<Eigen::Index>(limb.tip)) - center(m_rest, limb, limb.end))
          .transpose();
  const Eigen::Vector3d shin
    = (center(m_pose, limb, limb.end) - center(m_pose, limb, limb.end + .75 * length))
        .normalized()
        .transpose();
  return toes - toes.dot(shin) * shin;
}

// From its joint in the input, relative to the trunk, as it is in the pose.
Eigen::Vector3d Body_plan::direction_of_leg(const Limb& limb) const
{
  constexpr double length_of_head = .3;
  Eigen::VectorXd weights = m_shares;
  for(Eigen::Index v = 0; v < weights.size(); ++v)
  {
    const auto is_inside
      = [v](const Limb& other, const double length) { return other.distances[v] <= length; };
    if(std::any_of(m_limbs.begin(), m_limbs.end(),
                   [&](const Limb& other) { return is_inside(other, other.root); })
       || std::any_of(m_others.begin(), m_others.end(),
                      [&](const Limb& other) { return is_inside(other, length_of_head); }))
      weights[v] = 0;
  }
  return aligning_motion(m_pose, m_rest, weights).linear().transpose()
         * (center(m_rest, limb, limb.end) - center(m_rest, limb, limb.root)).transpose();
}

void Body_plan::set_frames(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                           const Measure_distances& measure)
{
  constexpr double least_evidence = .05, weight_of_face = .05;
  const bool is_person = m_kind == Skeleton_3::Kind::PERSON;
  if(are_legs_on_other_sides(coarse, measure))
    std::swap(m_limbs[2], m_limbs[3]);
  std::array<Eigen::RowVector3d, 2> left;
  for(std::size_t i = 0; i < 2; ++i)
    left[i] = is_person ? orthogonal_to_trunk(joint(m_limbs[2 * i]) - joint(m_limbs[2 * i + 1]))
                        : direction_across(i);
  // The front of a person, or the back of an animal, if the first limbs are on the left.
  const auto third = [&](const Eigen::RowVector3d& side) {
    return Eigen::RowVector3d(is_person ? side.cross(m_axis) : m_axis.cross(side));
  };
  double evidence = 0;
  if(is_person)
  {
    for(const std::size_t i : {2, 3})
      evidence += third(left[1]).dot(direction_of_toes(m_limbs[i]));
    std::vector<std::array<std::size_t, 3>> triangles_of_head;
    for(const auto& triangle : surface.triangles)
      if(std::all_of(triangle.begin(), triangle.end(), [&](const std::size_t v) {
           return head().distances[static_cast<Eigen::Index>(v)] < head().end;
         }))
        triangles_of_head.push_back(triangle);
    Eigen::Matrix3d frame;
    frame << left[0], m_axis, third(left[0]);
    evidence += weight_of_face * relief_in_front(m_pose, triangles_of_head, frame);
  }
  else
    for(std::size_t i = 0; i < 4; ++i)
      evidence -= third(left[i / 2]).dot(direction_of_leg(m_limbs[i])) / 2;
  m_is_certain = std::abs(evidence) >= least_evidence;
  if(evidence < 0)
  {
    std::swap(m_limbs[0], m_limbs[1]);
    std::swap(m_limbs[2], m_limbs[3]);
    for(Eigen::RowVector3d& side : left)
      side = -side;
  }
  for(std::size_t i = 0; i < 2; ++i)
    if(is_person)
      m_frames[i] << left[i], m_axis, third(left[i]);
    else
      m_frames[i] << left[i], third(left[i]), m_axis;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
