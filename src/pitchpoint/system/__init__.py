# SPDX-License-Identifier: Apache-2.0
"""Compiled systems: layout, element records, residual and observations as arrays."""
