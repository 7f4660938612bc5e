// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_COMPONENT_ROLES_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_COMPONENT_ROLES_H

#include "Following_candidate.h"
#include "shares_of_cells.h"
#include "../surface/planar.h"
#include "../surface/root_of_area.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/has_area.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// What happens to a component: it has a pose of its own; it follows a component with a pose, which
// deforms it or moves it rigidly, together with others of its group; or it keeps its place, since there
// is nothing to follow.
struct Component_role
{
  enum Kind { POSED, DEFORMED, RIGID, FIXED };

  Kind kind = POSED;
  std::size_t group = 0; // any number, equal for those that move as one
};

// Whether more than one component with a pose is an error.
inline bool refuses_several(const Options::Components components)
{
  return components == Options::Components::AUTOMATIC || components == Options::Components::REFUSE;
}

inline std::vector<std::size_t> posed_components(const std::vector<Component_role>& roles)
{
  std::vector<std::size_t> result;
  for(std::size_t c = 0; c < roles.size(); ++c)
    if(roles[c].kind == Component_role::POSED)
      result.push_back(c);
  return result;
}

// The refusal of several components: `what` they are, their number, and a vertex of each of two.
// `vertices_of(c)`: those of a component, as indices of the input.
template <class Function>
std::invalid_argument refusal_of_several(const std::string& what,
                                         const std::vector<Component_role>& roles,
                                         const Function& vertices_of)
{
  const std::vector<std::size_t> posed = posed_components(roles);
  const std::size_t others = roles.size() - posed.size();
  const auto own_vertex = [&](const std::size_t c, const std::size_t other) {
    std::vector<std::size_t> own = vertices_of(c), common = vertices_of(other);
    std::sort(own.begin(), own.end());
    std::sort(common.begin(), common.end());
    for(const std::size_t v : own)
      if(!std::binary_search(common.begin(), common.end(), v))
        return std::to_string(v);
    return std::to_string(own.front());
  };
  return std::invalid_argument(
    what
    + (others == 0 ? ""
                   : ", besides " + std::to_string(others)
                       + (others == 1 ? " that follows them" : " that follow them"))
    + ": vertex " + own_vertex(posed[0], posed[1]) + " belongs to one, vertex "
    + own_vertex(posed[1], posed[0]) + " to another");
}

// Decides which of the components of an input follow others. A component follows another one if it
// is small against it; if it is not large, and touches it; if it is in contact with it over a fair
// share of its surface; if it lies inside it; or if it wraps it, like a dress. What is on a plane, or lies
// inside, but apart from the surface, is a shape of its own, like a figure under the dome of a sky, unless
// it is tiny; so is what has much more detail than the largest, and is not in contact with it over a fair
// share of its surface, like a figure in a room.
class Component_roles
{
public:
  // `components`: by decreasing size. `is_fragment`: of components that follow another one in any
  // case. `has_budget`: whether the bodies share a number of cells.
  static std::vector<Component_role> find(const std::vector<Surface_component_3>& components,
                                          const std::vector<bool>& is_fragment,
                                          const Options::Components mode, const bool has_budget)
  {
    Component_roles roles(components, is_fragment, mode);
    if(mode == Options::Components::EACH)
    {
      if(has_budget)
        roles.exclude_those_without_a_body();
    }
    else if(mode != Options::Components::REFUSE && !roles.m_candidates.empty())
    {
      roles.find_followers();
      if(mode == Options::Components::LARGEST)
        for(const std::size_t c : roles.m_candidates)
          roles.m_roles[c].kind = Component_role::RIGID;
      else
        roles.keep_those_without_a_main_one();
      roles.unite_rigid_ones();
    }
    roles.leave_those_far_away();
    return roles.m_roles;
  }

private:
  static constexpr double SMALL_AREA = .05, SMALL_AREA_IN_TOUCH = .25; // of that of the largest
  static constexpr double SMALL_AREAS_IN_TOTAL = .5, AREAS_IN_TOUCH_IN_TOTAL = 3; // of that, too
  static constexpr double SHARE_IN_TOUCH = .33; // of the component's area
  static constexpr double SHARE_INSIDE = .5;
  static constexpr double DEFORMED_SHARE = .67;       // in touch or inside, if not large
  static constexpr double APARTNESS = .3;             // of the component's diameter
  static constexpr double GAP_OF_FLOATING = .15;      // of the diameter of the largest
  static constexpr double TINY_SIZE = .05;            // of the diameter of the largest
  static constexpr double TRIANGLES_OF_A_SHAPE = 200; // at least
  static constexpr double MORE_DETAIL = 4;            // times the triangles of the largest
  static constexpr double WRAPPED_SHARE = .33;        // of the area of the largest
  static constexpr double REACH = .25;                // of the diameter of the largest
  static constexpr double GAP = .02;                  // of the diameter, between parts of one thing
  static constexpr std::size_t LARGEST_NUMBER_OF_THINGS = 32;
  static constexpr double RIGID_SIZE = .15; // of the square root of the area of the largest
  static constexpr double SMALLEST_SHARE_OF_CELLS
    = .023; // between those of 43 and 44 equal components
  static constexpr std::size_t NUMBER_OF_SAMPLES = 256, SMALLEST_NUMBER_OF_SAMPLES = 16;
  static constexpr std::size_t NUMBER_OF_SAMPLES_IN_TOTAL = 20000;

