// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/firmware/lm3s6965/axes_emulated.h"

#define SUPPLY_V 24
#define RESISTANCE_OHM 2
#define FRICTION 2 // µN for each µm/s

void emulated_axis_step(struct emulated_axis* axis) {
    // mV over 1 mH in 100 µs: a tenth of a mA for each.
    axis->current_mA += (SUPPLY_V * axis->duty_permille - RESISTANCE_OHM * axis->current_mA) / 10;
    // µN on 0.1 kg in 100 µs: a thousandth of a µm/s for each.
    axis->speed_um_per_s += (1000 * axis->current_mA - FRICTION * axis->speed_um_per_s) / 1000;
    axis->place_pm100 += axis->speed_um_per_s;
}

int32_t emulated_axis_counts(const struct emulated_axis* axis) {
    return (int32_t)(axis->place_pm100 / 10000);
}
