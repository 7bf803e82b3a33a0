// SPDX-License-Identifier: GPL-3.0-or-later
// Frames on a serial line: consistent overhead byte stuffing (Cheshire & Baker 1999) with a 0x00 after each
// frame. Whatever is cut, doubled or damaged, a receiver is in step again at the next 0x00.
#ifndef CHIRON_STATION_COBS_H
#define CHIRON_STATION_COBS_H

#include "station/protocol/station_frame.h"

#ifdef __cplusplus
extern "C" {
#endif

#define STATION_COBS_BLOCK                                                                                   \
    (STATION_FRAME_SIZE + 1) // one byte more for every frame, as it is shorter than 254 bytes
#define STATION_COBS_SIZE (STATION_COBS_BLOCK + 1) // with the 0x00

// Writes STATION_COBS_SIZE bytes. A sender that begins, or that left off within a frame, sends one 0x00
// before the first of them.
void station_cobs_encode(const uint8_t* frame, uint8_t* out);

// What has come since the last 0x00. Begin with all zero (station_cobs_begin).
struct station_cobs {
    uint8_t length; // saturates above STATION_COBS_BLOCK
    uint8_t block[STATION_COBS_BLOCK];
};

enum station_cobs_event {
    STATION_COBS_NOTHING = 0, // more is to come
    STATION_COBS_FRAME = 1,   // out has STATION_FRAME_SIZE bytes, not checked
    STATION_COBS_BROKEN = 2   // what came between two 0x00 is no frame: count it
};

void station_cobs_begin(struct station_cobs* decoder);
// Takes one byte of the line. Two 0x00 in a row are nothing.
enum station_cobs_event station_cobs_take(struct station_cobs* decoder, uint8_t byte, uint8_t* out);

#ifdef __cplusplus
}
#endif
#endif
