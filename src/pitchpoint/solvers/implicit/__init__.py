# SPDX-License-Identifier: Apache-2.0
"""Implicit steps: Newton iterations, and the generalised-alpha method."""
