// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_WRITTEN_FILE_H
#define CGAL_CANONICAL_POSE_3_TEST_WRITTEN_FILE_H

#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace Canonical_pose_test {

// The path of a file with these bytes; of the running test alone, as tests run at the same time.
inline std::string written_file(const std::string& name, const std::string& bytes)
{
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = testing::TempDir() + test.test_suite_name() + '.' + test.name() + '.' + name;
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_WRITTEN_FILE_H
