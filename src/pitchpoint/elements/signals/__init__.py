# SPDX-License-Identifier: Apache-2.0
"""Parts of signals: record, sensors, actuators, and the net that sorts them."""
