# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors
"""What does not fit is an exception with a message; nothing is printed."""

import inspect
import os
import subprocess

import numpy as np
import pytest

import canonical_pose

NOT_FINITE = "vertex 3 has a coordinate that is not finite"


def with_value(array, index, value):
    array = np.array(array)
    array[index] = value
    return array


BAD_VERTICES = [
    (lambda v: v[:, :2], "vertices must be n x 3, but is 240 x 2"),
    (lambda v: v[0], "vertices must have 2 dimensions, but is 3"),
    (lambda v: v[None], "vertices must have 2 dimensions, but is 1 x 240 x 3"),
    (lambda v: 1., "vertices must have 2 dimensions, but is a single number"),
    (lambda v: [], "vertices must have 2 dimensions, but is empty"),
    (lambda v: None, "vertices must be an array of numbers"),
    (lambda v: v.astype(complex), "vertices must be an array of numbers"),
    (lambda v: v.astype(str), "vertices must be an array of numbers"),
    (lambda v: v.astype(object), "vertices must be an array of numbers"),
    (lambda v: [[0, 0, 0], [1, 2]], "vertices must be an array of numbers"),
    (lambda v: np.ma.masked_array(v, mask=v > v.mean()), "vertices must not have masked elements"),
    (lambda v: with_value(v, (3, 1), np.nan), NOT_FINITE),
    (lambda v: with_value(v, (3, 1), -np.inf), NOT_FINITE),
    (lambda v: v[:0], "names vertex .*, but there are 0"),
    (lambda v: v[:200], "face .* names vertex 2.., but there are 200"),
]
BAD_FACES = [
    (lambda f: f.astype(float), "faces must be integers"),
    (lambda f: f > 3, "faces must be integers"),
    (lambda f: f[0], "faces must have 2 dimensions, but is 3"),
    (lambda f: f[:, :2], "face 0 is not a polygon"),
    (lambda f: with_value(f, (3, 1), -1), "face 3 names (vertex -1, but there are 240|a vertex that does not exist)"),
    (lambda f: with_value(f, (3, 1), 240), "face 3 names vertex 240, but there are 240"),
    (lambda f: with_value(f.astype(np.uint64), (3, 1), 2**64 - 1),
     "faces names vertex 18446744073709551615, which is too large"),
    (lambda f: [*f.tolist(), [1, 2]], "face .* is not a polygon"),
    (lambda f: with_value(f.astype(object), (3, 1), 2**70), "face 3 names vertex 11.*, which is too large"),
    (lambda f: with_value(f.astype(object), (3, 1), -2**70), "face 3 names vertex -11.*, which is too small"),
    (lambda f: with_value(f.astype(object), (3, 1), 240), "face 3 names vertex 240, but there are 240"),
    (lambda f: [[0, 1, 2], 3], "face 1 must be a sequence of indices"),
    (lambda f: [[0, 1, "a"]], "face 0 must be integers"),
    (lambda f: "faces", "faces must be an array or a sequence of sequences"),
    (lambda f: 7, "faces must be an array or a sequence of sequences"),
    (lambda f: None, "either faces or cells are needed"),
]
NOT_INTEGERS = [True, np.True_, 1., "1", None]


def checked(*arguments, **keywords):
    """check() lists wrong values, others refuse them."""
    report = canonical_pose.check(*arguments, **keywords)
    if {defect["kind"] for defect in report["defects"]} & {"not_finite", "wrong_indices"}:
        raise ValueError(report["first_defect"])


SURFACE_FUNCTIONS = [
    canonical_pose.pose, canonical_pose.target, checked, canonical_pose.segment,
    canonical_pose.describe, canonical_pose.HeatSolver, canonical_pose.Registrar,
    lambda vertices, faces: canonical_pose.geodesics(vertices, faces, 0),
]


@pytest.fixture(autouse=True)
def nothing_is_printed(capfd):
    yield
    assert capfd.readouterr() == ("", "")


@pytest.mark.parametrize("function", SURFACE_FUNCTIONS)
@pytest.mark.parametrize("change, message", BAD_VERTICES)
def test_vertices(function, change, message, tube):
    with pytest.raises(ValueError, match=message):
        function(change(tube[0]), tube[1])


@pytest.mark.parametrize("function", SURFACE_FUNCTIONS)
@pytest.mark.parametrize("change, message", BAD_FACES)
def test_faces(function, change, message, tube):
    with pytest.raises(ValueError, match=message):
        function(tube[0], change(tube[1]))


