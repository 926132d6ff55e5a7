# SPDX-License-Identifier: Apache-2.0
"""Parts of the contacts of curves and surfaces: record, places of contact, wrenches."""
