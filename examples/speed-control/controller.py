# SPDX-License-Identifier: Apache-2.0
"""A sampled speed controller: proportional and integral part, limited torque."""


def speed_loop(t, inputs, state, parameters):
    """Torque of the motor [N m] by the error of its speed [rad/s]."""
    gain, integral_gain, most = parameters
    (error,) = inputs
    elapsed = t - state.get("time", t)
    # the drive is running at the start: the integral gives the initial torque of the model file
    integral = state.get("integral", 20.0) + integral_gain * elapsed * error
    wanted = gain * error + integral
    torque = min(max(wanted, -most), most)
    if torque == wanted:  # no integration at the torque limit
        state["integral"] = integral
    state["time"] = t
    return torque
