# SPDX-License-Identifier: Apache-2.0
"""The tests, by kind: unit, contracts, invariants, properties, validation, examples, browser."""
