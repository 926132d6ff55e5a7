# SPDX-License-Identifier: Apache-2.0
"""Contacts from what a user describes: records, defaults, what is refused."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest

from pitchpoint.core.errors import CompileError
from pitchpoint.model.components.contact import (
    CamContact,
    ContactCurve,
    ContactFriction,
    ContactLaw,
    ContactSurface,
    CurveContact,
    SurfaceContact,
)
from pitchpoint.model.keys import walk
from pitchpoint.multibody.bodies import FREE, Body
from pitchpoint.system import evaluate
from pitchpoint.system.rules.contact import cam_banks, curve_banks, curve_of, surface_banks
from pitchpoint.system.system import assemble
from tests.support.contacts import box, read

LAW = ContactLaw(force=1000.0, depth=1e-4)
CIRCLE = ContactCurve(shape="circle", radius=0.03)
BALL = ContactSurface(shape="sphere", radius=0.01)
NUMBER = {"ground": 0, "a": 1, "b": 2}
POINTS = {"pin": np.array([0.0, 0.04, 0.0])}


def end(name):
    body, _, marker = name.partition(".")
    return NUMBER[body], POINTS.get(marker, np.zeros(3)), np.eye(3)


def places(**sections):
    """What rules of a model with these sections read."""
    return SimpleNamespace(end=end, model=SimpleNamespace(**sections))


def surfaces(parts):
    """Banks of surface contacts."""
    return surface_banks(places(surface_contacts=parts))


def system_of(bank, apart):
    """Two free bodies with the bank of one rule."""
    bodies = [
        Body(motion=FREE, position=p, mass=1.0, polar_inertia=0.2, transverse_inertia=0.1, name=n)
        for n, p in (("a", apart), ("b", (0.0, 0.0, 0.0)))
    ]
    given = {bank.kind: bank.records}
    pools = {bank.kind: bank.pool}
    if bank.kind == "point_on_curve":
        return assemble(bodies, {}, given, names={bank.kind: bank.names}, pools=pools)
    return assemble(bodies, given, names={bank.kind: bank.names}, pools=pools)


def force(bank, apart):
    system = system_of(bank, apart)
    return read(system, system.initial_state(), f"contact_force[{bank.names[0]}]")


def test_every_key_is_described():
    for cls in (CamContact, CurveContact, SurfaceContact):
        for path, _, _, item in walk(cls):
            assert item.meaning, path


def test_a_cam_with_and_without_lift_off():
    parts = {
        "open": CamContact(ends=("a.pin", "b"), curve=CIRCLE, radius=0.01, law=LAW),
        "held": CamContact(ends=("a.pin", "b"), curve=CIRCLE, radius=0.01, permanent=True),
    }
    one, two = cam_banks(places(cam_contacts=parts))
    assert (one.names, two.names) == (("open",), ("held",))
    assert force(one, (0.0, -1e-4, 0.0)) == pytest.approx(1000.0, rel=1e-9)  # 0.1 mm at 1000 N
    system = system_of(two, (0.0, 0.0, 0.0))
    evaluate.residual(system, system.initial_state())
    assert system.workspace.g[0] == pytest.approx(0.0, abs=1e-15)


def test_curves():
    for curve, apart in (
        (
            ContactCurve(shape="polygon", x=(0, 0.04, 0.04, 0), y=(0, 0, 0.04, 0.04), radii=(0.01,) * 4),
            0.0699,
        ),
        (ContactCurve(shape="spline", x=(0.04, 0, -0.04, 0), y=(0, 0.04, 0, -0.04)), 0.0699),
        (CIRCLE, 0.0599),
    ):
        parts = {"c": CurveContact(ends=("a", "b"), first=CIRCLE, second=curve, law=LAW)}
        assert force(
            curve_banks(places(curve_contacts=parts))[0],
            (apart, 0.02 if curve.shape == "polygon" else 0.0, 0.0),
        ) == (pytest.approx(1000.0, rel=1e-6))
    involute = ContactCurve(shape="involute", radius=0.05, roll=(0.1, 0.5), hand="right")
    assert curve_of(involute, "x").length == pytest.approx(0.5 * 0.05 * (0.25 - 0.01))


def test_surfaces(tmp_path):
    surface = box((0.06, 0.06, 0.06))
    np.save(tmp_path / "box.npy", surface.vertices[surface.faces])
    triangles = ContactSurface(shape="triangles", file=str(tmp_path / "box.npy"))
    for first, second, apart in (
        (BALL, ContactSurface(shape="plane"), (0, 0, 0.0099)),
        (BALL, ContactSurface(shape="torus", radius=0.05, tube=0.02), (0.05, 0, 0.0299)),
        (BALL, triangles, (0, 0, 0.0399)),
        (BALL, ContactSurface(shape="cylinder", radius=0.03, hollow=True), (0.0201, 0, 0)),
    ):
        one, two, _ = surface_banks(
            places(
                surface_contacts={"s": SurfaceContact(ends=("a", "b"), first=first, second=second, law=LAW)}
            )
        )
        assert two.records.size == 0
        assert force(one, apart) == pytest.approx(1000.0, rel=1e-6)
    swapped = SurfaceContact(ends=("b", "a"), first=ContactSurface(shape="plane"), second=BALL, law=LAW)
    one, _, _ = surfaces({"s": swapped})
    assert (one.records["i"], one.records["j"]) == (1, 2)
    ring = ContactSurface(shape="torus", radius=0.05, tube=0.01)
    part = SurfaceContact(ends=("a", "b"), first=ring, second=ContactSurface(shape="plane"), law=LAW)
    assert force(surfaces({"s": part})[1], (0, 0, 0.0099)) == pytest.approx(1000.0, rel=1e-6)
    both = SurfaceContact(ends=("a", "b"), first=triangles, second=triangles, law=LAW)
    # 1000 N per square metre at 0.1 mm, on a side of 36 cm^2 less what hangs over
    assert force(surfaces({"s": both})[1], (1e-3, 1e-3, 0.0599)) == pytest.approx(3.6, rel=0.07)


def test_laws():
    rough = ContactFriction(static=0.1, dynamic=0.08)
    bounce = ContactLaw(force=1000.0, depth=1e-4, restitution=0.5, speed=2.0)
    part = SurfaceContact(
        ends=("a", "ground"), first=BALL, second=ContactSurface(shape="plane"), law=bounce, friction=rough
    )
    record = surfaces({"s": part})[0].records[0]
    assert record["x"] == pytest.approx(1.432751 / 2.0, rel=1e-6)
    assert (record["mu_s"], record["mu_d"], record["v_s"], record["v_d"]) == (0.1, 0.08, 1e-3, 1e-2)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (
            lambda: cam_banks(places(cam_contacts={"c": CamContact(ends=("a", "b"), curve=CIRCLE)})),
            "cam_contacts.c: .* requires a law",
        ),
        (
            lambda: curve_of(ContactCurve(shape="circle"), "x.curve"),
            r"x.curve.radius: is required for this shape",
        ),
        (lambda: curve_of(ContactCurve(shape="spline", x=(0, 1), y=(0, 1, 2)), "x"), "same number of points"),
        (lambda: curve_of(ContactCurve(shape="involute", radius=0.1), "x"), "x.roll: .* two roll angles"),
        (
            lambda: curve_of(ContactCurve(shape="polygon", x=(0, 1, 1), y=(0, 0, 1), radii=(9.0,) * 3), "x"),
            "overlap",
        ),
        (
            lambda: surfaces(
                {
                    "s": SurfaceContact(
                        ends=("a", "b"),
                        first=BALL,
                        second=ContactSurface(shape="triangles", file="/nowhere.npy"),
                        law=LAW,
                    )
                }
            ),
            "surface_contacts.s.file: .*nowhere",
        ),
        (
            lambda: surfaces(
                {
                    "s": SurfaceContact(
                        ends=("a", "b"),
                        first=BALL,
                        second=ContactSurface(shape="plane"),
                        law=ContactLaw(force=1.0, depth=1.0, damping=1.0, restitution=0.5),
                    )
                }
            ),
            "give one",
        ),
    ],
)
def test_what_is_refused(make, text):
    with pytest.raises(CompileError, match=text):
        make()
