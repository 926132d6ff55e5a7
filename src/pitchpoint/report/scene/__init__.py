# SPDX-License-Identifier: Apache-2.0
"""The 3-D scene of a model or a result: what there is to draw, where it is, and what acts on it."""
