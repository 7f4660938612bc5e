# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors
"""Kinds of input, threads, signals, memory, documentation and types."""

import doctest
import inspect
import os
import pathlib
import signal
import subprocess
import threading
import time

import numpy as np
import pytest

import canonical_pose


def test_kinds_of_arrays(tube):
    vertices, faces = tube
    expected = canonical_pose.geodesics(vertices, faces, 0).tobytes()
    wide = np.zeros((len(vertices), 7))
    wide[:, ::3] = vertices
    for values in (vertices.tolist(), np.asfortranarray(vertices), wide[:, ::3],
                   np.ma.array(vertices), vertices.astype(">f8")):
        assert canonical_pose.geodesics(values, faces, 0).tobytes() == expected
    for indices in (faces.tolist(), [tuple(face) for face in faces], list(faces),
                    np.asfortranarray(faces), faces.astype(np.uint8), faces.astype(">i4"),
                    faces.astype(object), [[np.int32(i) for i in face] for face in faces]):
        assert canonical_pose.geodesics(vertices, indices, 0).tobytes() == expected
    exact = canonical_pose.geodesics(vertices, faces, 0, geodesics="exact")
    single = canonical_pose.geodesics(vertices.astype(np.float32), faces, 0, geodesics="exact")
    np.testing.assert_allclose(single, exact, rtol=1e-5)


def test_polygons(box):
    vertices, faces = box
    triangulated = [*faces[:-1].tolist(), [1, 5, 7], [1, 7, 3]]
    assert canonical_pose.check(vertices, triangulated)["input"] == {
        **canonical_pose.check(vertices, faces)["input"], "faces": 7}
    assert len(canonical_pose.segment(vertices, triangulated, parts=1)[0]) == 7


def test_input_is_not_changed_and_output_is_not_copied(tube):
    vertices, faces = (array.copy() for array in tube)
    pose, _ = canonical_pose.pose(vertices, faces)
    assert (vertices == tube[0]).all() and (faces == tube[1]).all()
    assert pose.flags.f_contiguous and pose.flags.writeable and not pose.flags.owndata


time_of_signal = 0.


def wait_and_interrupt(seconds):
    global time_of_signal
    time.sleep(seconds)
    time_of_signal = time.monotonic()
    os.kill(os.getpid(), signal.SIGINT)


def test_interrupt_of_distances(figure):
    """Between sources, too; the next call is not concerned."""
    vertices, faces = figure
    solver = canonical_pose.HeatSolver(vertices, faces)
    expected = solver.distances(0).tobytes()
    for compute in (solver.distances,
                    lambda sources: canonical_pose.geodesics(vertices, faces, sources, threads=1)):
        sources = np.arange(8000) % len(vertices)  # about a second
        thread = threading.Thread(target=wait_and_interrupt, args=(.05,))
        thread.start()
        with pytest.raises(KeyboardInterrupt):
            compute(sources)
            pytest.fail("it was done before the signal")
        thread.join()
        assert solver.distances(0).tobytes() == expected


@pytest.mark.parametrize("function", [canonical_pose.pose, canonical_pose.segment,
                                      canonical_pose.describe])
def test_interrupt(function, figure):
    vertices, faces = figure
    # Never converges; so what stops it is the signal.
    options = dict(iterations=10**9, tikhonov=1e6, rounds=0, landmarks=10)
    thread = threading.Thread(target=wait_and_interrupt, args=(2.5,))
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        function(vertices, faces, **options)
        pytest.fail("it was done before the signal")
    assert time.monotonic() - time_of_signal < 1
    thread.join()


def test_interrupt_of_a_registrar(figure):
    registrar = canonical_pose.Registrar(*figure, iterations=10**9, tikhonov=1e6)
    thread = threading.Thread(target=wait_and_interrupt, args=(1,))
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        registrar.register(registrar.target)
    assert time.monotonic() - time_of_signal < 1
    thread.join()


