# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Detail-preserving canonical poses of 3D shapes.

A surface is given by ``vertices``, an array of n x 3 coordinates in any unit, and ``faces``, an
array of m x k indices of vertices from 0 (k = 3 for triangles), or a sequence of faces with
different numbers of corners. A tetrahedral mesh has ``cells``, m x 4, instead. Surfaces may have
holes, self-intersections and other defects, which are repaired internally; `check` lists them.

Lengths that are returned are in the unit of the vertices. Results are the same, bit for bit, as
those of the program ``canonical-pose`` with the options of the same names, and do not depend on the
number of threads. Reports have the form of its JSON reports. Matrices that are returned are in
Fortran order, in which they were computed, and are not copied.

Functions raise `ValueError` if an argument does not fit, with a message that names the defect and
the element; `RuntimeError` if something fails on the way; and `TypeError` for arguments of wrong
types. They run without the lock of the interpreter, so several can run in threads. Ctrl+C stops what
the main thread computes: a registration after the current iteration, distances between sources.
What `progress` raises stops a registration likewise.

Many shapes are described by `collection`, compared by `search`, and evaluated by `evaluate`; these run
the program ``canonical-pose``.
"""

import json as _json
import os as _os
import typing as _typing
import warnings as _warnings

import numpy as _numpy

from canonical_pose import _core
from canonical_pose._collections import collection, evaluate, search

__version__ = _core.version
__all__ = [
    "DescriptorIndex", "HeatSolver", "Match", "Mesh", "Progress", "Registrar",
    "align_handedness", "check", "collection", "compare", "describe", "evaluate", "geodesics", "load",
    "match", "mean_pose", "pose", "save", "search", "segment", "shape_distance", "target",
]


class Mesh(_typing.NamedTuple):
    """What a file contains: a surface, or a tetrahedral mesh; see `load`.

    Examples
    --------
    >>> mesh = canonical_pose.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], None, [[0, 1, 2, 3]])
    >>> pose, report = canonical_pose.pose(**mesh._asdict())
    """

    vertices: _numpy.ndarray
    faces: _typing.Any
    cells: _typing.Any


class Progress(_typing.NamedTuple):
    """What `progress` is called with, after each iteration of a registration.

    Attributes
    ----------
    iteration : int
        Number of completed iterations, from 1.
    round : int
        The round, from 1, if distances are measured on the pose; 0 for the final pose.
    component : int
        The number of the component, from 0, by decreasing size; the smallest is posed first.
    energy, energy_match, energy_arap, energy_constraints : float
        The energy, without unit, and its parts.
    largest_move : float
        The largest displacement of a vertex in this iteration, as a fraction of the largest distance.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> def stop_at_third(progress):
    ...     return progress.iteration < 3
    >>> pose, report = canonical_pose.pose(vertices, faces, landmarks=8, progress=stop_at_third)
    >>> report["registration"]["iterations"], report["registration"]["converged"]
    (3, False)
    """

    iteration: int
    round: int
    component: int
    energy: float
    energy_match: float
    energy_arap: float
    energy_constraints: float
    largest_move: float


def load(path):
    """Read a mesh from a file.

    Parameters
    ----------
    path : string or path
        A file that the program reads: OFF, OBJ, PLY, STL, glTF, or MEDIT, also compressed (``.gz``).

    Returns
    -------
    mesh : Mesh
        A named tuple of ``vertices``, an array of n x 3, ``faces``, an array of m x k, or a list of
        lists if their numbers of corners differ, and ``cells``, an array of m x 4. Of a surface,
        ``cells`` is None, and of a tetrahedral mesh, ``faces`` is.

    Examples
    --------
    >>> with open("triangle.obj", "w") as file:
    ...     characters = file.write("v 0 0 0\\nv 2 0 0\\nv 0 1 0\\nf 1 2 3\\n")
    >>> mesh = canonical_pose.load("triangle.obj")
    >>> mesh.vertices.shape, mesh.faces, mesh.cells
    ((3, 3), array([[0, 1, 2]]), None)
    """
    return Mesh(*_core.load(_os.fspath(path)))


def save(path, vertices, faces=None, *, cells=None, like=None):
    """Write a mesh to a file, in the format of its extension.

    Parameters
    ----------
    path : string or path
        ``.off``, ``.obj``, ``.ply``, ``.stl``, ``.glb``; for tetrahedral meshes, ``.mesh``, ``.vtu``.
        With ``.gz`` at the end, the file is compressed.
    vertices : array, n x 3
        Positions.
    faces : array of integers, m x k, or sequence of sequences
        The faces of a surface.
    cells : array of integers, m x 4
        The cells of a tetrahedral mesh, instead of `faces`.
    like : string or path
        A file with n vertices, whose faces or cells are written, instead of `faces` and `cells`. If
        both files have the same format, all of it but the positions stays as it is (texture
        coordinates, materials, colors, ...), and normals turn with the faces. Otherwise, or if
        something is lost nevertheless, there is a warning.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> canonical_pose.save("box.ply", vertices, faces)
    >>> pose, report = canonical_pose.pose(vertices, faces)
    >>> canonical_pose.save("pose.ply", pose, like="box.ply")
    """
    if like is not None and (faces is not None or cells is not None):
        raise TypeError("faces and cells are those of the file `like`")
    lost = _core.save(_os.fspath(path), vertices, faces, cells,
                      None if like is None else _os.fspath(like))
    if lost:
        _warnings.warn(f"'{_os.fspath(path)}' lacks {', '.join(lost)} of '{_os.fspath(like)}'",
                       stacklevel=2)


def pose(vertices, faces=None, *, cells=None, return_target=False, progress=None,
         detail_length=0.1, landmarks=80, rounds=None, body="auto", spacing=None,
         geodesics="heat", target_mode="mds", kernel="classical", tikhonov=0., iterations=500,
         paper_weights=None, injective=None, stance="canonical", frame="auto",
         components="auto", contacts="keep", symmetry="auto", solver="auto", seed=0, threads=0,
         matching_weights=None, stiffness=None, given_target=None, given_distances=None,
         spring=None, direction=None, handle=None, symmetric=None):
    """Bring a shape into its canonical pose.

    Parameters
    ----------
    vertices : array, n x 3
        Positions, in any unit.
    faces : array of integers, m x k, or sequence of sequences
        The faces of a surface.
    cells : array of integers, m x 4
        The cells of a tetrahedral mesh, instead of `faces`.
    return_target : bool
        Whether the target of the registration is returned, too.
    progress : function
        Called with a `Progress` after each iteration. If it returns False, the pose is that of least
        energy until then.
    detail_length : float
        Details smaller than this keep their shape; as a fraction of the largest distance, from
        1e-6 to 1000.
    landmarks : int
        Number of landmarks.
    rounds : int
        How often distances are measured again on the pose, at most. By default 3, or 0 with
        `given_target`, `paper_weights`, `target_mode="unfold"` or the uncentered kernel.
    body : "auto", "lattice", "tetgen" or "mesh"
        The elastic body inside a surface.
    spacing : float
        Spacing of the lattice, as a fraction of the largest distance, from 1e-6 to 1; by default,
        it depends on the thickness of the shape.
    geodesics : "heat", "wavefront" or "exact"
        How distances are computed.
    target_mode : "mds" or "unfold"
        Whether the target is computed by scaling of distances, or by moving the vertices away from
        each other.
    kernel : "classical", "gaussian" or "gaussian-uncentred"
        The kernel of the target.
    tikhonov : float
        Weight, without unit, that holds an iteration near the one before; from 0 to 1e9.
    iterations : int
        Maximum number of iterations.
    paper_weights : pair of floats
        Alpha, in the inverse of the unit of the vertices, and beta, as in the paper. They replace
        `detail_length` and `tikhonov`.
    injective : bool
        Whether no cell may be inverted. By default, true except with `paper_weights`.
    stance : "canonical", "t", "a", "vitruvian" or "stand"; or dict, or sequence of tuples
        The canonical pose; or, of a person, arms level ("t", "vitruvian") or 45 degrees downward
        ("a"), legs parallel or apart ("vitruvian"); or, of an animal, four legs straight downward
        ("stand"). Shapes without such limbs are refused. A dict has a direction (x, y, z) per limb:
        to the left of the body, upward, to the front; with "as-is" after it, if the limb keeps the
        bends of the canonical pose, instead of becoming straight. Keys are "left arm", "right
        arm", "left leg", "right leg", "left front leg", "right front leg", "left hind leg", "right
        hind leg", or a vertex of the limb. The other limbs are those of the item "stance", one of
        the names above, or keep their canonical pose relative to the trunk. The same as a
        sequence: [("stance", "a"), ("left arm", 1, 2, 0), (1234, 0, -1, .5, "as-is")].
    frame : "auto", "input", "canonical" or "body"
        The position of the pose: near the input; in the principal axes of the pose; or upright, the
        front toward +z and the feet on y = 0. By default, the last one for a stance, else the first
        one. Targets, given or returned, are near the input in any case.
    components : "auto", "refuse", "largest" or "each"
        What to do if there is more than one connected component. By default, what is small, inside
        or in contact follows the largest one, and other components are refused; see the item
        "followers" of the report.
    contacts : "keep" or "cut"
        Whether handles of a surface that look like false contacts of its parts are cut.
    symmetry : "auto" or "none"
        Whether the target is made symmetric where the shape has a clear symmetry.
    solver : "auto", "eigen" or "cholmod"
        The linear solver.
    seed : int
        0, or the seed that draws the first landmark.
    threads : int
        Maximum number of threads; 0 for no limit.
    matching_weights : array, n
        Factors of the weights of the vertices, without unit, 0 or from 1e-100 to 1e100.
    stiffness : array, n (surface) or m (tetrahedral mesh)
        Factors of the stiffness, without unit, from 1e-9 to 1e9.
    given_target : array, n x 3
        The target to be used, in the unit of the vertices. For a tetrahedral mesh, that of the
        vertices of its boundary.
    given_distances : array, n x l
        The distances to l landmarks to be used, in the unit of the vertices, as `geodesics`
        returns them.
    spring : sequence of (i, j, length) or (i, j, length, stiffness)
        Springs between two vertices; `length` in the unit of the vertices.
    direction : sequence of (i, j, x, y, z) or (i, j, x, y, z, stiffness)
        Vectors to vertex i from vertex j, in the unit of the vertices.
    handle : sequence of (i, x, y, z) or (i, x, y, z, stiffness)
        Positions of vertices, in the unit of the vertices.
    symmetric : sequence of (i, j) or (i, j, stiffness)
        Vertices that mirror each other.

    Returns
    -------
    pose : array, n x 3
        The positions of the vertices in the canonical pose, in the unit of the vertices.
    report : dict
        ``"input"``, numbers of elements and of defects; ``"body"``, its ``"kind"`` and size;
        ``"followers"``, the components without a pose of their own; ``"target"``, among others
        ``"max_geodesic"``, the largest distance; ``"rounds"``; ``"registration"``, with
        ``"iterations"``, ``"converged"`` and energies; ``"skeleton"``, None without a stance, else
        ``"kind"``, ``"is_front_certain"`` and ``"joints"``; ``"solver"``; ``"warnings"``; ``"stages"``, dicts
        of ``"name"`` ("diagnosis", "geodesics", "target", "body", "factorization", "local_steps",
        "global_steps" or "stance") and ``"seconds"``; ``"total_seconds"``, ``"peak_memory_bytes"`` and
        ``"versions"``.
    target : array, n x 3
        Only if `return_target`. For a tetrahedral mesh, that of the vertices of its boundary.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in range(7) for y in (0, 1) for z in (0, 1)]
    >>> rings = [[4 * x + i for i in (0, 1, 3, 2)] for x in range(7)]
    >>> faces = [[a[i], b[i], b[i - 1], a[i - 1]] for a, b in zip(rings, rings[1:])
    ...          for i in range(4)] + [rings[0][::-1], rings[-1]]
    >>> pose, report = canonical_pose.pose(vertices, faces, detail_length=0.1)
    >>> pose.shape
    (28, 3)
    >>> report["registration"]["converged"]
    True
    """
    result, target_points, report = _core.pose(vertices, faces, cells, dict(
        progress=_values(progress),
        detail_length=detail_length, landmarks=landmarks, rounds=rounds, body=body,
        spacing=spacing, geodesics=geodesics, target_mode=target_mode, kernel=kernel,
        tikhonov=tikhonov, iterations=iterations, paper_weights=paper_weights, injective=injective,
        stance=stance, frame=frame, components=components, contacts=contacts, symmetry=symmetry,
        solver=solver,
        seed=seed, threads=threads,
        matching_weights=matching_weights, stiffness=stiffness, given_target=given_target,
        given_distances=given_distances, spring=spring, direction=direction, handle=handle,
        symmetric=symmetric))
    report = _json.loads(report)
    return (result, report, target_points) if return_target else (result, report)


_pose_of = pose  # other functions have an argument with the name of this one


def target(vertices, faces, **options):
    """Compute the first target of a surface, without a registration.

    It is the embedding of the vertices by multidimensional scaling of their distances, in the
    position of the surface. `pose` refines it in its rounds; see there, `return_target`.

    Parameters
    ----------
    vertices : array, n x 3
        Positions, in any unit.
    faces : array of integers, m x k, or sequence of sequences
        The faces.
    **options
        As for `pose`; `landmarks`, `geodesics`, `kernel`, `components`, `seed`,
        `given_distances`, `solver` and `threads` are used.

    Returns
    -------
    target : array, n x 3
        The target of each vertex, in the unit of the vertices. Vertices that belong to no face, or
        to a component that is not posed, keep their position.
    report : dict
        The report as of `pose`, in which what describes body and registration is empty.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> target, report = canonical_pose.target(vertices, faces, landmarks=8)
    >>> target.shape, report["target"]["landmarks"]
    ((8, 3), 8)
    """
    if "progress" in options:
        raise TypeError("a target has no option progress, since there is no registration")
    result, report = _core.target(vertices, faces, options)
    return result, _json.loads(report)


def geodesics(vertices, faces, source, *, geodesics="heat", threads=0):
    """Measure distances along a surface.

    Parameters
    ----------
    vertices : array, n x 3
        Positions, in any unit.
    faces : array of integers, m x k, or sequence of sequences
        The faces. Each vertex must belong to one.
    source : int, or array of s integers
        The vertex, or the vertices, from which distances are measured.
    geodesics : "heat", "wavefront" or "exact"
        How distances are computed. Heat is fast, with a mean error of 1 to 5 percent.
    threads : int
        Maximum number of threads; 0 for no limit.

    Returns
    -------
    distances : array, n, or n x s if `source` is an array
        Distances in the unit of the vertices; infinite if there is no path.

    See also `HeatSolver`, for many sources one after the other.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> canonical_pose.geodesics(vertices, faces, 0, geodesics="exact").round(2)[[0, 1, 7]]
    array([0.  , 1.  , 2.24])
    >>> canonical_pose.geodesics(vertices, faces, [0, 7]).shape
    (8, 2)
    """
    sources, is_single = _sources(source)
    distances = _core.geodesics(vertices, faces, sources,
                                dict(geodesics=geodesics, threads=threads))
    return distances[:, 0] if is_single else distances


def check(vertices, faces=None, *, cells=None):
    """Tell what is wrong with a surface, or with the boundary of a tetrahedral mesh, if anything.

    Parameters
    ----------
    vertices : array, n x 3
        Positions, in any unit.
    faces : array of integers, m x k, or sequence of sequences
        The faces.
    cells : array of integers, m x 4
        The cells of a tetrahedral mesh, instead of `faces`.

    Returns
    -------
    report : dict
        ``"input"`` with numbers of elements and of defects, ``"first_defect"`` (None if there is
        none), ``"defects"``, dicts of ``"kind"``, ``"count"``, ``"element"``, ``"examples"`` and
        ``"message"``, and ``"stages"`` (its only name is "diagnosis"), ``"total_seconds"``,
        ``"peak_memory_bytes"`` and ``"versions"``, as of `pose`.

    Examples
    --------
    >>> report = canonical_pose.check([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    ...                               [[0, 2, 1], [0, 1, 3], [1, 2, 3]])
    >>> report["input"]["boundary_edges"]
    3
    """
    return _json.loads(_core.check(vertices, faces, cells))


def compare(pose, other, *more):
    """Tell how much poses of corresponding vertices differ.

    Neither position, orientation nor scale matter: poses are scaled to a radius of gyration of 1
    and moved onto each other.

    Parameters
    ----------
    pose, other, *more : arrays, n x 3
        Positions, in any unit, which may differ between the poses.

    Returns
    -------
    proper : float
        The root mean square distance of corresponding vertices, without unit; the mean over all
        pairs of poses.
    reflected : float
        The same, if mirror images are considered to be the same pose.

    Examples
    --------
    >>> pose = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]]
    >>> proper, reflected = canonical_pose.compare(pose, [[-x, y, z] for x, y, z in pose])
    >>> round(proper, 3), round(reflected, 3)
    (0.414, 0.0)
    """
    return _core.compare([pose, other, *more])


def align_handedness(pose, other, *more):
    """Find the poses of a shape that are mirror images of most of the others.

    The handedness of a single pose is not always certain: see ``"is_handedness_certain"`` in the
    report of `pose`. To make it consistent, pose such a shape again, with the mirror image of its
    target: ``given_target=target * [-1, 1, 1]``.

    Parameters
    ----------
    pose, other, *more : arrays, n x 3
        Positions of corresponding vertices, in any unit, which may differ between the poses.

    Returns
    -------
    is_mirrored : array of booleans
        For each pose, whether it has the other handedness than most of them; of as many on each side,
        than the first one.

    Examples
    --------
    >>> pose = [[0, 0, 0], [1, 0, 0], [0, 2, 0], [0, 0, 3]]
    >>> canonical_pose.align_handedness(pose, [[-x, y, z] for x, y, z in pose])
    array([False,  True])
    """
    return _numpy.array(_core.align_handedness([pose, other, *more]))


def mean_pose(poses):
    """Return the mean of poses, or of other shapes, with corresponding vertices.

    All are moved rigidly onto the mean and averaged, until the mean does not change. They are neither
    scaled nor reflected; see `align_handedness`.

    Parameters
    ----------
    poses : sequence of arrays, n x 3
        Positions of corresponding vertices, in the same unit, at any positions.

    Returns
    -------
    mean : array, n x 3
        The mean, in the same unit, and in the position nearest to that of the first pose.

    Examples
    --------
    >>> pose = canonical_pose.mean_pose([[[0, 0, 0], [2, 0, 0], [0, 1, 0]],
    ...                                  [[5, 0, 0], [5, 2, 0], [4, 0, 0]]])
    >>> (pose.round(6) + 0.).tolist()
    [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
    """
    return _core.mean_pose(list(poses))


def segment(vertices, faces, *, parts="auto", method="consensus", pose=None, progress=None,
            **options):
    """Divide a surface into parts, such as limbs, head and trunk.

    Parameters
    ----------
    vertices : array, n x 3
        Positions, in any unit.
    faces : array of integers, m x k, or sequence of sequences
        The faces.
    parts : int or "auto"
        Number of parts.
    method : "consensus", "sweep" or "kmeans"
        Sweep is fast, kmeans is that of the paper.
    pose : array, n x 3
        The pose to be used, in any unit; otherwise it is computed, if the method needs it.
    progress : function
        As for `pose`, while it is computed.
    **options
        As for `pose`; but each component is posed by default.

    Returns
    -------
    part_of_face : array of integers, m
        The part of each face, from 0.
    report : dict
        ``"method"``; ``"parts"``, dicts of ``"area"``, ``"faces"`` and ``"neighbors"``, with
        ``"part"``, ``"boundary_length"`` and ``"boundary_centroid"``; ``"tree"``, the hierarchy of parts
        (None with kmeans), with ``"leaves"``, ``"leaf_of_face"``, an array, and ``"merges"``;
        ``"warnings"``; ``"stages"`` ("pose", "segmentation" and "write"), ``"total_seconds"``,
        ``"peak_memory_bytes"`` and ``"versions"``, as of `pose`.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> part_of_face, report = canonical_pose.segment(vertices, faces, parts=1)
    >>> part_of_face
    array([0, 0, 0, 0, 0, 0])
    """
    if method not in ("consensus", "sweep", "kmeans"):
        raise ValueError(f"option method is {method!r}, but must be one of consensus, kmeans, sweep")
    if parts == "auto":
        parts = 0
    elif not hasattr(parts, "__index__"):
        raise TypeError("option parts must be an integer or 'auto'")
    elif parts < 1:
        raise ValueError(f"option parts is {parts}, but must be >= 1, or 'auto'")
    part_of_face, report = _core.segment(vertices, faces, parts, method, pose,
                                         {"components": "each", "progress": _values(progress),
                                          **options})
    report = _json.loads(report)
    if report.get("tree"):
        report["tree"]["leaf_of_face"] = _numpy.array(report["tree"]["leaf_of_face"], dtype=int)
    return part_of_face, report


def describe(vertices, faces, *, descriptor=None, pose=None, progress=None, **options):
    """Describe a surface by numbers, for search.

    Parameters
    ----------
    vertices : array, n x 3
        Positions, in any unit.
    faces : array of integers, m x k, or sequence of sequences
        The faces.
    descriptor : string, or sequence of strings
        The descriptors: "heat-kernel-quantiles", "shape-dna", "shape-distribution-d2" and
        "views"; by default, all.
    pose : array, n x 3
        The pose to be used, in any unit; otherwise it is computed, if a descriptor needs it.
    progress : function
        As for `pose`, while it is computed.
    **options
        As for `pose`; but each component is posed by default.

    Returns
    -------
    descriptors : dict
        For each name a dict of ``"version"``, an integer, and ``"values"``, an array without unit.

    See also `shape_distance` and `DescriptorIndex`.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> described = canonical_pose.describe(vertices, faces, descriptor="views", pose=vertices)
    >>> list(described), described["views"]["version"]
    (['views'], 1)
    """
    names = [] if descriptor is None else [descriptor] if isinstance(descriptor, str) else descriptor
    return _core.describe(vertices, faces, list(names), pose,
                          {"components": "each", "progress": _values(progress), **options})


class Match(_typing.NamedTuple):
    """Where the vertices of a surface are on another one, and the other way: what `match` returns.

    Attributes
    ----------
    faces : array of integers, n
        For each vertex, a face of the other surface.
    vertices : array of integers, n x 3
        Three vertices of this face.
    weights : array, n x 3
        Their weights, which are not negative and sum to 1.
    faces_at_other, vertices_at_other, weights_at_other : arrays, N, N x 3 and N x 3
        The same the other way: for each vertex of the other surface, a face of this one.
    round_trips : array, n
        The distance between a vertex and the point to which it returns from the other surface, in
        radii of the pose: small where both directions agree.
    scale : float
        The size of the surface, relative to that of the other one: the root of the ratio of areas.
    mean_distance : float
        The mean distance between nearest points of the poses, in their radii.
    edge_strain : float
        The sum of the changes of lengths of edges, relative to the sum of their lengths, both surfaces
        scaled to the same area. If it is several times the mean distance, parts may be missing.
    is_rotation_certain : bool
        Whether no other rotation of the pose leads to nearly as good a match; otherwise, front and
        back may be confused.
    compared_share, compared_share_of_other : float
        The shares of the areas that are compared: of the largest component and those near it that
        are not small.

    Examples
    --------
    >>> vertices = [[0, 0, 0], [3, 0, 0], [0, 2, 0], [0, 0, 1]]
    >>> faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
    >>> match = canonical_pose.match(vertices, faces, vertices, faces, pose=vertices,
    ...                              other_pose=vertices)
    >>> match.interpolated([10., 20., 30., 40.]).round(6)
    array([10., 20., 30., 40.])
    """

    faces: _numpy.ndarray
    vertices: _numpy.ndarray
    weights: _numpy.ndarray
    faces_at_other: _numpy.ndarray
    vertices_at_other: _numpy.ndarray
    weights_at_other: _numpy.ndarray
    round_trips: _numpy.ndarray
    scale: float
    mean_distance: float
    edge_strain: float
    is_rotation_certain: bool
    compared_share: float
    compared_share_of_other: float

    def interpolated(self, values):
        """Return values at the vertices of the surface, given those at the vertices of the other one."""
        return _numpy.einsum("nk,nk...->n...", self.weights, _numpy.asarray(values)[self.vertices])

    def interpolated_at_other(self, values):
        """Return values at the vertices of the other surface, given those at the vertices of this one."""
        return _numpy.einsum("nk,nk...->n...", self.weights_at_other,
                             _numpy.asarray(values)[self.vertices_at_other])

    def transferred_labels(self, faces, other_vertices, other_faces, labels):
        """Return a label for each face of the surface, given one for each face of the other surface.

        It is that of the face of the other surface near whose vertices the corners are.

        Parameters
        ----------
        faces, other_faces : arrays of integers, m x k and M x K, or sequences of sequences
            The faces.
        other_vertices : array, N x 3
            The positions of the other surface.
        labels : array, M
            A label, or any other value, for each face of the other surface.

        Returns
        -------
        labels : array, m
        """
        return _numpy.asarray(labels)[_core.matched_faces(self.vertices, self.weights, faces,
                                                           other_vertices, other_faces)]


def match(vertices, faces, other_vertices, other_faces, *, pose=None, other_pose=None,
          landmarks=(), progress=None, **options):
    """Find which point of a surface is which point of another one of the same kind.

    The match with the mirror image of a surface, ``vertices * [-1, 1, 1]`` and ``faces[:, ::-1]``, is its mirror
    symmetry.

    Parameters
    ----------
    vertices, other_vertices : arrays, n x 3 and N x 3
        Positions, in any units.
    faces, other_faces : arrays of integers, m x k and M x K, or sequences of sequences
        The faces. Vertices and faces need not correspond.
    pose, other_pose : arrays, n x 3 and N x 3
        The poses to be used, in any units; otherwise they are computed.
    landmarks : sequence of pairs of integers
        A vertex and one of the other surface that match.
    progress : function
        As for `pose`, while they are computed.
    **options
        As for `pose`; by default, each component is posed.

    Returns
    -------
    match : Match
        For each vertex, a point of a face of the other surface, and the other way.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 2) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> match = canonical_pose.match(vertices, faces, vertices, faces, pose=vertices,
    ...                              other_pose=vertices)
    >>> match.interpolated(vertices).shape
    (8, 3)

    The surface in the posture of the other one, with its own size and details:

    >>> posture, report = canonical_pose.pose(
    ...     vertices, faces, given_target=match.scale * match.interpolated(vertices))
    >>> posture.shape
    (8, 3)
    """
    options = {"components": "each", "progress": progress, **options}
    landmarks = list(landmarks)
    _core.check_landmarks(vertices, faces, other_vertices, other_faces, landmarks)
    poses = [given if given is not None else _pose_of(surface, surface_faces, **options)[0]
             for given, surface, surface_faces in ((pose, vertices, faces),
                                                   (other_pose, other_vertices, other_faces))]
    return Match(*_core.match(vertices, faces, poses[0], other_vertices, other_faces, poses[1],
                              landmarks, options))


def shape_distance(vertices, faces, other_vertices, other_faces, *, descriptor=None, pose=None,
                   other_pose=None, progress=None, **options):
    """Tell how different two surfaces are, whatever their poses.

    The distances are those by which the program searches a collection with a single descriptor. Those of
    different descriptors cannot be compared with each other.

    Parameters
    ----------
    vertices, other_vertices : arrays, n x 3 and N x 3
        Positions, in any units.
    faces, other_faces : arrays of integers, m x k and M x K, or sequences of sequences
        The faces. Vertices and faces need not correspond.
    descriptor : string, or sequence of strings
        As for `describe`; by default, all.
    pose, other_pose : arrays, n x 3 and N x 3
        The poses to be used, in any units; otherwise they are computed, if a descriptor needs them.
    progress : function
        As for `pose`, while they are computed.
    **options
        As for `describe`.

    Returns
    -------
    distances : dict
        For each name of a descriptor the distance, without unit.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> canonical_pose.shape_distance(vertices, faces, vertices, faces, descriptor="views")
    {'views': 0.0}
    """
    options.update(descriptor=descriptor, progress=progress)
    described = describe(vertices, faces, pose=pose, **options)
    others = describe(other_vertices, other_faces, pose=other_pose, **options)
    distances = {}
    for name, other in others.items():
        index = DescriptorIndex(name)
        index.insert(other["values"])
        distances[name] = float(index.distances(described[name]["values"])[0])
    return distances


class HeatSolver:
    """Measures distances along a surface, from many sources: it is prepared once.

    Parameters
    ----------
    vertices : array, n x 3
        Positions, in any unit.
    faces : array of integers, m x k, or sequence of sequences
        The faces. Each vertex must belong to one.
    time_step_factor : float
        The time step by the square of the mean edge length; the larger, the smoother the distances.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> solver = canonical_pose.HeatSolver(vertices, faces)
    >>> solver.distances(0).shape, solver.distances([0, 7]).shape
    ((8,), (8, 2))
    """

    def __init__(self, vertices, faces, *, time_step_factor=1.):
        self._core = _core.Heat_solver(vertices, faces, time_step_factor)
        self._arguments = _copied(vertices, faces), {"time_step_factor": time_step_factor}

    def __reduce__(self):
        return _restored, (HeatSolver, *self._arguments)

    def __repr__(self):
        return f"<HeatSolver of {len(self._arguments[0][0])} vertices>"

    def distances(self, source):
        """Return the distances of all vertices.

        Parameters
        ----------
        source : int, or array of s integers
            The vertex, or the vertices, from which distances are measured.

        Returns
        -------
        distances : array, n, or n x s if `source` is an array
            Distances in the unit of the vertices; infinite if there is no path. The same numbers
            as those of `geodesics`.
        """
        sources, is_single = _sources(source)
        result = self._core.distances(sources)
        return result[:, 0] if is_single else result

    def distance_to_nearest(self, sources):
        """Return the distance of each vertex from the nearest of the sources.

        Parameters
        ----------
        sources : array of s integers
            The vertices from which distances are measured.

        Returns
        -------
        distances : array, n
            Distances in the unit of the vertices; infinite if there is no path.
        """
        return self._core.distance_to_nearest(sources)


class Registrar:
    """Pulls a surface toward one target after the other: body and matrix are prepared once.

    Parameters
    ----------
    vertices : array, n x 3
        Positions, in any unit.
    faces : array of integers, m x k, or sequence of sequences
        The faces.
    **options
        As for `pose`, but for constraints, `rounds`, `stance`, `frame` and `paper_weights`.

    Copies and pickles are prepared anew, with the current detail length, and start at rest.

    Attributes
    ----------
    target : array, n x 3
        The first target, see the function `target`, in the unit of the vertices.
    body_vertices : array, N x 3
        The vertices of the elastic body at rest, in the unit of the vertices.
    body_cells : array of integers, M x 4
        Its cells.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> registrar = canonical_pose.Registrar(vertices, faces, landmarks=8)
    >>> pose, report = registrar.register(registrar.target)
    >>> pose.shape, report["inverted"]
    ((8, 3), 0)
    """

    def __init__(self, vertices, faces, **options):
        for name in ("rounds", "stance", "frame", "paper_weights", "spring", "direction", "handle",
                     "symmetric", "progress"):
            if name in options:
                raise TypeError(f"a registrar has no option {name}")
        self._core = _core.Registrar(vertices, faces, options)
        self._arguments = _copied(vertices, faces), options
        self._detail_length = None

    def __reduce__(self):
        return _restored, (Registrar, *self._arguments), self._detail_length

    def __setstate__(self, detail_length):
        self.set_detail_length(detail_length)

    def __repr__(self):
        return f"<Registrar of {len(self._arguments[0][0])} vertices>"

    @property
    def target(self):
        return self._core.target()

    @property
    def body_vertices(self):
        return self._core.body_vertices()

    @property
    def body_cells(self):
        return self._core.body_cells()

    def set_detail_length(self, detail_length):
        """Set the detail length, as a fraction of the largest distance."""
        self._core.set_detail_length(detail_length)
        self._detail_length = detail_length

    def register(self, target, *, warm=False, progress=None):
        """Pull the surface toward a target.

        Parameters
        ----------
        target : array, n x 3
            The target of each vertex, in the unit of the vertices.
        warm : bool
            Whether to start where the registration before ended.
        progress : function
            As for `pose`; ``round`` and ``component`` are 0.

        Returns
        -------
        pose : array, n x 3
            The positions of the vertices, in the unit of the vertices.
        report : dict
            ``"iterations"``, ``"converged"``, ``"energy"``, ``"energy_match"``, ``"energy_arap"``, the
            number of ``"inverted"`` cells, and ``"volume_ratio"``.
        """
        return self._core.register(target, warm, _values(progress))


class DescriptorIndex:
    """Searches shapes by one of the descriptors of `describe`.

    Parameters
    ----------
    descriptor : string
        Its name.

    Examples
    --------
    >>> index = canonical_pose.DescriptorIndex("shape-distribution-d2")
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> described = canonical_pose.describe(vertices, faces, descriptor="shape-distribution-d2",
    ...                                     pose=vertices)
    >>> values = described["shape-distribution-d2"]["values"]
    >>> index.insert(values)
    0
    >>> index.nearest(values, 1)
    (array([0]), array([0.]))
    """

    def __init__(self, descriptor):
        self._core = _core.Descriptor_index(descriptor)
        self._descriptor = descriptor

    def __reduce__(self):
        return _restored_index, (self._descriptor, [self.values(i) for i in range(len(self))])

    def __repr__(self):
        return f"<DescriptorIndex of {len(self)} shapes by {self._descriptor}>"

    def save(self, path):
        """Write the index to a file, which `load` reads."""
        values = [self.values(i) for i in range(len(self))]
        with open(path, "wb") as file:
            _numpy.savez(file, descriptor=self._descriptor, values=values)

    @staticmethod
    def load(path):
        """Return the index in a file that `save` wrote."""
        with _numpy.load(path, allow_pickle=False) as file:
            if "descriptor" not in file or "values" not in file:
                raise ValueError(f"'{_os.fspath(path)}' is not an index")
            return _restored_index(str(file["descriptor"]), list(file["values"]))

    def __len__(self):
        return len(self._core)

    def insert(self, values):
        """Add a shape by the values of its descriptor, and return its number, from 0."""
        return self._core.insert(values)

    def values(self, shape):
        """Return the values of a shape."""
        return self._core.values(shape)

    def distances(self, query=None):
        """Return the distances of all shapes, without unit.

        Parameters
        ----------
        query : array
            The values of another shape. None for the distances of all pairs.

        Returns
        -------
        distances : array, n, or n x n without `query`
        """
        return self._core.all_distances() if query is None else self._core.distances(query)

    def nearest(self, query, number=10):
        """Return the shapes nearest to a query.

        Parameters
        ----------
        query : array
            The values of another shape.
        number : int
            At most as many shapes are returned.

        Returns
        -------
        shapes : array of integers
            Their numbers, the nearest one first.
        distances : array
            Their distances, without unit.
        """
        return self._core.nearest(query, number)


def _copied(vertices, faces):
    """Return copies, for pickles of what was computed from them."""
    faces = (_numpy.array(faces) if hasattr(faces, "__array__")
             else [list(face) for face in faces])
    return _numpy.array(vertices, dtype=float), faces


def _restored(which, arrays, options):
    return which(*arrays, **options)


def _restored_index(descriptor, values):
    index = DescriptorIndex(descriptor)
    for vector in values:
        index.insert(vector)
    return index


def _values(progress):
    """Return a function of the values of a `Progress`."""
    return (lambda *values: progress(Progress(*values))) if callable(progress) else progress


def _sources(source):
    """Return sources as a sequence, and whether there is a single one."""
    is_single = _numpy.ndim(source) == 0
    return [source] if is_single else source, is_single
