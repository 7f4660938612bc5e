# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Collections are those of the program."""

import json
import os
import pathlib
import signal
import subprocess
import sys
import textwrap
import time

import numpy as np
import pytest

import canonical_pose
from conftest import write_off


@pytest.fixture(scope="module")
def program(tool):
    """The tool, if it has collections."""
    def run(*arguments):
        try:
            return tool(*arguments)
        except subprocess.CalledProcessError as error:
            if "without SQLite" in error.stderr:
                pytest.skip("the tool was built without SQLite")
            raise
    return run


@pytest.fixture(scope="module")
def folder(program, tmp_path_factory, tube, box):
    """Two tubes and a box, described, with their classes."""
    folder = tmp_path_factory.mktemp("collection")
    (folder / "shapes").mkdir()
    write_off(folder / "shapes" / "tube.off", *tube)
    write_off(folder / "shapes" / "long.off", tube[0] * [1, 1, 1.5], tube[1])
    write_off(folder / "shapes" / "box.off", *box)
    (folder / "classes.txt").write_text("tube round\nlong round\nbox flat\n")
    program("collection", folder / "shapes", "--database", folder / "expected.db", "--rounds", 0)
    return folder


def without_times(shapes):
    for shape in shapes:
        del shape["seconds"]
        for key in ("stages", "total_seconds", "peak_memory_bytes", "rounds"):
            del shape["report"][key]
    return shapes


def test_collection(program, folder, stub):
    shapes = canonical_pose.collection(folder / "a.db", folder / "shapes", poses=folder / "poses",
                                       segment=True, workers=2, rounds=0, tikhonov=None)
    stub.check("collection", shapes)
    assert all(shape["has_pose"] and shape["is_segmented"] for shape in shapes)
    expected = json.loads(program("collection", "--list", "--json", "--database", folder / "a.db"))
    assert shapes == canonical_pose.collection(folder / "a.db") == expected
    expected = canonical_pose.collection(folder / "expected.db")
    for shape in expected + shapes:
        shape["has_pose"] = shape["is_segmented"] = None
    assert without_times(shapes) == without_times(expected)
    mesh = canonical_pose.load(folder / "shapes" / "tube.off")
    pose, _ = canonical_pose.pose(mesh.vertices, mesh.faces, rounds=0)
    assert canonical_pose.load(folder / "poses" / "tube.off").vertices.tobytes() == pose.tobytes()


def test_options(folder, monkeypatch):
    """They are recorded as by the program, and names of files are no options."""
    monkeypatch.chdir(folder)
    for name in ("-n.off", "merge", "@list"):
        (folder / name).write_bytes((folder / "shapes" / "box.off").read_bytes())
    (folder / "paths.txt").write_text("merge\n")
    options = dict(landmarks=np.int64(8), detail_length=np.float64(.2), paper_weights=(100, 10),
                   injective=True, kernel="gaussian", geodesics="exact", threads=2, seed=0)
    shapes = canonical_pose.collection("options.db", ["-n.off", pathlib.Path("@list"), "@paths.txt"],
                                       descriptor=["shape-distribution-d2"], **options)
    assert [pathlib.Path(shape["path"]).name for shape in shapes] == ["-n.off", "@list", "merge"]
    for shape in shapes:
        assert shape["outcome"] == "done" and list(shape["descriptors"]) == ["shape-distribution-d2"]
        assert set(shape["options"].split(" --")) == {
            "--kernel gaussian", "landmarks 8", "detail-length 0.2", "paper-weights 100,10",
            "injective", "geodesics exact"}
    shapes = canonical_pose.collection("options.db", b"-n.off", injective=False,
                                       descriptor="shape-distribution-d2")
    assert "--no-injective" in {shape["options"] for shape in shapes}


def test_match(program, folder, stub, tmp_path):
    template = folder / "shapes" / "long.off"
    shapes = canonical_pose.collection(tmp_path / "a.db", folder / "shapes" / "tube.off", match=template,
                                       matches=tmp_path / "matches", rounds=0,
                                       descriptor="shape-distribution-d2")
    stub.check("collection", shapes)
    assert shapes[0]["report"]["match"]["mean_round_trip"] >= 0
    program("match", template, folder / "shapes" / "tube.off", "-o", tmp_path / "expected.off",
            "--pose", tmp_path / "matches" / "poses" / "long.off",
            "--other-pose", tmp_path / "matches" / "poses" / "tube.off")
    assert (tmp_path / "matches" / "tube.off").read_bytes() == (tmp_path / "expected.off").read_bytes()
    with pytest.raises(ValueError, match="--matches"):
        canonical_pose.collection(tmp_path / "a.db", folder / "shapes", match=template)


