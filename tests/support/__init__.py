# SPDX-License-Identifier: Apache-2.0
"""Small builders that several tests share."""