@pytest.mark.parametrize("function", SURFACE_FUNCTIONS)
@pytest.mark.parametrize("value", NOT_INTEGERS)
def test_types_of_faces(function, value, tube):
    """Of Python's numbers; those of NumPy have one type."""
    vertices, faces = tube
    with pytest.raises(TypeError, match=f"face 3 must be integers.*, but one is {value!r}"):
        function(vertices, with_value(faces.astype(object), (3, 1), value))
    if isinstance(value, (bool, np.bool_)):
        with pytest.raises(TypeError, match=f"face 1 must be integers.*, but one is {value!r}"):
            function(vertices, [[0, 1, 2], [0, value, 2]])


def test_types_of_other_indices(tube):
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    with pytest.raises(TypeError, match="cells must be integers.*, but one is True"):
        canonical_pose.check(vertices, cells=[[0, True, 2, 3]])
    for source in (True, [0, True], np.array([0, None])):
        with pytest.raises(TypeError, match="source must be integers.*, but one is"):
            canonical_pose.geodesics(*tube, source)


@pytest.mark.parametrize("function", [f for f in SURFACE_FUNCTIONS if f != checked])
@pytest.mark.parametrize("faces", [[], np.zeros((0, 3), dtype=int), [[0, 0, 0]], [[0, 1, 2]]])
def test_surfaces_without_area(function, faces):
    with pytest.raises(ValueError, match="no face|no area|no face has an area"):
        function(np.zeros((3, 3)), faces)


def test_check_lists_all(tube):
    vertices = tube[0].copy()
    faces = tube[1].copy()
    vertices[[3, 7, 9], 1] = np.nan, np.inf, -np.inf
    faces[[4, 6, 8], 2] = 240, -1, 999
    defects = canonical_pose.check(vertices, faces)["defects"]
    assert [(d["kind"], d["count"], d["examples"]) for d in defects] == [
        ("not_finite", 3, [[3], [7], [9]]), ("wrong_indices", 3, [[4], [6], [8]])]


def test_check_of_nothing():
    for vertices in (np.zeros((0, 3)), np.zeros((3, 3))):
        assert canonical_pose.check(vertices, [])["first_defect"] == "the surface has no face"


@pytest.mark.parametrize("cells, message", [
    (np.zeros((2, 3), dtype=int), "cells must be n x 4, but is 2 x 3"),
    ([[0, 1, 2, 5]], "cell 0 names vertex 5, but there are 4"),
    ([[0, 1, 2, 3.]], "cells must be integers"),
    ([0, 1, 2, 3], "cells must have 2 dimensions"),
])
def test_cells(cells, message):
    vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
    for function in (canonical_pose.pose, checked):
        with pytest.raises(ValueError, match=message):
            function(vertices, cells=cells)
    with pytest.raises(ValueError, match="cell 0 has no volume"):
        canonical_pose.pose(np.zeros((4, 3)), cells=[[0, 1, 2, 3]])
    with pytest.raises(ValueError, match="a tetrahedral mesh is its own body"):
        canonical_pose.pose(vertices, cells=[[0, 1, 2, 3]], body="lattice")
    with pytest.raises(ValueError, match="both faces and cells are given"):
        canonical_pose.pose(vertices, [[0, 1, 2]], cells=[[0, 1, 2, 3]])


