# SPDX-License-Identifier: Apache-2.0
"""Reports about a model: its numbers, what follows from it without a scenario, and the page of both."""
