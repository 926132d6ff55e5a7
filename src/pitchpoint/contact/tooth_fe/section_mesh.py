# SPDX-License-Identifier: Apache-2.0
"""Structured mesh of the transverse section of one pitch: tooth, root and body down to the clamped circle.

The tooth is a block of rows between its flanks. It ends at an arc between the middles of both fillets, which
is part of the upper edge of the body; the columns of the body continue from this edge to the clamped circle.

Derivation: docs/theory/tooth_fe.md, "Mesh".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from pitchpoint.contact.tooth_fe.contour import ComplexArray, Contour, FloatArray
from pitchpoint.core.errors import GeometryError

IntArray = NDArray[np.int64]

_SAG = 0.3
"""Height of the arc below the tooth relative to half its chord, for larger angles at its ends."""
_DEEP = 1.2
"""Depth of the layers that follow the contour of the root, in modules; deeper layers are concentric rings."""
_LAND = 0.3
"""Part of a column of the fillet above which the root circle has a column."""


@dataclass(frozen=True)
class Density:
    """Order and numbers of the elements of a section mesh.

    Parameters
    ----------
    order
        Polynomial order.
    across
        Borders of the columns of the tooth from its centre line (0) to its left flank (1).
    flank
        Borders of the rows at the involute from its root end (0) to its tip end (1), in arc length.
    fillet, root
        Rows of the tooth at the upper part of the fillet, columns next to the tooth at its lower part.
    body
        Borders of the layers below the root, from its contour (0) to the first ring (1).
    growth
        Ratio of the depths of consecutive rings below them.
    """

    order: int = 4
    across: tuple[float, ...] = (0.0, 0.7, 1.0)
    flank: tuple[float, ...] = (0.0, 0.5, 1.0)
    fillet: int = 1
    root: int = 1
    body: tuple[float, ...] = (0.0, 0.3, 1.0)
    growth: float = 3.0


@dataclass(frozen=True)
class SectionMesh:
    """Nodes and elements of one pitch.

    Parameters
    ----------
    order
        Polynomial order of the elements.
    points
        Nodes x + iy [m], shape (n,).
    elements
        Node numbers, shape (m, order + 1, order + 1): columns counter-clockwise, then rows.
    clockwise, counter
        Nodes of the radial borders of the pitch, shape (k,).
    clamped
        Nodes of the clamped circle, shape (j,).
    web
        True for elements of the web, shape (m,).
    grid
        Positions of the elements: column, and row inwards, negative in the tooth; shape (m, 2).
    column
        Border of each element towards the centre line of the tooth as in `Density.across`, -1 on its right
        side; shape (m,).
    flank, flank_roll
        Elements at the left flank and lengths of roll of their borders [m], shapes (n,) and (n + 1,).
    fillet, fillet_length
        Elements at the left fillet, the first ones of which are columns of the body, and arc lengths of their
        borders from the root circle [m], shapes (n,) and (n + 1,).
    """

    order: int
    points: ComplexArray
    elements: IntArray
    clockwise: IntArray
    counter: IntArray
    clamped: IntArray
    web: NDArray[np.bool_]
    grid: IntArray
    column: FloatArray
    flank: IntArray
    flank_roll: FloatArray
    fillet: IntArray
    fillet_length: FloatArray


def lobatto(order: int) -> FloatArray:
    """Gauss-Lobatto points in [-1, 1], shape (order + 1,).

    Parameters
    ----------
    order
        Order of the polynomials through the points, at least 1.

    Examples
    --------
    >>> lobatto(3).round(6).tolist()    # ±1/√5
    [-1.0, -0.447214, 0.447214, 1.0]
    """
    inner = legendre.legroots(legendre.legder(np.eye(order + 1)[order])) if order > 1 else np.empty(0)
    inner = 0.5 * (inner - inner[::-1])
    return np.concatenate([[-1.0], inner, [1.0]])


def nodes_between(borders: FloatArray, order: int) -> FloatArray:
    """Positions of the nodes of a row of elements.

    Parameters
    ----------
    borders
        Borders of the elements, shape (m + 1,).
    order
        Polynomial order.

    Returns
    -------
    ndarray, shape (order · m + 1,)

    Examples
    --------
    >>> nodes_between(np.array([0.0, 1.0, 3.0]), 2).tolist()
    [0.0, 0.5, 1.0, 2.0, 3.0]
    """
    inside = 0.5 * (1.0 + lobatto(order)[:-1])
    return np.append((borders[:-1, None] + np.diff(borders)[:, None] * inside).ravel(), borders[-1])


def section_mesh(
    contour: Contour, module: float, clamped: float, density: Density, rim: float | None = None
) -> SectionMesh:
    """Mesh of one pitch.

    Parameters
    ----------
    contour
        Outline of the tooth.
    module
        Normal module [m].
    clamped
        Radius of the clamped circle [m]: bore, or outside of an internal gear.
    density
        Order and numbers of elements.
    rim
        Radius between rim and web [m]; None without web.

    Raises
    ------
    GeometryError
        If the rim is thinner than the depth of the arc below the tooth, about 0.3 modules.

    Examples
    --------
    >>> from pitchpoint.geometry.cylindrical_gear import CylindricalGear
    >>> from pitchpoint.geometry.tooth_form import tooth_form
    >>> contour = Contour(tooth_form(CylindricalGear(z=17, m_n=1e-3)))
    >>> mesh = section_mesh(contour, 1e-3, 5e-3, Density())
    >>> mesh.points.size, len(mesh.elements), mesh.counter.size
    (529, 30, 13)
    """
    q, form = density.order, contour.form
    tangent = 0.5 * (max(contour.tangent_range[0], 0.0) + contour.tangent_range[1])
    middle = float(contour.fillet_length_at(np.array([tangent]))[0])
    root = _root_borders(contour, density, middle)
    edge = contour.root(nodes_between(root, q))  # from the middle of the root to the foot of the tooth
    upper = np.linspace(middle, contour.fillet_length, density.fillet + 1)
    # equal arc lengths, which are proportional to the squares of the lengths of roll
    low, high = (rho * rho for rho in contour.roll)
    roll = low + (high - low) * np.array(density.flank)
    involute = contour.involute(np.sqrt(nodes_between(roll, q)))
    side = np.append(contour.root(nodes_between(upper, q)), involute[1:])
    if form.sign * (form.r_a - form.r_Fa) > 1e-6 * module:
        last = side[-1] / abs(side[-1])
        side = np.append(side, last * nodes_between(np.array([form.r_Fa, form.r_a]), q)[1:])
    across = np.array(density.across)
    s = nodes_between(np.append(-across[:0:-1], across), q)
    tooth = _tooth(side, s, form.sign)
    top = np.concatenate([edge.conj(), tooth[1:-1, 0], edge[::-1]])
    rows, n_rim = _body(top, contour, module, clamped, density, rim)
    return _numbered(rows, tooth, n_rim, density, (np.sqrt(roll), root, upper))


def _root_borders(contour: Contour, density: Density, middle: float) -> FloatArray:
    """Borders of the columns next to the tooth, from the middle of the root to the middle of the fillet."""
    borders = np.linspace(0.0, middle, density.root + 1)
    if contour.land_length > _LAND * borders[1]:
        return np.append(-contour.land_length, borders)
    borders[0] = -contour.land_length
    return borders


def _tooth(side: ComplexArray, s: FloatArray, sign: int) -> ComplexArray:
    """Nodes of the tooth (column, row): transfinite between flanks, tip circle and the arc below."""
    foot, tip = side[0], side[-1]
    height = np.append(0.0, np.cumsum(np.abs(np.diff(side))))
    u = (height / height[-1])[None, :]
    below = foot.real - sign * _SAG * foot.imag * (1.0 - s * s) + 1j * foot.imag * s
    above = abs(tip) * np.exp(1j * np.angle(tip) * s)
    t = 0.5 * (1.0 + s)[:, None]
    inside = (1.0 - u) * below[:, None] + u * above[:, None] + t * side + (1.0 - t) * side.conj()
    corners = (1.0 - u) * (t * foot + (1.0 - t) * foot.conjugate())
    corners = corners + u * (t * tip + (1.0 - t) * tip.conjugate())
    return np.asarray(inside - corners)


def _body(
    top: ComplexArray,
    contour: Contour,
    module: float,
    clamped: float,
    density: Density,
    rim: float | None,
) -> tuple[ComplexArray, int]:
    """Nodes of the body (column, row) from its upper edge to the clamped circle, and layers of the rim."""
    q, form = density.order, contour.form
    sign, r_f = form.sign, form.r_f
    end = clamped if rim is None else rim
    depth = sign * (r_f - end)
    arc = float((sign * (r_f - np.abs(top))).max())
    if depth <= arc:  # elements would be turned inside out
        raise GeometryError(
            "is too thin for finite elements of teeth",
            where="bore_diameter" if rim is None else "rim_thickness",
            value=f"rim of {1e3 * depth:.4g} mm",
            limit=f"above {1e3 * arc:.4g} mm",
        )
    first = depth if depth < 1.6 * _DEEP * module else _DEEP * module
    ring = r_f - sign * first
    # half of the difference between equal angles and those of the upper edge
    angle = np.angle(top)
    even = np.linspace(angle[0], angle[-1], angle.size)
    circle = ring * np.exp(1j * (0.5 * (angle + even)))
    share = nodes_between(np.array(density.body), q)
    rows = [top[:, None] * (1.0 - share) + circle[:, None] * share]
    radius, layers, thickness = ring, [len(density.body) - 1], first * (1.0 - density.body[-2])
    for stop in (end, clamped):
        layers.append(layers[-1])
        rest = sign * (radius - stop)
        if rest > 1e-9 * module:
            borders = radius - sign * _graded(rest, thickness * density.growth, density.growth)
            rows.append(circle[:, None] / ring * nodes_between(borders, q)[1:])
            radius, thickness = stop, float(abs(borders[-1] - borders[-2]))
            layers[-1] += borders.size - 1
    return np.concatenate(rows, axis=1), layers[1]


def _graded(length: float, first: float, growth: float) -> FloatArray:
    """Borders from 0 to `length` whose spacings grow from about `first`."""
    n = max(1, round(math.log1p(length / first * (growth - 1.0)) / math.log(growth)))
    borders = np.append(0.0, np.cumsum(growth ** np.arange(n)))
    return np.asarray(borders / borders[-1] * length)


def _numbered(
    rows: ComplexArray,
    tooth: ComplexArray,
    n_rim: int,
    density: Density,
    borders: tuple[FloatArray, FloatArray, FloatArray],
) -> SectionMesh:
    """Mesh from the nodes of body and tooth."""
    q = density.order
    roll, root, upper = borders
    n_col, n_row = rows.shape
    body_ids = np.arange(rows.size).reshape(rows.shape)
    start = q * (root.size - 1)
    n_tooth = tooth.shape[0]
    tooth_ids = np.empty(tooth.shape, np.int64)
    tooth_ids[:, 0] = body_ids[start : start + n_tooth, 0]
    tooth_ids[:, 1:] = rows.size + np.arange(tooth[:, 1:].size).reshape(tooth[:, 1:].shape)

    def cells(ids: IntArray) -> IntArray:
        """Elements (column, row, order + 1, order + 1) of a grid of nodes."""
        windows = np.lib.stride_tricks.sliding_window_view(ids, (q + 1, q + 1))
        return windows[::q, ::q]

    body, upright = cells(body_ids), cells(tooth_ids)
    across = np.array(density.across)
    columns = np.concatenate([-across[:0:-1], across[:-1]])
    n_side = root.size - 1
    all_columns = np.concatenate([np.full(n_side, -1.0), columns, np.full(n_side, 1.0)])
    n_body = body.shape[0] * body.shape[1]
    grid = np.arange(n_body).reshape(body.shape[:2])
    high = n_body + np.arange(upright.shape[0] * upright.shape[1]).reshape(upright.shape[:2])
    elements = np.concatenate([body.reshape(-1, q + 1, q + 1), upright.reshape(-1, q + 1, q + 1)])
    column = np.concatenate([np.repeat(all_columns, body.shape[1]), np.repeat(columns, upright.shape[1])])
    web = np.zeros(elements.shape[0], bool)
    web[grid[:, n_rim:].ravel()] = True
    n_fillet = upper.size - 1
    on_fillet = root.size - 1 - (1 if root[0] < 0.0 and root[1] == 0.0 else 0)
    return SectionMesh(
        order=q,
        points=np.concatenate([rows.ravel(), tooth[:, 1:].ravel()]),
        elements=elements,
        clockwise=body_ids[0],
        counter=body_ids[-1],
        clamped=body_ids[:, -1],
        web=web,
        grid=np.concatenate([_positions(body.shape[:2], 0, 1), _positions(upright.shape[:2], n_side, -1)]),
        column=column,
        flank=high[-1, n_fillet : n_fillet + roll.size - 1],
        flank_roll=roll,
        fillet=np.concatenate([grid[-n_side:, 0][::-1][-on_fillet:], high[-1, :n_fillet]]),
        fillet_length=np.concatenate([root[-on_fillet - 1 :], upper[1:]]),
    )


def _positions(shape: tuple[int, ...], first: int, sign: int) -> IntArray:
    """Grid positions of a block of elements: columns from `first`, rows 0, 1 ... or -1, -2 ..."""
    column, row = np.indices(shape)
    row = row if sign > 0 else -1 - row
    return np.column_stack([first + column.ravel(), row.ravel()])
