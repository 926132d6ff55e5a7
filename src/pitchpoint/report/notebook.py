# SPDX-License-Identifier: Apache-2.0
"""Display of models and results in notebooks: tables or a summary, a plot, and the 3-D scene in a frame.

Results are plain xarray datasets. A formatter registered with IPython displays results of pitchpoint; other
datasets keep the display of xarray. Formatters are registered by class name, without importing the classes.
"""

from __future__ import annotations

import sys
import warnings
from collections.abc import Callable, Mapping
from html import escape
from typing import TYPE_CHECKING, Any

from pitchpoint.core.errors import split_notes
from pitchpoint.viz import notebook as drawings

if TYPE_CHECKING:
    import xarray as xr

    from pitchpoint.model.model import Model
    from pitchpoint.viz.quantities import Array, Channel
    from pitchpoint.viz.scene.content import Scene

HEIGHT, WITH_CURVES = "480px", "640px"
"""Height of a scene in a cell, without and with curves below it."""
MAX_BYTES = 8_000_000
"""Size limit of a scene in a notebook, including the viewer (0.7 MB): the file stores each scene."""
MAX_ROWS = 8


def register() -> bool:
    """Register the displays of gears, pairs, models and results with a running IPython; no effect elsewhere.

    Returns
    -------
    bool
        Whether IPython is running.
    """
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None and hasattr(ipython, "get_ipython") else None
    if shell is None:
        return False
    formatter = shell.display_formatter.formatters["text/html"]
    for (module, name), function in shown().items():
        formatter.for_type_by_name(module, name, function)
    return True


def shown() -> dict[tuple[str, str], Callable[[Any], str]]:
    """HTML formatters by module and class name."""
    found: dict[tuple[str, str], Callable[[Any], str]] = {
        key: getattr(drawings, function) for key, function in drawings.SHOWN.items()
    }
    found["pitchpoint.model.model", "Model"] = model_html
    found["xarray.core.dataset", "Dataset"] = dataset_html
    return found


def model_html(model: Model) -> str:
    """Tables of a model, a drawing of each gear pair, and the scene at rest."""
    from pitchpoint.report.scene.rest import rest_scene

    return drawings.model_html(model) + _frame(lambda: rest_scene(model))


def is_result(data: xr.Dataset) -> bool:
    """Whether a dataset was computed by pitchpoint."""
    source = str(data.attrs.get("source", ""))
    return "pitchpoint_version" in data.attrs or source.startswith("pitchpoint ")


def dataset_html(data: xr.Dataset) -> str:
    """Summary, scene and variables of a result; the xarray display for any other dataset."""
    own = str(data._repr_html_())
    if not is_result(data):
        return own
    folded = f"<details><summary>all {len(data.data_vars)} variables</summary>{own}</details>"
    return _summary(data) + _picture(data) + _frame(lambda: _scene(data)) + folded


def _picture(data: xr.Dataset) -> str:
    """Main plot of a result in a frame; none for a time response, whose scene has curves."""
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.report.pictures import plot
    from pitchpoint.report.result_kinds import kind_of
    from pitchpoint.viz.report.frame import figure_frame

    try:
        kind = kind_of(data)
        frame = "" if kind == "time" else figure_frame(plot(data), kind.replace("_", " "))
    except (PitchpointError, ValueError, OSError) as error:
        return _sentence(f"no plot: {error}")
    return frame if len(frame) <= MAX_BYTES else _sentence("no plot: too large for a notebook; use pp.plot")