  Component_roles(const std::vector<Surface_component_3>& components,
                  const std::vector<bool>& is_fragment, const Options::Components mode)
    : m_components(components), m_areas(relative_areas(components)), m_roles(components.size())
  {
    for(std::size_t c = 0; c < components.size(); ++c)
    {
      m_roles[c].group = c;
      if(is_fragment[c] || !has_some_area(c))
        m_roles[c].kind = Component_role::RIGID;
      else
        m_candidates.push_back(c);
    }
    if(m_candidates.empty())
      return;
    // A dress has two sides, so it may have a larger area than the body in it.
    const auto size = [&](const std::size_t c) {
      return mode == Options::Components::AUTOMATIC && !components[c].caps.empty() ? m_areas[c] / 2
                                                                                   : m_areas[c];
    };
    const auto largest = std::max_element(
      m_candidates.begin(), m_candidates.end(),
      [&](const std::size_t c, const std::size_t d) { return size(c) < size(d); });
    m_largest = mode == Options::Components::AUTOMATIC ? *largest : m_candidates.front();
    m_candidates.erase(std::find(m_candidates.begin(), m_candidates.end(), m_largest));
    m_size_of_largest = root_of_area(components[m_largest].points, components[m_largest].triangles);
    m_diameter_of_largest = diameter_of(components[m_largest].points);
    m_is_largest_flat = is_flat(m_largest);
    double small_areas = 0;
    for(const std::size_t c : m_candidates)
      if(m_areas[c] <= SMALL_AREA * m_areas[m_largest])
        small_areas += m_areas[c];
    m_are_small_ones_few = small_areas <= SMALL_AREAS_IN_TOTAL * m_areas[m_largest];
  }

  bool has_some_area(const std::size_t c) const
  {
    Point_matrix points = m_components[c].points;
    normalize(points);
    return has_area(points, m_components[c].triangles);
  }

  bool is_small(const std::size_t c) const
  {
    return m_are_small_ones_few && m_areas[c] <= SMALL_AREA * m_areas[m_largest];
  }

  void exclude_those_without_a_body()
  {
    const std::vector<double> shares = shares_of_cells(m_components, m_areas);
    for(const std::size_t c : m_candidates)
      if(shares[c] < SMALLEST_SHARE_OF_CELLS)
        m_roles[c].kind = is_small(c) ? Component_role::RIGID : Component_role::FIXED;
  }

