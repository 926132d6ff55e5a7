# SPDX-License-Identifier: Apache-2.0
"""From the stiffness law of a model file to a stiffness description."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from pitchpoint.contact.stiffness.description import Description, PairShape
from pitchpoint.model.components import stiffness as laws

if TYPE_CHECKING:
    from pitchpoint.contact.stiffness.din3990 import SingleStiffness
    from pitchpoint.core.user_law import UserLaw
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.law import PythonLaw
    from pitchpoint.model.model import Model

N_TRIES = 1024
"""Mesh phases at which a user's stiffness law is called once before anything is computed with it."""


def gear_blank_factor(gear: Gear) -> float:
    """C_R of one gear; 1 without rim and web."""
    from pitchpoint.contact.stiffness.din3990 import blank_factor

    if gear.rim_thickness is None and gear.web_thickness is None:
        return 1.0
    web = 1.0 if gear.web_thickness is None else gear.web_thickness / gear.face_width
    rim = 1.0 if gear.rim_thickness is None else gear.rim_thickness / gear.normal_module
    return blank_factor(web, rim)


def _options(model: Model, mesh: str) -> dict[str, Any]:
    gears = [model.gears[g] for g in model.meshes[mesh].gears]
    law = model.meshes[mesh].stiffness
    teeth = law.virtual_teeth if isinstance(law, laws.Din3990) else "iso"
    moduli = tuple(g.material_data.youngs_modulus for g in gears)
    return {
        "C_R": min(gear_blank_factor(g) for g in gears),
        "moduli": moduli,
        "virtual_teeth_formula": teeth,
    }


def single_stiffness_of(model: Model, mesh: str) -> SingleStiffness:
    """Single and mesh stiffness of a mesh by DIN 3990 / ISO 6336-1, with the factors of its gears."""
    from pitchpoint.contact.stiffness.din3990 import single_stiffness

    return single_stiffness(model.pairs[mesh], **_options(model, mesh))


def describe_stiffness(model: Model, mesh: str) -> Description:
    """Stiffness description of a mesh, by the law that its model names."""
    from pitchpoint.contact.stiffness import REGISTRY

    law = model.meshes[mesh].stiffness
    pair = model.pairs[mesh]
    source = REGISTRY[law.law].function if law.law in REGISTRY else None
    if isinstance(law, laws.PairTable):
        return PairShape(c_prime=law.single_stiffness, T_R=law.tip_relief_factor, table=np.array(law.values))
    assert source is not None  # the model layer knows no other law
    if isinstance(law, laws.Din3990):
        options = _options(model, mesh) | {"c_prime": law.single_stiffness, "low_load": law.low_load}
        return source(pair, S_R=law.stiffness_ratio, T_R=law.tip_relief_factor, **options)
    if isinstance(law, laws.Energy):
        return source(pair, T_R=law.tip_relief_factor, **_energy_options(model, mesh, law))
    if isinstance(law, laws.Hertz):
        return source(pair, **_hertz_options(model, mesh, law))
    if isinstance(law, laws.ConstantStiffness):
        return source(pair, mean=law.value)
    if isinstance(law, laws.Rectangular):
        return source(pair, high=law.high, low=law.low, duty=law.duty)
    if isinstance(law, laws.Fourier):
        return source(pair, mean=law.mean, cosine=law.cosine, sine=law.sine)
    if isinstance(law, laws.Table):
        return source(pair, values=law.values)
    own = user_law(law.python, f"meshes.{mesh}.stiffness.python")
    _try(own)
    return source(pair, function=lambda psi: own(0.0, psi))


def _try(law: UserLaw) -> None:
    """Go once through the mesh cycle: a law that fails is a failed computation, not a wrong file."""
    from pitchpoint.core.errors import SolverError
    from pitchpoint.core.status import NOT_FINITE, REFUSED

    for k in range(N_TRIES):
        said = law.diagnose(0.0, k / N_TRIES)
        if said:
            raise SolverError(f"{said} (mesh phase {k / N_TRIES:.4f})", NOT_FINITE)
        value = law(0.0, k / N_TRIES)
        if value <= 0.0:
            raise SolverError(
                f"{law.source} gives {value:.6g} N/m (mesh phase {k / N_TRIES:.4f}); a stiffness is > 0",
                REFUSED,
            )


def _hertz_options(model: Model, mesh: str, law: laws.Hertz) -> dict[str, Any]:
    materials = [model.gears[g].material_data for g in model.meshes[mesh].gears]
    given = law.force is not None and law.depth is not None
    return {
        "moduli": tuple(m.youngs_modulus for m in materials),
        "poisson": tuple(m.poisson_ratio for m in materials),
        "diameter": law.diameter,
        "constant": law.force / law.depth**law.exponent if given else None,  # type: ignore[operator]
        "exponent": law.exponent,
        "T_R": law.tip_relief_factor,
    }


def _energy_options(model: Model, mesh: str, law: laws.Energy) -> dict[str, Any]:
    gears = [model.gears[g] for g in model.meshes[mesh].gears]
    materials = [g.material_data for g in gears]
    return {
        "moduli": tuple(m.youngs_modulus for m in materials),
        "poisson": tuple(m.poisson_ratio for m in materials),
        "bores": tuple(g.bore_diameter or None for g in gears),
        "body": "load_line" if law.body else "rigid",
    }


def user_law(law: PythonLaw, where: str) -> UserLaw:
    """Load a user's Python law; the loader of the model has asked for permission already.

    Parameters
    ----------
    law
        File, function and parameters.
    where
        Place in the model that names it, for messages.

    Raises
    ------
    ModelError
        If there is no such file or function, or it takes other arguments.
    """
    from pitchpoint.core.user_law import load_user_law

    path = Path(law.file)
    reference = f"{path.name}:{law.function}"
    return load_user_law(reference, path.parent, allow_code=True, parameters=law.parameters, where=where)