def test_interrupt_of_components(figure):
    """All of them, not only that of the main thread."""
    vertices, faces = figure
    both = np.concatenate([vertices, vertices + 9]), np.concatenate([faces, faces + len(vertices)])
    thread = threading.Thread(target=wait_and_interrupt, args=(2.5,))
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        canonical_pose.pose(*both, iterations=10**9, tikhonov=1e6, rounds=0, landmarks=10,
                            components="each")
        pytest.fail("it was done before the signal")
    assert time.monotonic() - time_of_signal < 1
    thread.join()


@pytest.mark.parametrize("function", [canonical_pose.pose, canonical_pose.segment,
                                      canonical_pose.describe])
def test_progress(function, tube):
    """It is told each iteration, can stop the pose, and changes no result; what it raises is raised."""
    def bytes_of(result):
        return (result[0].tobytes() if isinstance(result, tuple)
                else [descriptor["values"].tobytes() for descriptor in result.values()])
    steps = []
    assert bytes_of(function(*tube, progress=steps.append)) == bytes_of(function(*tube))
    assert [step.iteration for step in steps] == list(range(1, len(steps) + 1))
    rounds = [step.round for step in steps]
    assert rounds[0] == 1 and rounds[-1] == 0 and {step.component for step in steps} == {0}
    for step in steps:
        assert isinstance(step, canonical_pose.Progress) and step.largest_move >= 0
        assert step.energy == pytest.approx(
            step.energy_match + step.energy_arap + step.energy_constraints)

    for stops in (lambda step: False, lambda step: np.bool_(False)):
        steps.clear()
        function(*tube, progress=lambda step: steps.append(step) or stops(step))
        assert len(steps) == 1

    error = LookupError("mine")

    def fail(step):
        raise error
    with pytest.raises(LookupError) as caught:
        function(*tube, progress=fail)
    assert caught.value is error
    with pytest.raises(ValueError, match="truth value"):
        function(*tube, progress=lambda step: np.zeros(2))
    with pytest.raises(TypeError, match="option progress must be a function"):
        function(*tube, progress=3)


def test_progress_of_components(tube):
    vertices, faces = tube
    both = np.concatenate([vertices, vertices + 20]), np.concatenate([faces, faces + len(vertices)])
    components = []
    pose, report = canonical_pose.pose(
        *both, components="each", rounds=0, progress=lambda step: components.append(step.component))
    assert report["registration"]["iterations"] == len(components)
    assert components == sorted(components, reverse=True) and set(components) == {0, 1}
    expected, _ = canonical_pose.pose(*both, components="each", rounds=0)
    assert pose.tobytes() == expected.tobytes()


