# Copyright (c) 2026 The Canonical_pose_3 authors.
#
# This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
# distribution.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Author(s) : The Canonical_pose_3 authors

"""Draws a surface, its target, and its canonical pose with its parts.

    python3 plot_pose.py figure.off picture.png

The file is an OFF file of triangles, such as make_figure writes it; up is +y. Needs Matplotlib
(Debian: python3-matplotlib).
"""

import sys

import matplotlib
import numpy as np

import canonical_pose

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def read_off(path):
    with open(path) as file:
        words = file.read().split()
    n, m = int(words[1]), int(words[2])
    vertices = np.array(words[4:4 + 3 * n], dtype=float).reshape(n, 3)
    faces = np.array(words[4 + 3 * n:4 + 3 * n + 4 * m], dtype=int).reshape(m, 4)
    return vertices, faces[:, 1:]


def draw(axes, title, vertices, faces, values, colors, radius):
    points = vertices - (vertices.min(axis=0) + vertices.max(axis=0)) / 2
    light = matplotlib.colors.LightSource(azdeg=315, altdeg=40)
    surface = axes.plot_trisurf(points[:, 0], -points[:, 2], points[:, 1], triangles=faces,
                                color="white", shade=False)
    corners = points[faces][:, :, [0, 2, 1]] * [1, -1, 1]
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    shade = light.shade_normals(normals / np.linalg.norm(normals, axis=1)[:, None])
    rgba = matplotlib.colormaps[colors](values)
    rgba[:, :3] *= (.45 + .55 * shade)[:, None]
    surface.set_facecolor(rgba)
    axes.set_title(title)
    axes.set_xlim(-radius, radius)
    axes.set_ylim(-radius, radius)
    axes.set_zlim(-radius, radius)
    axes.set_box_aspect((1, 1, 1), zoom=1.5)
    axes.view_init(elev=8, azim=-75)
    axes.set_axis_off()


def main(path, picture):
    vertices, faces = read_off(path)
    pose, report, target = canonical_pose.pose(vertices, faces, detail_length=.1,
                                               return_target=True)
    parts, _ = canonical_pose.segment(vertices, faces, pose=pose)
    distances = canonical_pose.HeatSolver(vertices, faces).distances(int(vertices[:, 1].argmax()))
    print(report["registration"])

    near = 1 - distances[faces].mean(axis=1) / distances.max()
    figure = pyplot.figure(figsize=(12, 4.5))
    shapes = [("Input, with distances from the top", vertices, near, "viridis"),
              ("Target", target, near, "viridis"),
              ("Canonical pose, with parts", pose, parts % 20, "tab20")]
    radius = max(np.ptp(points, axis=0).max() for _, points, _, _ in shapes) / 2
    for i, (title, points, values, colors) in enumerate(shapes):
        draw(figure.add_subplot(1, 3, i + 1, projection="3d"), title, points, faces, values, colors,
             radius)
    figure.subplots_adjust(0, 0, 1, .92, 0, 0)
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: plot_pose.py figure.off picture.png")
    main(*sys.argv[1:])
