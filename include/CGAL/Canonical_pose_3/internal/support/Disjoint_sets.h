// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_DISJOINT_SETS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_DISJOINT_SETS_H

#include <boost/pending/disjoint_sets.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Disjoint sets of the numbers from 0 to n - 1, which fit into 32 bits.
class Disjoint_sets
{
public:
  static constexpr std::size_t NONE = std::size_t(-1);

  explicit Disjoint_sets(const std::size_t n)
    : m_rank(n, 0), m_parent(n),
      m_sets(Map<std::uint8_t>(m_rank.data()), Map<std::uint32_t>(m_parent.data()))
  {
    std::iota(m_parent.begin(), m_parent.end(), std::uint32_t(0));
  }
  Disjoint_sets(const Disjoint_sets&) = delete;
  Disjoint_sets& operator=(const Disjoint_sets&) = delete;

  std::size_t number_of_members() const { return m_parent.size(); }
  void unite(const std::size_t a, const std::size_t b) { m_sets.union_set(a, b); }
  std::size_t representative(const std::size_t a) { return m_sets.find_set(a); }

private:
  // Not pointers: for them, get() of other headers of Boost would hide the right one.
  template <class Value>
  using Map = boost::iterator_property_map<Value*, boost::typed_identity_property_map<std::size_t>>;

  std::vector<std::uint8_t> m_rank; // at most the logarithm of n
  std::vector<std::uint32_t> m_parent;
  boost::disjoint_sets<Map<std::uint8_t>, Map<std::uint32_t>> m_sets;
};

// The sets to which items belong.
struct Component_labels
{
  std::vector<std::size_t> of_items;    // from 0, in the order of the first items
  std::vector<std::size_t> first_items; // for each label
};

// Labels items by the sets of their members: `member(item)` is in the set of the item. If it is
// Disjoint_sets::NONE, so is the label.
template <class Function>
Component_labels label_components(Disjoint_sets& sets, const std::size_t number_of_items,
                                  const Function& member)
{
  Component_labels result;
  result.of_items.assign(number_of_items, Disjoint_sets::NONE);
  std::vector<std::size_t> label_of_set(sets.number_of_members(), Disjoint_sets::NONE);
  for(std::size_t i = 0; i < number_of_items; ++i)
  {
    if(member(i) == Disjoint_sets::NONE)
      continue;
    std::size_t& label = label_of_set[sets.representative(member(i))];
    if(label == Disjoint_sets::NONE)
    {
      label = result.first_items.size();
      result.first_items.push_back(i);
    }
    result.of_items[i] = label;
  }
  return result;
}

// Labels the members.
inline Component_labels label_components(Disjoint_sets& sets)
{
  return label_components(sets, sets.number_of_members(), [](const std::size_t i) { return i; });
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SUPPORT_DISJOINT_SETS_H
