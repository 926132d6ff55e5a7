# SPDX-License-Identifier: Apache-2.0
"""Blade-element momentum theory of rotors: polars, induction and loads of a blade station."""
