# SPDX-License-Identifier: Apache-2.0
"""A speed controller as it runs in a drive: proportional and integral part, limited torque."""


def speed_loop(t, inputs, state, parameters):
    """Torque of the motor [N m] by the error of its speed [rad/s]."""
    gain, integral_gain, most = parameters
    (error,) = inputs
    elapsed = t - state.get("time", t)
    # the drive has been running: its integral holds the torque that the model file starts with
    integral = state.get("integral", 20.0) + integral_gain * elapsed * error
    wanted = gain * error + integral
    torque = min(max(wanted, -most), most)
    if torque == wanted:  # at its limit the integral waits
        state["integral"] = integral
    state["time"] = t
    return torque
