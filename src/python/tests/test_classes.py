# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Classes that are prepared once give the same results as the functions."""

import copy
import pickle
import threading

import numpy as np
import pytest

import canonical_pose


def test_heat_solver(fine_tube):
    vertices, faces = fine_tube
    solver = canonical_pose.HeatSolver(vertices, faces)
    expected = canonical_pose.geodesics(vertices, faces, [0, 17])
    assert solver.distances([0, 17]).tobytes() == expected.tobytes()
    assert solver.distances(17).tobytes() == expected[:, 1].tobytes()
    assert solver.distance_to_nearest([0, 17]).tobytes() == expected.min(axis=1).tobytes()
    smooth = canonical_pose.HeatSolver(vertices, faces, time_step_factor=10)
    assert not np.array_equal(smooth.distances(0), expected[:, 0])


def test_heat_solver_of_a_surface_to_be_repaired(fine_tube):
    vertices, faces = fine_tube
    # A soup: each triangle has vertices of its own.
    soup = vertices[faces].reshape(-1, 3)
    faces = np.arange(len(soup)).reshape(-1, 3)
    expected = canonical_pose.geodesics(soup, faces, 5)
    assert canonical_pose.HeatSolver(soup, faces).distances(5).tobytes() == expected.tobytes()


def test_heat_solver_in_threads(figure):
    solver = canonical_pose.HeatSolver(*figure)
    expected = [solver.distances(source) for source in range(8)]
    results = [None] * 8

    def run(source):
        results[source] = solver.distances(source)
    threads = [threading.Thread(target=run, args=(source,)) for source in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(a.tobytes() == b.tobytes() for a, b in zip(expected, results))


def test_target(figure):
    vertices, faces = figure
    target, report = canonical_pose.target(vertices, faces, landmarks=30)
    _, expected, final = canonical_pose.pose(vertices, faces, landmarks=30, rounds=0,
                                             return_target=True)
    assert target.tobytes() == final.tobytes()
    assert report["target"] == expected["target"]
    assert report["input"] == expected["input"]


def test_target_in_any_frame(tube):
    vertices, faces = tube

    def result(frame, target=None):
        pose, _, target = canonical_pose.pose(vertices + [30, -10, 20], faces, frame=frame,
                                              given_target=target, return_target=True)
        return pose.tobytes(), target.tobytes(), target

    _, expected_target, target = result("input")
    _, other_target, other = result("canonical")
    assert other_target == expected_target
    for frame in ("input", "canonical"):
        assert result(frame, target)[:2] == result(frame, other)[:2]


def test_target_of_several_components(tube):
    vertices, faces = tube
    n = len(vertices)
    both = np.concatenate([vertices, 2 * vertices + 20, [[1, 2, 3]]])
    faces = np.concatenate([faces, faces + n])
    with pytest.raises(ValueError, match="2 connected components"):
        canonical_pose.target(both, faces)
    target, _ = canonical_pose.target(both, faces, components="each")
    assert np.isfinite(target).all()
    assert target[-1].tolist() == [1, 2, 3]
    proper, _ = canonical_pose.compare(target[:n], target[n:-1])
    assert proper < .02
    target, _ = canonical_pose.target(both, faces, components="largest")
    np.testing.assert_allclose(target[:n], vertices, atol=1e-9)


def test_small_components_follow(tube):
    vertices, faces = tube
    n = len(vertices)
    crumb = vertices[0] + [[.1, 0, 0], [.11, 0, 0], [.1, .01, 0]]
    _, report = canonical_pose.pose(np.concatenate([vertices, crumb]),
                                    np.concatenate([faces, [[n, n + 1, n + 2]]]), rounds=0)
    assert report["followers"] == [{"component": 1, "vertex": n, "leader": 0, "rigid": True}]


def test_registrar(tube):
    vertices, faces = tube
    registrar = canonical_pose.Registrar(vertices, faces)
    assert registrar.target.tobytes() == canonical_pose.target(vertices, faces)[0].tobytes()
    expected, report = canonical_pose.pose(vertices, faces, given_target=registrar.target)
    pose, summary = registrar.register(registrar.target)
    assert summary["converged"] and summary["inverted"] == 0
    np.testing.assert_allclose(pose, expected, atol=1e-9)
    assert summary["energy"] == pytest.approx(report["registration"]["energy"], rel=1e-9)
    assert len(registrar.body_vertices) == report["body"]["vertices"]
    assert registrar.body_cells.shape == (report["body"]["tetrahedra"], 4)
    assert registrar.body_cells.max() == len(registrar.body_vertices) - 1
    for array in (registrar.target, registrar.body_vertices, registrar.body_cells):
        with pytest.raises(ValueError):
            array[0, 0] = 1

    again, warm = registrar.register(registrar.target, warm=True)
    assert warm["iterations"] < summary["iterations"]
    np.testing.assert_allclose(again, pose, atol=1e-2)
    registrar.set_detail_length(1)
    stiff, _ = registrar.register(registrar.target)
    rigid = canonical_pose.compare(stiff, vertices)[0]
    assert rigid < canonical_pose.compare(pose, vertices)[0]
    with pytest.raises(ValueError, match="detail_length"):
        registrar.set_detail_length(0)


def test_arrays_outlive_the_registrar(tube):
    registrar = canonical_pose.Registrar(*tube)
    points, cells, target = registrar.body_vertices, registrar.body_cells, registrar.target
    copies = points.copy(), cells.copy(), target.copy()
    del registrar
    assert all((a == b).all() for a, b in zip((points, cells, target), copies))


def test_registrar_with_isolated_vertices(tube):
    vertices, faces = tube
    registrar = canonical_pose.Registrar(np.concatenate([vertices, vertices[:1]]), faces)
    pose, _ = registrar.register(registrar.target)
    # It moves with the surface that it lies on.
    np.testing.assert_allclose(pose[-1], pose[0], atol=1e-9)


def test_registrar_refuses(tube):
    vertices, faces = tube
    registrar = canonical_pose.Registrar(vertices, faces)
    with pytest.raises(ValueError, match="the target has 3 vertices, but the surface has 240"):
        registrar.register(vertices[:3])
    with pytest.raises(TypeError, match="no option rounds"):
        canonical_pose.Registrar(vertices, faces, rounds=1)
    both = np.concatenate([vertices, vertices + 20])
    with pytest.raises(ValueError, match="2 components"):
        canonical_pose.Registrar(both, np.concatenate([faces, faces + len(vertices)]),
                                 components="each")


def test_descriptor_index(tube, box):
    shapes = [tube, (tube[0] * [1, 1, 2], tube[1]), box]
    values = [canonical_pose.describe(*shape, descriptor="views", pose=shape[0])["views"]["values"]
              for shape in shapes]
    index = canonical_pose.DescriptorIndex("views")
    assert [index.insert(v) for v in values] == [0, 1, 2] and len(index) == 3
    assert index.values(1).tobytes() == values[1].tobytes()
    shapes, distances = index.nearest(values[0], 2)
    assert shapes[0] == 0 and distances[0] < 1e-9 < distances[1]
    assert index.distances(values[0])[shapes].tolist() == distances.tolist()
    assert sorted(index.distances(values[0]))[:2] == distances.tolist()
    assert index.distances().shape == (3, 3)
    assert len(index.nearest(values[0])[0]) == 3
    with pytest.raises(ValueError, match="there are 2 values, but views has"):
        index.insert([1, 2])
    with pytest.raises(ValueError, match="there is no descriptor 'colors'"):
        canonical_pose.DescriptorIndex("colors")
    with pytest.raises(IndexError):
        index.values(3)


def test_shape_distance(tube, box):
    """As by an index of the other shape."""
    distances = canonical_pose.shape_distance(*tube, *box, rounds=0)
    described, others = (canonical_pose.describe(*shape, rounds=0) for shape in (tube, box))
    assert list(distances) == list(described)
    for name, distance in distances.items():
        index = canonical_pose.DescriptorIndex(name)
        index.insert(others[name]["values"])
        assert index.distances(described[name]["values"]).tolist() == [distance] and distance > 0
    assert canonical_pose.shape_distance(*box, *box, descriptor=["views"]) == {"views": 0}
    steps = []
    canonical_pose.shape_distance(*tube, *tube, descriptor="views", pose=tube[0], other_pose=tube[0],
                                  progress=steps.append)
    assert not steps
    canonical_pose.shape_distance(*tube, *tube, descriptor="views", progress=steps.append)
    assert [step.iteration for step in steps].count(1) == 2


def test_align_handedness(tube):
    vertices, faces = tube
    mirrored = vertices * [1, -1, 1] @ [[0, 1, 0], [0, 0, 1], [1, 0, 0]] + 3
    result = canonical_pose.align_handedness(vertices, mirrored, 2 * vertices)
    assert result.dtype == bool and result.tolist() == [False, True, False]
    assert canonical_pose.align_handedness(mirrored, vertices).tolist() == [False, True]


def test_mirror_image_of_a_target(figure):
    """It is posed by the mirror image of its target, and not turned inside out."""
    pose, report, target = canonical_pose.pose(*figure, return_target=True)
    other, mirrored = canonical_pose.pose(*figure, given_target=target * [-1, 1, 1])
    assert canonical_pose.align_handedness(pose, other).tolist() == [False, True]
    assert report["registration"]["inverted"] == mirrored["registration"]["inverted"] == 0
    assert mirrored["registration"]["volume_ratio"] > .5


@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy,
                                    lambda x: pickle.loads(pickle.dumps(x))])
