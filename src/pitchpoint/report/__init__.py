# SPDX-License-Identifier: Apache-2.0
"""Reports on a model: its parameters, results that need no scenario, and the HTML page with both."""
