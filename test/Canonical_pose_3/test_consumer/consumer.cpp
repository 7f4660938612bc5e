// Solves a small system and, if TetGen is linked, fills a small surface: this requires every
// library that the targets link.

#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>

#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
#include <CGAL/Canonical_pose_3/tetgen_body.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/generators.h>
#endif

#include <cmath>
#include <cstdlib>
#include <iostream>

bool solves()
{
  using Solver = CGAL::Canonical_pose_3::Default_factor_traits_d;
  Solver::Matrix matrix(2, 2);
  matrix.set_coef(0, 0, 2, true);
  matrix.set_coef(1, 1, 4, true);
  Solver solver;
  double denominator = 1;
  Eigen::MatrixXd solution;
  std::cout << "solver: " << Solver::name() << '\n';
  return solver.factor(matrix, denominator)
         && solver.linear_solver(Eigen::MatrixXd::Ones(2, 1), solution)
         && std::abs(solution(0, 0) - 0.5) < 1e-15 && std::abs(solution(1, 0) - 0.25) < 1e-15;
}

bool fills()
{
#ifdef CGAL_CANONICAL_POSE_3_USE_TETGEN
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  CGAL::Surface_mesh<Point> mesh;
  CGAL::make_tetrahedron(Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(0, 0, 1), mesh);
  const auto body = CGAL::Canonical_pose_3::tetgen_body(mesh, mesh.points());
  std::cout << "TetGen: " << body.cells().size() << " cells\n";
  return std::abs(body.volume() - 1. / 6) < 1e-12;
#else
  return true;
#endif
}

int main() { return solves() && fills() ? EXIT_SUCCESS : EXIT_FAILURE; }
