// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_BODY_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_BODY_H

#include <CGAL/Canonical_pose_3/Embedded_body_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Lattice_body_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/cell_stiffness.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Body_makers.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>

#include <Eigen/Core>

#include <cstddef>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// The body of a component.
struct Component_body
{
  std::string kind;
  std::variant<Lattice_body_3, Embedded_body_3> body;
  std::vector<std::size_t>
    origins;                 // the surface vertex of the body that each vertex of the component is
  Eigen::VectorXd stiffness; // of the cells, or nothing
  std::vector<std::string> warnings;

  Body_view view() const
  {
    return std::visit([](const auto& b) { return Body_view(b); }, body);
  }
};

inline Lattice_body_3 lattice_of(const Posed_component& component, const Landmark_fields_3& fields,
                                 const Options& options)
{
  return Lattice_body_3(component.points, component.triangles, fields.distances,
                        options.lattice_spacing, component.caps);
}

// The body of a surface that the options request. `stiffness`: of the vertices, or nothing; `shares`: theirs in the area.
inline Component_body body_of_surface(const Posed_component& component,
                                      const Landmark_fields_3& fields,
                                      const Eigen::VectorXd& stiffness, const Options& options,
                                      const Body_makers& bodies, const Eigen::VectorXd& shares)
{
  std::vector<std::size_t> origins(static_cast<std::size_t>(component.points.rows()));
  std::iota(origins.begin(), origins.end(), std::size_t(0));
  Component_body result = [&]() -> Component_body {
    if(options.body == Options::Body::MESH_3)
    {
      if(bodies.mesh_3 == nullptr)
        throw std::runtime_error("the program was built without bodies of Mesh_3");
      return {"mesh_3",
              bodies.mesh_3(component.points, component.triangles, fields.distances.maxCoeff(),
                            options.lattice_spacing),
              std::move(origins),
              {},
              {}};
    }
    std::vector<std::string> warnings;
    if(options.body == Options::Body::TETGEN)
    {
      if(bodies.tetgen == nullptr)
        throw std::runtime_error("the program was built without TetGen");
      try
      {
        return {"tetgen",
                bodies.tetgen(component.points, component.triangles),
                std::move(origins),
                {},
                {}};
      }
      catch(const std::runtime_error& error)
      {
        warnings.push_back(error.what() + std::string("; the lattice took its place"));
      }
    }
    return {"lattice",
            lattice_of(component, fields, options),
            std::move(origins),
            {},
            std::move(warnings)};
  }();
  if(stiffness.size() > 0)
    result.stiffness = cell_stiffness(result.view(), shares, stiffness);
  return result;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_BODY_H
