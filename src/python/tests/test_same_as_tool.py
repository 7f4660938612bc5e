# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Results are those of the tool, bit for bit, and reports have its form."""

import json
import os
import subprocess

import numpy as np
import pytest

import canonical_pose
from conftest import read_off, write_off


def keys_of(report):
    """The nested keys of a report; of lists, those of the first entry."""
    if isinstance(report, dict):
        return {key: keys_of(value) for key, value in report.items()}
    if isinstance(report, list) and report:
        return [keys_of(report[0])]
    return None


def without_times(report):
    return {key: value for key, value in report.items()
            if key not in ("stages", "total_seconds", "peak_memory_bytes", "rounds")}


@pytest.fixture(params=["tube", "figure"])
def shape(request, tmp_path):
    vertices, faces = request.getfixturevalue(request.param)
    path = tmp_path / "shape.off"
    write_off(path, vertices, faces)
    return vertices, faces, path


@pytest.mark.parametrize("options", [
    {},
    {"detail_length": .2, "landmarks": 20, "rounds": 1, "iterations": 40, "seed": 7, "threads": 1},
    {"kernel": "gaussian-uncentred", "solver": "eigen", "injective": False},
    {"target_mode": "unfold", "contacts": "cut"},
    {"geodesics": "wavefront", "spacing": .05, "components": "each", "body": "lattice",
     "frame": "canonical"},
])
def test_pose(tool, shape, tmp_path, options):
    vertices, faces, path = shape
    words = []
    for name, value in options.items():
        name = "--" + name.replace("_", "-")
        words += ["--no-injective"] if value is False else [name, value]
    tool("pose", path, "-o", tmp_path / "pose.off", "--target", tmp_path / "target.off",
         "--report", tmp_path / "report.json", *words)
    pose, report, target = canonical_pose.pose(vertices, faces, return_target=True, **options)
    assert pose.tobytes() == read_off(tmp_path / "pose.off")[0].tobytes()
    assert target.tobytes() == read_off(tmp_path / "target.off")[0].tobytes()
    expected = json.loads((tmp_path / "report.json").read_text())
    assert keys_of(report) == keys_of(expected)
    assert without_times(report) == without_times(expected)
    assert [stage["name"] for stage in report["stages"]] == [
        stage["name"] for stage in expected["stages"] if stage["name"] not in ("read", "write")]
    assert 0 < sum(stage["seconds"] for stage in report["stages"]) <= report["total_seconds"]


@pytest.mark.parametrize("start", [1, 2])
def test_first_corners_do_not_matter(figure, start):
    vertices, faces = figure
    pose, _ = canonical_pose.pose(vertices, faces)
    rolled, _ = canonical_pose.pose(vertices, np.roll(faces, start, axis=1))
    assert pose.tobytes() == rolled.tobytes()


def test_library(figure, tmp_path):
    """A CGAL::Surface_mesh has the same pose, bit for bit."""
    path = os.environ.get("CANONICAL_POSE_LIBRARY", "")
    if not os.path.exists(path):
        pytest.skip("there is no program that calls the library")
    subprocess.run([path, os.environ["CANONICAL_POSE_FIGURE"], str(tmp_path / "pose.off")],
                   check=True, stdout=subprocess.DEVNULL)
    pose, _ = canonical_pose.pose(*figure)
    assert pose.tobytes() == read_off(tmp_path / "pose.off")[0].tobytes()


def test_constraints_and_values(tool, tube, tmp_path):
    vertices, faces = tube
    n = len(vertices)
    write_off(tmp_path / "shape.off", vertices, faces)
    weights, stiffness = np.linspace(1, 2, n), np.linspace(2, 1, n)
    target = vertices + [[0, 0, 1]]
    np.savetxt(tmp_path / "weights.txt", weights, fmt="%.17g")
    np.savetxt(tmp_path / "stiffness.txt", stiffness, fmt="%.17g")
    write_off(tmp_path / "target.off", target, faces)
    tool("pose", tmp_path / "shape.off", "-o", tmp_path / "pose.off",
         "--matching-weights", tmp_path / "weights.txt", "--stiffness", tmp_path / "stiffness.txt",
         "--given-target", tmp_path / "target.off", "--spring", f"0,{n - 1},2.5,3",
         "--direction", "0,5,1,0,0", "--handle", "9,1,2,3,.5", "--symmetric", "20,25")
    pose, _ = canonical_pose.pose(
        vertices, faces, matching_weights=weights, stiffness=stiffness, given_target=target,
        spring=[(0, n - 1, 2.5, 3)], direction=[(0, 5, 1, 0, 0)], handle=[(9, 1, 2, 3, .5)],
        symmetric=[(20, 25)])
    assert pose.tobytes() == read_off(tmp_path / "pose.off")[0].tobytes()


def test_stances(tool, figure, tmp_path):
    """A file has the lines of a sequence, which are the items of a dict."""
    vertices, faces = figure
    write_off(tmp_path / "shape.off", vertices, faces)
    (tmp_path / "wave.txt").write_text("stance a\nright arm -.5 1 0 as-is\nleft leg .2 -1 .3\n")
    tool("pose", tmp_path / "shape.off", "-o", tmp_path / "pose.off", "--stance", tmp_path / "wave.txt")
    items = {"stance": "a", "right arm": (-.5, 1, 0, "as-is"), "left leg": np.array([.2, -1, .3])}
    for stance in (items, [("stance", "a"), ("right arm", -.5, 1, 0, "as-is"), ("left leg", .2, -1, .3)]):
        pose, report = canonical_pose.pose(vertices, faces, stance=stance)
        assert pose.tobytes() == read_off(tmp_path / "pose.off")[0].tobytes()
        assert report["skeleton"]["kind"] == "person"


