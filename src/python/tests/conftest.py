# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Shapes for the tests, and the tool to compare with.

CANONICAL_POSE_TOOL is the path of the program, CANONICAL_POSE_FIGURE that of a figure with limbs as
make_figure writes it, and CANONICAL_POSE_LIBRARY that of the example canonical_pose, which calls the
library; without them, the tests that need them are skipped.
"""

import ast
import os
import pathlib
import subprocess

import numpy as np
import pytest

import canonical_pose


def read_off(path):
    """Return vertices and triangles of an OFF file."""
    with open(path) as file:
        words = " ".join(line.split("#")[0] for line in file).split()
    assert words[0] == "OFF"
    n, m = int(words[1]), int(words[2])
    vertices = np.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    faces = np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)
    assert (faces[:, 0] == 3).all()
    return vertices, faces[:, 1:]


def write_off(path, vertices, faces):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(vertices)} {len(faces)} 0\n")
        for vertex in np.asarray(vertices).tolist():
            file.write(" ".join(map(repr, vertex)) + "\n")
        for face in np.asarray(faces).tolist():
            file.write(f"{len(face)} {' '.join(map(str, face))}\n")


class Stub:
    """What __init__.pyi says: the fields of classes, and what functions return."""

    def __init__(self):
        path = pathlib.Path(canonical_pose.__file__).with_name("__init__.pyi")
        self.tree = ast.parse(path.read_text())
        self.fields, self.functions = {}, {}
        for node in self.tree.body:
            if isinstance(node, ast.FunctionDef):
                self.functions[node.name] = node
            if isinstance(node, ast.ClassDef):
                fields = {}
                for base in node.bases:
                    fields.update(self.fields.get(base.id, {}))
                fields.update({item.target.id: item.annotation for item in node.body
                               if isinstance(item, ast.AnnAssign)})
                self.fields[node.name] = fields
                self.functions.update({f"{node.name}.{item.name}": item for item in node.body
                                       if isinstance(item, ast.FunctionDef)})

    def check(self, function, result):
        """Fail if the result of a function has not the type that is stated."""
        mismatches = list(self._mismatches(result, self.functions[function].returns, function))
        assert not mismatches, mismatches

    def _mismatches(self, value, type_, where):
        types = {"int": int, "float": (int, float), "str": str, "bool": bool,
                 "_Floats": np.ndarray, "_Integers": np.ndarray}
        if isinstance(type_, ast.BinOp):  # one of both
            both = [list(self._mismatches(value, t, where)) for t in (type_.left, type_.right)]
            yield from min(both, key=len)
        elif isinstance(type_, ast.Name) and type_.id in self.fields:
            fields = self.fields[type_.id]
            if not isinstance(value, dict) or set(value) != set(fields):
                yield f"{where}: {sorted(value) if isinstance(value, dict) else value}"
            else:
                for key, field in fields.items():
                    yield from self._mismatches(value[key], field, f"{where}.{key}")
        elif isinstance(type_, ast.Name):
            if not isinstance(value, types[type_.id]) or isinstance(value, bool) > (type_.id == "bool"):
                yield f"{where}: {value!r} is no {type_.id}"
        elif isinstance(type_, ast.Constant):
            if value is not type_.value:
                yield f"{where}: {value!r}"
        elif type_.value.id == "Literal":
            if value != type_.slice.value:
                yield f"{where}: {value!r}"
        elif type_.value.id == "tuple":
            if len(value) != len(type_.slice.elts):
                yield f"{where}: {len(value)} values"
            for entry, t in zip(value, type_.slice.elts):
                yield from self._mismatches(entry, t, where)
        elif type_.value.id == "list":
            for entry in value:
                yield from self._mismatches(entry, type_.slice, where + "[]")
        else:
            assert type_.value.id == "dict"
            for key, entry in value.items():
                yield from self._mismatches(entry, type_.slice.elts[1], f"{where}.{key}")


@pytest.fixture(scope="session")
def stub():
    return Stub()


def make_tube(rings=24, corners=10):
    """Return a closed tube that is bent by a right angle, with triangles."""
    t = np.linspace(0, 1, rings)[:, None]
    angle = np.pi / 2 * t
    around = 2 * np.pi * np.arange(corners)[None, :] / corners
    radius = 4 + .8 * np.cos(around)
    vertices = np.stack([radius * np.cos(angle), radius * np.sin(angle),
                         .8 * np.sin(around) + 0 * t], axis=2).reshape(-1, 3)
    i = corners * np.arange(rings - 1)[:, None] + np.arange(corners)[None, :]
    j = corners * np.arange(rings - 1)[:, None] + (np.arange(corners) + 1)[None, :] % corners
    sides = np.concatenate([np.stack([i, j, j + corners], 2), np.stack([i, j + corners, i + corners], 2)])
    last = corners * (rings - 1)
    caps = [[0, k + 1, k] for k in range(1, corners - 1)]
    caps += [[last, last + k, last + k + 1] for k in range(1, corners - 1)]
    return vertices, np.concatenate([sides.reshape(-1, 3), caps])


@pytest.fixture(scope="session")
def tube():
    return make_tube()


@pytest.fixture(scope="session")
def fine_tube():
    """The same tube, on which the heat method is accurate."""
    return make_tube(72, 30)


@pytest.fixture(scope="session")
def box():
    """A box of quadrilaterals, in integers."""
    vertices = np.array([[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)])
    faces = np.array([[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1],
                      [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
    return vertices, faces


@pytest.fixture(scope="session")
def tetrahedra():
    """A box of 2 x 2 x 8 cubes, six tetrahedra each."""
    size = (3, 3, 9)
    vertices = np.array(list(np.ndindex(size)), dtype=float)
    number = np.arange(len(vertices)).reshape(size)
    cells = []
    for x, y, z in np.ndindex(2, 2, 8):
        for order in ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)):
            corner = np.array([x, y, z])
            cell = [number[tuple(corner)]]
            for axis in order:
                corner[axis] += 1
                cell.append(number[tuple(corner)])
            cells.append(cell)
    return vertices, np.array(cells)


@pytest.fixture(scope="session")
def figure():
    path = os.environ.get("CANONICAL_POSE_FIGURE", "")
    if not os.path.exists(path):
        pytest.skip("there is no figure")
    return read_off(path)


@pytest.fixture(scope="session")
def tool():
    """A function that runs the tool, and returns what it prints."""
    path = os.environ.get("CANONICAL_POSE_TOOL", "")
    if not os.path.exists(path):
        pytest.skip("the tool is not built")

    def run(*arguments):
        return subprocess.run([path, *map(str, arguments)], check=True, capture_output=True,
                              text=True).stdout
    return run
