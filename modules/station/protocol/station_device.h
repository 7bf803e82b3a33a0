// SPDX-License-Identifier: GPL-3.0-or-later
// The device's side of the station protocol: which frames count, when efforts pass, when the device lets go.
// No clock, no link and no motor of its own: time, frames and measurements come in, frames and clamped
// efforts go out. The reference firmware and the emulated station run the same code. Not reentrant: where an
// interrupt calls it, whoever else calls it keeps that interrupt away.
#ifndef CHIRON_STATION_DEVICE_H
#define CHIRON_STATION_DEVICE_H

#include "station/protocol/station_features.h"

#ifdef __cplusplus
extern "C" {
#endif

// After so long without a valid output, the next one may have any number: a host that starts again need not
// know where the last one was. The device has let go long before.
#define STATION_NEW_HOST_US 500000u

// What the device is. The device keeps a pointer: it must outlive it, and may lie in read-only memory.
struct station_device_config {
    struct station_identity identity; // major and minor are filled in by the code
    struct station_names names;
    struct station_kinematics kinematics;
    struct station_calibration calibration;
    struct station_axis axes[STATION_AXES];
    struct station_parameters parameters[STATION_MOST_PARAMETERS / STATION_PARAMETERS_A_PAGE];
};

// What the control loop knows, each period.
struct station_hardware {
    bool dead_man;       // held; not looked at without STATION_HAS_DEAD_MAN
    bool at_reference;   // the counts are absolute, or an index pulse or a stop has set them
    bool motor_at_limit; // any motor runs at its limit
    uint8_t fault;       // enum station_fault_code of a fault that lasts now
};

// What an input frame says beyond the device's state.
struct station_sample {
    int32_t counts[STATION_AXES];
    int16_t jaw;
    int16_t wrench[6]; // mN, then 0.1 mN·m, in D
    bool wrench_valid;
    uint8_t buttons; // 0..15
    uint16_t supply_mV;
};

enum station_received {
    STATION_TOOK_OUTPUT = 0,
    STATION_TOOK_REQUEST = 1, // a reply was written
    STATION_IGNORED_CRC = 2,
    STATION_IGNORED_FRAME = 3, // wrong type or hold
    STATION_IGNORED_STALE = 4  // not newer than the last valid output
};

// Read what is public through the functions below.
struct station_device {
    const struct station_device_config* config;
    struct station_counters counters;
    int32_t limit[STATION_AXES];  // µN or µN·m
    int32_t display_limit_mN;     // the device's largest force
    int32_t effort[STATION_AXES]; // all 0 unless armed
    int16_t display[3];           // force mN, pitch and roll 0.1 mrad
    uint32_t now_us;
    uint32_t second_us; // of the second that runs
    uint32_t age_us;    // since the last valid output; does not wrap
    uint16_t sequence;  // of the next input frame
    uint16_t applied_sequence;
    uint8_t state;
    uint8_t fault;
    uint8_t hardware_fault;
    uint8_t hold_ms;
    bool dead_man;
    bool referenced;
    bool motor_at_limit;
    bool clamped;
    bool let_go;
    bool may_arm;      // a valid output without enable has come since armed was last left
    bool has_sequence; // of an output of this host
    bool had_output;
    bool display_valid;
    bool take_reference;
};

// In state unknown, at the given time. False, and the device must not be used, where a page of config could
// not be written.
bool station_device_begin(struct station_device* device, const struct station_device_config* config,
                          uint32_t now_us);

// One frame of STATION_FRAME_SIZE bytes that came in. Of a feature request, reply is written, to be sent at
// once. Time first: an output that comes when the hold time of the last one has run out finds the device let
// go.
enum station_received station_device_receive(struct station_device* device, uint32_t now_us,
                                             const uint8_t* frame, uint8_t* reply);
// A block of a serial line was no frame.
void station_device_broken_block(struct station_device* device);
// The link is gone, or another host has it: lets go, and takes any number next.
void station_device_link_lost(struct station_device* device, uint32_t now_us);

// Once a period, by a timer that does not depend on the link: hold time, faults, dead-man, reference. At
// least once in 71 minutes.
void station_device_advance(struct station_device* device, uint32_t now_us,
                            const struct station_hardware* hardware);

// Writes the next input frame. Once a period, after station_device_advance().
void station_device_input(struct station_device* device, const struct station_sample* sample, uint8_t* frame);

uint8_t station_device_state(const struct station_device* device);
// Of an axis 0..7, in µN or µN·m: within its rating, and 0 unless armed.
int32_t station_device_effort(const struct station_device* device, uint8_t axis);
// What a fingertip platform shows; false, and all 0, unless armed and told by the last output.
bool station_device_display(const struct station_device* device, int16_t* force_mN, int16_t* pitch_1e4_rad,
                            int16_t* roll_1e4_rad);
// True once after the home flag was taken: the control loop makes the present position its reference. Where
// the counts are absolute there is nothing to do.
bool station_device_take_reference(struct station_device* device);
// A fault that somebody other than the control loop found. Cleared as others are.
void station_device_raise_fault(struct station_device* device, uint8_t code);

// An axis' rating in µN or µN·m, to the nearest.
int32_t station_effort_limit(float rating);

#ifdef __cplusplus
}
#endif
#endif
