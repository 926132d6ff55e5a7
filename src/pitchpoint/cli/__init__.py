# SPDX-License-Identifier: Apache-2.0
"""Command-line interface: one module per command; heavy imports are inside the commands."""
