# SPDX-License-Identifier: Apache-2.0
"""Terminals of shafts (FMI 3.0): the torque on a body with its angle and speed, to be connected at once."""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

from pitchpoint.io.fmu.model import FmuModel


def terminals(model: FmuModel) -> str:
    """Text of `terminalsAndIcons.xml`; empty without terminals.

    Parameters
    ----------
    model
        The model; the bodies of its torques are in `shafts`.
    """
    names = {v.name for v in model.variables}
    lines = []
    for torque, body in model.shafts:
        angle, speed = f"angle[{body}]", f"speed[{body}]"
        if {torque, angle, speed} <= names:
            members = (("tau", torque, "inflow"), ("phi", angle, "signal"), ("w", speed, "signal"))
            lines.append(f'    <Terminal name={quoteattr(torque)} matchingRule="plug">')
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