def test_copies(fine_tube, tmp_path, copied):
    """Copies compute the same, and do not depend on arrays that change afterward."""
    vertices, faces = np.array(fine_tube[0]), fine_tube[1]
    solver = canonical_pose.HeatSolver(vertices, faces, time_step_factor=2.)
    registrar = canonical_pose.Registrar(vertices, faces, landmarks=20)
    registrar.set_detail_length(.3)
    target = registrar.target
    pose, _ = registrar.register(target)
    vertices[:] = 0
    assert copied(solver).distances(3).tobytes() == solver.distances(3).tobytes()
    again = copied(registrar)
    assert again.register(target)[0].tobytes() == pose.tobytes()
    assert repr(solver) == f"<HeatSolver of {len(vertices)} vertices>"
    assert repr(registrar) == f"<Registrar of {len(vertices)} vertices>"

    index = canonical_pose.DescriptorIndex("shape-distribution-d2")
    for k in range(3):
        index.insert(np.linspace(0, k, 64))
    index.save(tmp_path / "index")
    for other in copied(index), canonical_pose.DescriptorIndex.load(tmp_path / "index"):
        assert other.distances().tobytes() == index.distances().tobytes()
        assert repr(other) == "<DescriptorIndex of 3 shapes by shape-distribution-d2>"
    empty = canonical_pose.DescriptorIndex("views")
    empty.save(tmp_path / "empty")
    assert len(copied(empty)) == len(canonical_pose.DescriptorIndex.load(tmp_path / "empty")) == 0
    np.savez(tmp_path / "other.npz", a=1)
    with pytest.raises(ValueError, match="is not an index"):
        canonical_pose.DescriptorIndex.load(tmp_path / "other.npz")
