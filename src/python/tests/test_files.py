# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Files are read and written as by the tool."""

import os
import threading

import numpy as np
import pytest

import canonical_pose

TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, .1]])
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


@pytest.mark.parametrize("name", ["a.off", "a.obj", "a.ply", "a.off.gz", "a.OBJ"])
def test_surfaces(tmp_path, name):
    """Numbers are written with enough digits."""
    canonical_pose.save(tmp_path / name, TETRAHEDRON / 3, FACES)
    mesh = canonical_pose.load(str(tmp_path / name))
    assert mesh.vertices.tobytes() == (TETRAHEDRON / 3).tobytes()
    assert mesh.faces.tolist() == FACES.tolist()
    assert mesh.cells is None
    assert canonical_pose.check(*mesh[:2])["defects"] == []


def test_polygons(tmp_path):
    faces = [[0, 2, 1], [0, 1, 3, 2], [1, 2, 3]]
    canonical_pose.save(tmp_path / "a.off", TETRAHEDRON, faces)
    assert canonical_pose.load(tmp_path / "a.off").faces == faces
    with pytest.raises(ValueError, match="STL holds triangles only, but face 1 has 4 corners"):
        canonical_pose.save(tmp_path / "a.stl", TETRAHEDRON, faces)
    assert not (tmp_path / "a.stl").exists()


def test_tetrahedra(tmp_path):
    canonical_pose.save(tmp_path / "a.mesh", TETRAHEDRON, cells=[[0, 1, 2, 3]])
    mesh = canonical_pose.load(tmp_path / "a.mesh")
    assert mesh.faces is None and mesh.cells.tolist() == [[0, 1, 2, 3]]
    assert canonical_pose.pose(**mesh._asdict())[0].shape == (4, 3)
    with pytest.raises(ValueError, match="a tetrahedral mesh is written as .mesh or .vtu"):
        canonical_pose.save(tmp_path / "a.off", TETRAHEDRON, cells=[[0, 1, 2, 3]])
    with pytest.raises(ValueError, match="a surface cannot be written as .mesh"):
        canonical_pose.save(tmp_path / "a.mesh", TETRAHEDRON, FACES)


def test_like(tmp_path):
    """The same file with other positions; in another format, losses are named."""
    path = tmp_path / "a.obj"
    path.write_text("# mine\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 .5\nf 1/1 2/1 3/1\n")
    vertices = canonical_pose.load(path).vertices
    canonical_pose.save(path, 2 * vertices, like=path)
    assert path.read_text() == "# mine\nv 0 0 0\nv 2 0 0\nv 0 2 0\nvt 0 .5\nf 1/1 2/1 3/1\n"
    with pytest.warns(UserWarning, match="lacks comments of"):
        canonical_pose.save(tmp_path / "a.ply", vertices, like=path)
    assert b" texcoord\n" in (tmp_path / "a.ply").read_bytes()
    with pytest.warns(UserWarning, match="lacks texture coordinates, comments of"):
        canonical_pose.save(tmp_path / "a.stl", vertices, like=path)
    with pytest.raises(TypeError, match="are those of the file"):
        canonical_pose.save(path, vertices, [[0, 1, 2]], like=path)
    with pytest.raises(ValueError, match="there are 4 vertices, but '.*a.obj' has 3"):
        canonical_pose.save(path, TETRAHEDRON, like=path)


def test_errors(tmp_path):
    with pytest.raises(ValueError, match="'nowhere.off': it cannot be opened"):
        canonical_pose.load("nowhere.off")
    with pytest.raises(ValueError, match="is not one of .off"):
        canonical_pose.save(tmp_path / "a.xyz", TETRAHEDRON, FACES)
    with pytest.raises(ValueError, match="there is no such directory"):
        canonical_pose.save(tmp_path / "b" / "a.off", TETRAHEDRON, FACES)
    with pytest.raises(TypeError):
        canonical_pose.load(3)


def test_pipes(tmp_path):
    """What comes through a pipe has the format of its content, and is read once."""
    pipe = tmp_path / "pipe"
    os.mkfifo(pipe)
    for k in 1, 2:
        text = f"v 0 0 0\nv {k} 0 0\nv 0 1 0\nf 1 2 3\n"
        thread = threading.Thread(target=pipe.write_text, args=(text,))
        thread.start()
        assert canonical_pose.load(pipe).vertices[1, 0] == k
        thread.join()
