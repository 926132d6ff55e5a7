# SPDX-License-Identifier: Apache-2.0
"""Implicit methods: Newton iterations and the generalised-alpha method."""