def test_search(program, folder, stub):
    query = folder / "shapes" / "tube.off"
    for words, options in [((), {}), (("--descriptor", "views"), {"descriptor": "views"}),
                           (("--descriptor", "views:3", "--descriptor", "shape-distribution-d2:.5"),
                            {"descriptor": {"views": 3, "shape-distribution-d2": .5}}),
                           (("-n", 1), {"number": 1}), (("--pose", query), {"pose": query})]:
        answers = canonical_pose.search(folder / "expected.db", query, rounds=0, **options)
        stub.check("search", answers)
        lines = program("search", query, "--database", folder / "expected.db", "--rounds", 0, *words)
        assert lines == "".join(f"{i + 1} {answer['distance']:g} {answer['path']}\n"
                                for i, answer in enumerate(answers))
    assert [pathlib.Path(answer["path"]).name
            for answer in canonical_pose.search(folder / "expected.db", query, rounds=0)] == [
                "tube.off", "long.off", "box.off"]


def test_shape_distance(folder, tube):
    """It is the distance by which shapes are searched."""
    query = folder / "shapes" / "tube.off"
    for path in sorted((folder / "shapes").iterdir()):
        mesh = canonical_pose.load(path)
        distances = canonical_pose.shape_distance(*tube, *mesh[:2], rounds=0)
        for name, distance in distances.items():
            answers = canonical_pose.search(folder / "expected.db", query, descriptor=name, rounds=0)
            assert {answer["path"]: answer["distance"] for answer in answers}[str(path)] == distance


def test_evaluate(program, folder, stub):
    words = ("evaluate", "--database", folder / "expected.db", "--classes", folder / "classes.txt",
             "--rerank", "manifold")
    with pytest.warns(UserWarning, match="^this class has a single shape, which is no query: 'flat'$"):
        result = canonical_pose.evaluate(folder / "expected.db", folder / "classes.txt",
                                         rerank="manifold")
    stub.check("evaluate", result)
    lines = ["name NN FT ST E DCG mAP"]
    lines += [" ".join([name, *("%.4f" % x for x in evaluation["mean"].values())])
              for name, evaluation in result.items()]
    lines += ["", "name class NN FT ST E DCG mAP"]
    lines += [" ".join([name, of, *("%.4f" % x for x in measures.values())])
              for name, evaluation in result.items()
              for of, measures in evaluation["classes"].items()]
    assert program(*words) == "\n".join(lines) + "\n"
    program(*words, "--csv", folder / "curves.csv")
    lines = ["table,descriptor,row,column,value"]
    lines += [f"precision,{name},recall,{(i + 1) / 20:.2f},{precision:.4f}"
              for name, evaluation in result.items()
              for i, precision in enumerate(evaluation["precision"])]
    lines += [f"nearest,{name},{of},{nearest},{number}"
              for name, evaluation in result.items()
              for of, numbers in evaluation["nearest"].items() for nearest, number in numbers.items()]
    assert (folder / "curves.csv").read_text() == "\n".join(lines) + "\n"


def test_failures(folder, tmp_path):
    """What is refused is a result."""
    (tmp_path / "bad.off").write_text("OFF\n1 0 0\n")
    shapes = canonical_pose.collection(tmp_path / "a.db", [tmp_path / "bad.off",
                                                           folder / "shapes" / "box.off"],
                                       descriptor="shape-distribution-d2", rounds=0)
    assert {shape["outcome"] for shape in shapes} == {"refused", "done"}
    refused, = canonical_pose.collection(tmp_path / "a.db", failed=True)
    assert refused["message"] and refused["report"] is None