def _frame(scene: Callable[[], Scene]) -> str:
    """Scene in a frame, or a sentence with the reason why there is none."""
    from pitchpoint.core.errors import PitchpointError, ValidityWarning
    from pitchpoint.viz.scene.page import scene_frame

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ValidityWarning)  # reported when the model or result was created
            made = scene()
        if not made.solids:
            return _sentence("no scene: the model has no body with gears, shafts or a solid to draw")
        frame = scene_frame(made, height=WITH_CURVES if made.channels else HEIGHT)
    except (PitchpointError, ValueError, OSError) as error:
        return _sentence(f"no scene: {error}")
    if len(frame) > MAX_BYTES:
        size = f"{len(frame) / 1e6:.0f} MB (limit {MAX_BYTES / 1e6:.0f} MB)"
        return _sentence(f"no scene: too large for a notebook, {size}; use `pitchpoint view` to write a page")
    notes = "".join(_sentence(note) for note in made.notes)
    return frame + notes


def _sentence(text: str) -> str:
    first, _, rest = text.strip().partition("\n")
    more = f"<br>{escape(rest.strip())}" if rest.strip() else ""
    return f'<p style="opacity:.75">{escape(first)}{more}</p>'


def _scene(data: xr.Dataset) -> Scene:
    """Scene of a result over time, or of its model at rest if nothing moves."""
    from pitchpoint.report.scene.build import scene_of
    from pitchpoint.report.scene.rest import rest_scene
    from pitchpoint.report.stored_model import model_of

    model = model_of(data)
    moves = "time" in data.dims and data.sizes["time"] > 1
    if moves or {"mode", "coordinate"} <= set(data.dims):  # a Campbell diagram has modes without shapes
        return scene_of(model, data)
    return rest_scene(model)


def _summary(data: xr.Dataset) -> str:
    """Title, origin, status, and a table of the first channels of a result."""
    attrs = data.attrs
    bold = escape(str(attrs.get("title") or "Result"))
    sentence = f"<p><b>{bold}</b><br>{escape('; '.join(_facts(data)))}</p>{_ending(data)}"
    sentence += "".join(_sentence(note) for note in split_notes(str(attrs.get("notes", ""))))
    return sentence + _numbers(data) + _modes(data) + _sweep(data)


def _facts(data: xr.Dataset) -> list[str]:
    attrs = data.attrs
    words, name = str(attrs.get("kind", "")).replace("_", " "), attrs.get("scenario")
    facts = [f"{words or 'result'} of scenario {name}"] if name else [words] if words else []
    facts += [f"solver {str(attrs['solver']).replace('_', ' ')}"] if attrs.get("solver") else []
    if "time" in data.dims and data.sizes["time"] > 1:
        time = data["time"]
        facts.append(f"{data.sizes['time']} samples from {float(time[0]):.6g} to {float(time[-1]):.6g} s")
    version = attrs.get("pitchpoint_version") or attrs.get("package_version")
    made = [f"pitchpoint {version}"] if version else []
    if attrs.get("created"):
        made.append(str(attrs["created"]))
    return [*facts, ", ".join(made)] if made else facts


def _ending(data: xr.Dataset) -> str:
    """Sentence about the status of an unfinished result; empty if finished."""
    from pitchpoint.core.status import OK

    status, attrs = data.attrs.get("status", OK), data.attrs
    if status in (OK, "finished"):
        return ""
    sentence = attrs.get("status_text") or attrs.get("sentence") or ""
    words = f"not finished, status {status}" + (f": {sentence}" if sentence else "")
    return f"<p><b>{escape(words)}</b></p>"


def _numbers(data: xr.Dataset) -> str:
    """Statistics of the main channels, over the same window as in the terminal and in a report."""
    import numpy as np

    from pitchpoint.analysis.statistics import signal_statistics
    from pitchpoint.viz.quantities import channels, settle_time_of, window_words
    from pitchpoint.viz.run_record import settled_part, statistics_window
    from pitchpoint.viz.tables import plain_table

    if "time" not in data.dims or data.sizes["time"] < 2:
        return ""
    time, found = channels(data)
    inside = settled_part(time, settle_time_of(data.attrs))
    rows: list[str] = []
    for name in _main(data, list(found)):
        x = found[name].values[inside]
        if np.isfinite(x).all() and len(rows) < MAX_ROWS:
            known = found[name].statistics or vars(signal_statistics(x, time[inside]))
            rows.append(_row(found[name], x, known))
    if not rows:
        return ""
    head = ("channel", "unit", "mean", "rms (alternating)", "minimum", "maximum")
    window = statistics_window(time, found, settle_time_of(data.attrs))
    sentence = _sentence(window_words(*window).capitalize())
    return f'{drawings.STYLE}<div class="pp-shown">{plain_table(head, rows)}</div>{sentence}'


