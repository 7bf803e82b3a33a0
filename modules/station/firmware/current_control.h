// SPDX-License-Identifier: GPL-3.0-or-later
// The current of one motor: proportional and integral, in whole numbers, with limits on current and duty.
#ifndef CHIRON_FIRMWARE_CURRENT_CONTROL_H
#define CHIRON_FIRMWARE_CURRENT_CONTROL_H

#include "station/firmware/description.h"

#ifdef __cplusplus
extern "C" {
#endif

struct current_control {
    int64_t integral;   // millionths of a whole bridge
    int32_t trip_ticks; // that the current was too high
    bool at_limit;      // of current or duty, in the last tick
};

void current_control_reset(struct current_control* control);

// One tick: the duty in thousandths, -1000..1000. effort in µN or µN·m. 0 without a motor.
int32_t current_control_step(struct current_control* control, const struct motor_description* motor,
                             int32_t effort, int32_t measured_mA);

// Counts how long the current has been too high; true once it has been so long enough.
bool current_control_trips(struct current_control* control, const struct motor_description* motor,
                           int32_t measured_mA);

#ifdef __cplusplus
}
#endif
#endif
