// SPDX-License-Identifier: GPL-3.0-or-later
// What the firmware needs of a board. A board is one folder that defines these functions and a main program
// (lm3s6965/); the rest of the firmware knows no register.
#ifndef CHIRON_FIRMWARE_BOARD_H
#define CHIRON_FIRMWARE_BOARD_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// Called first in every tick, in the timer's interrupt: take the measurements that the functions below
// return.
void board_tick(void);

int32_t board_counts(uint8_t axis);                    // does not wrap within the range of the axis
int32_t board_current_mA(uint8_t axis);                // along the axis' positive effort
void board_drive(uint8_t axis, int32_t duty_permille); // -1000..1000 of the supply
void board_motors_off(void);                           // all bridges open; at once

bool board_dead_man(void);
uint8_t board_buttons(void); // bits 0..3
uint16_t board_supply_mV(void);
uint8_t board_fault(
    void); // enum station_fault_code of what only the board sees: emergency stop, temperature, encoders

// Keep the timer's interrupt away, and let it come again; not nested.
void board_lock(void);
void board_unlock(void);

#ifdef __cplusplus
}
#endif
#endif