def _main(data: xr.Dataset, names: list[str]) -> list[str]:
    """Main channels of a result that contains its model; else all channels."""
    from pitchpoint.core.errors import PitchpointError
    from pitchpoint.report.main_channels import main_channels
    from pitchpoint.report.stored_model import model_of

    try:
        model = model_of(data)
    except PitchpointError:
        return names
    return main_channels(model, names, str(data.attrs.get("scenario", "")))


def _modes(data: xr.Dataset) -> str:
    """The lowest natural frequencies and their damping."""
    from pitchpoint.viz.quantities import number
    from pitchpoint.viz.tables import plain_table

    if not {"frequency", "damping_ratio"} <= set(data) or data["frequency"].dims != ("mode",):
        return ""
    found = zip(data["frequency"].values, data["damping_ratio"].values, strict=True)
    rows = [
        f'<tr><th scope="row">{k}</th><td class="num">{number(float(frequency))}</td>'
        f'<td class="num">{number(100.0 * float(ratio))}</td></tr>'
        for k, (frequency, ratio) in enumerate(found, start=1)
    ]
    table = plain_table(("mode", "natural frequency [Hz]", "damping ratio [%]"), rows[:MAX_ROWS])
    return f'{drawings.STYLE}<div class="pp-shown">{table}</div>'


def _sweep(data: xr.Dataset) -> str:
    """Maximum response of a sweep in each direction, and its jumps."""
    from pitchpoint.viz.quantities import amount, number
    from pitchpoint.viz.tables import plain_table

    if not {"direction", "mesh_frequency", "statistic"} <= set(data.dims):
        return ""
    frequency, rows = data["mesh_frequency"].values, []
    for name in [str(name) for name in data if str(name).startswith("deflection[")][:MAX_ROWS]:
        owner = name.partition("[")[2].rstrip("]")
        for k, direction in enumerate(data["direction"].values):
            rms = data[name].sel(direction=direction, statistic="rms").dropna("mesh_frequency")
            if not rms.size:
                continue
            top = rms.idxmax("mesh_frequency")
            jumps = data["jump_mesh_frequency"].values[data["jump_direction"].values == k]
            values = (
                amount(float(rms.max()), "m", 5),
                number(float(top)),
                ", ".join(number(float(jump)) for jump in jumps) or "none",
            )
            cells = "".join(f'<td class="num">{value}</td>' for value in values)
            rows.append(f'<tr><th scope="row">{escape(f"{owner}, {direction}")}</th>{cells}</tr>')
    if not rows:
        return ""
    ends = f"mesh frequency {number(float(frequency[0]))} … {number(float(frequency[-1]))} Hz"
    head = (ends, "maximum rms of deflection", "at [Hz]", "jumps at [Hz]")
    return f'{drawings.STYLE}<div class="pp-shown">{plain_table(head, rows)}</div>'


def _row(channel: Channel, x: Array, known: Mapping[str, float]) -> str:
    """Table row of one channel in a customary unit."""
    from pitchpoint.viz.quantities import channel_scale, number

    shown = channel_scale(channel.name, channel.unit, x)
    # the alternating part of a constant is round-off, not a result
    rms = known["rms"] if known["rms"] > 1e-10 * abs(x).max() else 0.0
    values = (known["mean"], rms, known["min"], known["max"])
    cells = "".join(f'<td class="num">{number(value * shown.factor)}</td>' for value in values)
    label = escape(channel.label)
    return f'<tr><th scope="row">{label}</th><td class="unit">{shown.unit}</td>{cells}</tr>'
