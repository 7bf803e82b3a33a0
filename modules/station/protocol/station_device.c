// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/protocol/station_device.h"

#define LONGEST_AGE_US 0xFFFFFFFFu

int32_t station_effort_limit(float rating) {
    if (!(rating > 0.0f))
        return 0;
    const double micro = (double)rating * 1e6 + 0.5;
    return micro < 2147483647.0 ? (int32_t)micro : INT32_MAX;
}

static uint8_t parameter_pages(const struct station_device_config* config) {
    return (uint8_t)((config->identity.parameters + STATION_PARAMETERS_A_PAGE - 1) /
                     STATION_PARAMETERS_A_PAGE);
}

static void write_page(const struct station_device* device, uint8_t page, uint8_t* reply) {
    const struct station_device_config* config = device->config;
    enum station_result result = STATION_BAD_VALUE;
    if (page == STATION_PAGE_IDENTITY) {
        struct station_identity identity = config->identity;
        identity.major = STATION_MAJOR;
        identity.minor = STATION_MINOR;
        result = station_encode_identity(&identity, reply);
    } else if (page == STATION_PAGE_NAMES) {
        result = station_encode_names(&config->names, reply);
    } else if (page == STATION_PAGE_KINEMATICS) {
        result = station_encode_kinematics(&config->kinematics, reply);
    } else if (page == STATION_PAGE_CALIBRATION) {
        result = station_encode_calibration(&config->calibration, reply);
    } else if (page == STATION_PAGE_COUNTERS) {
        result = station_encode_counters(&device->counters, reply);
    } else if (page >= STATION_PAGE_AXIS && page < STATION_PAGE_AXIS + config->identity.axes) {
        const uint8_t axis = (uint8_t)(page - STATION_PAGE_AXIS);
        result = station_encode_axis(axis, &config->axes[axis], reply);
    } else if (page >= STATION_PAGE_PARAMETERS && page < STATION_PAGE_PARAMETERS + parameter_pages(config)) {
        const uint8_t index = (uint8_t)(page - STATION_PAGE_PARAMETERS);
        result = station_encode_parameters(index, &config->parameters[index], reply);
    }
    if (result != STATION_OK)
        station_encode_no_page(page, reply);
}

static bool config_is_allowed(const struct station_device* device) {
    const struct station_device_config* config = device->config;
    if (config->identity.axes > STATION_AXES || config->identity.parameters > STATION_MOST_PARAMETERS)
        return false;
    const uint8_t lasts[3] = {STATION_PAGE_COUNTERS, (uint8_t)(STATION_PAGE_AXIS + config->identity.axes - 1),
                              (uint8_t)(STATION_PAGE_PARAMETERS + parameter_pages(config) - 1)};
    const uint8_t firsts[3] = {STATION_PAGE_IDENTITY, STATION_PAGE_AXIS, STATION_PAGE_PARAMETERS};
    for (size_t kind = 0; kind < 3; ++kind) {
        for (uint8_t page = firsts[kind]; page <= lasts[kind]; ++page) {
            uint8_t reply[STATION_FRAME_SIZE];
            write_page(device, page, reply);
            if (reply[2] != STATION_PAGE_OK)
                return false;
        }
    }
    return true;
}

static void zero_efforts(struct station_device* device) {
    for (size_t axis = 0; axis < STATION_AXES; ++axis)
        device->effort[axis] = 0;
    for (size_t i = 0; i < 3; ++i)
        device->display[i] = 0;
    device->display_valid = false;
    device->clamped = false;
}

static uint8_t resting_state(const struct station_device* device) {
    return device->referenced ? STATION_HOMED : STATION_UNKNOWN;
}

static void disarm(struct station_device* device) {
    zero_efforts(device);
    device->may_arm = false;
    if (device->state == STATION_ARMED)
        device->state = resting_state(device);
}

bool station_device_begin(struct station_device* device, const struct station_device_config* config,
                          uint32_t now_us) {
    static const struct station_device nothing;
    *device = nothing;
    device->config = config;
    device->now_us = now_us;
    device->age_us = LONGEST_AGE_US;
    device->state = STATION_UNKNOWN;
    for (size_t axis = 0; axis < STATION_AXES; ++axis)
        device->limit[axis] =
            axis < config->identity.axes ? station_effort_limit(config->axes[axis].rating) : 0;
    device->display_limit_mN = station_effort_limit(config->identity.max_force_N) / 1000;
    return config_is_allowed(device);
}

