# SPDX-License-Identifier: Apache-2.0
"""3-D scene of a model or a result: solids, motion, forces, contacts, curves."""
