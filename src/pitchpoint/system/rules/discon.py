# SPDX-License-Identifier: Apache-2.0
"""Controller libraries with the interface of Bladed as sampled controllers of a system."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from pitchpoint.core.discon.process import ControllerError, Discon
from pitchpoint.core.discon.records import find_record
from pitchpoint.elements.signals.net import SignalNet
from pitchpoint.elements.signals.record import UNITS
from pitchpoint.model.components.controller import DisconController, inputs_of, outputs_of
from pitchpoint.system.controller import SampledController

PROCESS = "process"
"""Key of the process in the state of a controller."""


@dataclass(frozen=True)
class LibraryLaw:
    """Function of a sampled controller that calls a library; the process is in the state of the run.

    Parameters
    ----------
    name
        Name of the controller, default of the name of output files.
    part
        The controller of the model.
    """

    name: str
    part: DisconController

    def __call__(self, t: float, inputs: Any, state: dict[str, Any], _: Any) -> list[float]:
        """Call the library; the first call of a run starts its process."""
        part = self.part
        if PROCESS not in state:
            state[PROCESS] = self._begin()
        process = state[PROCESS]
        values = iter(inputs)
        for record, given in part.inputs.items():
            process[record] = float(next(values)) if isinstance(given, str) else given
        process.call(t)
        return [process[record] for record in part.outputs]

    def _begin(self) -> Discon:
        part = self.part
        process = Discon(
            part.library,
            part.input_file or "",
            outname=part.output_name or f"{self.name}.out",
            procedure=part.procedure,
            blades=part.blades,
            interval=part.period,
            timeout=part.timeout,
            torque_table=part.torque_table or (),
        )
        process["pitch_control"] = float(part.pitch_control == "individual")
        process["pitch_actuator"] = float(part.pitch_actuator == "rate")
        process["yaw_control"] = float(part.yaw_control == "torque")
        for record, output in part.outputs.items():
            if output in part.start:
                process[record] = part.start[output]
        return process


def finish(state: dict[str, Any]) -> tuple[str, ...]:
    """Make the last call of a library and end its process; returns what the library reported."""
    process = state.pop(PROCESS, None)
    if process is None:
        return ()
    reports = [f"reports: {text}" for text in process.messages]
    try:
        process.close()
    except ControllerError as error:
        reports.append(f"{error} (at the last call)")
    return tuple(reports)


def discon_controller(net: SignalNet, name: str, part: DisconController) -> SampledController:
    """Sampled controller of a library, with its output signals.

    Parameters
    ----------
    net
        Receives the output signals.
    name
        Name of the controller.
    part
        The controller of the model.
    """
    for record, output in part.outputs.items():
        found = find_record(record)
        unit = found.unit if found is not None and found.unit in UNITS else "1"
        net.held(output, part.start.get(output, 0.0), unit)
    return SampledController(
        name,
        LibraryLaw(name, part),
        inputs_of(part),
        outputs_of(part),
        part.period,
        part.delay,
        {},
        finish=finish,
    )
