# SPDX-License-Identifier: Apache-2.0
"""The second process that compiles may fail, but nothing may wait for it for ever."""

from __future__ import annotations

from pitchpoint.core import companion


def test_an_entry_that_nobody_was_asked_for_is_not_waited_for():
    companion.await_entry("somewhere:entry")


def test_a_failing_companion_does_no_harm(monkeypatch):
    monkeypatch.setattr(companion, "cores", lambda: 2)
    companion.delegate(["pitchpoint.no_such_module:entry", "pitchpoint.neither:entry"])
    companion.await_entry("pitchpoint.neither:entry")
    assert not companion._pending


def test_people_are_told_once():
    heard = []
    companion.listen(heard.append)
    companion.announce()
    companion.announce()
    assert len(heard) == 1
    assert "once" in heard[0]