@pytest.mark.parametrize("options, message", [
    ({"detail_length": 0}, "option detail_length is 0, but must be a number from 1e-06 to 1000"),
    ({"detail_length": float("nan")}, "option detail_length is nan, but must be a number from 1e-06 to 1000"),
    ({"landmarks": 0}, "option landmarks is 0, but must be a positive integer"),
    ({"landmarks": -2**70}, "option landmarks is -1180591620717411303424, but must be"),
    ({"landmarks": 2**70}, "option landmarks is 1180591620717411303424, but must be"),
    ({"iterations": 2**31}, "option iterations is 2147483648, but must be an integer from 1 to 2147483647"),
    ({"rounds": -1}, "option rounds is -1, but must be an integer from 0"),
    ({"threads": -1}, "option threads is -1, but must be an integer from 0"),
    ({"seed": 2**32}, "option seed is 4294967296, but must be an integer from 0 to 4294967295"),
    ({"tikhonov": -1}, "option tikhonov is -1, but must be a number from 0 to "),
    ({"spacing": 0}, "option spacing is 0.*, but must be a number from 1e-06 to 1"),
    ({"spacing": 1e-320}, "option spacing is 1e-320, but"),
    ({"spacing": 1.5}, "option spacing is 1.5, but"),
    ({"detail_length": 1e-320}, "option detail_length is .*e-32[01], but must be a number from 1e-06 to 1000"),
    ({"tikhonov": 1e300}, r"option tikhonov is 1e\+300, but must be a number from 0 to 1e\+09"),
    ({"kernel": "cubic"}, "option kernel is 'cubic', but must be one of classical, gaussian"),
    ({"geodesics": "mmp"}, "option geodesics is 'mmp', but must be one of exact, heat, wavefront"),
    ({"body": "soul"}, "option body is 'soul'"),
    ({"components": "all"}, "option components is 'all'"),
    ({"frame": "none"}, "option frame is 'none', but must be one of auto, body, canonical, input"),
    ({"solver": "lu"}, "option solver is 'lu'"),
    ({"stance": "x"}, "option stance is 'x', but must be one of a, canonical, stand, t, vitruvian"),
    ({"stance": {"stance": "x"}}, "stance: element 0 names the stance 'x', but must name one of a, canonical"),
    ({"stance": {"left arm": (1, 0, 0), "left wing": (1, 0, 0)}},
     "stance: element 1 names the limb 'left wing', but must name one of left arm, left front leg, "),
    ({"stance": {-1: (1, 0, 0)}}, "stance: element 0 begins neither with the name of a limb nor with the index"),
    ({"stance": {"left arm": (1, 0)}}, "stance: element 0 has 3 values, but must have 4 or 5"),
    ({"stance": [("left arm", 1, 0, 0, "bent")]}, "stance: element 0 ends in 'bent', but must end in 'straight' or"),
    ({"stance": [()]}, "stance: element 0 is empty"),
    ({"stance": {"left arm": (0, 0, 0)}}, "limb direction 0 has a direction of length 0"),
    ({"stance": {"left arm": (0, np.nan, 0)}}, "limb direction 0 has a direction that is not finite"),
    ({"stance": {240: (1, 0, 0)}}, "limb direction 0 names vertex 240, but there are 240"),
    ({"stance": 2 * [("left arm", 1, 0, 0)]}, "limb direction 1 names the left arm, which occurs before"),
    ({"stance": {"left arm": (1, 0, 0)}}, "no head and four limbs were found"),
    ({"paper_weights": (0, 1)}, "option paper_weights.alpha is 0, but must be > 0"),
    ({"matching_weights": [1, 2]}, "2 numbers are given as matching weight, but it takes 240"),
    ({"matching_weights": [[1, 2]]}, "matching_weights must have 1 dimension, but is 1 x 2"),
    ({"matching_weights": np.full(240, -1.)}, "weight"),
    ({"stiffness": np.zeros(240)}, "stiffness"),
    ({"given_target": np.zeros((5, 3))}, "target"),
    ({"given_target": np.zeros((240, 2))}, "given_target must be n x 3, but is 240 x 2"),
    ({"given_target": np.full((240, 3), np.nan)}, "vertex 0 has a coordinate that is not finite"),
    ({"given_distances": np.ones((240, 2))}, "column 0 of the distances has no landmark"),
    ({"given_distances": np.zeros((7, 2))}, "distances"),
    ({"spring": [(0, 1)]}, "option spring: element 0 has 2 values, but must have 3 or 4"),
    ({"spring": [(0, 1, 1), (0, -1, 1)]}, "spring: element 1 does not begin with two indices"),
    ({"spring": [(0, 240, 1)]}, "vertex 240"),
    ({"handle": [(.5, 0, 0, 0)]}, "handle: element 0 does not begin with the index of a vertex"),
    ({"direction": [(0, 0, 1, 0, 0)]}, "0"),
    ({"symmetric": [(0, 1, -1)]}, "symmetric pair 0 has the stiffness -1, but it must be from 1e-09"),
])
def test_options(options, message, tube):
    with pytest.raises(ValueError, match=message):
        canonical_pose.pose(*tube, **options)


# Rows of an array begin with indices that are whole numbers; what is not masked is not lost.
def test_constraints_of_an_array(tube):
    vertices, faces = tube
    rows = [(0, 100, .1), (1, 101, .2)]
    expected, _ = canonical_pose.pose(*tube, spring=rows)
    for arguments in ((vertices, np.array(rows)), (np.ma.masked_array(vertices), rows)):
        pose, _ = canonical_pose.pose(arguments[0], faces, spring=arguments[1])
        assert np.array_equal(pose, expected)


