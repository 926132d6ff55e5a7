# SPDX-License-Identifier: Apache-2.0
"""Functional mock-up units (FMUs) of other programs: their files, and processes that run them."""
