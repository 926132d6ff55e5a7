# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint view`: 3-D scene of a model or a result as one HTML file."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.options import allow_code, debug, output, quiet, writes
from pitchpoint.cli.output import show, show_notes

if TYPE_CHECKING:
    from pitchpoint.report.film import FilmMaker


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
@output("HTML file; default: name of FILE with .view.html.")
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
    film: str | None,
    output: str | None,
    allow_code: bool,
    quiet: bool,
) -> None:
    """Write the 3-D scene of FILE, a result (.h5) or a model, to one HTML page for any browser.

    With OTHER, show two scenes side by side with a common time.
    """
    from pitchpoint.report.film import film_maker
    from pitchpoint.report.view import write_view
    from pitchpoint.viz.scene.page import SceneStart

    # missing programs are reported before anything is computed
    maker = None if film is None else film_maker(film)
    target = output or str(Path(file).with_suffix(".view.html"))
    if modes and other is not None:
        raise click.BadParameter("modes can only be shown for one result or model", param_hint="--modes")
    sources = [file] if other is None else [file, other]
    start = SceneStart(view=direction, parallel=parallel, section=section or "")
    written, notes = write_view(target, *sources, allow_code=allow_code, modes=modes or 0, start=start)
    if not quiet:
        show(f"scene written to {written}, {written.stat().st_size / 1e6:.1f} MB; open it in a browser")
        show_notes(notes)
    if maker is not None:
        _film(written, maker, quiet)


def _film(page: Path, maker: FilmMaker, quiet: bool) -> None:
    """Write a video of a page with a progress display."""
    from pitchpoint.cli.progress import ProgressDisplay
    from pitchpoint.report.film import film

    with ProgressDisplay("video", "frames", quiet=quiet) as progress:
        path = film(page, maker, progress)
    if not quiet:
        show(f"video written to {path}, {path.stat().st_size / 1e6:.1f} MB")
