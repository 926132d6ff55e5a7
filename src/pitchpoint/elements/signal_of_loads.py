# SPDX-License-Identifier: Apache-2.0
"""Signals that depend on loads: code of `signal_flow`, evaluated after all forces and multipliers."""

from __future__ import annotations

from dataclasses import replace

from pitchpoint.elements import signal_flow
from pitchpoint.elements.kind import FRICTION
from pitchpoint.elements.signal_flow import RECORD, entry

__all__ = ["KIND", "RECORD", "entry"]

KIND = replace(signal_flow.KIND, name="signal_of_loads", channel=FRICTION)
