# SPDX-License-Identifier: Apache-2.0
"""Functional mock-up units: description, object code, link, archive."""
