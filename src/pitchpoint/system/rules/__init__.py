# SPDX-License-Identifier: Apache-2.0
"""Rules that convert model components to element records, one module per component."""
