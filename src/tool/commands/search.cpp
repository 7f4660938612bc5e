// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command search.

#include "Output_files.h"
#include "command_options.h"
#include "commands.h"
#include "formats/Cgal_types.h"
#include "collection/Collection_database.h"
#include "formats/Mesh_file.h"
#include "collection/described_collection.h"
#include "collection/list_collection.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

using Json = nlohmann::ordered_json;

struct Answer
{
  std::string path;
  double distance;
};

void write_answers(std::ostream& out, const std::vector<Answer>& answers)
{
  Json report = {{"answers", Json::array()}};
  for(const Answer& answer : answers)
    report["answers"].push_back({{"path", answer.path}, {"distance", answer.distance}});
  out << report.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

void add_search_options(Command_options& o)
{
  o.app.add_option("QUERY", o.arguments.input, "surface")->required();
  add_database(o);
  o.app.add_option("-n", o.arguments.number_of_answers, "number of answers")
    ->transform(integer(std::size_t(1)))
    ->capture_default_str();
  add_weighted_descriptors(o);
  add_given_pose(o);
  add_report(o);
  add_recorded_method_options(o);
}

int run_search(Arguments& arguments)
{
  Output_files files({arguments.report}, {arguments.input, arguments.pose, arguments.database});
  Collection_database database(arguments.database, false);
  const std::vector<Weighted_descriptor> chosen = chosen_descriptors(arguments, database);
  const Described_collection shapes = values_of(database, chosen, arguments.pose_options);
  warn_of_missing(std::cerr, database, shapes);
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
  std::vector<Answer> answers;
  for(std::size_t i = 0; i < (std::min)(arguments.number_of_answers, order.size()); ++i)
    answers.push_back({shapes.paths[order[i]], distance[static_cast<Eigen::Index>(order[i])]});
  files.write(arguments.report, [&](std::ostream& out) { write_answers(out, answers); });
  files.commit();
  if(arguments.quiet)
    return EXIT_SUCCESS;
  std::ostream& out = messages_beside({arguments.report});
  for(std::size_t i = 0; i < answers.size(); ++i)
    out << i + 1 << ' ' << answers[i].distance << ' ' << in_one_line(answers[i].path) << '\n';
  return EXIT_SUCCESS;
}

} // namespace

const Command SEARCH_COMMAND
  = {"search",
     "finds the shapes of a collection that are most similar to a surface",
     {"search man.off --database meshes.db",
      "search man.off --database meshes.db -n 3 --descriptor views"},
     add_search_options,
     run_search};

} // namespace Canonical_pose_tool
