// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/protocol/station_cobs.h"

void station_cobs_encode(const uint8_t* frame, uint8_t* out) {
    size_t code = 0; // where the distance to the next zero will stand
    for (size_t i = 0; i < STATION_FRAME_SIZE; ++i) {
        out[i + 1] = frame[i];
        if (frame[i] == 0) {
            out[code] = (uint8_t)(i + 1 - code);
            code = i + 1;
        }
    }
    out[code] = (uint8_t)(STATION_COBS_BLOCK - code);
    out[STATION_COBS_BLOCK] = 0;
}

void station_cobs_begin(struct station_cobs* decoder) {
    decoder->length = 0;
}

static bool decode_block(const uint8_t* block, uint8_t* out) {
    size_t next = block[0]; // the next distance, which stands for a zero
    for (size_t i = 1; i < STATION_COBS_BLOCK; ++i) {
        if (i == next) {
            out[i - 1] = 0;
            next = i + block[i];
        } else {
            out[i - 1] = block[i];
        }
    }
    return next == STATION_COBS_BLOCK;
}

enum station_cobs_event station_cobs_take(struct station_cobs* decoder, uint8_t byte, uint8_t* out) {
    if (byte != 0) {
        if (decoder->length < STATION_COBS_BLOCK)
            decoder->block[decoder->length] = byte;
        if (decoder->length <= STATION_COBS_BLOCK)
            ++decoder->length;
        return STATION_COBS_NOTHING;
    }
    const uint8_t length = decoder->length;
    decoder->length = 0;
    if (length == 0)
        return STATION_COBS_NOTHING;
    if (length != STATION_COBS_BLOCK || !decode_block(decoder->block, out))
        return STATION_COBS_BROKEN;
    return STATION_COBS_FRAME;
}
