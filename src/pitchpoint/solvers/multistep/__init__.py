# SPDX-License-Identifier: Apache-2.0
"""Backward differentiation formulas (BDF): step, order control, history, events, restarts."""