// The clock, and the hold time by it.
static void pass_time(struct station_device* device, uint32_t now_us) {
    const uint32_t passed = now_us - device->now_us;
    device->now_us = now_us;
    device->counters.uptime_s += passed / 1000000u;
    device->second_us += passed % 1000000u;
    if (device->second_us >= 1000000u) {
        device->second_us -= 1000000u;
        ++device->counters.uptime_s;
    }
    device->age_us = passed > LONGEST_AGE_US - device->age_us ? LONGEST_AGE_US : device->age_us + passed;
    if (device->state == STATION_ARMED && device->age_us >= 1000u * device->hold_ms) {
        disarm(device);
        device->let_go = true;
        ++device->counters.watchdog_trips;
    }
}

void station_device_raise_fault(struct station_device* device, uint8_t code) {
    if (code == STATION_NO_FAULT)
        return;
    if (code == STATION_ENCODER_FAULT)
        device->referenced = false;
    if (device->state == STATION_FAULT) // the first one is told
        return;
    disarm(device);
    device->state = STATION_FAULT;
    device->fault = code;
    ++device->counters.faults;
}

void station_device_link_lost(struct station_device* device, uint32_t now_us) {
    pass_time(device, now_us);
    if (device->state == STATION_ARMED) {
        device->let_go = true;
        ++device->counters.watchdog_trips;
    }
    disarm(device);
    device->has_sequence = false;
}

void station_device_broken_block(struct station_device* device) {
    ++device->counters.bad_crc;
}

void station_device_advance(struct station_device* device, uint32_t now_us,
                            const struct station_hardware* hardware) {
    pass_time(device, now_us);
    const bool has_dead_man = (device->config->identity.bits & STATION_HAS_DEAD_MAN) != 0;
    device->dead_man = has_dead_man && hardware->dead_man;
    device->motor_at_limit = hardware->motor_at_limit;
    device->hardware_fault = hardware->fault;
    station_device_raise_fault(device, hardware->fault);
    if (hardware->at_reference && hardware->fault != STATION_ENCODER_FAULT)
        device->referenced = true;
    if (device->state == STATION_UNKNOWN)
        device->state = resting_state(device);
    if (device->state == STATION_ARMED && has_dead_man && !device->dead_man)
        disarm(device);
}

static int32_t clamp(struct station_device* device, int32_t wanted, int32_t limit) {
    const int32_t given = wanted > limit ? limit : wanted < -limit ? -limit : wanted;
    device->clamped = device->clamped || given != wanted;
    return given;
}

static void apply_efforts(struct station_device* device, const struct station_output* output) {
    device->clamped = false;
    for (size_t axis = 0; axis < device->config->identity.axes; ++axis)
        device->effort[axis] = clamp(device, output->effort[axis], device->limit[axis]);
    device->display_valid = (output->flags & STATION_OUTPUT_DISPLAY) != 0;
    device->display[0] = (int16_t)clamp(device, output->display_force_mN, device->display_limit_mN);
    device->display[1] = output->display_pitch_1e4_rad;
    device->display[2] = output->display_roll_1e4_rad;
}

static void take_disabled_output(struct station_device* device, uint8_t flags) {
    disarm(device);
    device->may_arm = true;
    if ((flags & STATION_OUTPUT_CLEAR_FAULT) != 0 && device->state == STATION_FAULT &&
        device->hardware_fault == STATION_NO_FAULT) {
        device->fault = STATION_NO_FAULT;
        device->state = resting_state(device);
    }
    if ((flags & STATION_OUTPUT_HOME) != 0 && device->state == STATION_UNKNOWN &&
        (device->config->identity.bits & STATION_HOMES_BY_FLAG) != 0) {
        device->referenced = true;
        device->take_reference = true;
        device->state = STATION_HOMED;
    }
}

static void take_enabled_output(struct station_device* device, const struct station_output* output) {
    const bool has_dead_man = (device->config->identity.bits & STATION_HAS_DEAD_MAN) != 0;
    if (device->state == STATION_HOMED && device->may_arm && (!has_dead_man || device->dead_man)) {
        device->state = STATION_ARMED;
        device->let_go = false;
    }
    if (device->state == STATION_ARMED)
        apply_efforts(device, output);
}

