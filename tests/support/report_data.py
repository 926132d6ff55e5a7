# SPDX-License-Identifier: Apache-2.0
"""Data for tests of pictures and reports: a backlash oscillator that is good enough to look at.

The mesh is one equation of motion, m ẍ + c ẋ + k(ψ) g(x) = F, stepped with the semi-implicit Euler method.
That is no oracle for physics and none is needed: what is tested is that pictures show what the data hold.
"""

from __future__ import annotations

import base64
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import xarray as xr

from pitchpoint.geometry.cylindrical_gear import CylindricalGear
from pitchpoint.geometry.gear_pair import GearPair
from pitchpoint.viz.power_flow import OUTSIDE, PowerBlock, PowerFlow, PowerLink
from pitchpoint.viz.quantities import Channel
from pitchpoint.viz.report.build import (
    CaseTable,
    MeshCycleData,
    ModeData,
    ReportModel,
    ReportResults,
    SceneData,
    SourceData,
    TimeRun,
)
from pitchpoint.viz.scene.content import Scene, SceneBody, SceneSolid
from pitchpoint.viz.tables import GEAR_ROWS, MESH_ROWS

TEETH, MASS, STIFFNESS, GAP, FORCE = 50, 1.158, 4.0e8, 25e-6, 2128.0


@dataclass(frozen=True)
class Cycle:
    """What a mesh cycle looks like to a plot."""

    phase: np.ndarray
    stiffness_ratio: np.ndarray
    mean: float
    minimum: float
    maximum: float


def numbers_of(trace: dict[str, Any], letter: str) -> np.ndarray:
    """Numbers of a line of a page, as its script reads them."""
    offset, step, *even = trace.get("meta", {}).get("steps", {}).get(letter, (0.0, 1.0))
    if even:
        return offset + step * np.arange(even[0])
    values = trace["meta"]["means"] if letter == "means" else trace[letter]
    raw = np.frombuffer(base64.b64decode(values.get("bdata", "")), values["dtype"])
    if "packed" in values:
        raw = np.frombuffer(zlib.decompress(base64.b64decode(values["packed"]), -15), np.uint8)
        if values["dtype"] == "u2":
            gaps = (raw.reshape(3, -1).astype(np.int64) << np.array([[0], [8], [16]])).sum(axis=0)
            return offset + step * np.cumsum((gaps >> 1) ^ -(gaps & 1))
    return offset + step * (np.cumsum(raw, dtype=np.int64) if raw.dtype == np.uint8 else raw)


def pair() -> GearPair:
    gear = CylindricalGear(z=TEETH, m_n=3e-3, b=0.02)
    return GearPair(gear, gear, 0.1502)


def cycle() -> Cycle:
    phase = np.linspace(0.0, 1.0, 101)
    ratio = 1.2 - 0.2 * np.cos(2.0 * np.pi * phase)
    return Cycle(phase, ratio, 1.2, 1.0, 1.4)


def run(first: float, last: float, duration: float, rate: float = 50e3) -> dict[str, Any]:
    """Channels of a run whose mesh frequency goes from `first` to `last` [Hz]."""
    n = int(duration * rate)
    h = 1.0 / rate
    time = np.arange(n) * h
    psi = first * time + 0.5 * (last - first) / duration * time**2
    k = STIFFNESS * (1.0 - 0.2 * np.cos(2.0 * np.pi * psi))
    damping = 0.1 * float(np.sqrt(STIFFNESS * MASS))
    x = np.empty(n)
    force = np.empty(n)
    here, speed = GAP + FORCE / STIFFNESS, 0.0
    for i in range(n):
        gap = here - GAP if here > GAP else min(here + GAP, 0.0)
        force[i] = k[i] * gap
        x[i] = here
        speed += h * (FORCE - force[i] - damping * speed) / MASS
        here += h * speed
    angle = 2.0 * np.pi * psi / TEETH
    made = {
        "deflection[stage]": (x, "m", "deflection"),
        "mesh_force[stage]": (force, "N", "mesh force"),
        "contact_state[stage]": (np.sign(force), "", "contact state"),
        "circumferential_force[stage]": (0.94 * force, "N", "circumferential force"),
        "radial_force[stage]": (0.34 * force, "N", "radial force"),
        "angle[driver]": (angle, "rad", "angle"),
        "angle[driven]": (-0.5 * angle, "rad", "angle"),
        "speed[driver]": (np.gradient(angle, time), "rad/s", "speed"),
    }
    return {"time": time} | {name: Channel(name, *rest) for name, rest in made.items()}


