# SPDX-License-Identifier: Apache-2.0
"""Initial state of a scenario: bodies, filters and integrators, clutches."""
