# SPDX-License-Identifier: Apache-2.0
"""Model files with several wrong edits at once, and what becomes of them from loading to a short run.

Whatever an edit does, the answer is a refusal with a sentence (`PitchpointError`) or numbers that are finite
or have a status. Anything else is a raw exception, a hang or a number without a status: a fault of the code.
"""

from __future__ import annotations

import contextlib
import copy
import math
import random
import re
import signal
import traceback
import warnings
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from ruamel.yaml import YAML

from pitchpoint.core.errors import PitchpointError
from pitchpoint.io.measured.reading import read_measured
from pitchpoint.model.build import build_model
from pitchpoint.model.reading.reader import Reader

ROOT = Path(__file__).parents[2]
SOON = 180
"""Time after which a case counts as a hang [s]: its kernels may have to be compiled, next to other work."""
EXTREMES = (0, -1, 1, 2, 1e-300, 1e300, -1e300, 1e9, 1e-9, math.inf, math.nan, 10**20)
STRANGE: tuple[Any, ...] = (None, True, "", "x", "ground", "1 furlong", "nan", [], {}, [0, 0, 0], {"a": 1})


@cache
def model_trees() -> dict[str, tuple[Any, str]]:
    """Data and folder of every model file that is shipped, and of every whole one in the documentation.

    They are read once per process: edit copies.
    """
    found = {}
    for path in sorted((ROOT / "examples").rglob("*.yaml")):
        found[path.relative_to(ROOT).as_posix()] = (path.read_text(encoding="utf-8"), str(path.parent))
    for page in sorted([*(ROOT / "docs").rglob("*.md"), ROOT / "README.md"]):
        blocks = re.findall(
            r"^```yaml\n(.*?)^```", page.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE
        )
        for k, block in enumerate(blocks):
            found[f"{page.relative_to(ROOT).as_posix()} {k}"] = (block, str(page.parent))
    trees = {}
    for name, (text, folder) in found.items():
        with contextlib.suppress(Exception):  # fragments, and plans of data sets
            data = YAML(typ="safe", pure=True).load(text)
            build_model(data, Reader(allow_code=True, directory=folder))
            trees[name] = (_apart(data), folder)
    return trees


def _apart(data: Any) -> Any:
    """A copy without parts that are shared through anchors: a part moved into itself would have no end."""
    if isinstance(data, dict):
        return {key: _apart(value) for key, value in data.items()}
    return [_apart(value) for value in data] if isinstance(data, list) else data


