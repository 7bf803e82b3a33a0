// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/protocol/station_frame.h"

#define INPUT_STATUS_BITS (STATION_STATUS_WRENCH_VALID | STATION_STATUS_AT_LIMIT | STATION_STATUS_LET_GO)
#define OUTPUT_FLAG_BITS                                                                                     \
    (STATION_OUTPUT_ENABLE | STATION_OUTPUT_CLEAR_FAULT | STATION_OUTPUT_DISPLAY | STATION_OUTPUT_HOME)

uint16_t station_crc16(const uint8_t* bytes, size_t count) {
    uint32_t crc = 0xFFFFu;
    for (size_t i = 0; i < count; ++i) { // a byte at once, without a table (Greg Cook's form)
        uint32_t x = ((crc >> 8) ^ bytes[i]) & 0xFFu;
        x ^= x >> 4;
        crc = ((crc << 8) ^ (x << 12) ^ (x << 5) ^ x) & 0xFFFFu;
    }
    return (uint16_t)crc;
}

uint32_t station_crc32(uint32_t crc, const uint8_t* bytes, size_t count) {
    crc = ~crc;
    for (size_t i = 0; i < count; ++i) {
        crc ^= bytes[i];
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1u) ? 0xEDB88320u : 0u);
    }
    return ~crc;
}

bool station_newer(uint16_t a, uint16_t b) {
    const uint16_t ahead = (uint16_t)(a - b);
    return ahead != 0 && ahead < 0x8000u;
}

uint16_t station_gap(uint16_t a, uint16_t b) {
    return (uint16_t)(a - b - 1);
}

void station_put_u16(uint8_t* at, uint16_t value) {
    at[0] = (uint8_t)(value & 0xFFu);
    at[1] = (uint8_t)(value >> 8);
}

void station_put_u32(uint8_t* at, uint32_t value) {
    station_put_u16(at, (uint16_t)(value & 0xFFFFu));
    station_put_u16(at + 2, (uint16_t)(value >> 16));
}

void station_put_f32(uint8_t* at, float value) {
    union {
        float value;
        uint32_t bits;
    } both;
    both.value = value;
    station_put_u32(at, both.bits);
}

void station_put_f64(uint8_t* at, double value) {
    union {
        double value;
        uint64_t bits;
    } both;
    both.value = value;
    station_put_u32(at, (uint32_t)(both.bits & 0xFFFFFFFFu));
    station_put_u32(at + 4, (uint32_t)(both.bits >> 32));
}

uint16_t station_get_u16(const uint8_t* at) {
    return (uint16_t)(at[0] | ((uint32_t)at[1] << 8));
}

uint32_t station_get_u32(const uint8_t* at) {
    return station_get_u16(at) | ((uint32_t)station_get_u16(at + 2) << 16);
}

int16_t station_get_i16(const uint8_t* at) {
    const int32_t value = station_get_u16(at);
    return (int16_t)(value < 0x8000 ? value : value - 0x10000);
}

int32_t station_get_i32(const uint8_t* at) {
    const int64_t value = station_get_u32(at);
    return (int32_t)(value < 0x80000000LL ? value : value - 0x100000000LL);
}

float station_get_f32(const uint8_t* at) {
    union {
        float value;
        uint32_t bits;
    } both;
    both.bits = station_get_u32(at);
    return both.value;
}

double station_get_f64(const uint8_t* at) {
    union {
        double value;
        uint64_t bits;
    } both;
    both.bits = station_get_u32(at) | ((uint64_t)station_get_u32(at + 4) << 32);
    return both.value;
}

void station_seal(uint8_t* frame) {
    station_put_u16(frame + STATION_CRC_OFFSET, station_crc16(frame, STATION_CRC_OFFSET));
}

enum station_result station_check_crc(const uint8_t* frame) {
    const uint16_t crc = station_crc16(frame, STATION_CRC_OFFSET);
    return station_get_u16(frame + STATION_CRC_OFFSET) == crc ? STATION_OK : STATION_BAD_CRC;
}

uint8_t station_frame_type(const uint8_t* frame) {
    return frame[0];
}

static enum station_result check_head(const uint8_t* frame, uint8_t type) {
    if (station_check_crc(frame) != STATION_OK)
        return STATION_BAD_CRC;
    return station_frame_type(frame) == type ? STATION_OK : STATION_BAD_TYPE;
}

// The flags repeat the state. A station that contradicts itself must not be believed to be armed, nor to be
// safe.
static bool input_is_allowed(uint8_t flags, uint8_t state) {
    if (state > STATION_FAULT)
        return false;
    const bool armed = (flags & STATION_INPUT_ARMED) != 0;
    const bool fault = (flags & STATION_INPUT_FAULT) != 0;
    const bool homed = (flags & STATION_INPUT_HOMED) != 0;
    if (armed != (state == STATION_ARMED) || fault != (state == STATION_FAULT))
        return false;
    return state == STATION_FAULT ||
           homed == (state != STATION_UNKNOWN); // in a fault the reference may stand
}

