# SPDX-License-Identifier: Apache-2.0
"""Results of a stiffness law: stiffness of one tooth pair, or of the whole mesh over its phase.

Plain data without kernels: a model can be read and checked without the compiler.

Derivation: docs/theory/stiffness.md, "The mesh".
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pitchpoint.core.errors import Message, ModelError

Array = NDArray[np.float64]


def refuse(where: str, message: str, value: object, limit: str, remedy: str) -> ModelError:
    """Error for one invalid option of a stiffness law.

    Parameters
    ----------
    where
        Path of the option in the model.
    message
        Description of the problem, following the value.
    value
        Value found.
    limit
        Permitted values.
    remedy
        Corrective action.

    Examples
    --------
    >>> str(refuse("stiffness.mean", "is not a stiffness", -1.0, "> 0", "give N/m")).splitlines()[1].strip()
    'stiffness.mean: -1.0 is not a stiffness (limit > 0); give N/m'
    """
    return ModelError([Message(where, message, str(value), limit, remedy)])


def positive(where: str, value: float, unit: str) -> float:
    """Return a positive finite number, or raise ModelError.

    Parameters
    ----------
    where
        Path of the option in the model.
    value
        Value to check.
    unit
        Its SI unit, for the message.

    Raises
    ------
    ModelError
        If the number is not finite or not > 0.

    Examples
    --------
    >>> positive("stiffness.mean", 4.0e8, "N/m")
    400000000.0
    """
    if isinstance(value, bool) or not (math.isfinite(value) and value > 0.0):
        raise refuse(where, "is not a stiffness", value, "> 0", f"give a positive number in {unit}")
    return float(value)


def share(where: str, value: float) -> float:
    """Return a number in [0, 1], or raise ModelError.

    Parameters
    ----------
    where
        Path of the option in the model.
    value
        Value to check.

    Raises
    ------
    ModelError
        If the number is not between 0 and 1.

    Examples
    --------
    >>> share("stiffness.stiffness_ratio", 0.8)
    0.8
    """
    if isinstance(value, bool) or not 0.0 <= value <= 1.0:
        raise refuse(where, "is out of range", value, "0 to 1", "give a ratio between 0 and 1")
    return float(value)


def frozen_array(where: str, values: ArrayLike, least: int = 0) -> Array:
    """Return a read-only, contiguous copy of a finite one-dimensional array, or raise ModelError.

    Parameters
    ----------
    where
        Path of the option in the model.
    values
        Values to check, shape (n,).
    least
        Minimum number of values.

    Raises
    ------
    ModelError
        If the values are not a flat list of finite numbers, or if there are too few.

    Examples
    --------
    >>> frozen_array("stiffness.cosine", [-0.2, -0.1])
    array([-0.2, -0.1])
    """
    try:
        array = np.array(values, dtype=np.float64, order="C", ndmin=1)
    except (TypeError, ValueError):
        raise refuse(where, "is not a list of numbers", values, "numbers", "give a flat list") from None
    if array.ndim != 1 or array.size < least or not np.all(np.isfinite(array)):
        text = f"at least {least} finite numbers" if least else "finite numbers"
        raise refuse(where, "is not usable", values, text, "give a flat list")
    array.setflags(write=False)
    return array


@dataclass(frozen=True, kw_only=True)
class PairShape:
    """Stiffness of one tooth pair along its path of contact; the mesh is the sum over all pairs.

    Parameters
    ----------
    c_prime
        Stiffness of one pair per unit face width in the transverse plane along the base tangent, c'
        [N/m^(power + 1)]: maximum of the parabola, or the value at which `table` is 1.
    S_R
        Stiffness ratio, minimum over maximum of the parabola, in [0, 1].
    T_R
        Tip-relief factor in [0, 1]: ramps of T_R frac(eps_alpha) base pitches at both ends.
    table
        Values relative to c_prime at equal steps of the path from A to E, with linear interpolation; replaces
        the parabola (S_R is then not used) but not the ramps.
    load_limit
        Line load along the base tangent below which the stiffness decreases (ISO 6336-1, low specific load)
        [N/m]; 0: no reduction.
    power
        Exponent of the force over the penetration, >= 1; 1 is a linear spring.
    """

    c_prime: float
    S_R: float = 0.8
    T_R: float = 0.0
    table: Array | None = None
    load_limit: float = 0.0
    power: float = 1.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "c_prime", positive("stiffness.c_prime", self.c_prime, "N/m^2"))
        object.__setattr__(self, "S_R", share("stiffness.stiffness_ratio", self.S_R))
        object.__setattr__(self, "T_R", share("stiffness.tip_relief_factor", self.T_R))
        if self.table is not None:
            table = frozen_array("stiffness.table", self.table, 2)
            if table.min() < 0.0:
                raise refuse("stiffness.table", "is not a stiffness", table.min(), ">= 0", "check the table")
            object.__setattr__(self, "table", table)
        if not 1.0 <= self.power <= 5.0:
            raise refuse(
                "stiffness.exponent", "is not a valid exponent", self.power, "1 to 5", "1.5 is that of Hertz"
            )

    def ramp_length(self, eps_alpha: float) -> float:
        """Length of the ramps at both ends, L = T_R frac(eps_alpha) [base pitches]; 0 if below 1e-12.

        >>> round(PairShape(c_prime=14e9, T_R=0.75).ramp_length(1.3), 12)
        0.225
        """
        length = self.T_R * (eps_alpha - math.floor(eps_alpha))
        return length if length > 1e-12 else 0.0

    def along(self, p: ArrayLike, eps_alpha: float) -> Array:
        """Stiffness relative to c_prime at positions p on the path (any shape) [base pitches from A].

        >>> PairShape(c_prime=14e9, S_R=0.8).along([0.0, 0.65], 1.3).tolist()
        [0.8, 1.0]
        """
        p = np.asarray(p, dtype=np.float64)
        L = self.ramp_length(eps_alpha)
        if self.table is None:
            c = 1.0 - (1.0 - self.S_R) * (2.0 * p / eps_alpha - 1.0) ** 2
        else:
            c = np.interp(p, np.linspace(0.0, eps_alpha, self.table.size), self.table)
        if L > 0.0:
            c = c * (np.clip(np.minimum(p, eps_alpha - p), 0.0, L) / L)
        return np.asarray(c)

    def end_values(self) -> tuple[float, float]:
        """Stiffness at A and at E relative to c_prime, without the ramp.

        >>> PairShape(c_prime=14e9, S_R=0.8).end_values()
        (0.8, 0.8)
        """
        if self.table is None:
            return self.S_R, self.S_R
        return float(self.table[0]), float(self.table[-1])

    def slope(self, penetration: float) -> float:
        """Tangent stiffness per unit face width at a penetration [N/m^2]; c' for a linear law.

        >>> PairShape(c_prime=2e9, power=1.5).slope(1e-4)
        30000000.0
        """
        return float(self.power * self.c_prime * penetration ** (self.power - 1.0))

    def jumps(self, eps_alpha: float, eps_beta: float = 0.0) -> tuple[float, ...]:
        """Mesh phases in [0, 1) at which the mesh stiffness is discontinuous.

        A spur pair without ramps enters contact at psi = 0 and leaves it at psi = frac(eps_alpha); with
        overlap or ramps the mesh stiffness is continuous.

        >>> PairShape(c_prime=14e9).jumps(1.25), PairShape(c_prime=14e9).jumps(1.25, 0.5)
        ((0.0, 0.25), ())
        """
        if eps_beta > 0.0 or self.ramp_length(eps_alpha) > 0.0:
            return ()
        at_A, at_E = self.end_values()
        leave = eps_alpha - math.floor(eps_alpha)
        if leave == 0.0:
            return (0.0,) if at_A != at_E else ()
        return tuple(psi for psi, height in ((0.0, at_A), (leave, at_E)) if height > 0.0)


@dataclass(frozen=True, kw_only=True)
class PhaseStiffness:
    """Total mesh stiffness, prescribed over the mesh phase psi (period 1, a pair enters contact at psi = 0).

    Parameters
    ----------
    mean
        Mean stiffness over a period, along the base tangent [N/m].
    cosine, sine
        Fourier coefficients relative to the mean; entry h - 1 is harmonic h of psi. The shorter array is
        padded with zeros.
    table
        Values relative to the mean at psi = i/n, i = 0..n-1; periodic with linear interpolation.
    rectangular
        (first value, second value, duty): the first value relative to the mean applies for 0 <= psi < duty,
        the second for the rest of the period.

    At most one of the three forms may be given; without any the stiffness is constant.
    """

    mean: float
    cosine: Array | None = None
    sine: Array | None = None
    table: Array | None = None
    rectangular: tuple[float, float, float] | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "mean", positive("stiffness.mean", self.mean, "N/m"))
        cosine = frozen_array("stiffness.cosine", () if self.cosine is None else self.cosine)
        sine = frozen_array("stiffness.sine", () if self.sine is None else self.sine)
        n = max(cosine.size, sine.size)
        for name, array in (("cosine", cosine), ("sine", sine)):
            full = np.zeros(n)
            full[: array.size] = array
            full.setflags(write=False)
            object.__setattr__(self, name, full)
        if self.table is not None:
            object.__setattr__(self, "table", frozen_array("stiffness.table", self.table, 2))
        if (n > 0) + (self.table is not None) + (self.rectangular is not None) > 1:
            raise refuse(
                "stiffness", "form of description is given", "more than one", "one", "keep one of them"
            )

    @property
    def form(self) -> int:
        """Form number used by the kernels: 0 Fourier (or constant), 1 table, 2 rectangular.

        >>> PhaseStiffness(mean=1e8).form, PhaseStiffness(mean=1e8, table=[1.0, 1.0]).form
        (0, 1)
        """
        if self.table is not None:
            return 1
        return 2 if self.rectangular is not None else 0

    def arrays(self) -> tuple[int, Array, Array]:
        """Number of terms n and the two arrays, shapes (n,), of the kernel `phase_stiffness`.

        >>> n, first, second = PhaseStiffness(mean=1e8, cosine=[-0.2]).arrays()
        >>> n, first.tolist(), second.tolist()
        (1, [-0.2], [0.0])
        """
        assert self.cosine is not None and self.sine is not None  # filled in __post_init__
        if self.table is not None:
            return self.table.size, self.table, self.sine
        if self.rectangular is not None:
            return 3, np.array(self.rectangular), self.sine
        return self.cosine.size, self.cosine, self.sine

    def ratio(self, psi: ArrayLike) -> Array:
        """Stiffness relative to the mean at the phases psi (any shape).

        >>> PhaseStiffness(mean=1e8, cosine=[-0.2]).ratio([0.0, 0.5]).round(12).tolist()
        [0.8, 1.2]
        """
        phase = np.asarray(psi, dtype=np.float64)
        s = phase - np.floor(phase)
        if self.table is not None:
            knots = np.linspace(0.0, 1.0, self.table.size + 1)
            return np.asarray(np.interp(s, knots, np.append(self.table, self.table[0])))
        if self.rectangular is not None:
            first, second, part = self.rectangular
            return np.where(s < part, first, second)
        n, cosine, sine = self.arrays()
        angle = 2.0 * math.pi * s[..., None] * np.arange(1, n + 1)
        return np.asarray(1.0 + np.cos(angle) @ cosine + np.sin(angle) @ sine)

    def extremes(self) -> tuple[float, float]:
        """Minimum and maximum stiffness relative to the mean.

        For a Fourier series they are computed at the roots of its derivative, a polynomial in exp(2 pi i
        psi), and on a grid.

        >>> low, high = PhaseStiffness(mean=1e8, cosine=[-0.2, -0.1, -0.05]).extremes()
        >>> round(low, 9), round(high, 9)
        (0.65, 1.15)
        """
        count, first, second = self.arrays()
        values = np.ones(1)
        if self.form == 1:
            values = first
        elif self.form == 2:
            values = first[:2]
        elif np.any(first) or np.any(second):
            h = np.arange(1, count + 1)
            upper = 0.5 * h * (second + 1j * first)  # derivative = sum of upper z^h and its conjugate z^-h
            roots = np.roots(np.concatenate((upper[::-1], [0.0], np.conj(upper))))
            on_circle = np.abs(np.abs(roots) - 1.0) < 1e-5
            # a flat extremum is a multiple root, which round-off may move off the unit circle: add a grid
            grid = np.arange(8 * count) / (8.0 * count)
            phases = np.concatenate((np.angle(roots[on_circle]) / (2.0 * math.pi), grid))
            values = self.ratio(phases)
        return float(values.min()), float(values.max())

    def jumps(self, eps_alpha: float = 1.0, eps_beta: float = 0.0) -> tuple[float, ...]:
        """Mesh phases in [0, 1) at which the stiffness is discontinuous; the arguments are not used.

        >>> PhaseStiffness(mean=1e8, rectangular=(1.2, 0.8, 0.5)).jumps()
        (0.0, 0.5)
        """
        if self.rectangular is None:
            return ()
        first, second, part = self.rectangular
        return (0.0, part) if first != second and 0.0 < part < 1.0 else ()


#: The two kinds of description.
Description = PairShape | PhaseStiffness


def require_positive(where: str, description: PhaseStiffness) -> PhaseStiffness:
    """Return a prescribed stiffness that is positive at all phases, or raise ModelError.

    Parameters
    ----------
    where
        Path of the option in the model.
    description
        Prescribed stiffness to check.

    Raises
    ------
    ModelError
        If the stiffness is zero or negative at some phase.

    Examples
    --------
    >>> require_positive("stiffness.cosine", PhaseStiffness(mean=1e8, cosine=[0.5])).mean
    100000000.0
    """
    low, _ = description.extremes()
    if low <= 0.0:
        raise refuse(
            where, "times the mean is the lowest stiffness", f"{low:.4g}", "> 0", "lower the variation"
        )
    return description
