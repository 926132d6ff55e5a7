# SPDX-License-Identifier: Apache-2.0
"""Turbines in the ontology windIO, versions 1 and 2: blade, airfoils, hub, drive train, tower."""
