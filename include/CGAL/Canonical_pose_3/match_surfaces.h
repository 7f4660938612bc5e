// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MATCH_SURFACES_H
#define CGAL_CANONICAL_POSE_3_MATCH_SURFACES_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Match_options.h>
#include <CGAL/Canonical_pose_3/Matchable_surface_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Surface_match_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/linked_bodies.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/options_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/poses.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/assertions.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief finds for each vertex of a surface the point of another one that corresponds to it, such as the tip of the
left hand to the tip of the left hand.

Canonical poses of similar shapes are similar, and have the same handedness, so left and right are not confused. The
pose of the first surface is rotated toward that of the second one: its principal axes give four ways (or more, if
axes have similar lengths), from each of which closest points are iterated (P. Besl and N. McKay, 1992). Then points are
compared by more and more eigenfunctions of the Laplacian, mapped by a functional map (M. Ovsjanikov et al., "Functional maps",
2012; the refinement is that of S. Melzi et al., "ZoomOut", 2019), by their positions in the pose, which a smooth displacement brings
closer, and by the relief of the surfaces, that is, by how far they are above themselves after the heat equation has smoothed them
for four times; each coordinate counts in units of its residual. Of rotations after which the poses are nearly as close, that is
chosen whose match changes lengths of edges, functions, relief and positions the least. At last, the pose of the first surface is
registered, as rigidly as possible, to the points of the second one that match, by turns with comparisons in which normals count as
well. Vertices are where they then are on the other pose, on the same side of thin parts.

Of a surface with several components, the largest one is registered, and the others follow it. Components with less than a twentieth of
the area of the largest one, and isolated vertices, are located, but have no influence on others, nor on the means in the result.

The mirror symmetry of a shape is its match with its mirror image, that is, with its own points, one coordinate negated, and
reversed faces; the pose of this mirror image is not the mirror image of the pose.

\param surface the first surface.
\param other the second surface.
\param options the options.

\throws std::invalid_argument if a landmark is no vertex or contradicts another one, or an option is out of range.

