# SPDX-License-Identifier: Apache-2.0
"""`write_report`: report on a model and its results in one HTML file."""

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
    compare: bool = False,
    progress: Progress = silent,
    on_note: Callable[[str], None] | None = None,
) -> Path:
    """Write a report on a model and its results as one self-contained HTML page.

    Parameters
    ----------
    model
        Model, or path of its file.
    path_out
        HTML file to write; its folder is created if necessary, an older report is replaced.
    *results
        Any number of result files (`.h5`) of runs, slow rolls, sweeps, Campbell diagrams and cases, and
        datasets of `solve_time`, `solve_quasistatic`, `solve_campbell` and `sweep_speed`. The statistics
        begin at the `settle_time` of their scenarios. Results of the model alone (geometry, mesh cycle,
        modes) are always computed and shown.
    allow_code
        Allow model files to run the Python functions that they name.
    compare
        Overlay runs of different scenarios, too. Runs and sweeps of one scenario with different values in
        their models are always overlaid; the legend contains these values.
    progress
        Called with the number of completed parts: slow roll of every mesh, modes, Campbell diagram.
    on_note
        Called with every warning of the page, after the page is written.

    Returns
    -------
    Path
        The file. The same input gives the same bytes.

    Raises
    ------
    ModelError
        If the model file is invalid, or results are those of a machine with other bodies or meshes.
    PitchpointError
        If a result cannot be shown, or the page cannot be written or would overwrite an input file.

    Notes
    -----
    Validity warnings are listed in the report and are not raised.

    Examples
    --------
    >>> import pitchpoint as pp
    >>> system = pp.compile_model(pp.load_model("pair.yaml"), "steady")  # doctest: +SKIP
    >>> pp.write_report("pair.yaml", "pair.html", pp.solve_time(system), "sweep.h5")  # doctest: +SKIP
    PosixPath('pair.html')
    """
    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.io.yaml_model import load_model
    from pitchpoint.report.collect import collect
    from pitchpoint.report.describe import describe
    from pitchpoint.report.notes import remarks_of
    from pitchpoint.viz.report.build import report_html

    path = check_target(path_out, "page", files_of(model, *results))
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        if isinstance(model, str | os.PathLike):
            model = load_model(os.fspath(model), allow_code=allow_code)
        about = describe(model)
        found, remarks = collect(model, results, progress, compare)
    texts = [str(w.message) for w in heard if issubclass(w.category, ValidityWarning)]
    about = replace(about, warnings=remarks_of(texts, remarks))
    written = write_file(path, report_html(about, found))
    if on_note is not None:
        for text in about.warnings:
            on_note(text)
    return written


def files_of(*things: Model | str | os.PathLike[str] | xr.Dataset) -> list[str]:
    """Files given, or from which models and datasets were read.

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
            opened = getattr(thing, "encoding", None)  # a dataset stores the name of its file here
            source = getattr(thing, "file", None) if opened is None else opened.get("source")
            found += [str(source)] if source else []
    return found
