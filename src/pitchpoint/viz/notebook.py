# SPDX-License-Identifier: Apache-2.0
"""Display of gears, pairs and models in notebooks: a drawing and a short table.

`geometry` and `model` do not depend on plots. The package attaches `_repr_html_` to their classes when its
first public name is imported, so all notebooks that support this method display them.
`pitchpoint.report.notebook` registers further formatters with IPython, which add the scene.
"""

from __future__ import annotations

import sys
from typing import Any

# module and class -> function of this module that returns its HTML
SHOWN = {
    ("pitchpoint.geometry.cylindrical_gear", "CylindricalGear"): "gear_html",
    ("pitchpoint.geometry.gear_pair", "GearPair"): "pair_html",
    ("pitchpoint.geometry.bevel.gear", "BevelGear"): "bevel_gear_html",
    ("pitchpoint.geometry.bevel.pair", "BevelPair"): "bevel_pair_html",
    ("pitchpoint.model.components.gear", "Gear"): "component_html",
    ("pitchpoint.model.components.bevel_gear", "BevelGear"): "bevel_component_html",
    ("pitchpoint.model.model", "Model"): "model_html",
}
# Notebooks centre row headings and set them in bold; these tables override this.
STYLE = (
    "<style>.pp-shown table th,.pp-shown table td{font-weight:400;text-align:left!important}"
    ".pp-shown table .num{text-align:right!important}"
    ".pp-shown .pp-row{display:flex;flex-wrap:wrap;gap:16px}"
    ".pp-shown .pp-row>*{flex:1 1 300px;max-width:480px}"
    "</style>"
)


def _framed(*parts: str) -> str:
    inner = "".join(f"<div>{part}</div>" for part in parts)
    return f'{STYLE}<div class="pp-shown"><div class="pp-row">{inner}</div></div>'


def attach() -> None:
    """Attach `_repr_html_` to the imported classes of gears and pairs; models define it themselves."""
    for (module, name), function in SHOWN.items():
        shown = getattr(sys.modules.get(module), name, None)
        if shown is not None and not hasattr(shown, "_repr_html_"):
            shown._repr_html_ = globals()[function]


def gear_html(gear: Any) -> str:
    """Drawing, teeth with their tool, and data of a gear."""
    from pitchpoint.viz.gear_drawing import gear_svg
    from pitchpoint.viz.tables import GEAR_ROWS, quantity_table
    from pitchpoint.viz.tooth_drawing import tooth_svg

    name = "internal gear" if gear.z < 0 else "gear"
    table = quantity_table(GEAR_ROWS, {name: _known(gear, GEAR_ROWS)})
    teeth = f'<div style="max-width:820px">{tooth_svg(gear, name=name)}</div>'
    return _framed(gear_svg(gear, name=name), table) + teeth


def component_html(gear: Any) -> str:
    """Drawing and data of a gear of a model."""
    return gear_html(gear.geometry)


def pair_html(pair: Any) -> str:
    """Both gears in mesh, the mesh zone and the data of the pair."""
    from pitchpoint.viz.gear_drawing import mesh_zone_svg, pair_svg
    from pitchpoint.viz.tables import MESH_ROWS, quantity_table

    table = quantity_table(MESH_ROWS, {"pair": _known(pair, MESH_ROWS)})
    return _framed(pair_svg(pair), mesh_zone_svg(pair)) + _framed(table)


def bevel_gear_html(gear: Any) -> str:
    """Data of a bevel gear."""
    from pitchpoint.viz.tables import BEVEL_GEAR_ROWS, quantity_table

    return _framed(quantity_table(BEVEL_GEAR_ROWS, {"bevel gear": _known(gear, BEVEL_GEAR_ROWS)}))


def bevel_component_html(gear: Any) -> str:
    """Data of a bevel gear of a model."""
    return bevel_gear_html(gear.geometry)


def bevel_pair_html(pair: Any) -> str:
    """Data of a pair of bevel gears, and of each of them."""
    from pitchpoint.viz.tables import BEVEL_GEAR_ROWS, BEVEL_MESH_ROWS, quantity_table

    gears = {f"gear {k}": _known(gear, BEVEL_GEAR_ROWS) for k, gear in enumerate((pair.gear1, pair.gear2), 1)}
    both = quantity_table(BEVEL_GEAR_ROWS, gears)
    return _framed(quantity_table(BEVEL_MESH_ROWS, {"pair": _known(pair, BEVEL_MESH_ROWS)}), both)


def model_html(model: Any) -> str:
    """Tables of a model, and a drawing of each gear pair."""
    from pitchpoint.viz.gear_drawing import pair_svg

    drawings = [pair_svg(pair, names=tuple(model.meshes[name].gears)) for name, pair in model.pairs.items()]
    return model._repr_html_() + (_framed(*drawings) if drawings else "")


def _known(thing: Any, identifiers: tuple[str, ...]) -> dict[str, Any]:
    """Data of a gear or pair, without quantities that do not apply to it."""
    from pitchpoint.core.errors import PitchpointError

    found: dict[str, Any] = {}
    for key in identifiers:
        try:
            value = getattr(thing, key, None)
        except PitchpointError:
            continue
        if isinstance(value, int | float) and not isinstance(value, bool):
            # ISO 21771 uses negative values for internal gears; the tables do not. The signs of backlash
            # and of the crown of bevel gears are significant.
            found[key] = value if key.startswith(("x", "beta", "j_m", "t_xo")) else abs(value)
    return found