def test_errors(folder, tmp_path):
    database = folder / "expected.db"
    for call, error, message in [
        (lambda: canonical_pose.collection(database, tmp_path / "nowhere"), RuntimeError, "does not exist"),
        (lambda: canonical_pose.collection(tmp_path / "no.db"), RuntimeError, "unable to open"),
        (lambda: canonical_pose.collection(database, []), ValueError, "INPUT is required"),
        (lambda: canonical_pose.collection(database, ""), ValueError, "a path is empty"),
        (lambda: canonical_pose.collection(database, 3), TypeError, "not iterable"),
        (lambda: canonical_pose.collection(database, tmp_path, landmarks=0), ValueError, "--landmarks"),
        (lambda: canonical_pose.collection(database, tmp_path, body="--quiet"), ValueError, "--body"),
        (lambda: canonical_pose.collection(database, tmp_path, injective="no"), TypeError,
         "option injective must be True or False"),
        (lambda: canonical_pose.collection(database, tmp_path, frame="input"), TypeError,
         "there is no option frame"),
        (lambda: canonical_pose.search(database, tmp_path / "nowhere.off", rounds=0), RuntimeError,
         "nowhere.off: it cannot be opened|No such file"),
        (lambda: canonical_pose.search(database, folder / "shapes" / "box.off"), RuntimeError,
         "under the default options; it has some under '--rounds 0'"),
        (lambda: canonical_pose.search(database, folder / "shapes" / "box.off", number=0), ValueError, "-n"),
        (lambda: canonical_pose.search(database, folder / "shapes" / "box.off", descriptor={"views": 0}),
         ValueError, "--descriptor"),
        (lambda: canonical_pose.search(database, folder / "shapes" / "box.off", descriptor="colors"),
         ValueError, "there is no descriptor 'colors'"),
        (lambda: canonical_pose.evaluate(database, tmp_path / "nowhere"), RuntimeError, "cannot be read"),
        (lambda: canonical_pose.evaluate(database, folder / "classes.txt", rerank="guess"), ValueError,
         "--rerank"),
    ]:
        with pytest.raises(error, match=message):
            call()


def test_without_the_program(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    monkeypatch.setattr(canonical_pose._collections, "__file__", str(tmp_path / "a/b/c/d/__init__.py"))
    with pytest.raises(FileNotFoundError, match="the program canonical-pose was found neither"):
        canonical_pose.search("a.db", "a.off")
    installed = tmp_path / "bin" / "canonical-pose"
    installed.parent.mkdir()
    installed.write_text("#!/bin/sh\necho canonical-pose: no >&2\nexit 1\n")
    installed.chmod(0o755)
    monkeypatch.setattr(canonical_pose._collections, "__file__",
                        str(tmp_path / "lib/python3/dist-packages/canonical_pose/_collections.py"))
    with pytest.raises(RuntimeError, match="^no$"):
        canonical_pose.search("a.db", "a.off")


@pytest.mark.skipif(not os.path.exists("/proc/self/stat"), reason="needs /proc")
def test_interrupt(program, figure, tmp_path):
    """Nothing goes on after it, and the database can be written."""
    write_off(tmp_path / "figure.off", *figure)
    (tmp_path / "run.py").write_text(textwrap.dedent("""
        import canonical_pose
        canonical_pose.collection("a.db", "figure.off", iterations=10**9, tikhonov=1e6, rounds=0)
        """))
    process = subprocess.Popen([sys.executable, "-B", "run.py"], cwd=tmp_path, stderr=subprocess.PIPE,
                               text=True)
    for _ in range(1000):
        if of_folder(tmp_path) >= 3:  # Python, the program, and its process
            break
        time.sleep(.02)
    time.sleep(.5)
    assert of_folder(tmp_path) == 3
    started = time.monotonic()
    process.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in process.communicate(timeout=20)[1]
    assert time.monotonic() - started < 2
    for _ in range(100):
        if of_folder(tmp_path) == 0:
            break
        time.sleep(.02)
    assert of_folder(tmp_path) == 0
    shape, = canonical_pose.collection(tmp_path / "a.db", tmp_path / "figure.off", rounds=0,
                                       descriptor="shape-distribution-d2")
    assert shape["outcome"] == "done"


def of_folder(path):
    """Return the number of processes that run in a folder."""
    number = 0
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            number += os.readlink(process / "cwd") == str(path)
        except OSError:
            pass
    return number
