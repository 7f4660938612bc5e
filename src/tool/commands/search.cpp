// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command search.

#include "commands.h"
#include "formats/Cgal_types.h"
#include "collection/Collection_database.h"
#include "formats/Mesh_file.h"
#include "collection/described_collection.h"

#include <algorithm>
#include <iostream>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

void run_search(const Arguments& arguments)
{
  Collection_database database(arguments.database, false);
  const std::vector<Weighted_descriptor> chosen = chosen_descriptors(arguments, database);
  const Described_collection shapes = values_of(database, chosen, arguments.pose_options);
  const std::vector<Described_shape> query = described_shape(arguments, chosen);

  // The sum of the distances, after each was divided by its mean.
  Eigen::VectorXd distance = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(shapes.paths.size()));
  for(std::size_t k = 0; k < chosen.size(); ++k)
  {
    const Eigen::VectorXd d = chosen[k].descriptor.distances(query[k].values, shapes.values[k]);
    if(chosen.size() == 1)
      distance = d;
    else if(d.sum() > 0)
      distance += chosen[k].weight / d.mean() * d;
  }
  std::vector<std::size_t> order(shapes.paths.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
    return distance[static_cast<Eigen::Index>(a)] < distance[static_cast<Eigen::Index>(b)];
  });
  for(std::size_t i = 0; i < (std::min)(arguments.number_of_answers, order.size()); ++i)
    std::cout << i + 1 << ' ' << distance[static_cast<Eigen::Index>(order[i])] << ' '
              << shapes.paths[order[i]] << '\n';
}

} // namespace Canonical_pose_tool