def sweep() -> dict[str, Any]:
    """Points of a sweep with one jump in each direction and some contact loss on the upper branch."""
    points = []
    for direction, frequencies in (
        ("up", np.arange(1000.0, 3001.0, 100.0)),
        ("down", np.arange(3000.0, 999.0, -100.0)),
    ):
        for f in frequencies:
            upper = f > (2300.0 if direction == "up" else 1700.0)
            rms = (40e-6 if upper else 6e-6) * 1000.0 / f
            values = {"mean": 3e-5, "rms": rms, "min": 3e-5 - 2 * rms, "max": 3e-5 + 2 * rms}
            points.append(
                {
                    "direction": direction,
                    "speed": 2.0 * np.pi * f / TEETH,
                    "mesh_frequency": float(f),
                    "deflection": values,
                    "transmission_error": values,
                    "mesh_force": {key: value * 1e8 for key, value in values.items()},
                    "contact_loss_share": 0.4 if upper else 0.0,
                    "back_contact_share": 0.0,
                }
            )
    jumps = [{"direction": "up", "mesh_frequency": 2350.0}, {"direction": "down", "mesh_frequency": 1750.0}]
    return {"points": points, "jumps": jumps}


def values_of(thing: Any, identifiers: tuple[str, ...]) -> dict[str, Any]:
    return {key: getattr(thing, key) for key in identifiers if hasattr(thing, key)}


def cases() -> CaseTable:
    """Three cases over one number, the last of which failed."""
    path, found = "loads.input.torque", []
    for k, (torque, status) in enumerate(((100.0, 1), (150.0, 1), (200.0, 4))):
        row = {"unit": "m", "mean": 5e-5, "rms": 1e-8 * torque, "min": 4e-5, "max": 6e-5}
        force = {"unit": "N", "mean": 14.0 * torque, "rms": 1.0, "min": 0.0, "max": 20.0 * torque}
        found.append(
            {
                "case": k,
                "values": {path: f"{torque} N m"},
                "numbers": {path: torque},
                "status": status,
                "sentence": "finished" if status == 1 else "a force became <infinite> at t = 0.004 s",
                "channels": {"deflection[stage]": row, "mesh_force[stage]": force} if status == 1 else {},
            }
        )
    return CaseTable(cases=found, units={path: "N m"})


