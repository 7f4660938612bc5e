// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_DESCRIBED_COLLECTION_H
#define CGAL_CANONICAL_POSE_3_TOOL_DESCRIBED_COLLECTION_H

#include "Collection_database.h"
#include "Command_line.h"
#include "Report.h"
#include "descriptors.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

struct Weighted_descriptor
{
  Descriptor descriptor;
  double weight;
};

// The requested descriptors, or those that the database has. Throws std::invalid_argument if there is
// none, or one has a wrong name or weight.
std::vector<Weighted_descriptor> chosen_descriptors(const Arguments& arguments,
                                                    Collection_database& database);

// The shapes that have all these descriptors, described under these options. Throws
// std::invalid_argument if there is none.
Described_collection values_of(Collection_database& database,
                               const std::vector<Weighted_descriptor>& chosen,
                               const std::string& options);

// Says how many described shapes are not among these, if any.
void warn_of_missing(std::ostream& out, Collection_database& database,
                     const Described_collection& shapes);

// The values of the input.
std::vector<Described_shape> described_shape(const Arguments& arguments,
                                             const std::vector<Weighted_descriptor>& chosen);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_DESCRIBED_COLLECTION_H
