# SPDX-License-Identifier: Apache-2.0
"""Pictures and reports from results: the only place with colours."""