def scene() -> Scene:
    """A wedge that turns once in the time of the steady run."""
    points = np.array([[0.0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    times = np.linspace(0.0, 0.2, 101)
    turned = 2.0 * np.pi * times / 0.2
    body = SceneBody(name="driver", place=np.zeros(3), axes=np.eye(3), angle=turned, gross=turned)
    solid = SceneSolid(name="wedge", kind="body", body=0, points=points, triangles=faces)
    return Scene(title="wedge", bodies=[body], solids=[solid], times=times)


def power() -> PowerFlow:
    """A motor on two shafts that meet again, with losses in a mesh, and something small beside it."""
    blocks = [PowerBlock(name=n, speed=v) for n, v in (("one <1>", 100.0), ("two", -50.0), ("three", -50.0))]
    rows = (
        ("motor", "drive", OUTSIDE, 0, 1000.0, 1000.0, {}),
        ("a", "mesh", 0, 1, 600.0, 590.0, {"friction": 8.0, "damping": 1.0}),
        ("b", "mesh", 0, 2, 400.0, 395.0, {"friction": 5.0}),
        ("c", "coupling", 1, 2, 590.0, 590.0, {}),
        ("brake", "load", 2, OUTSIDE, 984.0, 984.0, {}),
    )
    keys = ("name", "kind", "start", "end", "given", "taken", "losses")
    links = [PowerLink(**dict(zip(keys, row, strict=True))) for row in rows]  # type: ignore[arg-type]
    return PowerFlow(span=(0.04, 0.2), blocks=blocks, links=links)


def campbell(
    modes: Mapping[str, Any] | None = None,
    orders: Mapping[str, tuple[float, str]] | None = None,
    operating: tuple[float, float] | None = None,
) -> xr.Dataset:
    """Campbell diagram as of `solve_campbell`: frequencies [Hz] by mode, orders and kinds by name."""
    speed = np.linspace(0.0, 400.0, 21)
    modes = {"mesh mode of stage": 2958.0} if modes is None else modes
    orders = orders or {"mesh stage": (50.0, "mesh"), "2× mesh stage": (100.0, "mesh")}
    curves = np.array([np.broadcast_to(f, speed.shape) for f in modes.values()], float).reshape(
        -1, speed.size
    )
    cross = [
        (2.0 * np.pi * f[0] / order, f[0], k + 1, name)
        for name, (order, _) in orders.items()
        for k, f in enumerate(curves)
        if f[0] < order * speed[-1] / (2.0 * np.pi)
    ]
    at = "crossing"
    words = {
        "order": [c[3] for c in cross],
        "whirl": [""] * len(cross),
        "source": ["transmission error"] * len(cross),
    }
    data: dict[str, Any] = {f"crossing_{k}": (at, np.array(v, dtype=object)) for k, v in words.items()}
    numbers = {"speed": 0, "frequency": 1}
    data |= {f"crossing_{k}": (at, np.array([c[n] for c in cross], float)) for k, n in numbers.items()}
    data |= {
        "frequency": (("speed", "mode"), curves.T),
        "damping_ratio": (("speed", "mode"), np.full(curves.T.shape, 0.05)),
        "excitation_order": ("excitation", [order for order, _ in orders.values()]),
        "excitation_kind": ("excitation", [kind for _, kind in orders.values()]),
        "crossing_mode": (at, np.array([c[2] for c in cross], int)),
        "crossing_damping_ratio": (at, np.full(len(cross), 0.05)),
        "crossing_participation": (at, np.full(len(cross), 0.8)),
        "crossing_amplification": (at, np.full(len(cross), 8.0)),
    }
    attrs: dict[str, Any] = {"body": "driver", "ranking": "ranked"}
    if operating is not None:
        attrs["operating_speed"] = list(operating)
        data["crossing_separation"] = (at, np.array([c[0] / operating[1] - 1.0 for c in cross]))
    coords = {
        "speed": speed,
        "mode": np.arange(1, len(modes) + 1),
        "name": ("mode", list(modes)),
        "excitation": list(orders),
        "crossing": np.arange(1, len(cross) + 1),
    }
    return xr.Dataset(data, coords=coords, attrs=attrs)


def report_model() -> ReportModel:
    stage = pair()
    return ReportModel(
        title="Pair <50/50> & its resonance",
        model_hash="0123456789abcdef" * 4,
        version="0.1.0",
        gears={"g1": values_of(stage.gear1, GEAR_ROWS), "g2": values_of(stage.gear2, GEAR_ROWS)},
        meshes={"stage": values_of(stage, MESH_ROWS)},
        pairs={"stage": (stage, "g1", "g2")},
        shafts={"stage": "driver"},
        counts=[("gears: 2", "g1 (50), g2 (50)")],
        warnings=["stage: a warning with <brackets>"],
        assumptions=[("all meshes", [("damping.d_out", "0 N s/m")])],
        sources=["ISO 21771"],
    )


def report_results() -> ReportResults:
    phase = np.linspace(0.0, 1.0, 51)
    return ReportResults(
        mesh_cycles={
            "stage": MeshCycleData(
                stiffness=cycle(),
                error_phase=phase,
                loaded_ratio=1.19 - 0.2 * np.cos(2.0 * np.pi * phase),
                share_way=1.75 * phase,
                share=np.where(abs(phase - 0.5) < 0.07, 1.0, 0.5),
                errors={"unloaded": 0.0 * phase, "150 N m": 8e-6 + 1e-6 * np.cos(2 * np.pi * phase)},
            )
        },
        runs={
            "steady": TimeRun(data=run(1800.0, 1800.0, 0.2), settle_time=0.04),
            "run-up": TimeRun(data=run(500.0, 3000.0, 0.5)),
        },
        sweeps={"sweep": sweep()},
        modes={
            "": ModeData(
                names=["rigid rotation", "mesh mode"],
                frequency=[0.0, 2958.0],
                damping_ratio=[float("nan"), 0.05],
            )
        },
        cases={"steady": cases()},
        powers={"steady": power(), "run-up": "No power flow of run-up: it is <not> known."},
        scene=SceneData(scene=scene(), run="steady", words="The scene shows <steady>."),
        sources=[
            SourceData(name="steady", kind="time response", sentence="finished", rows=[("solver", "<rk4>")]),
            SourceData(name="run-up", kind="time response", finished=False, sentence="failed: a force <x>"),
            SourceData(name="sweep", kind="speed sweep", sentence="finished"),
        ],
        campbells={"": campbell()},
    )
