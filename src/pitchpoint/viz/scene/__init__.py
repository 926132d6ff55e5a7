# SPDX-License-Identifier: Apache-2.0
"""3-D scene as plain data, file and HTML page."""
