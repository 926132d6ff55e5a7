# SPDX-License-Identifier: Apache-2.0
"""The model: data from drawings and data sheets, immutable and validated."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn, TypeVar

from pitchpoint.core.errors import Message, ModelError
from pitchpoint.model import sections
from pitchpoint.model.bevel_places import assemble_bevels, bevel_gap, bevel_pair
from pitchpoint.model.checks.gear_pairs import gap
from pitchpoint.model.checks.python_components import recheck
from pitchpoint.model.checks.validate import check
from pitchpoint.model.component import without_arrays
from pitchpoint.model.finish import finish
from pitchpoint.model.inertia import BodyInertia, body_inertia
from pitchpoint.model.keys import Place, defaults_of, derived, keys_of
from pitchpoint.model.mechanism import Mechanism
from pitchpoint.model.origin import Origin
from pitchpoint.model.parameters import resolve
from pitchpoint.model.parts import Parts, carriers_of
from pitchpoint.model.phasing import Phasing, assemble
from pitchpoint.model.reading.reader import Reader
from pitchpoint.model.replace import changed_parts
from pitchpoint.model.scenario import Scenario
from pitchpoint.model.sections import GROUPS, Contents
from pitchpoint.model.shafts import station_names, stations_of
from pitchpoint.model.show import dotted
from pitchpoint.model.speed_ratios import start_speeds, sweep_meshes
from pitchpoint.model.write import yaml_text

if TYPE_CHECKING:
    from pitchpoint.core.formula.formula import Amount
    from pitchpoint.geometry.bevel.pair import BevelPair
    from pitchpoint.geometry.gear_pair import GearPair
    from pitchpoint.model.components.bevel_gear import BevelGear
    from pitchpoint.model.components.bevel_mesh import BevelMesh
    from pitchpoint.model.components.gear import Gear
    from pitchpoint.model.components.mesh import Mesh

V = TypeVar("V")


class Frozen(dict[str, V]):
    """An immutable dictionary."""

    def _refuse(self, *_: Any, **__: Any) -> NoReturn:
        raise TypeError("a model is frozen; use model.replace(path, value)")

    __setitem__ = __delitem__ = update = pop = popitem = clear = setdefault = _refuse
    __ior__ = _refuse

    def _ipython_key_completions_(self) -> list[str]:
        """Names for the completion of `model.gears["`."""
        return list(self)

    def __reduce__(self) -> tuple[type, tuple[dict[str, V]]]:
        return type(self), (dict(self),)


@sections.extensible
@dataclass(frozen=True, kw_only=True)
class Model(Contents):
    """Gears, bodies, meshes, supports, loads and scenarios of one machine.

    The constructor validates the model and reports all problems in one `ModelError`. All values are in SI
    units and radians.
    """

    others: Mapping[str, Mapping[str, Any]] = dataclasses.field(
        default_factory=dict, repr=False, metadata={"later": True}
    )
    """Sections of other packages, also available as attributes."""
    file: str | None = derived()
    """Path of the model file."""
    lines: Mapping[Place, int] | None = derived()
    """Line numbers of the keys in the model file, counted from 1."""
    changed: bool | None = derived()
    """Whether values were replaced after reading: the file no longer describes the model."""
    allow_code: bool = derived(False)
    """Whether Python functions were permitted when the model was read; `replace` then permits them too."""
    origin: Origin = derived(Origin())
    """Formulas with parameters and numbers without unit as written, included files."""
    pairs: Mapping[str, GearPair] = derived()
    """Gear pair of every mesh at its centre distance, with the common face width."""
    mechanism: Mechanism = derived()
    """Kinematic tree of the bodies and the cut joints."""

    def __post_init__(self) -> None:
        report = Reader(
            allow_code=self.allow_code,
            directory=self.directory,
            sources=dict(self.origin.sources),
            bare=list(self.origin.bare),
        )
        for name in self.others:
            if sections.find(name) is None:
                report.unknown({name: None}, keys_of(type(self)), ())
        values, names = finish(self, report)
        self._set_others({n: part for n, part in values.items() if sections.is_other(n)})
        for name, value in values.items():
            if not sections.is_other(name):
                frozen = Frozen(value) if isinstance(value, Mapping) else value
                object.__setattr__(self, name, frozen)
        object.__setattr__(self, "origin", dataclasses.replace(self.origin, sources=report.sources))
        unread = len(report.problems)
        recheck(self, (), report)
        if len(report.problems) > unread:  # of a wrong type: other checks may fail
            raise ModelError(report.problems, self.file)
        parts = self._parts()
        parts.names = names
        check(parts, report)
        if report.problems:
            raise ModelError(report.problems, self.file)
        self._settle(parts)

    @classmethod
    def from_parts(
        cls,
        parts: Parts,
        keys: Mapping[str, Any],
        file: str | None = None,
        lines: Mapping[Place, int] | None = None,
        *,
        allow_code: bool = False,
        origin: Origin | None = None,
    ) -> Model:
        """Create a model from parts that `validate.check` has completed without problems.

        Parameters
        ----------
        parts
            The parts.
        keys
            Values of the keys that are not sections; defaults if omitted.
        file, lines, allow_code, origin
            As in the class.
        """
        model = object.__new__(cls)
        given = {**defaults_of(cls), **keys}
        plain = {n: v for n, v in given.items() if n not in GROUPS and not sections.is_other(n)}
        own = {
            "file": file,
            "lines": lines,
            "changed": None,
            "damping": parts.damping,
            "allow_code": allow_code,
            "origin": origin or Origin(),
        }
        for name, value in {**plain, **own}.items():
            object.__setattr__(model, name, value)
        model._settle(parts)
        return model

    def _settle(self, parts: Parts) -> None:
        for group in (*GROUPS, "pairs"):
            object.__setattr__(self, group, Frozen(getattr(parts, group)))
        self._set_others(parts.others)
        object.__setattr__(self, "parameters", Frozen(self.parameters))
        object.__setattr__(self, "mechanism", parts.mechanism)

    def _set_others(self, others: Mapping[str, Mapping[str, Any]]) -> None:
        found = {name: Frozen(part) for name, part in others.items() if part}
        object.__setattr__(self, "others", Frozen(found))
        for name, part in found.items():  # attributes; empty ones are of the class, see `sections.extensible`
            object.__setattr__(self, name, part)

    def _parts(self) -> Parts:
        keys = (*sections.groups_of(self), "damping", "housing", "lubricant", "load_case")
        parts = Parts.of({name: getattr(self, name) for name in keys})
        parts.mechanism = self.mechanism or parts.mechanism
        return parts

    def replace(self, path: str, value: Any, *, allow_code: bool | None = None) -> Model:
        """New model with one value changed; all derived data are updated.

        Parameters
        ----------
        path
            Dotted path of the keys of a file, such as "gears.pinion.profile_shift_coefficient", or
            "parameters.NAME": all values with this parameter are then read again.
        value
            A value as in a file (number in SI, text with unit, mapping), or a component; None removes an
            optional key, or a component such as "loads.input".
        allow_code
            Whether the value may name a Python function; None: as when the model was read.

        Raises
        ------
        ModelError
            If the key does not exist, the value cannot be read, or the changed model is invalid.
        """
        return self.replace_all({path: value}, allow_code=allow_code)

    def replace_all(self, changes: Mapping[str, Any], *, allow_code: bool | None = None) -> Model:
        """New model with several values changed together; only the final model must be valid.

        Parameters
        ----------
        changes
            New values by path, both as in `replace`.
        allow_code
            As in `replace`.

        Raises
        ------
        ModelError
            With all paths that do not exist and values that cannot be read, or with the problems of the
            changed model.
        """
        code = self.allow_code if allow_code is None else allow_code
        report = Reader(
            allow_code=code,
            directory=self.directory,
            parameters=self.amounts,
            materials=self.materials,
            sources=dict(self.origin.sources),
            bare=list(self.origin.bare),
        )
        plain = {path: without_arrays(value) for path, value in changes.items()}
        tops = changed_parts(self, plain, report)
        others = {name: tops.pop(name) for name in list(tops) if sections.is_other(name)}
        known = self.origin.bare
        new = tuple(f"{path}." for path in changes)
        bare = tuple(
            b if b in known and not f"{dotted(b.place)}.".startswith(new) else b._replace(in_file=False)
            for b in report.bare
        )
        origin = dataclasses.replace(self.origin, sources=report.sources, bare=bare)
        return dataclasses.replace(
            self, **tops, others={**self.others, **others}, changed=True, origin=origin
        )

    @property
    def directory(self) -> str:
        """Directory of relative file names."""
        return str(Path(self.file).parent) if self.file else "."

    # --- derived data ----------------------------------------------------------------------------------
    def line(self, place: Place) -> int | None:
        """Line of a key in the model file, such as ("loads", "push"); None if not in a file."""
        return self._all_lines.get(place)

    def line_of(self, where: str) -> int | None:
        """Line of a key by its dotted path, or of the nearest enclosing key; None without a file."""
        places = self._lines_by_path
        while where and where not in places:
            where = where.rpartition(".")[0]
        return places.get(where)

    @cached_property
    def _lines_by_path(self) -> dict[str, int]:
        return {dotted(place): line for place, line in self._all_lines.items()}

    @cached_property
    def _all_lines(self) -> dict[tuple[Any, ...], int]:
        """Lines of the keys of the file, and of the components of planetary stages and scissor gears."""
        from pitchpoint.model.planetary_stages import lines_of_planets
        from pitchpoint.model.scissor_gears import lines_of_free_halves

        lines = self.lines or {}
        planets = lines_of_planets(self.planetary_stages, lines)
        return {**dict(planets), **dict(lines_of_free_halves(self, lines)), **lines}

    def backlash(self, mesh: str) -> float:
        """Backlash along the base tangent at the centre distance [m]: as given, or from geometry.

        For a bevel mesh at the mean cone distance.
        """
        if mesh in self.bevel_meshes:
            return bevel_gap(self.bevel_pairs[mesh], self.bevel_meshes[mesh])
        return gap(self.pairs[mesh], self.meshes[mesh])

    @cached_property
    def amounts(self) -> dict[str, Amount]:
        """SI value and unit of every parameter."""
        return resolve(self.parameters, Reader())

    @cached_property
    def phasing(self) -> Phasing:
        """Angular positions of the gears as assembled, see `pitchpoint.model.phasing`."""
        return assemble(self.gears, self.meshes)

    @property
    def toothed(self) -> dict[str, Gear | BevelGear]:
        """All cylindrical and bevel gears; their names are unique."""
        return {**self.gears, **self.bevel_gears}

    @property
    def every_mesh(self) -> dict[str, Mesh | BevelMesh]:
        """All meshes of cylindrical and bevel gears; their names are unique."""
        return {**self.meshes, **self.bevel_meshes}

    def section_of(self, mesh: str) -> str:
        """Section of the file that contains a mesh."""
        return "meshes" if mesh in self.meshes else "bevel_meshes"

    @cached_property
    def bevel_pairs(self) -> dict[str, BevelPair]:
        """Gear pair of every bevel mesh."""
        return {name: bevel_pair(self, mesh) for name, mesh in self.bevel_meshes.items()}

    @cached_property
    def bevel_angles(self) -> dict[str, float]:
        """Angle from the x axis of the body to the centre of tooth 0 of every bevel gear at zero spin
        [rad]."""
        return assemble_bevels(self)

    def body_of(self, gear: str) -> str | None:
        """Name of the body of a gear; None for a gear without body."""
        return self._carriers.get(gear)

    @cached_property
    def _carriers(self) -> dict[str, str]:
        return carriers_of(self.bodies)

    def body_inertia(self, body: str) -> BodyInertia:
        """Mass and moments of inertia of a body, as given or summed over its gears."""
        return body_inertia(self.bodies[body], self.gears, self.bevel_gears)

    def start_speeds(self, scenario: str | Scenario) -> dict[str, float]:
        """Initial speed of every body in a scenario [rad/s], from the gear ratios.

        All stations of a shaft start with its speed.
        """
        chosen = self.scenarios[scenario] if isinstance(scenario, str) else scenario
        found = start_speeds(self._parts(), chosen.speed, chosen.hold, chosen.engaged)[0]
        for name, places in self.stations.items():
            found |= dict.fromkeys(station_names(name, len(places)), found[name])
        return found

    @cached_property
    def stations(self) -> dict[str, tuple[float, ...]]:
        """Positions of the stations of every shaft, from its start [m]."""
        return stations_of(self)

    def sweep_mesh(self, scenario: str | Scenario) -> str:
        """Mesh whose mesh frequency a sweep refers to."""
        chosen = self.scenarios[scenario] if isinstance(scenario, str) else scenario
        if chosen.sweep is None:
            raise ModelError([Message("scenarios", "is not a sweep", remedy="name a scenario with sweep")])
        meshes = sweep_meshes(self._parts(), chosen.sweep.body)
        return chosen.sweep.mesh or next(iter(meshes))

    @classmethod
    def from_dict(cls, data: Mapping[str, Any], *, allow_code: bool = False) -> Model:
        """Create a model from nested mappings, as in a file.

        Parameters
        ----------
        data
            Sections and keys as in a file; components may also be objects.
        allow_code
            Accept entries that name Python functions.

        Raises
        ------
        ModelError
            With all problems.

        Examples
        --------
        >>> Model.from_dict({"title": "fan", "bodies": {"rotor": {"inertia": "0.2 kg m^2"}}})
        Model 'fan': 1 body
        """
        if not isinstance(data, Mapping):
            raise ModelError([Message("model", "is not a mapping of keys", remedy="begin with gears")])
        given = {str(name): value for name, value in data.items() if value is not None}
        own = {name: value for name, value in given.items() if name in keys_of(sections.Contents)}
        others = {name: value for name, value in given.items() if name not in own}
        return cls(**own, others=others, allow_code=allow_code)

    def to_yaml(self) -> str:
        """Text of a model file that reads back to an equal model.

        Texts with units and formulas are as in the file or in the arguments of the model, other quantities
        have customary units. Comments are not kept.
        """
        return yaml_text(self)

    def __repr__(self) -> str:
        """Title, number of components of each section, names of the scenarios."""
        from pitchpoint.model.table import summary

        return summary(self)

    def _repr_html_(self) -> str:
        """Tables of gears, meshes and bodies for notebooks."""
        from pitchpoint.model.table import model_table

        return model_table(self)