def test_types_of_parts(tube):
    for parts in ("3", 2., None):
        with pytest.raises(TypeError, match="option parts must be an integer or 'auto'"):
            canonical_pose.segment(*tube, parts=parts)


@pytest.mark.parametrize("options", [
    {"detail_length": "short"}, {"landmarks": 3.5}, {"kernel": 3}, {"spring": 3},
    {"spring": [3]}, {"stance": 3}, {"stance": ["t"]}, {"stance": {"left arm": ("1", "0", "up")}},
    {"stance": [("left arm", 1, 0, 0, True)]}, {"injective": "maybe"}, {"threads": [1]}, {"paper_weights": 3}, {"handle": [(0, "a", 0, 0)]},
])
def test_types_of_options(options, tube):
    with pytest.raises(TypeError, match="option .* must be"):
        canonical_pose.pose(*tube, **options)


def test_unknown_options(tube):
    for function in (canonical_pose.target, canonical_pose.segment, canonical_pose.describe,
                     canonical_pose.Registrar, lambda *shape, **options:
                     canonical_pose.shape_distance(*shape, *shape, **options),
                     lambda *shape, **options:
                     canonical_pose.match(*shape, *shape, pose=shape[0], other_pose=shape[0],
                                          **options)):
        with pytest.raises(TypeError, match="there is no option colour"):
            function(*tube, colour="red")


def test_options_have_the_names_of_the_tool(tool):
    usage = subprocess.run([os.environ["CANONICAL_POSE_TOOL"], "pose", "--help"],
                           capture_output=True, text=True, check=True).stdout
    names = set(inspect.signature(canonical_pose.pose).parameters)
    names -= {"vertices", "faces", "cells", "return_target", "progress"}
    missing = {name for name in names if "--" + name.replace("_", "-") not in usage}
    assert not missing


@pytest.mark.parametrize("source, message", [
    (240, "source names vertex 240, but there are 240"),
    (-1, "source names vertex -1, but there are 240"),
    ([0, 999], "source names vertex 999"),
    (.5, "source must be integers"),
    ([[0]], "source must have 1 dimension"),
    ("a", "source must be integers"),
])
def test_sources(source, message, tube):
    for function in (lambda: canonical_pose.geodesics(*tube, source),
                     lambda: canonical_pose.HeatSolver(*tube).distances(source)):
        with pytest.raises(ValueError, match=message):
            function()


def test_isolated_vertices_have_no_distances(tube):
    vertices = np.concatenate([tube[0], [[0, 0, 0]]])
    for function in (lambda source: canonical_pose.geodesics(vertices, tube[1], source),
                     lambda source: canonical_pose.HeatSolver(vertices, tube[1]).distances(source)):
        distances = function(0)
        assert np.isinf(distances[240]) and np.isfinite(distances[:240]).all()
        with pytest.raises(ValueError, match="a source names vertex 240, which belongs to no face"):
            function(240)


def test_poses_that_do_not_correspond(tube):
    for function in (canonical_pose.compare, canonical_pose.align_handedness):
        with pytest.raises(ValueError, match="poses of .* points cannot be compared"):
            function(tube[0], tube[0][:-1])
        with pytest.raises(ValueError, match="same position"):
            function(np.zeros((4, 3)), np.zeros((4, 3)))
        with pytest.raises(ValueError, match="pose 1 must be n x 3, but is 240 x 2"):
            function(tube[0], tube[0][:, :2])
    with pytest.raises(ValueError, match="the pose has 3 vertices, but the surface has 240"):
        canonical_pose.shape_distance(*tube, *tube, other_pose=tube[0][:3], descriptor="views")
    for function in (canonical_pose.segment, canonical_pose.describe):
        with pytest.raises(ValueError, match="the pose has 3 vertices, but the surface has 240"):
            function(*tube, pose=tube[0][:3])


def test_segment_and_describe_refuse(tube):
    with pytest.raises(ValueError, match="option parts is 0"):
        canonical_pose.segment(*tube, parts=0)
    with pytest.raises(ValueError, match="option method is 'guess'"):
        canonical_pose.segment(*tube, method="guess")
    with pytest.raises(ValueError, match="there is no descriptor 'colors'"):
        canonical_pose.describe(*tube, descriptor="colors")
    with pytest.raises(ValueError, match="there is no descriptor 'colors'"):
        canonical_pose.shape_distance(*tube, *tube, descriptor="colors")
    with pytest.raises(ValueError, match="time step|time_step"):
        canonical_pose.HeatSolver(*tube, time_step_factor=-1)
