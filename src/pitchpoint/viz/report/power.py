# SPDX-License-Identifier: Apache-2.0
"""Section of a report on power flow: drawing, numbers, power balance."""

from __future__ import annotations

from collections.abc import Mapping
from html import escape

import numpy as np

from pitchpoint.viz.power_flow import OUTSIDE, PowerFlow, PowerLink
from pitchpoint.viz.power_flow_drawing import NEGLIGIBLE as SMALLEST
from pitchpoint.viz.power_flow_drawing import power_flow_svg, undrawn
from pitchpoint.viz.quantities import Scale, amount, number, scale, span
from pitchpoint.viz.report.page import Section
from pitchpoint.viz.same_curves import grouped
from pitchpoint.viz.tables import plain_table

NEGLIGIBLE = 1e-6
"""Share of the power below which a term of the balance is omitted."""
ALIKE = 0.002
"""Difference of two powers relative to the largest that is not visible."""
MAX_COLUMNS = 5
"""Runs next to each other in a table."""
CIRCULATES = 0.5
"""Input relative to the largest power below which the remainder is given as a share of the input, too."""
CLOSES = 0.005
"""Relative remainder up to which a balance counts as closed."""


def power_section(flows: Mapping[str, PowerFlow | str]) -> Section:
    """Section with the power flow of each run; runs with the same path of the power share a picture.

    Parameters
    ----------
    flows
        Flows by name of the run, or a sentence with the reason why there is none.
    """
    section = Section("power", "Power flow")
    for group in _same_paths(flows):
        first, flow = next(iter(group.items()))
        section.add_name(", ".join(group), flows)
        drawing = power_flow_svg(flow)
        whose = f" of {first}" if len(group) > 1 else ""
        words = f"Mean powers{whose} from {span(*flow.span, 's')}; bands are as wide as the power."
        words = f"{words} {_small(flow)} {_friction(flow)}"
        section.add(
            f"<figure>{drawing}<figcaption>{escape(' '.join(words.split()))}</figcaption></figure>"
            if drawing
            else "<p>No power is transmitted in this run.</p>"
        )
        if len(group) == 1:
            section.add(f"<p>{escape(balance(flow))}</p>{_table(flow)}")
            continue
        names = list(group)
        for k in range(0, len(names), MAX_COLUMNS):
            section.add(_common_table({name: group[name] for name in names[k : k + MAX_COLUMNS]}))
        texts = [f"{name}: {balance(one)}" for name, one in _unlike(group).items()]
        section.add(f'<ul class="notes">{"".join(f"<li>{escape(text)}</li>" for text in texts)}</ul>')
    reasons = [f"<p>{escape(flow)}</p>" for flow in flows.values() if isinstance(flow, str)]
    section.add("".join(reasons))
    return section


def _same_paths(flows: Mapping[str, PowerFlow | str]) -> list[dict[str, PowerFlow]]:
    """Flows by name, in groups with the same blocks and links in the same directions."""
    found: dict[tuple[object, ...], dict[str, PowerFlow]] = {}
    for name, flow in flows.items():
        if isinstance(flow, PowerFlow):
            links = tuple((link.name, link.kind, link.start, link.end) for link in flow.links)
            found.setdefault((tuple(b.name for b in flow.blocks), links), {})[name] = flow
    return list(found.values())


def _unlike(group: Mapping[str, PowerFlow]) -> dict[str, PowerFlow]:
    """Flows under the names of all that have the same powers within the width of a line."""
    return {", ".join(names): flow for names, flow in grouped(group, _alike)}


def _alike(one: PowerFlow, flow: PowerFlow) -> bool:
    most = max((link.given for link in flow.links), default=0.0)
    equal = all(abs(a.given - b.given) <= ALIKE * most for a, b in zip(flow.links, one.links, strict=True))
    return equal and abs(flow.lost - one.lost) <= ALIKE * max(flow.lost, one.lost)


def _common_table(group: Mapping[str, PowerFlow]) -> str:
    """Power of every element and losses of several runs, a column each."""
    columns = _unlike(group)
    powers = {name: [link.given for link in flow.links] for name, flow in columns.items()}
    unit = scale("W", [max((p for own in powers.values() for p in own), default=0.0)])
    lost = scale("W", [max(flow.lost for flow in columns.values())])
    places = _places(max((p for own in powers.values() for p in own), default=0.0) * unit.factor)
    one = next(iter(columns.values()))
    body = []
    for k, link in enumerate(one.links):
        cells = "".join(
            f'<td class="num">{_fixed(own[k] * unit.factor, places)}</td>' for own in powers.values()
        )
        body.append(
            f'<tr><th scope="row">{escape(link.name)} ({link.kind})</th>'
            f"<td>{escape(_end(one, link.start))} → {escape(_end(one, link.end))}</td>{cells}</tr>"
        )
    losses = "".join(f'<td class="num">{number(f.lost * lost.factor, 4)}</td>' for f in columns.values())
    body.append(f'<tr><th scope="row">losses, sum [{lost.unit}]</th><td></td>{losses}</tr>')
    return plain_table([f"power [{unit.unit}]", "from → to", *columns], body)


