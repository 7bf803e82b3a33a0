// SPDX-License-Identifier: GPL-3.0-or-later
// The linkage of P1's mechanism as far as a board with two motors drives it: both base joints, 2,000 lines an
// encoder, capstans of 10. The handle's three angles have neither encoder nor motor and read 0. Lengths are
// those of docs/devices.md, section 5.1; what a motor gives is an ASSUMPTION.
#include "station/firmware/description.h"

#define COUNT_RAD 7.853981633974483e-05 // 2 pi / (2,000 lines x 4 edges x 10)
#define QUARTER_TURN 20000              // counts

#define JOINT(id)                                                                                            \
    { COUNT_RAD, 0.0, 3.141592653589793, 0.64f, 0.0125f, 0.01f, STATION_RADIAN, id }
#define ANGLE(id, most)                                                                                      \
    { COUNT_RAD, -(most), most, 0.0f, 0.0f, 0.0f, STATION_RADIAN, id }
// 0.05 N·m/A by a capstan of 10; at most 1.5 A.
#define MOTOR                                                                                                \
    { 500000, 1500, 2500, 100, 50, 500 }

const struct description the_description = {
    .device =
        {
            .identity = {.axes = 5,
                         .bits = STATION_RENDERS_FORCE | STATION_HAS_DEAD_MAN | STATION_HOMES_BY_FLAG,
                         .period_us = 1000,
                         .oldest_sample_us = 1000,
                         .max_force_N = 4.5f,
                         .max_torque_Nm = 0.0f,
                         .max_damping_Ns_per_m = 10.0f,
                         .parameters = 6},
            .names = {"Five-bar linkage, two motors", ""},
            .kinematics = {"five_bar_spherical", "1.0 LM3S6965"},
            .calibration = {0, 0, ""},
            .axes = {JOINT("theta1"), JOINT("theta2"), ANGLE("pitch", 1.1), ANGLE("yaw", 0.53),
                     ANGLE("roll", 3.2)},
            // l1, l2, half base, base forward, base up, mounting pitch
            .parameters = {{{0.140, 0.220, 0.060, -0.005, -0.175, 0.5794493116620293}}},
        },
    .motors = {MOTOR, MOTOR},
    .reference_counts = {QUARTER_TURN, QUARTER_TURN}, // homed with both proximal links upright
    .least_supply_mV = 18000,
};