<em>Complexity:</em> \f$ O(n \log n) \f$ for the vertices of both surfaces.
*/
Surface_match_3 match_surfaces(const Matchable_surface_3& surface, const Matchable_surface_3& other,
                               const Match_options& options = Match_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief writes surface locations of CGAL to a property map, one per vertex of a mesh.

\tparam PolygonMesh a model of `VertexListGraph`
\tparam OtherMesh a model of `FaceListGraph`
\tparam LocationMap a model of `WritablePropertyMap` with the vertex descriptor of `PolygonMesh` as key type and
        `CGAL::Polygon_mesh_processing::Face_location<OtherMesh, FT>` as value type, for any number type `FT`

\param locations one for each vertex of `mesh`: `Surface_match_3::locations`; or, for the way back,
       `Surface_match_3::locations_of_other`, with the meshes exchanged.
\param mesh the mesh whose vertices have locations.
\param other the mesh with the faces.
\param location_map receives the locations.

\pre There is a location for each vertex, and the locations are on `other`.

\throws std::invalid_argument if a face of `other` is not a triangle: a location of CGAL has three barycentric
       coordinates. Nothing is written then.

<em>Complexity:</em> linear.
*/
template <class PolygonMesh, class OtherMesh, class LocationMap>
void put_locations(const std::vector<Surface_match_3::Location>& locations, const PolygonMesh& mesh,
                   const OtherMesh& other, LocationMap location_map)
{
  using Location = typename boost::property_traits<LocationMap>::value_type;
  using Face = typename boost::graph_traits<OtherMesh>::face_descriptor;
  using FT = typename Location::second_type::value_type;
  const auto descriptors = internal::vertex_descriptors(mesh);
  const auto range = faces(other);
  const std::vector<Face> face_descriptors(range.begin(), range.end());
  CGAL_precondition(locations.size() == descriptors.size());
  internal::index_triangles(other); // refuses other faces
  const auto rows = internal::number_vertices(other);
  for(std::size_t i = 0; i < locations.size(); ++i)
  {
    const auto& [face, corners, weights] = locations[i];
    CGAL_precondition(face < face_descriptors.size());
    Location location(face_descriptors[face], {FT(0), FT(0), FT(0)});
    auto h = prev(halfedge(location.first, other), other);
    for(FT& coordinate : location.second)
    {
      const auto corner = std::find(corners.begin(), corners.end(), get(rows, target(h, other)));
      CGAL_precondition(corner != corners.end());
      coordinate = FT(weights[static_cast<std::size_t>(corner - corners.begin())]);
      h = next(h, other);
    }
    put(location_map, descriptors[i], location);
  }
}

inline namespace CGAL_CANONICAL_POSE_3_BODIES {

/*!
\ingroup PkgCanonicalPose3Ref

\brief computes the pose of a polygon mesh, and prepares both for `match_surfaces()`.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh the mesh.
\param options the options of the pose.
\param np the named parameters of `CGAL::canonical_pose_3()`.

\throws std::invalid_argument under the same conditions as `CGAL::canonical_pose_3()`.
\throws std::runtime_error also if there is no pose, or the library was built without Spectra.

\sa `Matchable_surface_3`, whose constructor is given a pose
*/
template <class PolygonMesh, class NamedParameters = parameters::Default_named_parameters>
Matchable_surface_3 matchable_surface(const PolygonMesh& mesh, const Options& options = Options(),
                                      const NamedParameters& np = parameters::default_values())
{
  const Point_matrix points = internal::points_of_parameters(mesh, np);
  const Face_list polygons = internal::index_polygons(mesh);
  const Result result = internal::pose_of_surface(
    points, polygons, internal::options_of_parameters(options, np), internal::linked_bodies());
  if(!result.is_usable())
    throw std::runtime_error("there is no pose: the registration met numbers that are not finite");
  return {points, polygons, result.pose};
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same with the default options.
*/
template <class PolygonMesh, class T, class Tag, class Base>
Matchable_surface_3 matchable_surface(const PolygonMesh& mesh,
                                      const Named_function_parameters<T, Tag, Base>& np)
{
  return matchable_surface(mesh, Options(), np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief finds for each vertex of a mesh the location on another one that corresponds to it.

The poses are computed with the default options, so that meshes that consist of several shapes are refused. For given poses,
or other options, prepare each mesh as a `Matchable_surface_3` (by its constructor or by `matchable_surface()`), match these,
and write the locations by `put_locations()`. This is what this function does.

\tparam PolygonMesh a model of `FaceListGraph`
\tparam OtherMesh a model of `FaceListGraph`
\tparam LocationMap a model of `WritablePropertyMap` with the vertex descriptor of `PolygonMesh` as key type and
        `CGAL::Polygon_mesh_processing::Face_location<OtherMesh, FT>` as value type, for any number type `FT`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
\tparam OtherNamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param mesh a polygon mesh.
\param other a triangle mesh. Both may have holes and defects, see `CGAL::canonical_pose_3()`.
\param location_map receives a location for each vertex of `mesh`.
\param options the options of the match. Its landmarks are numbers of vertices, in the order of `vertices(mesh)` and
       `vertices(other)`. Its number of threads holds for the poses, too.
\param np the named parameters of `CGAL::canonical_pose_3()`, for `mesh`.
\param np_of_other the same for `other`.

\returns the match, which also holds the way back. Its vertices and faces are counted in the order of the ranges of the meshes.

\throws std::invalid_argument if a face of `other` is not a triangle, under the same conditions as
       `CGAL::canonical_pose_3()`, and if a landmark or an option is out of range. The message starts with "the other mesh" if it
       is about `other`.
\throws std::runtime_error if the solver fails, there is no pose, or the library was built without Spectra.
*/
template <class PolygonMesh, class OtherMesh, class LocationMap,
          class NamedParameters = parameters::Default_named_parameters,
          class OtherNamedParameters = parameters::Default_named_parameters>
Surface_match_3
match_surfaces(const PolygonMesh& mesh, const OtherMesh& other, LocationMap location_map,
               const Match_options& options = Match_options(),
               const NamedParameters& np = parameters::default_values(),
               const OtherNamedParameters& np_of_other = parameters::default_values())
{
  const auto of_other = [](const auto& function) {
    try
    {
      return function();
    }
    catch(const std::invalid_argument& error)
    {
      throw std::invalid_argument(std::string("the other mesh: ") + error.what());
    }
  };
  options.check(internal::vertex_descriptors(mesh).size(),
                internal::vertex_descriptors(other).size());
  of_other([&] { // before the time is spent
    internal::index_triangles(other);
    internal::points_of_parameters(other, np_of_other);
  });
  Options of_poses;
  of_poses.number_of_threads = options.number_of_threads;
  const Matchable_surface_3 surface = matchable_surface(mesh, of_poses, np);
  const Matchable_surface_3 surface_of_other
    = of_other([&] { return matchable_surface(other, of_poses, np_of_other); });
  const Surface_match_3 match = match_surfaces(surface, surface_of_other, options);
  put_locations(match.locations, mesh, other, location_map);
  return match;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same with the default options.
*/
template <class PolygonMesh, class OtherMesh, class LocationMap, class T, class Tag, class Base,
          class OtherNamedParameters = parameters::Default_named_parameters>
Surface_match_3
match_surfaces(const PolygonMesh& mesh, const OtherMesh& other, LocationMap location_map,
               const Named_function_parameters<T, Tag, Base>& np,
               const OtherNamedParameters& np_of_other = parameters::default_values())
{
  return match_surfaces(mesh, other, location_map, Match_options(), np, np_of_other);
}

} // namespace CGAL_CANONICAL_POSE_3_BODIES

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MATCH_SURFACES_H
