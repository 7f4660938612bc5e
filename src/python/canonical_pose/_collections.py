# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Collections of shapes, by the program: each shape is computed by a process of its own."""

import json
import os
import pathlib
import shutil
import subprocess
import warnings

# Those of `pose` that a collection records.
OPTIONS = ("detail_length", "landmarks", "rounds", "body", "spacing", "geodesics", "target_mode",
           "kernel", "tikhonov", "iterations", "paper_weights", "injective", "components", "contacts",
           "symmetry", "solver", "seed", "threads")


def collection(database, shapes=None, *, descriptor=None, poses=None, match=None, matches=None,
               segment=False, workers=0, time_limit=3600, memory_limit=0, failed=False, **options):
    """Describe many surfaces, and store the results in a database, for `search` and `evaluate`.

    It runs the program ``canonical-pose``, which must be installed, and starts a process for each
    shape: what is refused or crashes is a result as well. What is up to date is not computed again.
    If it is stopped, the same call continues.

    Parameters
    ----------
    database : string or path
        The file of the database (SQLite), which is created if it does not exist.
    shapes : string or path, or sequence of these
        Files, folders, which stand for the surfaces in them, or strings ``"@list"``, where ``list`` is a
        file with one path per line. None computes nothing.
    descriptor : string, or sequence of strings
        As for `describe`.
    poses : string or path
        A folder for the poses, which have the names and formats of the shapes.
    match : string or path
        The file of a surface, the template, that is also matched with each shape. Then the report of a
        shape has ``"match"``, with ``"mean_distance"``, ``"mean_round_trip"``, the mean of
        ``round_trips`` without those of small components and isolated vertices, and
        ``"is_rotation_certain"``, as of the function `match`, and with ``"warnings"``.
    matches : string or path
        The folder for the template in the shape of each one, needed with `match`: vertex i of each
        file is vertex i of the template. Files have the names of the shapes and its format.
    segment : bool
        Whether shapes are also divided into parts.
    workers : int
        Number of shapes computed at the same time; 0 for one per processor.
    time_limit : float
        Seconds for a shape; 0 for no limit.
    memory_limit : float
        Megabytes of memory for a shape; 0 for no limit.
    failed : bool
        Whether only the shapes without a result are returned.
    **options
        As for `pose`, but for arrays, constraints and `frame`; each component is posed by default, and
        `threads`, of each shape, is 1.

    Returns
    -------
    shapes : list of dicts
        All shapes of the database: ``"path"``, ``"checksum"``, ``"options"``, ``"version"``,
        ``"outcome"``, which is ``"done"`` if there is a result, ``"message"``, ``"seconds"``,
        ``"has_pose"``, ``"is_segmented"``, ``"descriptors"``, a dict of versions, and ``"report"``.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> canonical_pose.save("box.off", vertices, faces)
    >>> shapes = canonical_pose.collection("shapes.db", "box.off", descriptor="views", landmarks=8)
    >>> shapes[0]["outcome"], shapes[0]["options"], shapes[0]["descriptors"]
    ('done', '--landmarks 8', {'views': 1})
    """
    if shapes is not None:
        if isinstance(shapes, (str, bytes, os.PathLike)):
            shapes = [shapes]
        words = ["--quiet", f"--workers={workers}", f"--time-limit={time_limit}",
                 f"--memory-limit={memory_limit}", *_descriptor_words(descriptor)]
        if poses is not None:
            words.append(f"--poses={_path(poses)}")
        if match is not None:
            words.append(f"--match={_path(match)}")
        if matches is not None:
            words.append(f"--matches={_path(matches)}")
        if segment:
            words.append("--segment")
        inputs = [shape if isinstance(shape, str) and shape[:1] == "@" else _path(shape)
                  for shape in shapes]
        _run("collection", database, *words, *_option_words(options), *inputs)
    return json.loads(_run("collection", database, "--list", "--json",
                           *(["--failed"] if failed else [])))


def search(database, query, *, number=10, descriptor=None, pose=None, **options):
    """Find the shapes of a `collection` that are most similar to a surface.

    Parameters
    ----------
    database : string or path
        The file of the database.
    query : string or path
        The file of the surface.
    number : int
        At most as many shapes are returned.
    descriptor : string, sequence of strings, or dict
        As for `describe`; by default, those of the database. A dict has their weights.
    pose : string or path
        The file of the pose of the surface; otherwise it is computed, if a descriptor needs it.
    **options
        As for `collection`; the shapes must have been described with the same ones.

    Returns
    -------
    shapes : list of dicts
        ``"path"`` and ``"distance"``, the nearest one first. Distances by several descriptors are
        divided by their means, multiplied by the weights, and added.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> canonical_pose.save("box.off", vertices, faces)
    >>> shapes = canonical_pose.collection("search.db", "box.off", descriptor="views")
    >>> canonical_pose.search("search.db", "box.off")[0]["distance"]
    0.0
    """
    words = ["-n", str(number), *_descriptor_words(descriptor)]
    if pose is not None:
        words.append(f"--pose={_path(pose)}")
    return json.loads(_run("search", database, "--quiet", "--report=-", *words,
                           *_option_words(options), _path(query)))["answers"]


