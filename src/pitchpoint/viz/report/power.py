# SPDX-License-Identifier: Apache-2.0
"""The section of a report about power: a drawing of its flow, the numbers, and how well they close."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

from pitchpoint.viz.power_flow import OUTSIDE, PowerFlow, PowerLink
from pitchpoint.viz.power_flow_drawing import power_flow_svg
from pitchpoint.viz.quantities import Scale, amount, number, scale, span
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.tables import plain_table

NEGLIGIBLE = 1e-6
"""Share of the power below which a part of a balance is not worth a word."""
CLOSES = 0.005
"""Share of the power up to which a balance counts as closed."""


def power_section(flows: Mapping[str, PowerFlow | str]) -> Section:
    """Where the power of each run goes.

    Parameters
    ----------
    flows
        Flows by the name of the run, or a sentence that states why there is none.
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
            else "<p>No power flows in this run.</p>"
        )
        section.add(f"<p>{escape(balance(flow))}</p>")
        section.add(_table(flow))
    return section


def balance(flow: PowerFlow) -> str:
    """What comes in, what goes out and what is left, of the whole and of the worst block, in sentences."""
    most = max((link.given for link in flow.links), default=0.0)
    parts = {
        "put in": flow.put_in,
        "fed in by what moves with the mesh phase": flow.fed,
        "taken out": flow.taken_out,
        "lost": flow.lost,
        "into rotation and flanks": flow.stored,
    }
    words = [f"{what} {amount(p, 'W')}" for what, p in parts.items() if abs(p) > NEGLIGIBLE * most]
    share = abs(flow.remainder) / most if most else 0.0
    text = f"Balance: {', '.join(words)}; remainder {amount(flow.remainder, 'W')}"
    text += f", {number(100.0 * share, 2)} % of the largest power." if most else "."
    if flow.unfollowed:
        text += f" It holds what these take or give: {', '.join(flow.unfollowed)}."
    elif share > CLOSES:
        text += " It holds jumps of the stiffness and vibration that samples of this rate do not show."
    return text + _blocks(flow, most)


def _blocks(flow: PowerFlow, most: float) -> str:
    """How well single blocks close."""
    if len(flow.blocks) < 2 or not most:
        return ""
    worst = max(range(len(flow.blocks)), key=lambda block: abs(flow.left(block)))
    left = flow.left(worst)
    if abs(left) <= NEGLIGIBLE * most:
        return f" Every block closes by itself, to {number(100.0 * NEGLIGIBLE, 2)} % of the largest power."
    return f" Of single blocks {flow.blocks[worst].name} leaves most: {amount(left, 'W')}."


def _friction(flow: PowerFlow) -> str:
    if not flow.booked:
        return ""
    return "The result does not state what friction does to each gear: it counts for the one that drives."


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
    head = ["element", "from → to", f"given [{unit.unit}]", f"taken [{unit.unit}]"]
    return plain_table([*head, *(f"lost to {word} [{lost.unit}]" for word in kinds)], body)


def _loss(link: PowerLink, word: str, unit: Scale) -> str:
    return number(link.losses[word] * unit.factor, 4) if word in link.losses else "–"


def _end(flow: PowerFlow, block: int) -> str:
    return "outside" if block == OUTSIDE else flow.blocks[block].name
