// SPDX-License-Identifier: GPL-3.0-or-later
// Three straight axes that exist only in the processor (lm3s6965/axes_emulated.c): for trying and testing
// without hardware.
#include "station/firmware/description.h"

#define AXIS(id)                                                                                             \
    { 1e-6, -0.2, 0.2, 4.5f, 0.0f, 2.0f, STATION_METRE, id }
#define MOTOR                                                                                                \
    { 1000000, 5000, 7500, 100, 50, 1000 }

const struct description the_description = {
    .device =
        {
            .identity = {.axes = 3,
                         .bits = STATION_RENDERS_FORCE | STATION_HOMES_BY_FLAG,
                         .period_us = 1000,
                         .oldest_sample_us = 1000,
                         .max_force_N = 4.5f,
                         .max_torque_Nm = 0.0f,
                         .max_damping_Ns_per_m = 20.0f},
            .names = {"Chiron reference firmware", "EMULATED-1"},
            .kinematics = {"cartesian", "1.0 emulated axes"},
            .calibration = {0, 0, ""},
            .axes = {AXIS("x"), AXIS("y"), AXIS("z")},
        },
    .motors = {MOTOR, MOTOR, MOTOR},
    .least_supply_mV = 18000,
};