  // Removes followers from the candidates. Those that follow the largest component directly are
  // found first, then those that follow these, and so on. Large ones must be in contact with the
  // largest itself.
  void find_followers()
  {
    const std::size_t number_of_samples
      = (std::max)((std::min)(NUMBER_OF_SAMPLES_IN_TOTAL / m_candidates.size(), NUMBER_OF_SAMPLES),
                   SMALLEST_NUMBER_OF_SAMPLES);
    const Point_matrix points_of_largest = points_on_surface(
      m_components[m_largest].points, m_components[m_largest].triangles, number_of_samples);
    std::vector<Following_candidate> candidates(m_components.size());
    std::vector<std::size_t> rest;
    for(const std::size_t c : m_candidates)
      if(is_small(c) && is_of_rigid_size(c) && is_tiny(c)) // the quick way for many
        m_roles[c].kind = Component_role::RIGID;
      else
      {
        candidates[c] = Following_candidate(m_components[c], number_of_samples);
        rest.push_back(c);
      }
    std::vector<char> wraps(m_components.size(), 0);
    for_each_index(rest.size(), [&](const std::size_t i) {
      wraps[rest[i]]
        = !is_not_large(rest[i])
          && surrounds(rest[i],
                       points_of_largest.topRows(static_cast<Eigen::Index>(number_of_samples)));
    });
    std::vector<std::size_t> apart;
    std::vector<char> is_in_contact(m_components.size(), 0);
    for(std::vector<std::size_t> leaders = {m_largest}; !rest.empty() && !leaders.empty();)
    {
      const Component_neighborhood neighborhood(m_components, leaders);
      for_each_index(rest.size(),
                     [&](const std::size_t i) { candidates[rest[i]].approach(neighborhood); });
      const bool is_first = leaders.front() == m_largest;
      leaders.clear();
      std::vector<std::size_t> others;
      for(const std::size_t c : rest)
      {
        const Following_candidate& candidate = candidates[c];
        if(is_first)
          is_in_contact[c] = candidate.share_in_touch() >= SHARE_IN_TOUCH;
        const bool is_inside = candidate.share_inside() >= SHARE_INSIDE;
        if(is_first && !wraps[c] && is_apart(c, candidate))
          apart.push_back(c);
        else if(is_small(c) && is_of_rigid_size(c))
          m_roles[c].kind = Component_role::RIGID;
        else if(wraps[c] || is_small(c) || is_inside || is_in_contact[c]
                || (is_not_large(c) && candidate.is_in_touch()))
        {
          m_roles[c].kind = wraps[c] || is_deformed(c, candidate) ? Component_role::DEFORMED
                                                                  : Component_role::RIGID;
          leaders.push_back(c);
          if(!is_small(c) && !is_inside)
            m_in_touch.push_back(c);
        }
        else
          others.push_back(c);
      }
      rest = std::move(others);
    }
    rest.insert(rest.end(), apart.begin(), apart.end());
    m_candidates = std::move(rest);
  }

  // If what touches the largest component, or what touches that, is several times as large, as in a soup
  // of triangles, the largest is not the main one.
  void keep_those_without_a_main_one()
  {
    double areas = 0;
    for(const std::size_t c : m_in_touch)
      areas += m_areas[c];
    if(areas > AREAS_IN_TOUCH_IN_TOTAL * m_areas[m_largest])
      for(const std::size_t c : m_in_touch)
        m_roles[c].kind = Component_role::POSED;
  }

  bool is_apart(const std::size_t c, const Following_candidate& candidate) const
  {
    if(is_tiny(c))
      return false;
    if(m_is_largest_flat)
      return !is_flat(c);
    if(!is_of_tiny_size(c) && has_detail(c, MORE_DETAIL)
       && candidate.share_in_touch() < SHARE_IN_TOUCH)
      return true;
    return candidate.share_inside() >= SHARE_INSIDE
           && candidate.median_distance() > APARTNESS * candidate.diameter()
           && (m_areas[c] > SMALL_AREA * m_areas[m_largest]
               || candidate.least_distance() >= GAP_OF_FLOATING * m_diameter_of_largest
               || (!is_of_tiny_size(c) && has_detail(c, 1)));
  }

  bool is_tiny(const std::size_t c) const { return is_of_tiny_size(c) && !has_detail(c, .1); }

  bool is_of_tiny_size(const std::size_t c) const
  {
    return diameter_of(m_components[c].points) <= TINY_SIZE * m_diameter_of_largest;
  }

  // Whether a component has this share of the triangles of the largest.
  bool has_detail(const std::size_t c, const double share) const
  {
    const double number = share * static_cast<double>(m_components[m_largest].triangles.size());
    return static_cast<double>(m_components[c].triangles.size())
           >= (std::max)(number, TRIANGLES_OF_A_SHAPE);
  }

  bool is_flat(const std::size_t c) const
  {
    return is_planar(m_components[c].points, m_components[c].triangles);
  }

  // A sword that is held by a hand is not.
  bool is_deformed(const std::size_t c, const Following_candidate& candidate) const
  {
    return !is_of_rigid_size(c)
           && (candidate.share_in_touch() >= (is_not_large(c) ? DEFORMED_SHARE : SHARE_IN_TOUCH)
               || candidate.share_inside() >= DEFORMED_SHARE);
  }

