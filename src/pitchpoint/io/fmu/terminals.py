# SPDX-License-Identifier: Apache-2.0
"""Terminals of shafts (FMI 3.0): torque, angle and speed of a body, to be connected at once.

Of a load the torque is an input, of a drive the speed.
"""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

from pitchpoint.io.fmu.model import FmuModel


def terminals(model: FmuModel) -> str:
    """Text of `terminalsAndIcons.xml`; empty without terminals.

    Parameters
    ----------
    model
        The model, with its `shafts`.
    """
    names = {v.name for v in model.variables}
    lines = []
    for shaft, torque, angle, speed in model.shafts:
        if {torque, angle, speed} <= names:
            members = (("tau", torque, "inflow"), ("phi", angle, "signal"), ("w", speed, "signal"))
            lines.append(f'    <Terminal name={quoteattr(shaft)} matchingRule="plug">')
            lines += [
                f"      <TerminalMemberVariable variableName={quoteattr(variable)} "
                f'memberName="{member}" variableKind="{kind}"/>'
                for member, variable, kind in members
            ]
            lines.append("    </Terminal>")
    if not lines:
        return ""
    head = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<fmiTerminalsAndIcons fmiVersion="3.0">',
        "  <Terminals>",
    ]
    return "\n".join([*head, *lines, "  </Terminals>", "</fmiTerminalsAndIcons>"]) + "\n"