def places(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Paths of all values of nested data."""
    out = [path] if path else []
    items = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for step, value in items:
        out += places(value, (*path, step))
    return out


def at(data: Any, path: tuple[Any, ...]) -> Any:
    """Value at a path."""
    for step in path:
        data = data[step]
    return data


def edit(data: Any, chance: random.Random) -> None:
    """Delete, double, swap, move, rename or replace one value of nested data."""
    every = places(data)
    if not every:
        return
    path, other = chance.choice(every), chance.choice(every)
    owner, key = at(data, path[:-1]), path[-1]
    how = chance.choice(("delete", "double", "swap", "move", "name", "number", "strange", "length", "scale"))
    value = owner[key]
    if how == "delete":
        del owner[key]
    elif how == "double" and isinstance(owner, dict):
        owner[f"{key}_2"] = copy.deepcopy(value)
    elif how == "swap" and path != other[: len(path)] and other != path[: len(other)]:
        there = at(data, other[:-1])
        owner[key], there[other[-1]] = there[other[-1]], value
    elif how == "move" and path != other[: len(path)] and isinstance(at(data, other), dict):
        at(data, other)[key] = value
        if owner is not at(data, other):
            del owner[key]
    elif how == "name":
        owner[key] = chance.choice(["nobody", "ground", "nobody.m", str(other[-1])])
    elif how == "number":
        owner[key] = chance.choice(EXTREMES)
    elif how == "strange":
        owner[key] = copy.deepcopy(chance.choice(STRANGE))
    elif how == "length" and isinstance(value, list):
        owner[key] = value[: chance.randrange(len(value) + 1)] or [*value, 1.0]
    elif how == "scale" and isinstance(value, int | float) and not isinstance(value, bool):
        owner[key] = value * chance.choice((-1.0, 0.0, 1e-6, 0.5, 3.0, 1e6))


def shortened(data: Any) -> Any:
    """The same with scenarios of a few steps."""
    scenarios = data.get("scenarios") if isinstance(data, dict) else None
    for scenario in scenarios.values() if isinstance(scenarios, dict) else ():
        if not isinstance(scenario, dict):
            continue
        if isinstance(scenario.get("sweep"), dict):
            scenario["sweep"] |= {"points": 2, "settle_periods": 1, "measure_periods": 1}
        elif isinstance(scenario.get("quasi_static"), dict):
            scenario["quasi_static"] |= {"points": 8, "periods": 1}
        else:
            for key in ("settle_time", "sample_rate", "tolerance"):
                scenario.pop(key, None)
            scenario |= {"duration": 5e-5, "step": 1e-5}
    return data


def damaged(data: bytes, chance: random.Random) -> bytes:
    """Bytes of a file with up to five changed, cut at any place in half of the cases."""
    raw = bytearray(data)
    for _ in range(chance.randrange(6)):
        # most of what can go wrong is in the first bytes
        place = int(chance.random() ** chance.choice((1, 4)) * len(raw))
        raw[place] = chance.choice((0, 1, 127, 128, 255, chance.randrange(256)))
    return bytes(raw[: chance.randrange(len(raw) + 1)]) if chance.random() < 0.5 else bytes(raw)


class Hang(BaseException):
    """A case took too long."""


@contextlib.contextmanager
def soon(seconds: int) -> Iterator[None]:
    """Raise `Hang` in the block after a time."""

    def stop(*_: Any) -> None:
        raise Hang

    before = signal.signal(signal.SIGALRM, stop)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def outcome(data: Any, folder: str, *, compute: bool) -> str:
    """Word for what became of a model: "refused", "loaded", "computed", or a fault with its place.

    `compute` also compiles it, finds its modes and runs every scenario for a few steps.
    """

    def done() -> str:
        model = build_model(shortened(data), Reader(allow_code=True, directory=folder))
        return _computed(model) if compute else "loaded"

    return _word(done)


def outcome_of_file(path: Path) -> str:
    """Word for what became of a measured file."""

    def done() -> str:
        found = read_measured(path, sample_rate=None if path.suffix in (".csv", ".h5") else 1000.0)
        finite = all(np.isfinite(v).all() for v in found.data_vars.values())
        return "loaded" if finite else "number without a status in a file"

    return _word(done)


def _word(done: Callable[[], str]) -> str:
    try:
        with soon(SOON), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return done()
    except PitchpointError as error:
        assert str(error).strip()
        return "refused"
    except Hang:
        return "hang"
    except Exception as error:  # noqa: BLE001 - what this looks for
        frames = [f for f in traceback.extract_tb(error.__traceback__) if "pitchpoint" in f.filename]
        last = f"{Path(frames[-1].filename).name}:{frames[-1].lineno}" if frames else "?"
        return f"raw {type(error).__name__} at {last}: {str(error)[:80]}"


def _computed(model: Any) -> str:
    """Modes and short runs of every scenario; a refusal of one of them does not stop the others."""
    from pitchpoint import compile_model, solve_modal, solve_quasistatic, solve_time, sweep_speed

    word = "refused"
    with contextlib.suppress(PitchpointError):
        modes = solve_modal(compile_model(model))
        if not all(np.isfinite(modes[name]).all() for name in ("frequency", "damping_ratio")):
            return "number without a status in modes"
        word = "computed"
    for name, scenario in model.scenarios.items():
        with contextlib.suppress(PitchpointError):
            kinds = {"a sweep": scenario.sweep, "a roll": scenario.quasi_static}
            kind = next((word for word, given in kinds.items() if given is not None), "a run")
            solve = {"a sweep": sweep_speed, "a roll": solve_quasistatic, "a run": solve_time}[kind]
            found = solve(compile_model(model, name))
            if found.attrs.get("status", "finished") == "finished" and not all(
                np.isfinite(v).all() for v in found.data_vars.values() if v.dtype.kind == "f"
            ):
                return f"number without a status in {kind}"
            word = "computed"
    return word


def counted(seed: int, cases: int, every: int) -> tuple[Counter[str], dict[str, Any]]:
    """Outcomes of some cases, the first of each fault by its word; every `every`-th is computed as well."""
    trees = model_trees()
    names = sorted(trees)
    chance = random.Random(seed)
    words: Counter[str] = Counter()
    first: dict[str, Any] = {}
    for k in range(cases):
        data, folder = trees[chance.choice(names)]
        data = copy.deepcopy(data)
        for _ in range(chance.choice((1, 1, 2, 3, 5))):
            edit(data, chance)
        case = copy.deepcopy(data)
        word = outcome(data, folder, compute=k % every == 0)
        words[word] += 1
        if word not in ("loaded", "refused", "computed"):
            first.setdefault(word, case)
    return words, first


def counted_files(seed: int, cases: int, good: Mapping[str, bytes], folder: Path) -> Counter[str]:
    """Outcomes of damaged measured files; `good` has the contents of one file by its name."""
    chance = random.Random(seed)
    words: Counter[str] = Counter()
    for _ in range(cases):
        name = chance.choice(sorted(good))
        path = folder / f"{seed}.{name.rpartition('.')[2]}"
        path.write_bytes(damaged(good[name], chance))
        words[outcome_of_file(path)] += 1
    return words
