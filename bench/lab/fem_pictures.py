"""Kerf's body beside finite elements, and the lines of these over it."""

import numpy as np
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.lines import Line2D

from . import bodies, drawing

FROM = np.array([1.5, 1.2, 4]) / np.linalg.norm([1.5, 1.2, 4])  # the front right above
RIGHT = np.cross([0, 1, 0], FROM) / np.linalg.norm(np.cross([0, 1, 0], FROM))
UP = np.cross(FROM, RIGHT)
LIGHT = np.array([0.3, 0.9, 0.5]) / np.linalg.norm([0.3, 0.9, 0.5])
SHARP = 0.5  # cosine of the angle between faces from which on they are edged
SKIN, WALL = np.array([0.93, 0.62, 0.55]), np.array([0.72, 0.12, 0.16])


def in_view(points):
    """Where points are seen, to the right and up [mm]."""
    return 1000 * np.stack([points @ RIGHT, points @ UP], axis=-1)


def normals_of(points, triangles):
    a, b, c = bodies.corners(points, triangles)
    normals = np.cross(b - a, c - a)
    return normals / np.linalg.norm(normals, axis=1)[:, None]


def edges_of(triangles):
    """The ends of each edge, and the two triangles at it."""
    ends = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
    at = np.repeat(np.arange(len(triangles)), 3)
    order = np.lexsort(ends.T)
    ends, at = ends[order], at[order]
    pairs = np.flatnonzero((ends[1:] == ends[:-1]).all(axis=1))
    return ends[pairs], np.stack([at[pairs], at[pairs + 1]], axis=1)


def is_rim(surface, at):
    """Of edges by their triangles: between skin and walls."""
    return surface.walls[at[:, 0]] != surface.walls[at[:, 1]]


def is_outline(surface, at):
    """Of edges by their triangles: sharp ones at rest; all where the body is round."""
    normals = normals_of(surface.rest, surface.triangles)
    bent = (normals[at[:, 0]] * normals[at[:, 1]]).sum(axis=1) < SHARP
    return bent if (bent & ~is_rim(surface, at)).any() else np.ones_like(bent)


def draw_lines(panel, surface, wanted, hue):
    """Those edges that belong to a triangle which is turned to the view."""
    ends, at = edges_of(surface.triangles)
    turned = normals_of(surface.positions, surface.triangles) @ FROM > 0
    chosen = ends[turned[at].any(axis=1) & wanted(surface, at)]
    panel.add_collection(LineCollection(in_view(surface.positions[chosen]), colors=hue,
                                        linewidths=0.9))


def draw_body(panel, surface):
    """From the back to the front."""
    normals = normals_of(surface.positions, surface.triangles)
    depth = (surface.positions @ FROM)[surface.triangles].mean(axis=1)
    order = np.argsort(depth)[(normals @ FROM > 0)[np.argsort(depth)]]
    bright = 0.45 + 0.55 * np.clip(normals @ LIGHT, 0, 1)
    hues = bright[:, None] * np.where(surface.walls[:, None], WALL, SKIN)
    panel.add_collection(PolyCollection(in_view(surface.positions[surface.triangles[order]]),
                                        facecolors=hues[order], edgecolors=hues[order],
                                        linewidths=0.3))
    draw_lines(panel, surface, is_rim, drawing.VERMILLION)


def figure_of(title, kerf_body, elements):
    figure, axes = drawing.panels(1, 3, 640, 460)
    figure.suptitle(title, x=0.01, ha="left")
    for panel, name, body in zip(axes[0], ("Kerf", "finite elements", "Kerf, and lines of finite "
                                           "elements"), (kerf_body, elements, kerf_body)):
        draw_body(panel, body)
        panel.set(title=name, xlabel="to the right of the view, mm", ylabel="up, mm")
        for shown in (kerf_body, elements):  # all panels show the same place
            panel.update_datalim(in_view(shown.positions[np.unique(shown.triangles)]))
        panel.set_aspect("equal", adjustable="datalim")
        panel.margins(0.03)
        panel.autoscale_view()
    draw_lines(axes[0, 2], elements, is_outline, drawing.BLUE)
    axes[0, 2].legend(handles=[Line2D([], [], color=drawing.VERMILLION, label="rim of Kerf's cut"),
                               Line2D([], [], color=drawing.BLUE, label="finite elements")],
                      loc="best")
    return figure
