# SPDX-License-Identifier: Apache-2.0
"""Checks of a model: every problem is reported at its key."""
