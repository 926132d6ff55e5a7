# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint view`: 3-D scene of a model or a result as one HTML file."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from pitchpoint.cli.options import allow_code, debug, output, quiet, scenario, writes
from pitchpoint.cli.output import show, show_notes
from pitchpoint.cli.settings import set_option, settings_of_command
from pitchpoint.cli.tunable_numbers import input_option, parameter_option

if TYPE_CHECKING:
    from pitchpoint.report.film import FilmMaker
    from pitchpoint.viz.scene.page import SceneStart


@click.command()
@click.argument("file", type=click.Path(exists=True, dir_okay=False))
@click.argument("other", required=False, type=click.Path(exists=True, dir_okay=False))
@click.option(
    "--modes",
    type=click.IntRange(min=1),
    metavar="N",
    help="Also compute and show the lowest N mode shapes; default: none.",
)
@click.option(
    "--view",
    "direction",
    type=click.Choice(["axis", "side", "top", "iso"]),
    default="iso",
    show_default=True,
    help="Initial view: along the axis of the shafts, from the side, from above, or oblique.",
)
@click.option("--parallel", is_flag=True, help="Parallel projection, as in a drawing; default: central.")
@click.option(
    "--section",
    type=click.Choice(["x", "y", "z", "axis"]),
    help="Cut the parts in the middle, normal to x, y, z or the axis of the shafts; default: no section.",
)
@writes(
    "--film",
    help="Also write a video (mp4, webm or gif); requires Chromium, ffmpeg and Playwright.",
)
@click.option(
    "--live",
    is_flag=True,
    help="The model runs in the page, with sliders for loads, speeds and parameters; requires ziglang.",
)
@scenario
@parameter_option
@input_option
@set_option
@output("HTML file; default: name of FILE with .view.html, or .live.html.")
@allow_code
@quiet
@debug
def view(
    file: str,
    other: str | None,
    modes: int | None,
    direction: str,
    parallel: bool,
    section: str | None,
    output: str | None,
    allow_code: bool,
    quiet: bool,
    **how: Any,
) -> None:
    """Write the 3-D scene of FILE, a result (.h5) or a model, to one HTML page for any browser.

    With OTHER, show two scenes side by side with a common time. With --live, the compiled model runs in the
    page, without a server; --scenario, --parameter, --input and --set apply to it.
    """
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.cli.results import refuse_without_effect
    from pitchpoint.report.film import film_maker
    from pitchpoint.report.view import write_view
    from pitchpoint.viz.scene.page import SceneStart

    film = how.pop("film")
    # missing programs are reported before anything is computed
    maker = None if film is None else film_maker(film)
    if how.pop("live"):
        taken = {"--modes": modes, "a second file": other, "--film": film}
        if unfit := [name for name, value in taken.items() if value]:
            raise click.UsageError(f"--live cannot be combined with {', '.join(unfit)}")
        start = SceneStart(view=direction, parallel=parallel, section=section or "")
        _live(file, output, start, allow_code=allow_code, quiet=quiet, **how)
        return
    names = {"scenario": "--scenario", "parameters": "--parameter", "more_inputs": "--input"}
    refuse_without_effect("without --live", {names[key]: value or None for key, value in how.items()})
    refuse_without_effect("without --live", {"--set": settings_of_command() or None})
    target = output or str(Path(file).with_suffix(".view.html"))
    if modes and other is not None:
        raise click.BadParameter("modes can only be shown for one result or model", param_hint="--modes")
    sources = [file] if other is None else [file, other]
    start = SceneStart(view=direction, parallel=parallel, section=section or "")
    with ProgressDisplay("view", quiet=quiet):
        written, notes = write_view(target, *sources, allow_code=allow_code, modes=modes or 0, start=start)
    if not quiet:
        show(f"scene written to {written}, {written.stat().st_size / 1e6:.1f} MB; open it in a browser")
        show_notes(notes)
    if maker is not None:
        _film(written, maker, quiet)


def _live(
    file: str,
    output: str | None,
    start: SceneStart,
    *,
    scenario: str | None,
    parameters: Sequence[str],
    more_inputs: Sequence[str],
    allow_code: bool,
    quiet: bool,
) -> None:
    """Write a page in which the model runs."""
    from pitchpoint.cli.reading import read_model
    from pitchpoint.cli.results import choose_scenario
    from pitchpoint.cli.tunable_numbers import ranges_of, show_settable
    from pitchpoint.io.fmu.web import check_web
    from pitchpoint.io.target import check_target, write_file
    from pitchpoint.report.exported_model import begin_export
    from pitchpoint.report.live import live_text, offered
    from pitchpoint.report.view import RESULT_ENDINGS

    if file.lower().endswith(RESULT_ENDINGS):
        raise click.UsageError(f"{file} is a result; --live requires a model")
    target = check_target(output or str(Path(file).with_suffix(".live.html")), "page", [file])
    check_web()
    model = read_model(file, allow_code, quiet)
    name = choose_scenario(model, scenario, "time")
    if parameters:
        run, tunable = begin_export(model, name, ranges_of(model, parameters), more_inputs)
    else:
        model, run, tunable = offered(model, name, more_inputs)
    page, _ = live_text(run, tunable, model, name, start)
    write_file(target, page)
    if not quiet:
        show_settable(run, tunable)
        show(f"live page written to {target}, {len(page) / 1e6:.1f} MB; open it in a browser")


def _film(page: Path, maker: FilmMaker, quiet: bool) -> None:
    """Write a video of a page with a progress display."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.report.film import film

    with ProgressDisplay("video", "frames", quiet=quiet) as progress:
        path = film(page, maker, progress)
    if not quiet:
        show(f"video written to {path}, {path.stat().st_size / 1e6:.1f} MB")