  bool is_not_large(const std::size_t c) const
  {
    return m_areas[c] <= SMALL_AREA_IN_TOUCH * m_areas[m_largest];
  }

  // Whether a component wraps a fair share of the points of the largest one.
  bool surrounds(const std::size_t c, const Point_matrix& points) const
  {
    const Component_neighborhood neighborhood(m_components, {c});
    Eigen::Index number = 0;
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      number += neighborhood.surrounds(points.row(i)) ? 1 : 0;
    return static_cast<double>(number) >= WRAPPED_SHARE * static_cast<double>(points.rows());
  }

  bool is_of_rigid_size(const std::size_t c) const
  {
    return diameter_of(m_components[c].points) <= RIGID_SIZE * m_size_of_largest;
  }

  // What moves rigidly and touches a large thing that moves rigidly belongs to it, like the guard of a
  // sword, unless it is as near to the body.
  void unite_rigid_ones()
  {
    std::vector<std::size_t> rigid, things;
    for(std::size_t c = 0; c < m_roles.size(); ++c)
      if(m_roles[c].kind == Component_role::RIGID && m_components[c].points.rows() > 0)
      {
        rigid.push_back(c);
        if(!is_of_rigid_size(c) && has_some_area(c))
          things.push_back(c);
      }
    if(things.empty() || things.size() > LARGEST_NUMBER_OF_THINGS)
      return;
    std::vector<std::vector<char>> touches(things.size(), std::vector<char>(rigid.size(), 0));
    const Component_neighborhood body(m_components, {m_largest});
    for_each_index(things.size(), [&](const std::size_t i) {
      const Component_neighborhood thing(m_components, {things[i]});
      for(std::size_t j = 0; j < rigid.size(); ++j)
      {
        const Point_matrix& points = m_components[rigid[j]].points;
        const double gap = distance(points, thing);
        touches[i][j] = gap <= GAP * diameter_of(points)
                        && (gap < distance(points, body) || !is_of_rigid_size(rigid[j]));
      }
    });
    Disjoint_sets groups(m_roles.size());
    for(std::size_t i = 0; i < things.size(); ++i)
      for(std::size_t j = 0; j < rigid.size(); ++j)
        if(touches[i][j])
          groups.unite(things[i], rigid[j]);
    const Component_labels labels = label_components(groups);
    for(const std::size_t c : rigid)
      m_roles[c].group = labels.of_items[c];
  }

  // What is far away keeps its place: the rotation of the nearest limb would carry it away.
  void leave_those_far_away()
  {
    std::vector<std::size_t> leaders, rigid;
    for(std::size_t c = 0; c < m_roles.size(); ++c)
      if(m_components[c].points.rows() > 0)
        (m_roles[c].kind == Component_role::POSED || m_roles[c].kind == Component_role::DEFORMED
           ? leaders
           : rigid)
          .push_back(c);
    if(leaders.empty() || rigid.empty())
      return;
    const Component_neighborhood body(m_components, leaders);
    const double reach = REACH * m_diameter_of_largest;
    std::vector<char> is_near(rigid.size(), 0);
    for_each_index(rigid.size(), [&](const std::size_t i) {
      is_near[i] = distance(m_components[rigid[i]].points, body) <= reach;
    });
    std::vector<char> is_group_near(m_roles.size(), 0);
    for(std::size_t i = 0; i < rigid.size(); ++i)
      is_group_near[m_roles[rigid[i]].group] |= is_near[i];
    for(const std::size_t c : rigid)
      if(!is_group_near[m_roles[c].group])
        m_roles[c].kind = Component_role::FIXED;
  }

  static double distance(const Point_matrix& points, const Component_neighborhood& neighborhood)
  {
    double result = std::numeric_limits<double>::infinity();
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      result = (std::min)(result, neighborhood.distance(points.row(i)));
    return result;
  }

  const std::vector<Surface_component_3>& m_components;
  const std::vector<double> m_areas; // relative to the largest
  std::vector<Component_role> m_roles;
  std::size_t m_largest = 0;    // of those that have an area
  double m_size_of_largest = 0; // square root of its area
  double m_diameter_of_largest = 0;
  bool m_is_largest_flat = false;
  std::vector<std::size_t> m_candidates; // the others that have one
  std::vector<std::size_t> m_in_touch;   // followers that are neither small nor inside
  bool m_are_small_ones_few = true;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_COMPONENT_ROLES_H
