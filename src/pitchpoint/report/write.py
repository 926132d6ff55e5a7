# SPDX-License-Identifier: Apache-2.0
"""`write_report`: one HTML file about a model and its results."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from pitchpoint.core.errors import ValidityWarning
from pitchpoint.core.progress import Progress, silent

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model


def write_report(
    model: Model | str | os.PathLike[str],
    path_out: str | os.PathLike[str],
    *results: str | os.PathLike[str] | xr.Dataset,
    allow_code: bool = False,
    progress: Progress = silent,
    on_note: Callable[[str], None] | None = None,
) -> Path:
    """Write one self-contained HTML page about a model and its results.

    Parameters
    ----------
    model
        A model, or the name of its file.
    path_out
        The HTML file to write; its folder is made if it does not exist, an older report is replaced.
    *results
        Result files (`.h5`) of runs, slow rolls, sweeps and cases, and datasets of `solve_time`,
        `solve_quasistatic` and `sweep_speed`, in any number. The first fifth of a dataset counts as settling,
        from a file those of its scenario. What follows from the model alone (geometry, mesh cycle, modes) is
        computed and shown in any case.
    allow_code
        Whether a model file may name Python code.
    progress
        Called with the number of parts that are done: the slow roll of every mesh, modes, Campbell diagram.
    on_note
        Called with every warning of the page, as soon as the page is written.

    Returns
    -------
    Path
        The file. The same input gives the same bytes.

    Raises
    ------
    ModelError
        If the model file is wrong.
    PitchpointError
        If a result has no place in a report, or the page cannot be written or would destroy another file.

    Notes
    -----
    Validity warnings that come up on the way are in the report and are not raised.

    Examples
    --------
    >>> import pitchpoint as pp
    >>> system = pp.compile_model(pp.load_model("pair.yaml"), "steady")  # doctest: +SKIP
    >>> pp.write_report("pair.yaml", "pair.html", pp.solve_time(system), "sweep.h5")  # doctest: +SKIP
    PosixPath('pair.html')
    """
    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.report.collect import collect, describe
    from pitchpoint.viz.report.build import report_html

    path = check_target(path_out, "page", files_of(model, *results))
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        if isinstance(model, str | os.PathLike):
            model = load_model(os.fspath(model), allow_code=allow_code)
        about = describe(model)
        found, remarks = collect(model, results, progress)
    texts = [str(w.message) for w in heard if issubclass(w.category, ValidityWarning)]
    about = replace(about, warnings=list(dict.fromkeys([*texts, *remarks])))
    written = write_file(path, report_html(about, found))
    if on_note is not None:
        for text in about.warnings:
            on_note(text)
    return written


def files_of(*things: Model | str | os.PathLike[str] | xr.Dataset) -> list[str]:
    """Files that are named, or that models and datasets were read from.

    Examples
    --------
    >>> files_of("pair.yaml", Path("steady.h5"))
    ['pair.yaml', 'steady.h5']
    """
    found = []
    for thing in things:
        if isinstance(thing, str | os.PathLike):
            found.append(os.fspath(thing))
        else:
            opened = getattr(thing, "encoding", None)  # where a dataset keeps the name of its file
            source = getattr(thing, "file", None) if opened is None else opened.get("source")
            found += [str(source)] if source else []
    return found
