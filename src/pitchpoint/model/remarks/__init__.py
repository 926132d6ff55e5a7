# SPDX-License-Identifier: Apache-2.0
"""Remarks and warnings on valid data that have no effect or a rarely intended one."""
