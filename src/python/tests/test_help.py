# Copyright (c) 2026 The Canonical_pose_3 authors.
# SPDX-License-Identifier: GPL-3.0-or-later

"""The page of the program names the options that --help lists, with the same defaults, and no others."""

import os
import pathlib
import re
import subprocess

import pytest

PAGE = pathlib.Path(__file__).parents[2] / "tool" / "canonical_pose.md"


def sections_of_page():
    return {section.split("\n")[0]: section
            for section in re.split("^## ", PAGE.read_text(), flags=re.M)[1:]}


def table_of(section):
    """The defaults by option."""
    rows = re.findall(r"^\| (`-.*?[^\\]) \| (.*?[^\\]) \| ", section, flags=re.M)
    return {name: default for names, default in rows for name in re.findall("--[a-z-]+", names)}


def options_of_help(command):
    """The defaults by option; None if there is none."""
    usage = subprocess.run([os.environ["CANONICAL_POSE_TOOL"], command, "--help"],
                           capture_output=True, text=True, check=True).stdout
    return {name: default for name, default in
            re.findall(r"^  (?:-\w,)?(--[a-z-]+)(?: [A-Z]\S*?(?:=(\S+))?)?(?=\s)", usage, flags=re.M)}


@pytest.mark.skipif("CANONICAL_POSE_TOOL" not in os.environ, reason="there is no program")
def test_options():
    sections = sections_of_page()
    described = set(re.findall("--[a-z-]+", PAGE.read_text()))
    for command in ("pose", "segment", "describe", "collection", "search", "evaluate", "check",
                    "geodesics", "match", "compare", "page"):
        table = table_of(sections[command])
        options = options_of_help(command)
        assert set(table) <= set(options), command
        assert set(options) <= described, command
        for name, default in table.items():
            if re.fullmatch(r"`[a-z]+`|[\d.]+", default) and options[name]:
                assert options[name] == default.strip("`"), (command, name)
            elif options[name]:
                assert options[name] in default, (command, name)
