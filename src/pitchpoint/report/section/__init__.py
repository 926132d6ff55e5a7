# SPDX-License-Identifier: Apache-2.0
"""The gearbox in section as plain data for `viz.section_drawing`: axes, their parts, the developed layout."""