def balance(flow: PowerFlow) -> str:
    """Power balance of the machine and of the worst block, in sentences."""
    most = max((link.given for link in flow.links), default=0.0)
    parts = {
        "input": flow.put_in,
        "input by phase-dependent stiffness and static errors": flow.fed,
        "input by stiffness jumps where tooth pairs without relief enter and leave": flow.jumps,
        "output": flow.taken_out,
        "losses": flow.lost,
        "stored in rotation and deflection": flow.stored,
    }
    outside = f" ({amount(flow.damped, 'W')} by damping outside meshes and couplings)"
    more = {"losses": outside} if abs(flow.damped) > NEGLIGIBLE * most else {}
    words = [
        f"{what} {amount(p, 'W')}{more.get(what, '')}"
        for what, p in parts.items()
        if abs(p) > NEGLIGIBLE * most
    ]
    share = abs(flow.remainder) / most if most else 0.0
    text = f"Balance: {', '.join(words)}; remainder {amount(flow.remainder, 'W')}"
    text += f", {number(100.0 * share, 2)} % of the largest power" if most else ""
    if most and NEGLIGIBLE * most < flow.put_in < CIRCULATES * most:
        share = abs(flow.remainder) / flow.put_in
        text += f" and {number(100.0 * share, 2)} % of the input"
    text += "."
    if flow.unseparated:
        text += (
            f" It includes the power of the stiffness jumps of {', '.join(flow.unseparated)}, "
            "which the samples do not separate: increase sample_rate."
        )
    if flow.unfollowed:
        text += f" It includes the power exchanged with: {', '.join(flow.unfollowed)}."
    elif share > CLOSES and not flow.unseparated:
        text += " It includes vibration and impacts that this sample rate does not resolve."
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


def _small(flow: PowerFlow) -> str:
    """Sentence about powers without a band."""
    names = undrawn(flow)
    share = f"{number(100.0 * SMALLEST, 2)} % of the largest power"
    return f"Powers up to {share} are not drawn: {', '.join(names)}." if names else ""


def _friction(flow: PowerFlow) -> str:
    if not flow.booked:
        return ""
    return "The result does not divide friction power between the gears: it is assigned to the driving gear."


def _table(flow: PowerFlow) -> str:
    unit = scale("W", [max((link.given for link in flow.links), default=0.0)])
    places = _places(max((link.given for link in flow.links), default=0.0) * unit.factor)
    lost = scale("W", [max((loss for link in flow.links for loss in link.losses.values()), default=0.0)])
    kinds = list(dict.fromkeys(word for link in flow.links for word in link.losses))
    most = max((abs(link.stored) for link in flow.links), default=0.0)
    holds, kept = most > NEGLIGIBLE * flow.put_in, scale("W", [most])
    body = []
    small = 0.0
    for link in flow.links:
        # equal decimals: a small power next to a large one is not more exact
        powers = [_fixed(p * unit.factor, places) for p in (link.given, link.taken)]
        kept_words = number(link.stored * kept.factor, 4) if link.stored else "–"
        if not any(float(p.replace("−", "-")) for p in powers) and link.lost < NEGLIGIBLE * flow.put_in:
            small = max(small, link.given, link.taken)
            continue
        cells = "".join(f'<td class="num">{power}</td>' for power in powers)
        cells += "".join(f'<td class="num">{_loss(link, word, lost)}</td>' for word in kinds)
        cells += f'<td class="num">{kept_words}</td>' * int(holds)
        body.append(
            f'<tr><th scope="row">{escape(link.name)} ({link.kind})</th>'
            f"<td>{escape(_end(flow, link.start))} → {escape(_end(flow, link.end))}</td>{cells}</tr>"
        )
    head = ["element", "from → to", f"input [{unit.unit}]", f"output [{unit.unit}]"]
    head += [f"loss, {word} [{lost.unit}]" for word in kinds] + [f"stored [{kept.unit}]"] * holds
    words = f"<p>Not listed: elements with powers up to {escape(amount(small, 'W'))}.</p>" if small else ""
    return plain_table(head, body) + words


def _places(largest: float) -> int:
    """Decimals with which the largest value of a column has five digits."""
    return int(np.clip(4 - np.floor(np.log10(largest)), 0, 6)) if largest > 0.0 else 0


def _fixed(value: float, places: int) -> str:
    """Number with fixed decimals.

    Examples
    --------
    >>> _fixed(94.2478, 3), _fixed(-1e-5, 3), _fixed(-2.5, 1)
    ('94.248', '0.000', '−2.5')
    """
    text = f"{value:.{places}f}"
    return text.replace("-", "−") if float(text) else text.lstrip("-")


def _loss(link: PowerLink, word: str, unit: Scale) -> str:
    return number(link.losses[word] * unit.factor, 4) if word in link.losses else "–"


def _end(flow: PowerFlow, block: int) -> str:
    return "outside" if block == OUTSIDE else flow.blocks[block].name
