# SPDX-License-Identifier: Apache-2.0
"""`--vary`: values of keys, the cases of all their combinations, and the model that they change."""

from __future__ import annotations

import functools
import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.settings import scalar, split_at_path

if TYPE_CHECKING:
    from pitchpoint.model.model import Model

_OPEN, _CLOSE = "([{", ")]}"
_RANGE = re.compile(
    r"(?P<low>[-+]?\d*\.?\d+)\s*(?P<unit>[^\d.:]*?)\s*(?:\.\.|:)\s*(?P<high>[-+]?\d*\.?\d+)\s*(?P<own>[^\d.:]*).*"
)
"""Range of numbers, which other options take, but not `--vary`."""


def vary_option(function: Any) -> Any:
    """Add `--vary`, `--load-cases` and `--jobs` to a command; `vary` includes all load cases on request."""
    from pitchpoint.cli.options import jobs

    @functools.wraps(function)
    def with_cases(*, file: str, vary: tuple[str, ...], load_cases: bool, **rest: Any) -> Any:
        """Vary the load case, too, if all of them are requested."""
        if load_cases:
            vary = (*vary, f"load_case={','.join(load_cases_in(file))}")
        return function(file=file, vary=vary, **rest)

    cases = click.option(
        "--load-cases",
        is_flag=True,
        help="Run all load cases of the file into one table; short for --vary load_case=NAME1,NAME2,...",
    )
    vary = click.option(
        "--vary",
        multiple=True,
        metavar="PATH=V1,V2,...",
        help="Run every value of a key, listed with commas, such as 'loads.input.torque=50 N m,150 N m'; "
        "several --vary options run all combinations, on all cores, into one table.",
    )
    return vary(jobs(cases(with_cases)))


def load_cases_in(file: str) -> list[str]:
    """Names of the load cases of a model file, which need not be valid.

    Raises
    ------
    click.UsageError
        If there are none.
    """
    from pitchpoint.io.yaml_model import data_of
    from pitchpoint.model.load_cases import SECTION

    data = data_of(file)
    found = data.get(SECTION) if isinstance(data, dict) else None
    if not isinstance(found, dict) or not found:
        raise click.UsageError(f"--load-cases: {file} has no {SECTION}")
    return [str(name) for name in found]


def values_of(text: str, known: Callable[[str], bool] | None = None) -> tuple[str, list[Any]]:
    """Read one `PATH=V1,V2`; commas inside brackets are part of a value.

    Parameters
    ----------
    text
        Argument of `--vary`.
    known
        Function that recognises existing paths, whose names may contain an equals sign.

    Examples
    --------
    >>> values_of("meshes.stage.damper.ratio=0.05,0.1")
    ('meshes.stage.damper.ratio', [0.05, 0.1])
    >>> values_of("loads.input.torque=50 N m, 10 N m * min(t, 1)")[1]
    ['50 N m', '10 N m * min(t, 1)']
    """
    path, sign, rest = split_at_path(text, known)
    parts, depth = [""], 0
    for letter in rest:
        depth += (letter in _OPEN) - (letter in _CLOSE)
        if letter == "," and depth <= 0:
            parts.append("")
        else:
            parts[-1] += letter
    if not sign or not path.strip() or not all(part.strip() for part in parts):
        raise click.BadParameter(f"{text!r} is not of the form PATH=V1,V2,...", param_hint="--vary")
    for part in parts:
        if found := _RANGE.fullmatch(part.strip()):
            low, high = float(found["low"]), float(found["high"])
            unit = found["own"].strip() or found["unit"]
            values = ",".join(f"{x:g} {unit}".strip() for x in (low, 0.5 * (low + high), high))
            raise click.BadParameter(
                f"{part.strip()!r} is a range, and every value is one case; list the values, such as "
                f"'{path.strip()}={values}'",
                param_hint="--vary",
            )
    return path.strip(), [scalar(part.strip(), "--vary") for part in parts]


def varied(vary: Sequence[str], known: Callable[[str], bool]) -> dict[str, list[Any]]:
    """Values of all `--vary` by path; `known` as in `values_of`."""
    paths: dict[str, list[Any]] = {}
    for text in vary:
        path, values = values_of(text, known)
        if path in paths:
            raise click.BadParameter(f"{path} is varied twice", param_hint="--vary")
        paths[path] = values
    return paths


def cases_of(vary: Sequence[str], file: str) -> list[dict[str, Any]]:
    """Cases of `--vary` for a model file that need not be valid; none without `--vary`."""
    from pitchpoint.cli.settings import known_in
    from pitchpoint.sweep.cases import grid

    return grid(varied(vary, known_in(file))) if vary else []


def base_model(file: str, allow_code: bool, quiet: bool, vary: Sequence[str]) -> Model:
    """Model whose values `--vary` replaces: of the file, or with the first valid case if that is refused."""
    from pitchpoint.cli.reading import read_model
    from pitchpoint.core.errors import Message, ModelError

    try:
        return read_model(file, allow_code, quiet)
    except ModelError as error:
        refused = error
    problems: dict[Message, None] = {}
    for case in cases_of(vary, file):
        try:
            return read_model(file, allow_code, quiet, case=case)
        except ModelError as error:
            problems |= dict.fromkeys(error.problems)
    raise ModelError(list(problems), file) if problems else refused