static bool is_stale(const struct station_device* device, uint16_t sequence) {
    return device->has_sequence && device->age_us < STATION_NEW_HOST_US &&
           !station_newer(sequence, device->applied_sequence);
}

enum station_received station_device_receive(struct station_device* device, uint32_t now_us,
                                             const uint8_t* frame, uint8_t* reply) {
    pass_time(device, now_us);
    if (station_check_crc(frame) != STATION_OK) {
        ++device->counters.bad_crc;
        return STATION_IGNORED_CRC;
    }
    uint8_t page = 0;
    if (station_decode_feature_request(frame, &page) == STATION_OK) {
        write_page(device, page, reply);
        return STATION_TOOK_REQUEST;
    }
    struct station_output output;
    if (station_decode_output(frame, &output) != STATION_OK) {
        ++device->counters.bad_frames;
        return STATION_IGNORED_FRAME;
    }
    if (is_stale(device, output.sequence)) {
        ++device->counters.stale_outputs;
        return STATION_IGNORED_STALE;
    }
    if (device->has_sequence && device->age_us < STATION_NEW_HOST_US)
        device->counters.lost_outputs += station_gap(output.sequence, device->applied_sequence);
    device->has_sequence = true;
    device->had_output = true;
    device->applied_sequence = output.sequence;
    device->age_us = 0;
    device->hold_ms = output.hold_ms;
    if ((output.flags & STATION_OUTPUT_ENABLE) != 0)
        take_enabled_output(device, &output);
    else
        take_disabled_output(device, output.flags);
    return STATION_TOOK_OUTPUT;
}

void station_device_input(struct station_device* device, const struct station_sample* sample,
                          uint8_t* frame) {
    struct station_input input;
    input.flags = (uint8_t)((sample->buttons << 4) & STATION_INPUT_BUTTONS);
    input.flags |= device->dead_man ? STATION_INPUT_DEAD_MAN : 0;
    input.flags |= device->state == STATION_ARMED ? STATION_INPUT_ARMED : 0;
    input.flags |= device->state == STATION_FAULT ? STATION_INPUT_FAULT : 0;
    input.flags |= device->referenced ? STATION_INPUT_HOMED : 0;
    input.sequence = device->sequence++;
    input.time_us = device->now_us;
    for (size_t axis = 0; axis < STATION_AXES; ++axis)
        input.counts[axis] = axis < device->config->identity.axes ? sample->counts[axis] : 0;
    input.jaw = (int16_t)((device->config->identity.bits & STATION_HAS_JAW) ? sample->jaw : 0);
    const bool wrench_valid =
        sample->wrench_valid && (device->config->identity.bits & STATION_MEASURES_FORCE) != 0;
    for (size_t i = 0; i < 6; ++i)
        input.wrench[i] = (int16_t)(wrench_valid ? sample->wrench[i] : 0);
    input.applied_sequence = device->applied_sequence;
    const uint32_t age_ms = device->age_us / 1000u;
    input.applied_age_ms = (uint8_t)(device->had_output && age_ms < 255u ? age_ms : 255u);
    input.state = device->state;
    input.fault = device->fault;
    input.status = wrench_valid ? STATION_STATUS_WRENCH_VALID : 0;
    input.status |= device->clamped || device->motor_at_limit ? STATION_STATUS_AT_LIMIT : 0;
    input.status |= device->let_go ? STATION_STATUS_LET_GO : 0;
    input.supply_mV = sample->supply_mV;
    (void)station_encode_input(&input, frame); // state and flags agree
}

uint8_t station_device_state(const struct station_device* device) {
    return device->state;
}

int32_t station_device_effort(const struct station_device* device, uint8_t axis) {
    return axis < STATION_AXES ? device->effort[axis] : 0;
}

bool station_device_display(const struct station_device* device, int16_t* force_mN, int16_t* pitch_1e4_rad,
                            int16_t* roll_1e4_rad) {
    *force_mN = device->display[0];
    *pitch_1e4_rad = device->display[1];
    *roll_1e4_rad = device->display[2];
    return device->display_valid;
}

bool station_device_take_reference(struct station_device* device) {
    const bool take = device->take_reference;
    device->take_reference = false;
    return take;
}
