# SPDX-License-Identifier: Apache-2.0
"""Numbers from the dataset of a contact analysis of tooth flanks (`solvers.contact_analysis`)."""
