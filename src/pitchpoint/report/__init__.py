# SPDX-License-Identifier: Apache-2.0
"""What is said about a model: its numbers, what follows from it without a scenario, and the page of both."""
