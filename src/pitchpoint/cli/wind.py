# SPDX-License-Identifier: Apache-2.0
"""`pitchpoint wind`: turbulent wind from a seed, as a full-field file of TurbSim."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import click

from pitchpoint.cli.options import as_json, debug, quantity, quiet, with_suffix
from pitchpoint.cli.output import emit_json, show

if TYPE_CHECKING:
    from pitchpoint.core.errors import Message

CLASSES = tuple(f"{turbine}{turbulence}" for turbine in ("I", "II", "III") for turbulence in "ABC")
OPTIONS = {
    "mean_speed": "--speed",
    "deviation": "--deviation",
    "hub_height": "--height",
    "width": "--width",
    "height": "--width",
    "time_step": "--step",
    "duration": "--duration",
}
"""Options by the names of `KaimalTurbulence`."""
BELOW_GROUND = "the grid would reach below the ground; reduce --width or correct --height"


@click.command()
@click.argument("output", type=click.Path(dir_okay=False), metavar="OUT.bts")
@quantity("--speed", "speed", "Mean speed at the hub, such as '12 m/s'; required.", unit=True)
@quantity("--height", "length", "Height of the hub, centre of the grid; required.", unit=True)
@quantity(
    "--width", "length", "Width and height of the grid, above the diameter of the rotor; required.", unit=True
)
@quantity("--duration", "time", "Duration; default: 600 s. The wind repeats after it.", unit=True)
@quantity("--step", "time", "Time step; default: 0.1 s.", unit=True)
@quantity("--deviation", "speed", "Standard deviation, instead of that of the class.", unit=True)
@click.option(
    "--class",
    "name",
    type=click.Choice(CLASSES),
    default="IB",
    show_default=True,
    help="Class of the turbine and category of the turbulence, IEC 61400-1.",
)
@click.option("--extreme", is_flag=True, help="Extreme instead of normal turbulence of the class.")
@click.option(
    "--exponent",
    type=click.FloatRange(-1.0, 1.0),
    default=0.2,
    show_default=True,
    metavar="A",
    help="Exponent of the mean speed over the height.",
)
@click.option(
    "--points",
    type=click.IntRange(2, 200),
    default=25,
    show_default=True,
    metavar="N",
    help="Grid points across width and height.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0),
    default=1,
    show_default=True,
    metavar="N",
    help="The same seed gives the same wind.",
)
@as_json
@quiet
@debug
def wind(
    output: str, speed: float | None, height: float | None, width: float | None, as_json: bool, quiet: bool,
    **options: object,
) -> None:  # fmt: skip
    """Make turbulent wind of IEC 61400-1 and write it to OUT.bts, for `winds: {NAME: {box: OUT.bts}}`.

    Kaimal spectra and exponential coherence; the file contains the mean wind.
    """
    from pitchpoint.core.errors import ModelError
    from pitchpoint.io.target import check_target
    from pitchpoint.io.wind.turbsim import write_turbsim
    from pitchpoint.model.wind.iec import WindClass
    from pitchpoint.model.wind.steady import SteadyWind
    from pitchpoint.model.wind.turbulence import KaimalTurbulence
    from pitchpoint.solvers.turbulence.box import make_turbulence
    from pitchpoint.system.wind import add_mean

    if speed is None or height is None or width is None:
        raise click.UsageError("give --speed, --height and --width, such as '12 m/s', '90 m' and '140 m'")
    check_target(with_suffix(output, ".bts"), "turbsim")
    name = str(options["name"])
    wind_class = WindClass(name[:-1], name[-1])
    deviation = options["deviation"]
    if deviation is None:
        of_class = wind_class.extreme_deviation if options["extreme"] else wind_class.normal_deviation
        deviation = of_class(speed)
    elif options["extreme"]:
        raise click.UsageError("--deviation and --extreme both define the turbulence; omit one of them")
    try:
        turbulence = KaimalTurbulence(
            mean_speed=speed,
            deviation=float(str(deviation)),
            hub_height=height,
            size=(width, width),
            points=(int(str(options["points"])),) * 2,
            duration=float(str(options["duration"] or 600.0)),
            time_step=float(str(options["step"] or 0.1)),
        )
    except ModelError as error:
        raise ModelError(_of_options(error.problems, options["deviation"] is not None)) from None
    mean = SteadyWind(speed=speed, hub_height=height, exponent=float(str(options["exponent"])))
    box = add_mean(make_turbulence(turbulence, int(str(options["seed"]))), mean)
    target = write_turbsim(output, box)
    found = {
        "file": str(target),
        "samples": turbulence.samples,
        "deviation": turbulence.deviation,
        "largest": float(box.velocity[..., 0].max()),
        "smallest": float(box.velocity[..., 0].min()),
    }
    if as_json:
        emit_json(found)
    elif not quiet:
        show(
            f"{turbulence.samples} samples, standard deviation {turbulence.deviation:.3g} m/s, "
            f"{found['smallest']:.3g} to {found['largest']:.3g} m/s along the wind, written to {target}"
        )


def _of_options(problems: Sequence[Message], deviation: bool) -> list[Message]:
    """Problems at the options that give the values; `deviation` states whether it is given."""
    found: dict[str, Message] = {}
    for problem in problems:
        name = problem.where.rpartition(".")[2]
        if name != "deviation" or deviation:
            remedy = BELOW_GROUND if name == "height" else problem.remedy
            place = OPTIONS.get(name, "wind")
            found.setdefault(place, problem.changed(where=place, remedy=remedy))
    return list(found.values())
