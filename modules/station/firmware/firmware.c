// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/firmware/firmware.h"

#define LOW_SUPPLY_PERIODS 5

bool firmware_begin(struct firmware* firmware, const struct description* description) {
    static const struct firmware nothing;
    *firmware = nothing;
    firmware->description = description;
    firmware->shown_state = 255;
    station_cobs_begin(&firmware->decoder);
    static const uint8_t begins = 0; // of the line
    (void)byte_ring_put(&firmware->to_send, &begins, 1);
    board_motors_off();
    return station_device_begin(&firmware->device, &description->device, 0);
}

// A frame that finds no room is dropped: what is newer comes soon.
static void send_frame(struct firmware* firmware, const uint8_t* frame) {
    uint8_t line[STATION_COBS_SIZE];
    station_cobs_encode(frame, line);
    (void)byte_ring_put(&firmware->to_send, line, STATION_COBS_SIZE);
}

static size_t add_text(char* line, size_t at, const char* text) {
    while (*text != 0)
        line[at++] = *text++;
    return at;
}

static size_t add_number(char* line, size_t at, uint32_t number) {
    char digits[10];
    size_t count = 0;
    do {
        digits[count++] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number != 0);
    while (count > 0)
        line[at++] = digits[--count];
    return at;
}

static void tell_service(struct firmware* firmware) {
    const struct station_device* device = &firmware->device;
    if (device->state == firmware->shown_state && device->let_go == firmware->shown_let_go)
        return;
    static const char* const states[] = {"unknown", "homed", "armed", "fault"};
    char line[96];
    size_t at = add_number(line, 0, device->now_us);
    at = add_text(line, at, " us ");
    at = add_text(line, at, states[device->state & 3u]);
    at = add_text(line, at, device->let_go ? " let-go" : "");
    at = add_text(line, at, " fault ");
    at = add_number(line, at, device->fault);
    at = add_text(line, at, " age ");
    at = add_number(line, at, device->age_us);
    at = add_text(line, at, " hold ");
    at = add_number(line, at, device->hold_ms);
    at = add_text(line, at, "\r\n");
    if (!byte_ring_put(&firmware->service, (const uint8_t*)line, at))
        return; // told as soon as there is room
    firmware->shown_state = device->state;
    firmware->shown_let_go = device->let_go;
}

static bool is_overspeed(struct firmware* firmware, uint8_t axis, int32_t counts) {
    const int32_t most = firmware->description->motors[axis].most_counts_per_ms;
    const int64_t moved = (int64_t)counts - firmware->last_counts[axis];
    firmware->last_counts[axis] = counts;
    return most > 0 && firmware->ticks > FIRMWARE_TICKS_A_PERIOD && (moved > most || moved < -most);
}

static uint8_t look_for_fault(struct firmware* firmware, bool period) {
    const struct description* description = firmware->description;
    uint8_t fault = board_fault();
    for (uint8_t axis = 0; axis < description->device.identity.axes; ++axis) {
        if (current_control_trips(&firmware->controls[axis], &description->motors[axis],
                                  board_current_mA(axis)) &&
            fault == STATION_NO_FAULT)
            fault = STATION_OVER_CURRENT;
        if (period && is_overspeed(firmware, axis, board_counts(axis)) && fault == STATION_NO_FAULT)
            fault = STATION_OVERSPEED;
    }
    if (period) {
        const bool low = board_supply_mV() < description->least_supply_mV;
        if (!low)
            firmware->low_supply_periods = 0;
        else if (firmware->low_supply_periods < LOW_SUPPLY_PERIODS)
            ++firmware->low_supply_periods;
    }
    if (firmware->low_supply_periods == LOW_SUPPLY_PERIODS && fault == STATION_NO_FAULT)
        fault = STATION_SUPPLY_FAULT;
    return fault;
}

static void drive_motors(struct firmware* firmware) {
    const struct description* description = firmware->description;
    if (station_device_state(&firmware->device) != STATION_ARMED) {
        board_motors_off();
        for (uint8_t axis = 0; axis < STATION_AXES; ++axis)
            current_control_reset(&firmware->controls[axis]);
        return;
    }
    for (uint8_t axis = 0; axis < description->device.identity.axes; ++axis)
        board_drive(axis, current_control_step(&firmware->controls[axis], &description->motors[axis],
                                               station_device_effort(&firmware->device, axis),
                                               board_current_mA(axis)));
}

static void send_input(struct firmware* firmware) {
    struct station_sample sample = {{0}, 0, {0}, false, 0, 0};
    if (station_device_take_reference(&firmware->device)) {
        for (uint8_t axis = 0; axis < STATION_AXES; ++axis)
            firmware->reference[axis] = (int32_t)((uint32_t)board_counts(axis) -
                                                  (uint32_t)firmware->description->reference_counts[axis]);
    }
    for (uint8_t axis = 0; axis < STATION_AXES; ++axis) // as unsigned, which may wrap
        sample.counts[axis] = (int32_t)((uint32_t)board_counts(axis) - (uint32_t)firmware->reference[axis]);
    sample.buttons = board_buttons();
    sample.supply_mV = board_supply_mV();
    uint8_t frame[STATION_FRAME_SIZE];
    station_device_input(&firmware->device, &sample, frame);
    send_frame(firmware, frame);
}

void firmware_tick(struct firmware* firmware) {
    firmware->now_us += FIRMWARE_TICK_US;
    ++firmware->ticks;
    const bool period = firmware->ticks % FIRMWARE_TICKS_A_PERIOD == 0;
    board_tick();
    struct station_hardware hardware = {false, false, false, 0};
    hardware.dead_man = board_dead_man();
    hardware.fault = look_for_fault(firmware, period);
    for (uint8_t axis = 0; axis < STATION_AXES; ++axis)
        hardware.motor_at_limit = hardware.motor_at_limit || firmware->controls[axis].at_limit;
    station_device_advance(&firmware->device, firmware->now_us, &hardware);
    drive_motors(firmware);
    tell_service(firmware);
    if (period)
        send_input(firmware);
}

void firmware_poll(struct firmware* firmware) {
    uint8_t byte = 0;
    while (byte_ring_take(&firmware->received, &byte)) {
        uint8_t frame[STATION_FRAME_SIZE];
        const enum station_cobs_event event = station_cobs_take(&firmware->decoder, byte, frame);
        if (event == STATION_COBS_NOTHING)
            continue;
        uint8_t reply[STATION_FRAME_SIZE];
        board_lock();
        if (event == STATION_COBS_BROKEN)
            station_device_broken_block(&firmware->device);
        else if (station_device_receive(&firmware->device, firmware->now_us, frame, reply) ==
                 STATION_TOOK_REQUEST)
            send_frame(firmware, reply);
        board_unlock();
    }
}