def test_given_distances_and_paper_weights(tool, tube, tmp_path):
    vertices, faces = tube
    write_off(tmp_path / "shape.off", vertices, faces)
    sources = [0, 50, 100, 150, 200]
    tool("geodesics", tmp_path / "shape.off", "-o", tmp_path / "distances.txt",
         *[word for source in sources for word in ("--source", source)])
    distances = canonical_pose.geodesics(vertices, faces, sources)
    assert distances.tobytes() == np.loadtxt(tmp_path / "distances.txt").tobytes()
    tool("pose", tmp_path / "shape.off", "-o", tmp_path / "pose.off",
         "--given-distances", tmp_path / "distances.txt", "--paper-weights", "100,10")
    pose, _ = canonical_pose.pose(vertices, faces, given_distances=distances,
                                  paper_weights=(100, 10))
    assert pose.tobytes() == read_off(tmp_path / "pose.off")[0].tobytes()


def test_tetrahedra(tool, tetrahedra, tmp_path):
    vertices, cells = tetrahedra
    with open(tmp_path / "box.mesh", "w") as file:
        file.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(vertices)}\n")
        np.savetxt(file, np.c_[vertices, np.zeros(len(vertices))], fmt="%.17g")
        file.write(f"Tetrahedra\n{len(cells)}\n")
        np.savetxt(file, np.c_[cells + 1, np.zeros(len(cells))], fmt="%d")
        file.write("End\n")
    tool("pose", tmp_path / "box.mesh", "-o", tmp_path / "pose.mesh",
         "--target", tmp_path / "target.off")
    tool("check", tmp_path / "box.mesh", "--report", tmp_path / "report.json")
    pose, report, target = canonical_pose.pose(vertices, cells=cells, return_target=True)
    lines = (tmp_path / "pose.mesh").read_text().split("\n")
    first = next(i for i, line in enumerate(lines) if line.strip() == "Vertices") + 2
    expected = np.loadtxt(lines[first:first + len(vertices)])[:, :3]
    assert pose.tobytes() == expected.tobytes()
    assert target.tobytes() == read_off(tmp_path / "target.off")[0].tobytes()
    assert report["body"] == {"kind": "complex", "vertices": len(vertices), "tetrahedra": len(cells)}
    checked = canonical_pose.check(vertices, cells=cells)
    expected = json.loads((tmp_path / "report.json").read_text())
    assert without_times(checked) == without_times(expected)


@pytest.mark.parametrize("method", ["heat", "wavefront", "exact"])
def test_geodesics(tool, shape, tmp_path, method):
    vertices, faces, path = shape
    tool("geodesics", path, "-o", tmp_path / "distances.txt", "--source", 3, "--source", 11,
         "--geodesics", method)
    expected = np.loadtxt(tmp_path / "distances.txt")
    distances = canonical_pose.geodesics(vertices, faces, [3, 11], geodesics=method)
    assert distances.tobytes() == expected.tobytes()
    one = canonical_pose.geodesics(vertices, faces, np.int32(11), geodesics=method)
    assert one.tobytes() == expected[:, 1].tobytes()


def test_check(tool, tube, tmp_path):
    vertices, faces = tube
    faces = np.concatenate([faces[3:], [[0, 0, 1]]])
    write_off(tmp_path / "shape.off", vertices, faces)
    tool("check", tmp_path / "shape.off", "--report", tmp_path / "report.json")
    report = canonical_pose.check(vertices, faces)
    expected = json.loads((tmp_path / "report.json").read_text())
    assert keys_of(report) == keys_of(expected)
    assert without_times(report) == without_times(expected)


def test_compare(tmp_path, tube):
    path = os.environ.get("CANONICAL_POSE_TOOL", "")
    if not os.path.exists(path):
        pytest.skip("the tool is not built")
    vertices, faces = tube
    poses = [vertices, vertices * [1, 1, -2], vertices[::-1].copy()]
    for i, pose in enumerate(poses):
        write_off(tmp_path / f"{i}.off", pose, faces)
    output = subprocess.run([path, "compare", *[str(tmp_path / f"{i}.off") for i in range(3)]],
                            check=True, capture_output=True, text=True).stdout
    mean = output.split("\n")[-2].split()
    assert ["%.6f" % difference for difference in canonical_pose.compare(*poses)] == mean[:2]


@pytest.mark.parametrize("words, options", [
    ((), {}),
    (("--parts", "4"), {"parts": 4}),
    (("--method", "sweep"), {"method": "sweep"}),
    (("--method", "kmeans", "--parts", "3", "--seed", "2"),
     {"method": "kmeans", "parts": 3, "seed": 2}),
])
def test_segment(tool, shape, tmp_path, words, options):
    vertices, faces, path = shape
    tool("segment", path, "-o", tmp_path / "parts.txt", "--report", tmp_path / "report.json", *words)
    parts, report = canonical_pose.segment(vertices, faces, **options)
    assert parts.dtype == np.intp
    assert (parts == np.loadtxt(tmp_path / "parts.txt", dtype=int)).all()
    expected = json.loads((tmp_path / "report.json").read_text())
    if report["tree"]:
        report["tree"]["leaf_of_face"] = report["tree"]["leaf_of_face"].tolist()
    assert without_times(report) == without_times(expected)


def test_describe(tool, shape, tmp_path):
    vertices, faces, path = shape
    tool("describe", path, "-o", tmp_path / "all.json")
    expected = json.loads((tmp_path / "all.json").read_text())
    described = canonical_pose.describe(vertices, faces)
    assert list(described) == list(expected)
    for name, descriptor in described.items():
        assert descriptor["version"] == expected[name]["version"]
        assert descriptor["values"].tolist() == expected[name]["values"]
