// SPDX-License-Identifier: GPL-3.0-or-later
// The control loop of a station on a serial line. A board's timer calls firmware_tick() 10,000 times a
// second; its program calls firmware_poll() in between; its serial line's interrupt exchanges bytes with the
// rings. Efforts, hold time and faults are the tick's business alone: they need neither the line nor the
// program.
#ifndef CHIRON_FIRMWARE_FIRMWARE_H
#define CHIRON_FIRMWARE_FIRMWARE_H

#include "station/firmware/board.h"
#include "station/firmware/byte_ring.h"
#include "station/firmware/current_control.h"
#include "station/firmware/description.h"
#include "station/protocol/station_cobs.h"

#ifdef __cplusplus
extern "C" {
#endif

#define FIRMWARE_TICK_US 100u
#define FIRMWARE_TICKS_A_PERIOD 10u // of input frames, 1 ms

struct firmware {
    const struct description* description;
    struct station_device device;
    struct station_cobs decoder;
    struct current_control controls[STATION_AXES];
    int32_t reference[STATION_AXES];   // the board's counts where an axis reads 0
    int32_t last_counts[STATION_AXES]; // a period ago
    volatile uint32_t now_us;          // of the last tick
    uint32_t ticks;
    uint8_t low_supply_periods;
    uint8_t shown_state; // on the service line
    bool shown_let_go;
    struct byte_ring received; // the line's interrupt puts, the program takes
    struct byte_ring to_send;  // the tick and the program (locked) put, the line's interrupt takes
    struct byte_ring service;  // text for technicians: a line for each change of state
};

// False, and nothing may go on, where the description is not allowed.
bool firmware_begin(struct firmware* firmware, const struct description* description);

// In the timer's interrupt, every FIRMWARE_TICK_US.
void firmware_tick(struct firmware* firmware);

// In the program: takes what has come.
void firmware_poll(struct firmware* firmware);

#ifdef __cplusplus
}
#endif
#endif
