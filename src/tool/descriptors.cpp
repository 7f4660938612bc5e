// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "descriptors.h"
#include "Command_line.h"

#include <CGAL/Canonical_pose_3/Shape_distribution_d2_3.h>
#include <CGAL/Canonical_pose_3/View_descriptor_3.h>
#ifdef CANONICAL_POSE_WITH_SPECTRA
#include <CGAL/Canonical_pose_3/Heat_kernel_quantiles_3.h>
#include <CGAL/Canonical_pose_3/Shape_dna_3.h>
#endif

#include <algorithm>
#include <stdexcept>

namespace Canonical_pose_tool {

namespace {

template <class Model>
Descriptor descriptor_of(const bool needs_pose, const double weight)
{
  const Model model;
  return {Model::name(),
          Model::version(),
          needs_pose,
          weight,
          model,
          static_cast<Eigen::Index>(model.size()),
          [model](const Eigen::VectorXd& query, const Eigen::Ref<const Eigen::MatrixXd>& others) {
            return model.distances(query, others);
          }};
}

std::vector<Descriptor> all_descriptors()
{
  namespace CP = CGAL::Canonical_pose_3;
  return {
#ifdef CANONICAL_POSE_WITH_SPECTRA
    descriptor_of<CP::Heat_kernel_quantiles_3>(false, 4),
    descriptor_of<CP::Shape_dna_3>(false, 0.25),
#endif
    descriptor_of<CP::Shape_distribution_d2_3>(true, 1),
    descriptor_of<CP::View_descriptor_3>(true, 2),
  };
}

} // namespace

std::vector<Descriptor> descriptors(const std::vector<std::string>& names)
{
  const std::vector<Descriptor> all = all_descriptors();
  if(names.empty())
    return all;
  std::vector<Descriptor> result;
  for(const std::string& name : names)
  {
    const auto is_named = [&](const Descriptor& d) { return d.name == name; };
    const auto found = std::find_if(all.begin(), all.end(), is_named);
    if(found == all.end())
    {
      std::string known;
      for(const Descriptor& d : all)
        known += (known.empty() ? "" : ", ") + d.name;
      throw Usage_error("there is no descriptor '" + name + "' in this build, which has " + known);
    }
    if(std::none_of(result.begin(), result.end(), is_named))
      result.push_back(*found);
  }
  return result;
}

} // namespace Canonical_pose_tool
