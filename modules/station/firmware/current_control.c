// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/firmware/current_control.h"

#define WHOLE_BRIDGE 1000000
#define TRIP_TICKS 5

static int64_t limited(int64_t value, int64_t limit, bool* reached) {
    if (value <= limit && value >= -limit)
        return value;
    *reached = true;
    return value > 0 ? limit : -limit;
}

void current_control_reset(struct current_control* control) {
    control->integral = 0;
    control->at_limit = false;
}

int32_t current_control_step(struct current_control* control, const struct motor_description* motor,
                             int32_t effort, int32_t measured_mA) {
    control->at_limit = false;
    if (motor->effort_per_A <= 0)
        return 0;
    const int64_t wanted_mA =
        limited((int64_t)effort * 1000 / motor->effort_per_A, motor->limit_mA, &control->at_limit);
    const int64_t error_mA = wanted_mA - measured_mA;
    // The integral alone may fill the bridge and no more, so that it lets go as soon as the error turns.
    bool full = false;
    control->integral = limited(control->integral + motor->integral * error_mA, WHOLE_BRIDGE, &full);
    const int64_t duty =
        limited(control->integral + motor->proportional * error_mA, WHOLE_BRIDGE, &control->at_limit);
    return (int32_t)(duty / (WHOLE_BRIDGE / 1000));
}

bool current_control_trips(struct current_control* control, const struct motor_description* motor,
                           int32_t measured_mA) {
    const bool high =
        motor->effort_per_A > 0 && (measured_mA > motor->trip_mA || measured_mA < -motor->trip_mA);
    control->trip_ticks = high ? control->trip_ticks + 1 : 0;
    if (control->trip_ticks < TRIP_TICKS)
        return false;
    control->trip_ticks = TRIP_TICKS;
    return true;
}
