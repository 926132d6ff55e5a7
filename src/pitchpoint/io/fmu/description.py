# SPDX-License-Identifier: Apache-2.0
"""Model description of a functional mock-up unit, `modelDescription.xml`, of FMI 2.0 and 3.0."""

from __future__ import annotations

import math
from collections.abc import Iterable
from xml.sax.saxutils import quoteattr

from pitchpoint.core.unit_expression import parse_unit
from pitchpoint.io.fmu.model import CAUSALITIES, INDICATOR, OUTPUT, SLOPE, STATE, TIME, FmuModel, Variable

_ANGLES = ("rad", "rad/s", "rad/s^2")
"""Units in which the radian is a base unit of its own; in stiffness and torque it is 1."""


def description(model: FmuModel, version: int) -> str:
    """Text of `modelDescription.xml`.

    Parameters
    ----------
    model
        The model.
    version
        2 or 3.
    """
    root = "guid" if version == 2 else "instantiationToken"
    attributes = {
        "fmiVersion": f"{version}.0",
        "modelName": model.title or model.name,
        root: model.token,
        "generationTool": "pitchpoint",
        "variableNamingConvention": "flat",
    }
    if version == 2:
        attributes["numberOfEventIndicators"] = str(len(model.indicators) if model.exchanges else 0)
    structure = _structure_2(model) if version == 2 else _structure_3(model)
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f"<fmiModelDescription{_attributes(attributes)}>",
        *_interfaces(model, version),
        "  <UnitDefinitions>",
        *_units(model.variables),
        "  </UnitDefinitions>",
        "  <LogCategories>",
        '    <Category name="logStatusWarning"/>',
        '    <Category name="logStatusError"/>',
        "  </LogCategories>",
        f"  <DefaultExperiment{_attributes(_experiment(model))}/>",
        "  <ModelVariables>",
        *(_variable(model, k, version) for k in references(model, version)),
        "  </ModelVariables>",
        "  <ModelStructure>",
        *structure,
        "  </ModelStructure>",
        "</fmiModelDescription>",
    ]
    return "\n".join(lines) + "\n"


def references(model: FmuModel, version: int) -> list[int]:
    """Value references of the variables in the description, in its order."""
    hidden = {TIME, INDICATOR} if version == 2 else set()
    hidden |= set() if model.exchanges else {STATE, SLOPE, INDICATOR}
    return [k for k, variable in enumerate(model.variables) if variable.kind not in hidden]


def _attributes(values: dict[str, str]) -> str:
    return "".join(f" {name}={quoteattr(value)}" for name, value in values.items())


def _experiment(model: FmuModel) -> dict[str, str]:
    return {
        "startTime": repr(model.reals["t0"]),
        "stopTime": repr(model.stop),
        "stepSize": repr(model.sample),
    }


def _interfaces(model: FmuModel, version: int) -> list[str]:
    """Elements of the kinds of simulation."""
    word = "FMUstate" if version == 2 else "FMUState"
    both = {
        "modelIdentifier": model.name,
        f"canGetAndSet{word}": "true",
        f"canSerialize{word}": "true",
    }
    co = f'  <CoSimulation{_attributes(both)} canHandleVariableCommunicationStepSize="true"/>'
    provided = {f"providesDirectionalDerivative{'s' if version == 3 else ''}": "true"}
    return [f"  <ModelExchange{_attributes({**both, **provided})}/>", co] if model.exchanges else [co]


def _units(variables: Iterable[Variable]) -> list[str]:
    """Definitions of the units in base units."""
    lines = []
    for name in sorted({v.unit for v in variables} - {"1"}):
        unit = parse_unit(name)
        powers = {"kg": unit.kg, "m": unit.m, "s": unit.s, "K": unit.K, "rad": int(name in _ANGLES)}
        base = {key: str(power) for key, power in powers.items() if power}
        base |= {"factor": repr(float(unit.factor))} if unit.factor != 1 else {}
        lines.append(f"    <Unit name={quoteattr(name)}><BaseUnit{_attributes(base)}/></Unit>")
    return lines


def _variable(model: FmuModel, reference: int, version: int) -> str:
    """Element of a variable."""
    v = model.variables[reference]
    head = {"name": v.name, "valueReference": str(reference), "description": v.text}
    head |= {"causality": CAUSALITIES[v.kind], "variability": "tunable" if v.is_fixed else "continuous"}
    if not v.is_set and v.kind != TIME:
        head["initial"] = "exact" if v.kind == STATE else "calculated"
    more = {"unit": v.unit} if v.unit != "1" else {}
    more |= {"start": repr(v.start)} if v.is_set or v.kind == STATE else {}
    limits = {"min": v.least, "max": v.most}
    more |= {word: repr(limit) for word, limit in limits.items() if math.isfinite(limit)}
    if v.kind == SLOPE:
        state = model.of_kind(STATE)[v.first]
        more["derivative"] = str(references(model, 2).index(state) + 1 if version == 2 else state)
    if version == 2:
        return f"    <ScalarVariable{_attributes(head)}><Real{_attributes(more)}/></ScalarVariable>"
    return f"    <Float64{_attributes({**head, **more})}/>"


def _structure_2(model: FmuModel) -> list[str]:
    """Outputs, derivatives and initial unknowns by their positions from 1."""
    place = {reference: k for k, reference in enumerate(references(model, 2), start=1)}

    def group(name: str, kinds: tuple[int, ...]) -> list[str]:
        """One group of unknowns."""
        found = sorted(place[k] for kind in kinds for k in model.of_kind(kind) if k in place)
        rows = [f'      <Unknown index="{k}"/>' for k in found]
        return [f"    <{name}>", *rows, f"    </{name}>"] if rows else []

    return [
        *group("Outputs", (OUTPUT,)),
        *group("Derivatives", (SLOPE,)),
        *group("InitialUnknowns", (OUTPUT, SLOPE)),
    ]


def _structure_3(model: FmuModel) -> list[str]:
    """Outputs, derivatives, initial unknowns and event indicators by their value references."""
    groups: list[tuple[str, tuple[int, ...]]] = [("Output", (OUTPUT,)), ("InitialUnknown", (OUTPUT,))]
    if model.exchanges:
        groups = [
            ("Output", (OUTPUT,)),
            ("ContinuousStateDerivative", (SLOPE,)),
            ("InitialUnknown", (OUTPUT, SLOPE)),
            ("EventIndicator", (INDICATOR,)),
        ]
    return [
        f'    <{name} valueReference="{k}"/>'
        for name, kinds in groups
        for kind in kinds
        for k in model.of_kind(kind)
    ]