enum station_result station_encode_input(const struct station_input* input, uint8_t* frame) {
    if (!input_is_allowed(input->flags, input->state))
        return STATION_BAD_VALUE;
    frame[0] = STATION_INPUT;
    frame[1] = input->flags;
    station_put_u16(frame + 2, input->sequence);
    station_put_u32(frame + 4, input->time_us);
    for (size_t axis = 0; axis < STATION_AXES; ++axis)
        station_put_u32(frame + 8 + 4 * axis, (uint32_t)input->counts[axis]);
    station_put_u16(frame + 40, (uint16_t)input->jaw);
    for (size_t i = 0; i < 6; ++i)
        station_put_u16(frame + 42 + 2 * i, (uint16_t)input->wrench[i]);
    station_put_u16(frame + 54, input->applied_sequence);
    frame[56] = input->applied_age_ms;
    frame[57] = input->state;
    frame[58] = input->fault;
    frame[59] = (uint8_t)(input->status & INPUT_STATUS_BITS);
    station_put_u16(frame + 60, input->supply_mV);
    station_seal(frame);
    return STATION_OK;
}

enum station_result station_decode_input(const uint8_t* frame, struct station_input* out) {
    const enum station_result head = check_head(frame, STATION_INPUT);
    if (head != STATION_OK)
        return head;
    if (!input_is_allowed(frame[1], frame[57]))
        return STATION_BAD_VALUE;
    out->flags = frame[1];
    out->sequence = station_get_u16(frame + 2);
    out->time_us = station_get_u32(frame + 4);
    for (size_t axis = 0; axis < STATION_AXES; ++axis)
        out->counts[axis] = station_get_i32(frame + 8 + 4 * axis);
    out->jaw = station_get_i16(frame + 40);
    for (size_t i = 0; i < 6; ++i)
        out->wrench[i] = station_get_i16(frame + 42 + 2 * i);
    out->applied_sequence = station_get_u16(frame + 54);
    out->applied_age_ms = frame[56];
    out->state = frame[57];
    out->fault = frame[58];
    out->status = (uint8_t)(frame[59] & INPUT_STATUS_BITS);
    out->supply_mV = station_get_u16(frame + 60);
    return STATION_OK;
}

static bool hold_is_allowed(uint8_t hold_ms) {
    return hold_ms >= 1 && hold_ms <= STATION_MOST_HOLD_MS;
}

enum station_result station_encode_output(const struct station_output* output, uint8_t* frame) {
    if (!hold_is_allowed(output->hold_ms))
        return STATION_BAD_VALUE;
    const bool display = (output->flags & STATION_OUTPUT_DISPLAY) != 0;
    frame[0] = STATION_OUTPUT;
    frame[1] = (uint8_t)(output->flags & OUTPUT_FLAG_BITS);
    station_put_u16(frame + 2, output->sequence);
    station_put_u16(frame + 4, output->answered_sequence);
    frame[6] = output->hold_ms;
    frame[7] = 0;
    for (size_t axis = 0; axis < STATION_AXES; ++axis)
        station_put_u32(frame + 8 + 4 * axis, (uint32_t)output->effort[axis]);
    station_put_u16(frame + 40, (uint16_t)(display ? output->display_force_mN : 0));
    station_put_u16(frame + 42, (uint16_t)(display ? output->display_pitch_1e4_rad : 0));
    station_put_u16(frame + 44, (uint16_t)(display ? output->display_roll_1e4_rad : 0));
    for (size_t i = 46; i < STATION_CRC_OFFSET; ++i)
        frame[i] = 0;
    station_seal(frame);
    return STATION_OK;
}

enum station_result station_decode_output(const uint8_t* frame, struct station_output* out) {
    const enum station_result head = check_head(frame, STATION_OUTPUT);
    if (head != STATION_OK)
        return head;
    if (!hold_is_allowed(frame[6]))
        return STATION_BAD_VALUE;
    out->flags = (uint8_t)(frame[1] & OUTPUT_FLAG_BITS);
    const bool display = (out->flags & STATION_OUTPUT_DISPLAY) != 0;
    out->sequence = station_get_u16(frame + 2);
    out->answered_sequence = station_get_u16(frame + 4);
    out->hold_ms = frame[6];
    for (size_t axis = 0; axis < STATION_AXES; ++axis)
        out->effort[axis] = station_get_i32(frame + 8 + 4 * axis);
    out->display_force_mN = (int16_t)(display ? station_get_i16(frame + 40) : 0);
    out->display_pitch_1e4_rad = (int16_t)(display ? station_get_i16(frame + 42) : 0);
    out->display_roll_1e4_rad = (int16_t)(display ? station_get_i16(frame + 44) : 0);
    return STATION_OK;
}
