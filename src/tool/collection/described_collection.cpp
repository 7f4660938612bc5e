// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "described_collection.h"
#include "Report.h"
#include "describe_shape.h"
#include "option_values.h"
#include "formats/Mesh_file.h"

#include <algorithm>
#include <stdexcept>

namespace Canonical_pose_tool {

namespace {

// Removes the weight of "NAME:WEIGHT".
std::optional<double> take_weight(std::string& name)
{
  const std::size_t colon = name.rfind(':');
  if(colon == std::string::npos)
    return std::nullopt;
  const std::optional<double> weight = real_of(name.substr(colon + 1));
  name.erase(colon);
  return weight;
}

// How messages name the options of `pose`.
std::string name_of_options(const std::string& options)
{
  return options.empty() ? "the default options" : "'" + options + "'";
}

} // namespace

std::vector<Weighted_descriptor> chosen_descriptors(const Arguments& arguments,
                                                    Collection_database& database)
{
  std::vector<Weighted_descriptor> result;
  if(arguments.descriptors.empty())
  {
    const auto stored = database.descriptors();
    for(const Descriptor& descriptor : descriptors({}))
      if(std::find(stored.begin(), stored.end(),
                   std::make_pair(descriptor.name, descriptor.version))
         != stored.end())
        result.push_back({descriptor, descriptor.weight});
    if(result.empty())
      throw std::invalid_argument("the database '" + arguments.database
                                  + "' has no described shape");
  }
  for(std::string name : arguments.descriptors)
  {
    const std::optional<double> weight = take_weight(name);
    if(std::any_of(result.begin(), result.end(),
                   [&](const Weighted_descriptor& w) { return w.descriptor.name == name; }))
      throw Usage_error("the descriptor '" + name + "' is given twice");
    const Descriptor descriptor = descriptors({name}).front();
    result.push_back({descriptor, weight.value_or(descriptor.weight)});
  }
  return result;
}

Described_collection values_of(Collection_database& database,
                               const std::vector<Weighted_descriptor>& chosen,
                               const std::string& options)
{
  std::vector<Collection_database::Requested_descriptor> requested;
  std::string names;
  for(const Weighted_descriptor& weighted : chosen)
  {
    const Descriptor& d = weighted.descriptor;
    requested.push_back({d.name, d.version, d.size});
    names += (names.empty() ? "" : ", ") + d.name;
  }
  Described_collection result = database.values(requested, options);
  if(result.paths.empty())
  {
    const std::string message
      = "the database has no shape with " + names + " under " + name_of_options(options);
    std::string others;
    for(const std::string& other : database.options())
      if(other != options)
        others += (others.empty() ? "; it has some under " : ", ") + name_of_options(other);
    throw std::invalid_argument(message + others);
  }
  return result;
}

void warn_of_missing(std::ostream& out, Collection_database& database,
                     const Described_collection& shapes)
{
  const std::size_t n = database.paths_of_described().size();
  if(shapes.paths.size() < n)
    out << "canonical-pose: warning: " << n - shapes.paths.size() << " of " << n
        << " described shapes are left out: they lack a descriptor, or were described under other "
           "options\n";
}

std::vector<Described_shape> described_shape(const Arguments& arguments,
                                             const std::vector<Weighted_descriptor>& chosen)
{
  std::vector<Descriptor> all;
  for(const Weighted_descriptor& weighted : chosen)
    all.push_back(weighted.descriptor);
  return describe_shape(read_mesh_file(arguments.input), all, arguments).descriptors;
}

} // namespace Canonical_pose_tool
