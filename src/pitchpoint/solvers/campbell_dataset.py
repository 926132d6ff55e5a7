# SPDX-License-Identifier: Apache-2.0
"""`solve_campbell`: Campbell diagram as a dataset, with energies and ranked critical speeds."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from pitchpoint.core.errors import SolverError, join_notes
from pitchpoint.core.progress import Progress, silent
from pitchpoint.core.status import INCONSISTENT
from pitchpoint.core.units import format_quantity
from pitchpoint.solvers.campbell import Campbell, follow_modes
from pitchpoint.solvers.critical_speeds import RANKING, CriticalSpeed, critical_speeds, separation
from pitchpoint.solvers.excitation_orders import USUAL, Order, Orders, excitation_orders
from pitchpoint.solvers.modal import FREQUENCY, RATIO
from pitchpoint.solvers.modes.energies import WAYS
from pitchpoint.solvers.modes.unstable import UnstableMode, is_undamped, undamped_note, unstable_modes
from pitchpoint.system.system import System

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.scenario import Scenario


NO_EQUILIBRIUM = "no equilibrium at"
"""First words of the note on speeds that are omitted."""
NAMED = 4
"""Most speeds without an equilibrium that a note lists."""


def solve_campbell(
    system: System,
    speeds: ArrayLike,
    body: str | None = None,
    scenario: Scenario | str | None = None,
    *,
    count: int | None = None,
    orders: Orders = USUAL,
    more_orders: Mapping[str, float] | None = None,
    operating: tuple[float, float] | None = None,
    progress: Progress = silent,
) -> xr.Dataset:
    """Campbell diagram: natural frequencies over speed, excitation orders, ranked critical speeds.

    Parameters
    ----------
    system
        The compiled model.
    speeds
        Speeds of one body [rad/s], shape (n_speed,), positive in its direction of rotation in the scenario.
    body
        Reference body of the speed; default the first. The speeds of the other bodies follow from the gear
        ratios; speeds that these do not determine, as in a planetary set of three free members, have the
        ratio of the speeds and drives of the scenario. With bodies in trees, the relative equilibrium is
        computed for every speed.
    scenario
        Gives loads and the operating point; mesh stiffness is the mean over the mesh cycle.
    count
        Number of modes, the lowest at rest. Default: all of up to 24, otherwise the lowest 16.
    orders
        `1x`, `2x` (shafts), `mesh`, `2mesh`, `sidebands` (one pair per gear at every mesh order),
        `2sidebands`, numbers, as a list or as text, `mesh,2`; default 1x, 2x, mesh, 2mesh, sidebands.
    more_orders
        Further orders per revolution of the body by name; `BPFO front` drives the rolling bearing `front`.
    operating
        Lowest and highest operating speed of the body [rad/s], for the separation of critical speeds.
    progress
        Called after every speed.

    Returns
    -------
    xarray.Dataset
        Modes are branches, see `solvers.campbell`; `name` is a coordinate of `mode`. Variables: see Notes.

    Raises
    ------
    SolverError
        If the body or scenario does not exist, an order is unknown, or there is no equilibrium at any speed.

    Notes
    -----
    Over `speed` and `mode`: frequency [Hz], the damped natural frequency, 0 where a mode does not oscillate;
    damping_ratio, 1 where it is overdamped; whirl and whirl_index; character, the number of the mode whose
    shape at rest is most similar; strain_to_kinetic and gyroscopic_share, which sum to 1. With `component`
    strain_share, with `part` kinetic_share, over `part` and `motion`: they sum to 1.

    Over `excitation`: excitation_order, excitation_kind. Over `mesh`: order, and with `speed` mesh_frequency
    [Hz].

    Over `crossing`, ranked: crossing_speed, crossing_frequency, crossing_damping_ratio, crossing_mode
    (number), crossing_order (name), crossing_whirl, crossing_source, crossing_participation,
    crossing_amplification, crossing_response, crossing_stiffness_sensitivity (also over `component`) and
    crossing_inertia_sensitivity (over `part`), and crossing_separation with `operating`.

    Over `unstable`, ranges of speeds in which a mode grows, lowest damping first: unstable_mode (number),
    unstable_from, unstable_to, unstable_damping_ratio, unstable_source (component that feeds energy).

    The attribute `dissipation` is "none" if the model has no damping. Speeds without an equilibrium are
    omitted; the attribute `omitted_speed` has them. `multiblade` names rotors in multi-blade coordinates.
    """
    began = time.perf_counter()
    found = follow_modes(system, speeds, body, scenario, count=count, progress=progress)
    return campbell_dataset(
        system, found, orders=orders, more_orders=more_orders, operating=operating, began=began
    )


def campbell_dataset(
    system: System,
    found: Campbell,
    *,
    orders: Orders = USUAL,
    more_orders: Mapping[str, float] | None = None,
    operating: tuple[float, float] | None = None,
    began: float | None = None,
) -> xr.Dataset:
    """Dataset of modes over speed; parameters as in `solve_campbell`."""
    import xarray as xr

    from pitchpoint.solvers.dataset import attributes

    began = time.perf_counter() if began is None else began
    listed = excitation_orders(system, found.motions, found.rates, orders, more_orders)
    critical, unstable = critical_speeds(found, listed), unstable_modes(found)
    data = _of_modes(found) | _of_orders(found, listed) | _of_crossings(found, critical, operating)
    data |= _of_unstable(unstable)
    coords = {
        "speed": ("speed", found.speed, {"units": "rad/s", "long_name": f"speed of {found.body}"}),
        "mode": np.arange(1, len(found.names) + 1),
        "name": ("mode", list(found.names), {"long_name": "name of the mode"}),
        "component": list(found.motions.groups.components),
        "part": list(found.motions.groups.parts),
        "motion": list(WAYS),
        "mesh": list(found.orders),
        "excitation": [order.name for order in listed],
        "crossing": np.arange(1, len(critical) + 1),
        "unstable": np.arange(1, len(unstable) + 1),
    }
    wall = time.perf_counter() - began
    attrs = attributes(system, "campbell", wall_s=wall, body=found.body)
    undamped = is_undamped(found.modes.linear)
    notes = [*found.notes, *([undamped_note(unstable[0].damping_ratio)] if undamped and unstable else [])]
    if found.omitted:
        notes.append(omitted_words(found))
    more: dict[str, Any] = {"body": found.body, "ranking": RANKING, "notes": join_notes(notes)}
    if undamped:
        more["dissipation"] = "none"
    if found.omitted:
        more["omitted_speed"] = sorted(found.omitted)
    if found.rotors:
        more["multiblade"] = ", ".join(found.rotors)
    if operating is not None:
        more["operating_speed"] = [float(x) for x in operating]
    return xr.Dataset(
        {k: (dims, v, {"units": unit, "long_name": text}) for k, (dims, v, unit, text) in data.items()},
        coords=coords,
        attrs={**attrs, **more},
    )


def omitted_words(found: Campbell) -> str:
    """The speeds without an equilibrium, which are omitted, and the reason at the first of them."""
    speeds = sorted(found.omitted)
    texts = [format_quantity(speed, "angular_speed", 4) for speed in speeds]
    words = ", ".join(texts) if len(texts) <= NAMED else f"{texts[0]} to {texts[-1]} ({len(texts)} speeds)"
    plural = "these speeds are" if len(texts) > 1 else "this speed is"
    return f"{NO_EQUILIBRIUM} {words} of {found.body}, {plural} omitted: {found.omitted[speeds[0]]}"


Rows = dict[str, tuple[Any, Any, str, str]]


def _of_modes(found: Campbell) -> Rows:
    """Variables over speed and mode."""
    both = ("speed", "mode")
    groups, each = found.motions.groups, found.energies
    sizes = (len(found.speed), len(found.names))

    def over(values: list[Any], *more: int) -> Any:
        """Values of all speeds, also of none."""
        return np.array(values, dtype=np.float64).reshape(*sizes, *more)

    return {
        "frequency": (both, found.frequency, *FREQUENCY),
        "damping_ratio": (both, found.damping_ratio, *RATIO),
        "whirl": (both, np.array(found.whirl, dtype=object).reshape(sizes), "", "whirl of the shafts"),
        "whirl_index": (both, found.whirl_index, "1", "whirl: 1 forward, 0 planar, -1 backward"),
        "character": (
            both,
            found.character + 1,
            "1",
            "number of the mode with the most similar shape at rest",
        ),
        "strain_to_kinetic": (both, over([e.strain_ratio for e in each]), "1", "strain over kinetic energy"),
        "gyroscopic_share": (both, over([e.gyroscopic for e in each]), "1", "gyroscopic over kinetic energy"),
        "strain_share": (
            (*both, "component"),
            over([e.strain for e in each], len(groups.components)),
            "1",
            "share in the strain energy",
        ),
        "kinetic_share": (
            (*both, "part", "motion"),
            over([e.kinetic for e in each], len(groups.parts), len(WAYS)),
            "1",
            "share in the kinetic energy",
        ),
    }


def _of_orders(found: Campbell, listed: Sequence[Order]) -> Rows:
    """Variables over the orders."""
    teeth = np.array(list(found.orders.values()), dtype=np.float64)
    per = f"periods per revolution of {found.body}"
    return {
        "order": ("mesh", teeth, "1", f"mesh {per}"),
        "mesh_frequency": (
            ("speed", "mesh"),
            np.abs(found.speed)[:, None] * teeth / (2.0 * np.pi),
            "Hz",
            "mesh frequency",
        ),
        "excitation_order": ("excitation", np.array([o.value for o in listed]), "1", per),
        "excitation_kind": ("excitation", np.array([o.kind for o in listed], dtype=object), "", "kind"),
    }


def _of_unstable(listed: Sequence[UnstableMode]) -> Rows:
    """Variables over the unstable modes."""
    one = "unstable"
    sources = np.array([u.source for u in listed], dtype=object)
    return {
        "unstable_mode": (one, np.array([u.mode + 1 for u in listed], np.int64), "1", "number of the mode"),
        "unstable_from": (one, np.array([u.low for u in listed]), "rad/s", "unstable from this speed"),
        "unstable_to": (one, np.array([u.high for u in listed]), "rad/s", "unstable up to this speed"),
        "unstable_damping_ratio": (
            one,
            np.array([u.damping_ratio for u in listed]),
            "1",
            "lowest damping ratio",
        ),
        "unstable_source": (one, sources, "", "component that feeds energy into the mode"),
    }


def _of_crossings(
    found: Campbell, critical: Sequence[CriticalSpeed], operating: tuple[float, float] | None
) -> Rows:
    """Variables over the critical speeds."""
    one = "crossing"
    speed = np.array([c.speed for c in critical])
    rows: Rows = {
        "crossing_speed": (one, speed, "rad/s", "critical speed"),
        "crossing_frequency": (one, np.array([c.frequency for c in critical]), "Hz", "frequency"),
        "crossing_damping_ratio": (one, np.array([c.damping_ratio for c in critical]), "1", "damping ratio"),
        "crossing_mode": (one, np.array([c.mode + 1 for c in critical], np.int64), "1", "number of the mode"),
    }
    for name, text in (("whirl", "whirl of the shafts"), ("source", "what drives the mode")):
        words = np.array([getattr(c, name) for c in critical], dtype=object)
        rows[f"crossing_{name}"] = (one, words, "", text)
    rows["crossing_order"] = (one, np.array([c.order.name for c in critical], dtype=object), "", "order")
    for name, text in (
        ("participation", "share of the energy where the order acts"),
        ("amplification", "amplification at resonance: response where the order acts"),
        ("response", "response of the machine at resonance"),
    ):
        rows[f"crossing_{name}"] = (one, np.array([getattr(c, name) for c in critical]), "1", text)
    groups = found.motions.groups
    for name, over, count in (
        ("stiffness", "component", len(groups.components)),
        ("inertia", "part", len(groups.parts)),
    ):
        values = np.array([getattr(c.moved_by, name) for c in critical]).reshape(-1, count)
        text = f"relative change of the critical speed over that of the {name}"
        rows[f"crossing_{name}_sensitivity"] = ((one, over), values, "1", text)
    if operating is not None:
        if max(map(abs, operating)) == 0.0:
            raise SolverError("operating: the operating speed is zero; give a speed above 0", INCONSISTENT)
        rows["crossing_separation"] = (
            one,
            separation(speed, operating),
            "1",
            "distance from the operating speed",
        )
    return rows