def evaluate(database, classes, *, descriptor=None, rerank=None, **options):
    """Evaluate how well the shapes of a `collection` find those of their class.

    Parameters
    ----------
    database : string or path
        The file of the database.
    classes : string or path
        A file of lines with the name of a shape, without folder and extension, and its class.
    descriptor : string, sequence of strings, or dict
        As for `search`.
    rerank : "manifold"
        Whether the answers after manifold ranking are evaluated as well.
    **options
        As for `collection`; they choose among several descriptions of a shape.

    Returns
    -------
    evaluations : dict
        For each descriptor, and for ``"fused"``, all of them together, a dict. ``"mean"`` has the means
        of ``"nearest_neighbor"``, ``"first_tier"``, ``"second_tier"``, ``"e_measure"``,
        ``"discounted_cumulative_gain"`` and ``"average_precision"``, as fractions, over all queries, and
        ``"classes"`` those for each class. ``"precision"`` is a list of the mean precisions at the
        recalls 1/20, 2/20, ..., 1, and ``"nearest"`` tells, for each class, the numbers of its shapes
        whose nearest shape is in each class.

    Examples
    --------
    >>> vertices = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 5)]
    >>> faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    >>> for name in "first.off", "second.off":
    ...     canonical_pose.save(name, vertices, faces)
    >>> with open("classes.txt", "w") as file:
    ...     characters = file.write("first box\\nsecond box\\n")
    >>> shapes = canonical_pose.collection("boxes.db", ["first.off", "second.off"], descriptor="views")
    >>> evaluations = canonical_pose.evaluate("boxes.db", "classes.txt")
    >>> evaluations["views"]["mean"]["nearest_neighbor"], evaluations["views"]["nearest"]
    (1.0, {'box': {'box': 2}})
    """
    words = [f"--classes={_path(classes)}", *_descriptor_words(descriptor)]
    if rerank is not None:
        words.append(f"--rerank={rerank}")
    return json.loads(_run("evaluate", database, "--quiet", "--report=-", *words,
                           *_option_words(options)))


def _path(path):
    """Return a path that is no option, and no name of a command."""
    path = os.fsdecode(path)
    if not path:
        raise ValueError("a path is empty")
    return os.path.join(os.curdir, path)


def _descriptor_words(descriptor):
    if descriptor is None:
        return []
    if isinstance(descriptor, str):
        descriptor = [descriptor]
    elif hasattr(descriptor, "items"):
        descriptor = [f"{name}:{weight}" for name, weight in descriptor.items()]
    return [f"--descriptor={name}" for name in descriptor]


def _option_words(options):
    words = []
    for name, value in options.items():
        if name not in OPTIONS:
            raise TypeError(f"there is no option {name}")
        option = "--" + name.replace("_", "-")
        if value is None:
            continue
        if name == "injective":
            if value not in (True, False):
                raise TypeError("option injective must be True or False")
            words.append(option if value else "--no-injective")
        elif name == "paper_weights":
            words.append(f"{option}={','.join(map(str, value))}")
        else:
            words.append(f"{option}={value}")
    return words


def _program():
    """Return the path of the program: where the package was built or installed, or on PATH."""
    folder = pathlib.Path(__file__).resolve().parent
    beside = [folder.parents[1] / "canonical-pose"]  # in the build directory
    if len(folder.parents) > 3:
        beside.append(folder.parents[3] / "bin" / "canonical-pose")
    for path in [*beside, "canonical-pose"]:
        if found := shutil.which(path):
            return found
    raise FileNotFoundError("the program canonical-pose was found neither beside the module nor on PATH: "
                            "collections need it; install the tools of Canonical_pose_3")


def _run(command, database, *words):
    """Return the output of the program."""
    with subprocess.Popen([_program(), command, f"--database={_path(database)}", *words],
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE
                          ) as process:
        try:
            output, errors = process.communicate()
        except BaseException:  # such as KeyboardInterrupt
            process.terminate()  # on which it removes its files, and its processes end
            process.wait()
            raise
    messages = [line.removeprefix("canonical-pose: ")
                for line in errors.decode(errors="replace").splitlines()]
    if process.returncode == 0:
        for message in messages:
            warnings.warn(message.removeprefix("warning: "), stacklevel=3)
        return output.decode(errors="replace")
    message = messages[-1] if messages else f"canonical-pose ended with the code {process.returncode}"
    raise (ValueError if process.returncode == 2 else RuntimeError)(message)
