// A part of a program that requests the body of TetGen before main() runs, and prints the result.
// It is compiled twice, with and without TetGen.

#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>

#include <array>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
const char* const part = "with TetGen: ";
#else
const char* const part = "without TetGen: ";
#endif

// The kind of the body, or the reason why there is none.
std::string body_of_octahedron()
{
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  const std::vector<Point> points = {Point(3, 0, 0),  Point(0, 2, 0),  Point(0, 0, 1),
                                     Point(-3, 0, 0), Point(0, -2, 0), Point(0, 0, -1)};
  const std::vector<std::array<std::size_t, 3>> faces
    = {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}, {4, 0, 2}, {1, 0, 5}, {3, 1, 5}, {4, 3, 5}, {0, 4, 5}};
  std::vector<Point> pose;
  CGAL::Canonical_pose_3::Options options;
  options.body = CGAL::Canonical_pose_3::Options::Body::TETGEN;
  try
  {
    return CGAL::canonical_pose_3(points, faces, pose, options).summary.body.kind;
  }
  catch(const std::exception& error)
  {
    return error.what();
  }
}

[[maybe_unused]] const std::ostream& printed = std::cout << part << body_of_octahedron()
                                                         << std::endl;

} // namespace
