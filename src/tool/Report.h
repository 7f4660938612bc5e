// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_REPORT_H
#define CGAL_CANONICAL_POSE_3_TOOL_REPORT_H

#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Segmentation_tree_3.h>
#include <CGAL/Canonical_pose_3/Skeleton_3.h>
#include <CGAL/Canonical_pose_3/Surface_match_3.h>
#include <CGAL/Canonical_pose_3/segmentation_parts.h>

#include <Eigen/Core>

#include <chrono>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

// Measures the running time of the stages.
class Stage_clock
{
public:
  // Returns the seconds since the last call, or since construction.
  double lap()
  {
    const auto before = m_last;
    m_last = Clock::now();
    return seconds(m_last - before);
  }

  // Returns the seconds since construction.
  double total() const { return seconds(Clock::now() - m_start); }

private:
  using Clock = std::chrono::steady_clock;

  static double seconds(const Clock::duration duration)
  {
    return std::chrono::duration<double>(duration).count();
  }

  const Clock::time_point m_start = Clock::now();
  Clock::time_point m_last = m_start;
};

// Writes the report (JSON) of a pose.
void write_report(std::ostream& out, const CGAL::Canonical_pose_3::Registration_summary& summary,
                  double total_seconds,
                  const std::optional<CGAL::Canonical_pose_3::Skeleton_3>& skeleton = std::nullopt);

// Writes the report (JSON) of a diagnosis.
void write_report(std::ostream& out, const CGAL::Canonical_pose_3::Diagnosis_3& diagnosis,
                  const std::vector<CGAL::Canonical_pose_3::Registration_summary::Stage>& stages,
                  double total_seconds);

// What is reported of a segmentation.
struct Segmentation_report
{
  std::string method;
  std::vector<CGAL::Canonical_pose_3::Segmentation_part_3> parts;
  std::optional<CGAL::Canonical_pose_3::Segmentation_tree_3> tree; // not of k-means
  std::vector<std::string> warnings;
  std::vector<CGAL::Canonical_pose_3::Registration_summary::Stage> stages;
};

// Writes the report (JSON) of a segmentation.
void write_report(std::ostream& out, const Segmentation_report& segmentation,
                  double seconds_to_write, double total_seconds);

// Writes the report (JSON) of a match.
void write_report(std::ostream& out, const CGAL::Canonical_pose_3::Surface_match_3& match,
                  const std::vector<std::string>& warnings,
                  const std::vector<CGAL::Canonical_pose_3::Registration_summary::Stage>& stages,
                  double total_seconds);

// Writes the outcome in one line, and one line per warning.
void write_outcome(std::ostream& out, const CGAL::Canonical_pose_3::Registration_summary& summary);

// Writes one line per field.
void write_table(std::ostream& out, const CGAL::Canonical_pose_3::Diagnosis_3& diagnosis);

// The values of a descriptor.
struct Described_shape
{
  std::string name;
  int version;
  Eigen::VectorXd values;
};

void write_descriptors(std::ostream& out, const std::vector<Described_shape>& descriptors);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_REPORT_H
