// SPDX-License-Identifier: GPL-3.0-or-later
// board.h's functions about axes by computed ones.
#include "station/firmware/board.h"
#include "station/firmware/lm3s6965/axes.h"
#include "station/firmware/lm3s6965/axes_emulated.h"

#define AXES 3

static struct emulated_axis axes[AXES];

void axes_begin(void) {}

void board_tick(void) {
    for (uint8_t axis = 0; axis < AXES; ++axis)
        emulated_axis_step(&axes[axis]);
}

int32_t board_counts(uint8_t axis) {
    return axis < AXES ? emulated_axis_counts(&axes[axis]) : 0;
}

int32_t board_current_mA(uint8_t axis) {
    return axis < AXES ? axes[axis].current_mA : 0;
}

void board_drive(uint8_t axis, int32_t duty_permille) {
    if (axis < AXES)
        axes[axis].duty_permille = duty_permille;
}

void board_motors_off(void) {
    for (uint8_t axis = 0; axis < AXES; ++axis) {
        axes[axis].duty_permille = 0;
        axes[axis].current_mA = 0;
    }
}

bool board_dead_man(void) {
    return false;
}

uint8_t board_buttons(void) {
    return 0;
}

uint16_t board_supply_mV(void) {
    return 24000;
}

uint8_t board_fault(void) {
    return 0;
}
