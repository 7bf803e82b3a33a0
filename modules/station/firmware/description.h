// SPDX-License-Identifier: GPL-3.0-or-later
// What a laboratory writes for its own mechanism: one file with one of these (descriptions/).
#ifndef CHIRON_FIRMWARE_DESCRIPTION_H
#define CHIRON_FIRMWARE_DESCRIPTION_H

#include "station/protocol/station_device.h"

#ifdef __cplusplus
extern "C" {
#endif

// A motor and its current controller.
struct motor_description {
    int32_t effort_per_A; // effort of the axis in µN or µN·m by 1 A, gears and drums included; 0: no motor
    int32_t limit_mA;     // never asked for more
    int32_t trip_mA;      // measured for five ticks in a row: over-current
    int32_t proportional; // duty of a whole bridge in millionths, by 1 mA of error
    int32_t integral;     // the same, added in each tick
    int32_t most_counts_per_ms; // faster is overspeed; 0: not watched
};

struct description {
    struct station_device_config device;
    struct motor_description motors[STATION_AXES];
    int32_t reference_counts[STATION_AXES]; // that each axis has where it is homed
    uint16_t least_supply_mV;               // 0: not watched
};

// The one that this firmware was built for.
extern const struct description the_description;

#ifdef __cplusplus
}
#endif
#endif
