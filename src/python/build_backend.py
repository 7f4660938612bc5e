# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Builds the wheel for pip, by CMake; needs nothing else.

Libraries, interpreters and compilers are found as by CMake alone. The environment variable CMAKE_ARGS
adds arguments, and BUILD_DIRECTORY (default: build-python) is where.
"""

import base64
import hashlib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import sysconfig
import tarfile
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
VERSION = re.search(
    r'_VERSION "(.+)"', (ROOT / "include/CGAL/Canonical_pose_3/library_configuration.h").read_text()
)[1]
NAME = f"canonical_pose-{VERSION}"
METADATA = f"""\
Metadata-Version: 2.1
Name: canonical-pose
Version: {VERSION}
Summary: Detail-preserving canonical poses of 3D shapes
License: GPL-3.0-or-later
Requires-Python: >=3.9
Requires-Dist: numpy
Description-Content-Type: text/markdown

{(ROOT / "README.md").read_text()}"""


def install(directory):
    """Build the module and install it below a directory."""
    build = ROOT / os.environ.get("BUILD_DIRECTORY", "build-python")
    options = ["python=ON", "tools=OFF", "tests=OFF", "examples=OFF", "benchmark=OFF"]
    subprocess.run(["cmake", "-S", ROOT, "-B", build, "-DCMAKE_BUILD_TYPE=Release",
                    f"-DPython_EXECUTABLE={sys.executable}", "-DPYTHON_INSTALL_DIRECTORY=.", "-DBUILD_SHARED_LIBS=OFF",
                    *(f"-DWITH_{option}" for option in options),
                    *shlex.split(os.environ.get("CMAKE_ARGS", ""))], check=True)
    subprocess.run(["cmake", "--build", build, "--target", "canonical_pose_python",
                    "--parallel", os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", "2")], check=True)
    subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", directory],
                   check=True)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    tag = f"{python}-{python}-{re.sub('[-.]', '_', sysconfig.get_platform())}"
    wheel = f"{NAME}-{tag}.whl"
    records = []
    with tempfile.TemporaryDirectory() as directory, \
            zipfile.ZipFile(pathlib.Path(wheel_directory) / wheel, "w", zipfile.ZIP_DEFLATED) as file:
        def add(path, content):
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            records.append(f"{path},sha256={digest},{len(content)}\n")
            file.writestr(path, content)

        install(directory)
        for path in sorted(pathlib.Path(directory).rglob("*.*")):
            add(path.relative_to(directory).as_posix(), path.read_bytes())
        information = f"{NAME}.dist-info"
        add(f"{information}/METADATA", METADATA.encode())
        add(f"{information}/LICENSE.md", (ROOT / "LICENSE.md").read_bytes())
        add(f"{information}/WHEEL", ("Wheel-Version: 1.0\nGenerator: build_backend\n"
                                     f"Root-Is-Purelib: false\nTag: {tag}\n").encode())
        records.append(f"{information}/RECORD,,\n")
        file.writestr(f"{information}/RECORD", "".join(records))
    return wheel


def build_sdist(sdist_directory, config_settings=None):
    """Pack the files under version control."""
    archive = f"{NAME}.tar.gz"
    listing = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], check=True, capture_output=True)
    with tarfile.open(pathlib.Path(sdist_directory) / archive, "w:gz") as file, \
            tempfile.NamedTemporaryFile() as information:
        for path in os.fsdecode(listing.stdout).split("\0")[:-1]:
            file.add(ROOT / path, f"{NAME}/{path}")
        information.write(METADATA.encode())
        information.flush()
        file.add(information.name, f"{NAME}/PKG-INFO")
    return archive
