// SPDX-License-Identifier: GPL-3.0-or-later
// Axes that are computed: a mass of 0.1 kg and a friction of 2 N·s/m on each, moved by 1 N for each ampere of
// a motor of 2 Ω and 1 mH at 24 V. In whole numbers, so that every run is the same.
#ifndef CHIRON_FIRMWARE_AXES_EMULATED_H
#define CHIRON_FIRMWARE_AXES_EMULATED_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

struct emulated_axis {
    int32_t duty_permille;
    int32_t current_mA;
    int32_t speed_um_per_s;
    int64_t place_pm100; // 100 pm
};

// 100 µs.
void emulated_axis_step(struct emulated_axis* axis);
int32_t emulated_axis_counts(const struct emulated_axis* axis); // µm

#ifdef __cplusplus
}
#endif
#endif
