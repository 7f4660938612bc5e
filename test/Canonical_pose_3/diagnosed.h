// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_DIAGNOSED_H
#define CGAL_CANONICAL_POSE_3_TEST_DIAGNOSED_H

#include <CGAL/Canonical_pose_3/diagnose.h>

#include <gtest/gtest.h>

#include "dirty_shapes.h"
#include "matchers.h"

#include <string>
#include <vector>

namespace Canonical_pose_test {

using Defects = std::vector<std::string>;

inline CGAL::Canonical_pose_3::Diagnosis_3 diagnosis(const Polygon_soup& soup)
{
  return CGAL::Canonical_pose_3::diagnose(to_matrix(soup.points), soup.polygons);
}

/// "kind count" of each defect, in order.
inline Defects defects(const Polygon_soup& soup)
{
  const CGAL::Canonical_pose_3::Diagnosis_3 found = diagnosis(soup);
  Defects result;
  for(const auto& defect : found.defects)
    result.push_back(defect.kind + ' ' + std::to_string(defect.count));
  EXPECT_EQ(found.first_defect, found.defects.empty() ? "" : found.defects[0].message);
  return result;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_DIAGNOSED_H
