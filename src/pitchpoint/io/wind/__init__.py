# SPDX-License-Identifier: Apache-2.0
"""Files of turbulent wind: full-field files of TurbSim, boxes of the Mann generator."""
