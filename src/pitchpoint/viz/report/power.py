# SPDX-License-Identifier: Apache-2.0
"""Section of a report on power flow: drawing, numbers, power balance."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

from pitchpoint.viz.power_flow import OUTSIDE, PowerFlow, PowerLink
from pitchpoint.viz.power_flow_drawing import power_flow_svg
from pitchpoint.viz.quantities import Scale, amount, number, scale, span
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import plain_table

NEGLIGIBLE = 1e-6
"""Share of the power below which a term of the balance is omitted."""
CLOSES = 0.005
"""Relative remainder up to which a balance counts as closed."""


def power_section(flows: Mapping[str, PowerFlow | str]) -> Section:
    """Section with the power flow of each run.

    Parameters
    ----------
    flows
        Flows by name of the run, or a sentence with the reason why there is none.
    """
    section = Section("power", "Power flow")
    for name, flow in flows.items():
        section.add(f"<h3>{escape(name)}</h3>" if len(flows) > 1 else "")
        if isinstance(flow, str):
            section.add(f"<p>{escape(flow)}</p>")
            continue
        drawing = power_flow_svg(flow)
        words = f"Mean powers from {span(*flow.span, 's')}; bands are as wide as the power. {_friction(flow)}"
        section.add(
            f"<figure>{drawing}<figcaption>{escape(words.strip())}</figcaption></figure>"
            if drawing
            else "<p>No power is transmitted in this run.</p>"
        )
        section.add(f"<p>{escape(balance(flow))}</p>")
        section.add(_table(flow))
    return section


def balance(flow: PowerFlow) -> str:
    """Power balance of the machine and of the worst block, in sentences."""
    most = max((link.given for link in flow.links), default=0.0)
    parts = {
        "input": flow.put_in,
        "input by phase-dependent stiffness and static errors": flow.fed,
        "output": flow.taken_out,
        "losses": flow.lost,
        "stored in rotation and flanks": flow.stored,
    }
    words = [f"{what} {amount(p, 'W')}" for what, p in parts.items() if abs(p) > NEGLIGIBLE * most]
    share = abs(flow.remainder) / most if most else 0.0
    text = f"Balance: {', '.join(words)}; remainder {amount(flow.remainder, 'W')}"
    text += f", {number(100.0 * share, 2)} % of the largest power." if most else "."
    if flow.unfollowed:
        text += f" It includes the power exchanged with: {', '.join(flow.unfollowed)}."
    elif share > CLOSES:
        text += " It includes stiffness jumps and vibration that this sample rate does not resolve."
    return text + _blocks(flow, most)


def _blocks(flow: PowerFlow, most: float) -> str:
    """Sentence about the balance of single blocks."""
    if len(flow.blocks) < 2 or not most:
        return ""
    worst = max(range(len(flow.blocks)), key=lambda block: abs(flow.left(block)))
    left = flow.left(worst)
    if abs(left) <= NEGLIGIBLE * most:
        return f" Every block balances within {number(100.0 * NEGLIGIBLE, 2)} % of the largest power."
    return f" Largest remainder of a block: {amount(left, 'W')}, {flow.blocks[worst].name}."


def _friction(flow: PowerFlow) -> str:
    if not flow.booked:
        return ""
    return "The result does not divide friction power between the gears: it is assigned to the driving gear."


def _table(flow: PowerFlow) -> str:
    unit = scale("W", [max((link.given for link in flow.links), default=0.0)])
    lost = scale("W", [max((loss for link in flow.links for loss in link.losses.values()), default=0.0)])
    kinds = list(dict.fromkeys(word for link in flow.links for word in link.losses))
    body = []
    for link in flow.links:
        cells = "".join(
            f'<td class="num">{number(p * unit.factor, 5)}</td>' for p in (link.given, link.taken)
        )
        cells += "".join(f'<td class="num">{_loss(link, word, lost)}</td>' for word in kinds)
        body.append(
            f'<tr><th scope="row">{escape(link.name)} ({link.kind})</th>'
            f"<td>{escape(_end(flow, link.start))} → {escape(_end(flow, link.end))}</td>{cells}</tr>"
        )
    head = ["element", "from → to", f"input [{unit.unit}]", f"output [{unit.unit}]"]
    return plain_table([*head, *(f"loss, {word} [{lost.unit}]" for word in kinds)], body)


def _loss(link: PowerLink, word: str, unit: Scale) -> str:
    return number(link.losses[word] * unit.factor, 4) if word in link.losses else "–"


def _end(flow: PowerFlow, block: int) -> str:
    return "outside" if block == OUTSIDE else flow.blocks[block].name
