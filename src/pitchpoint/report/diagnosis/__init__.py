# SPDX-License-Identifier: Apache-2.0
"""The diagnosis of a record: file and machine, findings in words, and its page."""