def test_progress_of_a_registrar(tube):
    registrar = canonical_pose.Registrar(*tube)
    expected, report = registrar.register(registrar.target)
    steps = []
    pose, _ = registrar.register(registrar.target, progress=steps.append)
    assert pose.tobytes() == expected.tobytes()
    assert [step.iteration for step in steps] == list(range(1, report["iterations"] + 1))
    assert steps[-1].energy == report["energy"]
    _, report = registrar.register(registrar.target, progress=lambda step: step.iteration < 2)
    assert report["iterations"] == 2 and not report["converged"]
    with pytest.raises(ZeroDivisionError):
        registrar.register(registrar.target, progress=lambda step: 1 // 0)
    assert registrar.register(registrar.target)[0].tobytes() == expected.tobytes()
    for function in (canonical_pose.Registrar, canonical_pose.target):
        with pytest.raises(TypeError, match="no option progress"):
            function(*tube, progress=print)
    with pytest.raises(TypeError, match="option progress must be a function"):
        registrar.register(registrar.target, progress="no")


def test_other_exceptions_of_signals(figure):
    def fail(*_):
        raise LookupError("alarm")
    before = signal.signal(signal.SIGALRM, fail)
    try:
        signal.setitimer(signal.ITIMER_REAL, 1.5)
        with pytest.raises(LookupError, match="alarm"):
            canonical_pose.pose(*figure, iterations=10**9, tikhonov=1e6, rounds=0)
    finally:
        signal.signal(signal.SIGALRM, before)


def test_lock_is_released(figure):
    count = 0
    is_done = False

    def counts():
        nonlocal count
        while not is_done:
            count += 1
            time.sleep(.001)
    thread = threading.Thread(target=counts)
    thread.start()
    before = count
    canonical_pose.pose(*figure)
    assert count > before + 50
    is_done = True
    thread.join()


def test_calls_in_threads(tube):
    expected = canonical_pose.pose(*tube)[0].tobytes()
    results = []
    threads = [threading.Thread(target=lambda: results.append(canonical_pose.pose(*tube)[0]))
               for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert [pose.tobytes() for pose in results] == 4 * [expected]


def resident_megabytes():
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="needs /proc")
def test_memory_does_not_grow(figure):
    vertices, faces = figure
    bad = faces.copy()
    bad[3, 0] = -1

    def least_memory(calls):
        """Some calls keep buffers of the linear algebra, until others return them."""
        least = np.inf
        for _ in range(calls):
            pose, _ = canonical_pose.pose(vertices, faces, rounds=0, landmarks=5, spacing=.2,
                                          solver="eigen")
            canonical_pose.describe(vertices, faces, pose=pose, descriptor="shape-distribution-d2")
            canonical_pose.HeatSolver(vertices, faces).distances([0, 1, 2])
            canonical_pose.check(vertices, faces)
            with pytest.raises(ValueError):
                canonical_pose.pose(vertices, bad)
            least = min(least, resident_megabytes())
        return least
    least_memory(30)
    before = least_memory(30)
    assert least_memory(200) - before < 5 # the pose alone takes 12 megabytes in 200 calls


def public_functions():
    for name in canonical_pose.__all__:
        value = getattr(canonical_pose, name)
        yield name, value
        if inspect.isclass(value):
            for method, function in vars(value).items():
                if inspect.isfunction(function) and not method.startswith("_"):
                    yield f"{name}.{method}", function


def has_collections():
    """Whether the program was built, with collections."""
    path = os.environ.get("CANONICAL_POSE_TOOL", "")
    return os.path.exists(path) and b"without SQLite" not in subprocess.run(
        [path, "collection", "--list", "--database", "nowhere.db"], capture_output=True).stderr


def test_documentation(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # some examples write files
    finder = doctest.DocTestFinder()
    runner = doctest.DocTestRunner(optionflags=doctest.NORMALIZE_WHITESPACE)
    tests = {}
    for module in (canonical_pose, canonical_pose._collections):
        for test in finder.find(module, name="canonical_pose",
                                extraglobs={"canonical_pose": canonical_pose}):
            if module is canonical_pose or test.examples:
                tests[test.name] = test
    for name, value in public_functions():
        assert inspect.getdoc(value), name
        if "." not in name:
            assert tests[f"canonical_pose.{name}"].examples, name
    if not has_collections():
        for name in ("collection", "search", "evaluate"):
            del tests[f"canonical_pose.{name}"]
    for test in tests.values():
        runner.run(test)
    assert runner.summarize(verbose=False).failed == 0


def test_types(stub):
    """The types have the functions and parameters of the module, and nothing else."""
    assert pathlib.Path(canonical_pose.__file__).with_name("py.typed").exists()
    names = {node.name for node in stub.tree.body if hasattr(node, "name")}
    assert {name for name in names if not name.startswith("_")} == set(canonical_pose.__all__)
    methods = {name for name in stub.functions if "." in name and "__" not in name}
    assert methods - {name for name, _ in public_functions()} == {
        "Registrar.target", "Registrar.body_vertices", "Registrar.body_cells", "DescriptorIndex.load"}
    options = set(stub.fields["_Options"])
    assert set(stub.fields["_RecordedOptions"]) == set(canonical_pose._collections.OPTIONS)
    for name, value in public_functions():
        if hasattr(value, "_fields"):
            assert list(stub.fields[name]) == list(value._fields)
            continue
        function = value.__init__ if inspect.isclass(value) else value
        arguments = stub.functions[name + ".__init__" if inspect.isclass(value) else name].args
        names = [argument.arg for argument in arguments.args + arguments.kwonlyargs]
        parameters = inspect.signature(function).parameters
        expected = [p.name for p in parameters.values()
                    if p.kind in (p.POSITIONAL_OR_KEYWORD, p.KEYWORD_ONLY)]
        if name == "pose":
            assert set(expected) - set(names) == options
            continue
        assert names == expected, name
        assert (arguments.kwarg is not None) == any(
            p.kind == p.VAR_KEYWORD for p in parameters.values()), name


def test_arrays_of_others(tube):
    """Objects that convert to arrays are arrays."""
    class Other:
        def __init__(self, array):
            self.array = array

        def __array__(self, dtype=None, copy=None):
            return self.array

    vertices, faces = tube
    expected = canonical_pose.geodesics(vertices, faces, 0)
    assert canonical_pose.geodesics(Other(vertices), Other(faces), 0).tobytes() == expected.tobytes()
    expected = canonical_pose.HeatSolver(vertices, faces).distances(0)
    solver = canonical_pose.HeatSolver(Other(vertices), Other(faces))
    assert solver.distances(0).tobytes() == expected.tobytes()


def test_report_of_parts(tube):
    """A report can be printed."""
    _, report = canonical_pose.segment(*tube, method="sweep")
    assert isinstance(report["tree"]["leaf_of_face"], np.ndarray)
    assert len(report["tree"]["leaf_of_face"]) == len(tube[1])


def test_types_of_reports(stub, tube):
    vertices, faces = tube
    crumb = vertices[0] + [[.1, 0, 0], [.11, 0, 0], [.1, .01, 0]]
    shape = np.concatenate([vertices, crumb]), np.concatenate([faces, [[240, 241, 242]]])
    pose, report = canonical_pose.pose(*shape)
    assert report["followers"] and report["rounds"]
    stub.check("target", (pose, report))
    stub.check("pose", canonical_pose.pose(*tube, return_target=True))
    names = {stage["name"] for stage in report["stages"]}
    for name in names:
        assert f'"{name}"' in canonical_pose.pose.__doc__
    stub.check("target", canonical_pose.target(*tube))
    report = canonical_pose.check(vertices, faces[3:])
    assert report["defects"]
    stub.check("check", report)
    for method, parts in (("sweep", "auto"), ("consensus", 3), ("kmeans", 3)):
        result = canonical_pose.segment(*tube, method=method, parts=parts, rounds=0)
        stub.check("segment", result)
        for stage in result[1]["stages"]:
            assert f'"{stage["name"]}"' in canonical_pose.segment.__doc__
    stub.check("describe", canonical_pose.describe(*tube, rounds=0))
    registrar = canonical_pose.Registrar(*tube)
    stub.check("Registrar.register", registrar.register(registrar.target))


def test_match(tube):
    """The match of a surface with itself, whose shape has several rotations, is somewhere on it."""
    vertices, faces = tube
    match = canonical_pose.match(vertices, faces, vertices, faces, pose=vertices, other_pose=vertices,
                                 landmarks=[(0, 0)], threads=1)
    assert match.weights.shape == match.vertices.shape == (len(vertices), 3)
    np.testing.assert_allclose(match.weights.sum(axis=1), 1)
    assert all(set(corners) == set(faces[face]) for corners, face in zip(match.vertices, match.faces))
    assert match.interpolated(vertices).shape == vertices.shape
    assert match.interpolated(np.arange(len(vertices))).shape == (len(vertices),)
    again = canonical_pose.match(vertices, faces, vertices, faces, other_pose=vertices, threads=1)
    assert again.round_trips.shape == (len(vertices),)
    assert again.faces_at_other.shape == (len(vertices),) and again.scale == 1
    with pytest.raises(ValueError, match="the landmark 0, 240 is out of range"):
        canonical_pose.match(*tube, *tube, landmarks=[(0, 240)], progress=lambda *_: pytest.fail("too late"))
    with pytest.raises(ValueError, match="the pose has 3 vertices"):
        canonical_pose.match(*tube, *tube, pose=vertices[:3], other_pose=vertices)


@pytest.fixture(scope="module")
def bent_cone(tube):
    """A shape whose only symmetry is a mirror symmetry, and the same half as large, turned and moved."""
    vertices, faces = tube
    t = np.arctan2(vertices[:, 1], vertices[:, 0]) / (np.pi / 2)
    center = 4 * vertices / np.hypot(vertices[:, 0], vertices[:, 1])[:, None] * [1, 1, 0]
    shape = center + (vertices - center) * (1 + t[:, None])
    return shape, faces, shape[:, [1, 2, 0]] / 2 + 7


def test_match_of_the_same_shape(bent_cone):
    """It returns each vertex."""
    vertices, faces, other = bent_cone
    match = canonical_pose.match(vertices, faces, other, faces[::-1], pose=vertices, other_pose=other)
    np.testing.assert_allclose(match.interpolated(other), other, atol=1e-6)
    np.testing.assert_allclose(match.interpolated_at_other(vertices), vertices, atol=1e-6)
    np.testing.assert_allclose(match.weights_at_other.sum(axis=1), 1)
    assert all(set(corners) == set(faces[face])
               for corners, face in zip(match.vertices_at_other, match.faces_at_other))
    assert match.scale == pytest.approx(2) and match.is_rotation_certain
    assert match.edge_strain < 1e-6
    assert match.compared_share == match.compared_share_of_other == 1
    posture, _ = canonical_pose.pose(vertices, faces,
                                     given_target=match.scale * match.interpolated(other))
    assert canonical_pose.compare(posture, vertices)[0] < 1e-3
    labels = np.where(vertices[faces].mean(axis=1)[:, 0] > 3, "near", "far")
    assert (match.transferred_labels(faces, other, faces[::-1], labels[::-1]) == labels).all()


def test_transferred_labels():
    """Two triangles on a square, cut along the other diagonal, with a vertex in the middle of one of them."""
    match = canonical_pose.Match(*[None] * len(canonical_pose.Match._fields))
    match = match._replace(vertices=np.array([[0, 1, 2], [0, 1, 2], [0, 1, 2], [2, 1, 3]]),
                           weights=np.array([[1, 0, 0], [0, 1, 0], [.2, .4, .4], [0, 0, 1]]))
    faces, other_faces = [[0, 1, 2], [1, 3, 2]], [[0, 1, 2], [2, 1, 3], [3, 1, 4]]
    other = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]]  # the last one is far from all
    assert match.transferred_labels(faces, other, other_faces, ["a", "b", "c"]).tolist() == ["a", "b"]
    assert match.transferred_labels(faces, other, other_faces, np.eye(3)).tolist() == np.eye(3)[:2].tolist()
    with pytest.raises(ValueError, match="face 0 names vertex 4, but there are 4"):
        match.transferred_labels([[0, 1, 4]], other, other_faces, [1, 2, 3])
    with pytest.raises(ValueError, match="vertex 3 is at vertex 3, but there are 3"):
        match.transferred_labels(faces, other[:3], other_faces[:1], [1])


def test_mirrored_match(bent_cone):
    """The mirror symmetry of a shape."""
    vertices, faces, _ = bent_cone
    mirrored = vertices * [1, 1, -1]
    match = canonical_pose.match(vertices, faces, mirrored, faces[:, ::-1], pose=vertices,
                                 other_pose=mirrored)
    np.testing.assert_allclose(match.interpolated(vertices), mirrored, atol=1e-6)


def test_mean_pose(bent_cone):
    """That of rigid copies is the first one, and of two sizes the middle."""
    vertices, _, other = bent_cone
    copies = [vertices, 2 * other + 9, vertices[:, [2, 0, 1]] * [1, -1, -1]]
    np.testing.assert_allclose(canonical_pose.mean_pose(copies), vertices, atol=1e-5)
    np.testing.assert_allclose(canonical_pose.mean_pose(np.array([vertices, 3 * vertices])),
                               2 * vertices - vertices.mean(axis=0), atol=1e-5)
    for poses, message in [([], "there is no pose"), (vertices, "pose 0 must have 2 dimensions"),
                           ([vertices, other[1:]], "poses of .* points cannot be compared")]:
        with pytest.raises(ValueError, match=message):
            canonical_pose.mean_pose(poses)
