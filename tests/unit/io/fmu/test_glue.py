# SPDX-License-Identifier: Apache-2.0
"""FMI functions in C: they agree with the records of the package; the text is their translation."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from pitchpoint.core import status
from pitchpoint.elements import drive as elements
from pitchpoint.elements.drive import RECORD
from pitchpoint.io.fmu import model
from pitchpoint.io.fmu.glue import make
from pitchpoint.io.fmu.model_data import STATUSES, glue, number_names
from pitchpoint.multibody.channels import CTL
from pitchpoint.report.exported_model import fmu_model
from pitchpoint.solvers.equilibrium.unknowns import extents
from pitchpoint.solvers.exported_run import export_run
from pitchpoint.solvers.sampling import RECORDER
from pitchpoint.system import requests
from pitchpoint.system.compile import compile_model
from tests.support.fmu_models import pair

HEADER = glue("instance.h")


def enum(first):
    """Names of an enumeration that begins with a name, with their values."""
    found = re.search(rf"enum \{{ ({first}[^}}]*) \}}", HEADER)[1]
    names, value = {}, -1
    for part in found.split(", "):
        name, _, given = part.partition(" = ")
        value = int(given) if given else value + 1
        names[name] = value
    return names


@pytest.mark.parametrize("version", [2, 3])
def test_the_text_is_the_translation_of_the_sources(version):
    """After an edit of the C files: make glue."""
    assert glue(f"fmi{version}.ll").splitlines()[0] == f"; {make.sources_hash()}"


def test_records_and_codes_are_those_of_the_package():
    control = re.search(r"typedef struct \{ double t, ck, cd, cm; i64 jac; \} Ctl;", HEADER)
    assert control and list(CTL.names[:5]) == ["t", "ck", "cd", "cm", "jac"]
    fields = re.search(r"typedef struct \{\n  i64 ([^;]*);\n\} Recorder;", HEADER)[1]
    assert tuple(fields.split(", ")) == RECORDER.names
    drive = re.search(r"typedef struct \{ i64 ([^;]*); double ([^;]*); \} Drive;", HEADER)
    names = [*drive[1].split(", "), *drive[2].split(", ")]
    assert names == list(RECORD.names[: len(names)])
    assert all(RECORD.fields[name][1] == 8 * k for k, name in enumerate(names))
    assert all(getattr(elements, name) == value for name, value in enum("RAMP").items())
    assert all(getattr(requests, name) == value for name, value in enum("OBSERVE").items())
    assert all(getattr(status, name) == value for name, value in enum("OK").items())
    assert all(getattr(model, name) == value for name, value in enum("OUTPUT").items())
    assert status.sentence(STATUSES - 1) and "unknown" in status.sentence(STATUSES)


@pytest.fixture(scope="module")
def exported():
    """Started run of the pair."""
    return export_run(compile_model(pair("generalized_alpha"), "steady"))


def test_the_identifier_depends_on_the_data_of_the_start(exported):
    unit = fmu_model(exported, (), "pair", "pair")
    assert list(unit.extents) == extents(exported.system).tolist()
    for change in ({"instants": (0.0, 0.5, 1e-4, 0.5)}, {"extents": (2.0, *unit.extents[1:])}):
        assert replace(unit, **change).token != unit.token
    assert replace(unit).token == unit.token


def test_every_number_of_the_header_is_given(exported):
    run = exported
    integers, reals = number_names()
    counted = {"n_moved", "n_code", "n_variables", "n_indicators", "n_drives"}
    counted |= {"n_entries", "n_free", "n_free_balancing", "n_balancing", "n_instants", "n_spins", "n_gaps"}
    assert set(integers) == counted | set(run.numbers)
    assert reals == ["t0", "h", "rate", "far"]
