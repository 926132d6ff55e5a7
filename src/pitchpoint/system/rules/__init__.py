# SPDX-License-Identifier: Apache-2.0
"""One rule per component: from what the user describes to the records of the elements."""
