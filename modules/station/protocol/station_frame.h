// SPDX-License-Identifier: GPL-3.0-or-later
// The frames between a host and a haptic station, version 1 (docs/station-protocol.md). Portable C99 without
// allocation and without a library, for micro-controllers, emulated stations and the host alike. Feature
// pages: station_features.h; serial lines: station_cobs.h.
#ifndef CHIRON_STATION_FRAME_H
#define CHIRON_STATION_FRAME_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define STATION_MAJOR 1
#define STATION_MINOR 0
#define STATION_FRAME_SIZE 64
#define STATION_CRC_OFFSET 62
#define STATION_AXES 8
// By these a host recognises a station among the USB HID devices, whoever made it.
#define STATION_HID_USAGE_PAGE 0xFF00
#define STATION_HID_USAGE 0x4348
#define STATION_MOST_HOLD_MS 20

enum station_type {
    STATION_INPUT = 1,  // device to host
    STATION_OUTPUT = 2, // host to device
    STATION_FEATURE_REQUEST = 3,
    STATION_FEATURE_REPLY = 4
};

enum station_state { STATION_UNKNOWN = 0, STATION_HOMED = 1, STATION_ARMED = 2, STATION_FAULT = 3 };

enum station_fault_code {
    STATION_NO_FAULT = 0,
    STATION_OVERSPEED = 1,
    STATION_OVER_CURRENT = 2,
    STATION_OVER_TEMPERATURE = 3,
    STATION_ENCODER_FAULT = 4, // the reference is lost with it
    STATION_SUPPLY_FAULT = 5,
    STATION_PROTOCOL_FAULT = 6,
    STATION_EMERGENCY_STOP = 7,
    STATION_INTERNAL_FAULT = 8
};

// Flags of an input frame.
#define STATION_INPUT_DEAD_MAN 0x01u
#define STATION_INPUT_ARMED 0x02u
#define STATION_INPUT_FAULT 0x04u
#define STATION_INPUT_HOMED 0x08u
#define STATION_INPUT_BUTTONS 0xF0u

// Status bits of an input frame.
#define STATION_STATUS_WRENCH_VALID 0x01u
#define STATION_STATUS_AT_LIMIT                                                                              \
    0x02u                           // a motor runs at its limit, or an effort was clamped to its axis' rating
#define STATION_STATUS_LET_GO 0x04u // the hold time ran out since the last armed frame

// Flags of an output frame.
#define STATION_OUTPUT_ENABLE 0x01u
#define STATION_OUTPUT_CLEAR_FAULT 0x02u
#define STATION_OUTPUT_DISPLAY 0x04u
#define STATION_OUTPUT_HOME 0x08u

// What became of a frame. A frame that is not STATION_OK is ignored and counted.
enum station_result {
    STATION_OK = 0,
    STATION_BAD_CRC = 1,
    STATION_BAD_TYPE = 2,
    STATION_BAD_VALUE = 3 // a value that version 1 does not allow
};

// One input frame. An axis that the device does not have reads 0.
struct station_input {
    uint8_t flags;
    uint16_t sequence;
    uint32_t time_us; // the device's clock; wraps
    int32_t counts[STATION_AXES];
    int16_t jaw;       // counts
    int16_t wrench[6]; // on the tool, in D: mN, then 0.1 mN·m
    uint16_t applied_sequence;
    uint8_t applied_age_ms; // 255: 255 or more, or no output yet
    uint8_t state;          // enum station_state
    uint8_t fault;          // enum station_fault_code; codes above 8 are kept for later versions
    uint8_t status;
    uint16_t supply_mV;
};

// One output frame.
struct station_output {
    uint8_t flags;
    uint16_t sequence;
    uint16_t answered_sequence;   // of the input frame that it answers
    uint8_t hold_ms;              // 1..STATION_MOST_HOLD_MS
    int32_t effort[STATION_AXES]; // µN or µN·m
    int16_t display_force_mN; // along the platform's normal; the three are 0 without STATION_OUTPUT_DISPLAY
    int16_t display_pitch_1e4_rad; // 0.1 mrad
    int16_t display_roll_1e4_rad;
};

// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, not reflected. "123456789" gives 0x29B1.
uint16_t station_crc16(const uint8_t* bytes, size_t count);
// CRC-32 of IEEE 802.3. "123456789" gives 0xCBF43926. crc: 0, or what the bytes before these gave.
uint32_t station_crc32(uint32_t crc, const uint8_t* bytes, size_t count);

// True where a comes after b in 16-bit serial arithmetic: less than half the circle ahead of it.
bool station_newer(uint16_t a, uint16_t b);
// How many numbers lie between b and the newer a: 0 where a follows b at once.
uint16_t station_gap(uint16_t a, uint16_t b);

// Writes the CRC into the last two bytes.
void station_seal(uint8_t* frame);
// STATION_BAD_CRC or STATION_OK.
enum station_result station_check_crc(const uint8_t* frame);
// The type of a frame, not checked.
uint8_t station_frame_type(const uint8_t* frame);

// Each writes a whole frame of STATION_FRAME_SIZE bytes. STATION_BAD_VALUE, and nothing written, where the
// decoder would refuse it.
enum station_result station_encode_input(const struct station_input* input, uint8_t* frame);
enum station_result station_encode_output(const struct station_output* output, uint8_t* frame);

// Each checks CRC, then type, then values, and leaves *out as it was unless the result is STATION_OK.
// Reserved bytes and bits are ignored and read as 0. Refused values: a state above 3, flags of an input frame
// that contradict its state, a hold of 0 or above 20 ms.
enum station_result station_decode_input(const uint8_t* frame, struct station_input* out);
enum station_result station_decode_output(const uint8_t* frame, struct station_output* out);

// Little-endian access to a frame's bytes; IEEE 754 for f32 and f64.
void station_put_u16(uint8_t* at, uint16_t value);
void station_put_u32(uint8_t* at, uint32_t value);
void station_put_f32(uint8_t* at, float value);
void station_put_f64(uint8_t* at, double value);
uint16_t station_get_u16(const uint8_t* at);
uint32_t station_get_u32(const uint8_t* at);
int16_t station_get_i16(const uint8_t* at);
int32_t station_get_i32(const uint8_t* at);
float station_get_f32(const uint8_t* at);
double station_get_f64(const uint8_t* at);

#ifdef __cplusplus
}
#endif
#endif
