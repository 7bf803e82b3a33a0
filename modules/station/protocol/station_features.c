// SPDX-License-Identifier: GPL-3.0-or-later
#include "station/protocol/station_features.h"

#define FIRST 4 // where a page's values begin
#define NAME_BYTES 28
#define KINEMATICS_BYTES 24
#define PERSON_BYTES 24
#define AXIS_ID_BYTES 13

static void begin_frame(uint8_t type, uint8_t page, uint8_t status, uint8_t* frame) {
    for (size_t i = 0; i < STATION_FRAME_SIZE; ++i)
        frame[i] = 0;
    frame[0] = type;
    frame[1] = page;
    frame[2] = status;
}

static bool is_finite64(double value) {
    return value - value == 0.0; // not so of an infinity or of what is no number
}

static bool is_finite32(float value) {
    return value - value == 0.0f;
}

// Length of the sequence that begins at text[0], 0 where it is none (RFC 3629) or a control character.
static size_t utf8_length(const uint8_t* text, size_t room) {
    const uint8_t a = text[0];
    if (a < 0x80)
        return a >= 0x20 && a != 0x7F ? 1 : 0;
    const size_t length = a >= 0xC2 && a <= 0xDF   ? 2
                          : a >= 0xE0 && a <= 0xEF ? 3
                          : a >= 0xF0 && a <= 0xF4 ? 4
                                                   : 0;
    if (length == 0 || length > room)
        return 0;
    for (size_t i = 1; i < length; ++i) {
        if ((text[i] & 0xC0) != 0x80)
            return 0;
    }
    const uint8_t b = text[1];
    if (length == 2 && a == 0xC2 && b < 0xA0) // the other control characters
        return 0;
    if ((a == 0xE0 && b < 0xA0) || (a == 0xED && b > 0x9F) || (a == 0xF0 && b < 0x90) ||
        (a == 0xF4 && b > 0x8F))
        return 0;
    return length;
}

static bool text_is_allowed(const uint8_t* text, size_t size) {
    size_t i = 0;
    while (i < size && text[i] != 0) {
        const size_t length = utf8_length(text + i, size - i);
        if (length == 0)
            return false;
        i += length;
    }
    for (; i < size; ++i) {
        if (text[i] != 0)
            return false;
    }
    return true;
}

// text has size + 1 characters; what stands after its 0 is not looked at.
static bool put_text(uint8_t* at, const char* text, size_t size) {
    size_t i = 0;
    for (; i < size && text[i] != 0; ++i)
        at[i] = (uint8_t)text[i];
    if (i == size && text[size] != 0)
        return false;
    for (; i < size; ++i)
        at[i] = 0;
    return text_is_allowed(at, size);
}

static void get_text(char* out, const uint8_t* at, size_t size) {
    for (size_t i = 0; i < size; ++i)
        out[i] = (char)at[i];
    out[size] = 0;
}

static enum station_result finish(bool allowed, const uint8_t* ready, uint8_t* frame) {
    if (!allowed)
        return STATION_BAD_VALUE;
    for (size_t i = 0; i < STATION_CRC_OFFSET; ++i)
        frame[i] = ready[i];
    station_seal(frame);
    return STATION_OK;
}

enum station_result station_encode_feature_request(uint8_t page, uint8_t* frame) {
    begin_frame(STATION_FEATURE_REQUEST, page, 0, frame);
    station_seal(frame);
    return STATION_OK;
}

enum station_result station_decode_feature_request(const uint8_t* frame, uint8_t* page) {
    if (station_check_crc(frame) != STATION_OK)
        return STATION_BAD_CRC;
    if (station_frame_type(frame) != STATION_FEATURE_REQUEST)
        return STATION_BAD_TYPE;
    *page = frame[1];
    return STATION_OK;
}

enum station_result station_decode_feature_head(const uint8_t* frame, uint8_t* page, uint8_t* status) {
    if (station_check_crc(frame) != STATION_OK)
        return STATION_BAD_CRC;
    if (station_frame_type(frame) != STATION_FEATURE_REPLY)
        return STATION_BAD_TYPE;
    if (frame[2] > STATION_NO_SUCH_PAGE)
        return STATION_BAD_VALUE;
    *page = frame[1];
    *status = frame[2];
    return STATION_OK;
}

void station_encode_no_page(uint8_t page, uint8_t* frame) {
    begin_frame(STATION_FEATURE_REPLY, page, STATION_NO_SUCH_PAGE, frame);
    station_seal(frame);
}

static enum station_result check_page(const uint8_t* frame, uint8_t wanted) {
    uint8_t page = 0;
    uint8_t status = 0;
    const enum station_result head = station_decode_feature_head(frame, &page, &status);
    if (head != STATION_OK)
        return head;
    return page == wanted && status == STATION_PAGE_OK ? STATION_OK : STATION_BAD_TYPE;
}

static bool limit_is_allowed(float value) {
    return is_finite32(value) && value >= 0.0f;
}

static bool identity_is_allowed(const struct station_identity* identity) {
    return identity->axes >= 1 && identity->axes <= STATION_AXES && identity->period_us >= 1 &&
           limit_is_allowed(identity->max_force_N) && limit_is_allowed(identity->max_torque_Nm) &&
           limit_is_allowed(identity->max_damping_Ns_per_m) && is_finite64(identity->jaw_count_rad) &&
           identity->jaw_count_rad >= 0.0 && identity->parameters <= STATION_MOST_PARAMETERS;
}

#define IDENTITY_BITS 0x7Fu

enum station_result station_encode_identity(const struct station_identity* identity, uint8_t* frame) {
    uint8_t ready[STATION_FRAME_SIZE];
    begin_frame(STATION_FEATURE_REPLY, STATION_PAGE_IDENTITY, STATION_PAGE_OK, ready);
    ready[4] = identity->major;
    ready[5] = identity->minor;
    ready[6] = identity->axes;
    ready[7] = (uint8_t)(identity->bits & IDENTITY_BITS);
    station_put_u32(ready + 8, identity->period_us);
    station_put_u32(ready + 12, identity->oldest_sample_us);
    station_put_f32(ready + 16, identity->max_force_N);
    station_put_f32(ready + 20, identity->max_torque_Nm);
    station_put_f32(ready + 24, identity->max_damping_Ns_per_m);
    station_put_f64(ready + 28, identity->jaw_count_rad);
    ready[36] = identity->parameters;
    return finish(identity_is_allowed(identity), ready, frame);
}

enum station_result station_decode_identity(const uint8_t* frame, struct station_identity* out) {
    const enum station_result head = check_page(frame, STATION_PAGE_IDENTITY);
    if (head != STATION_OK)
        return head;
    struct station_identity read;
    read.major = frame[4];
    read.minor = frame[5];
    read.axes = frame[6];
    read.bits = (uint8_t)(frame[7] & IDENTITY_BITS);
    read.period_us = station_get_u32(frame + 8);
    read.oldest_sample_us = station_get_u32(frame + 12);
    read.max_force_N = station_get_f32(frame + 16);
    read.max_torque_Nm = station_get_f32(frame + 20);
    read.max_damping_Ns_per_m = station_get_f32(frame + 24);
    read.jaw_count_rad = station_get_f64(frame + 28);
    read.parameters = frame[36];
    if (!identity_is_allowed(&read))
        return STATION_BAD_VALUE;
    *out = read;
    return STATION_OK;
}

enum station_result station_encode_names(const struct station_names* names, uint8_t* frame) {
    uint8_t ready[STATION_FRAME_SIZE];
    begin_frame(STATION_FEATURE_REPLY, STATION_PAGE_NAMES, STATION_PAGE_OK, ready);
    const bool model = put_text(ready + FIRST, names->model, NAME_BYTES);
    const bool serial = put_text(ready + FIRST + NAME_BYTES, names->serial_number, NAME_BYTES);
    return finish(model && serial, ready, frame);
}

enum station_result station_decode_names(const uint8_t* frame, struct station_names* out) {
    const enum station_result head = check_page(frame, STATION_PAGE_NAMES);
    if (head != STATION_OK)
        return head;
    if (!text_is_allowed(frame + FIRST, NAME_BYTES) ||
        !text_is_allowed(frame + FIRST + NAME_BYTES, NAME_BYTES))
        return STATION_BAD_VALUE;
    get_text(out->model, frame + FIRST, NAME_BYTES);
    get_text(out->serial_number, frame + FIRST + NAME_BYTES, NAME_BYTES);
    return STATION_OK;
}

enum station_result station_encode_kinematics(const struct station_kinematics* kinematics, uint8_t* frame) {
    uint8_t ready[STATION_FRAME_SIZE];
    begin_frame(STATION_FEATURE_REPLY, STATION_PAGE_KINEMATICS, STATION_PAGE_OK, ready);
    const bool id = put_text(ready + FIRST, kinematics->id, KINEMATICS_BYTES);
    const bool firmware = put_text(ready + FIRST + KINEMATICS_BYTES, kinematics->firmware, NAME_BYTES);
    return finish(id && firmware, ready, frame);
}

enum station_result station_decode_kinematics(const uint8_t* frame, struct station_kinematics* out) {
    const enum station_result head = check_page(frame, STATION_PAGE_KINEMATICS);
    if (head != STATION_OK)
        return head;
    if (!text_is_allowed(frame + FIRST, KINEMATICS_BYTES) ||
        !text_is_allowed(frame + FIRST + KINEMATICS_BYTES, NAME_BYTES))
        return STATION_BAD_VALUE;
    get_text(out->id, frame + FIRST, KINEMATICS_BYTES);
    get_text(out->firmware, frame + FIRST + KINEMATICS_BYTES, NAME_BYTES);
    return STATION_OK;
}

enum station_result station_encode_calibration(const struct station_calibration* calibration,
                                               uint8_t* frame) {
    uint8_t ready[STATION_FRAME_SIZE];
    begin_frame(STATION_FEATURE_REPLY, STATION_PAGE_CALIBRATION, STATION_PAGE_OK, ready);
    station_put_u32(ready + 4, calibration->unix_time);
    station_put_u32(ready + 8, calibration->crc32);
    return finish(put_text(ready + 12, calibration->by_whom, PERSON_BYTES), ready, frame);
}

enum station_result station_decode_calibration(const uint8_t* frame, struct station_calibration* out) {
    const enum station_result head = check_page(frame, STATION_PAGE_CALIBRATION);
    if (head != STATION_OK)
        return head;
    if (!text_is_allowed(frame + 12, PERSON_BYTES))
        return STATION_BAD_VALUE;
    out->unix_time = station_get_u32(frame + 4);
    out->crc32 = station_get_u32(frame + 8);
    get_text(out->by_whom, frame + 12, PERSON_BYTES);
    return STATION_OK;
}

enum station_result station_encode_counters(const struct station_counters* counters, uint8_t* frame) {
    begin_frame(STATION_FEATURE_REPLY, STATION_PAGE_COUNTERS, STATION_PAGE_OK, frame);
    station_put_u32(frame + 4, counters->bad_crc);
    station_put_u32(frame + 8, counters->lost_outputs);
    station_put_u32(frame + 12, counters->watchdog_trips);
    station_put_u32(frame + 16, counters->faults);
    station_put_u32(frame + 20, counters->uptime_s);
    station_put_u32(frame + 24, counters->bad_frames);
    station_put_u32(frame + 28, counters->stale_outputs);
    station_seal(frame);
    return STATION_OK;
}

enum station_result station_decode_counters(const uint8_t* frame, struct station_counters* out) {
    const enum station_result head = check_page(frame, STATION_PAGE_COUNTERS);
    if (head != STATION_OK)
        return head;
    out->bad_crc = station_get_u32(frame + 4);
    out->lost_outputs = station_get_u32(frame + 8);
    out->watchdog_trips = station_get_u32(frame + 12);
    out->faults = station_get_u32(frame + 16);
    out->uptime_s = station_get_u32(frame + 20);
    out->bad_frames = station_get_u32(frame + 24);
    out->stale_outputs = station_get_u32(frame + 28);
    return STATION_OK;
}

static bool axis_is_allowed(const struct station_axis* axis) {
    return is_finite64(axis->count_size) && axis->count_size > 0.0 && is_finite64(axis->minimum) &&
           is_finite64(axis->maximum) && axis->minimum <= axis->maximum && limit_is_allowed(axis->rating) &&
           limit_is_allowed(axis->coulomb) && limit_is_allowed(axis->viscous) && axis->unit <= STATION_RADIAN;
}

enum station_result station_encode_axis(uint8_t index, const struct station_axis* axis, uint8_t* frame) {
    uint8_t ready[STATION_FRAME_SIZE];
    begin_frame(STATION_FEATURE_REPLY, (uint8_t)(STATION_PAGE_AXIS + index), STATION_PAGE_OK, ready);
    station_put_f64(ready + 4, axis->count_size);
    station_put_f64(ready + 12, axis->minimum);
    station_put_f64(ready + 20, axis->maximum);
    station_put_f32(ready + 28, axis->rating);
    station_put_f32(ready + 32, axis->coulomb);
    station_put_f32(ready + 36, axis->viscous);
    ready[40] = axis->unit;
    const bool id = put_text(ready + 41, axis->id, AXIS_ID_BYTES);
    return finish(id && index < STATION_AXES && axis_is_allowed(axis), ready, frame);
}

enum station_result station_decode_axis(const uint8_t* frame, uint8_t index, struct station_axis* out) {
    const enum station_result head = check_page(frame, (uint8_t)(STATION_PAGE_AXIS + index));
    if (head != STATION_OK)
        return head;
    struct station_axis read;
    read.count_size = station_get_f64(frame + 4);
    read.minimum = station_get_f64(frame + 12);
    read.maximum = station_get_f64(frame + 20);
    read.rating = station_get_f32(frame + 28);
    read.coulomb = station_get_f32(frame + 32);
    read.viscous = station_get_f32(frame + 36);
    read.unit = frame[40];
    get_text(read.id, frame + 41, AXIS_ID_BYTES);
    if (index >= STATION_AXES || !axis_is_allowed(&read) || !text_is_allowed(frame + 41, AXIS_ID_BYTES))
        return STATION_BAD_VALUE;
    *out = read;
    return STATION_OK;
}

#define PARAMETER_PAGES (STATION_MOST_PARAMETERS / STATION_PARAMETERS_A_PAGE)

static bool parameters_are_allowed(const struct station_parameters* parameters) {
    for (size_t i = 0; i < STATION_PARAMETERS_A_PAGE; ++i) {
        if (!is_finite64(parameters->values[i]))
            return false;
    }
    return true;
}

enum station_result station_encode_parameters(uint8_t index, const struct station_parameters* parameters,
                                              uint8_t* frame) {
    uint8_t ready[STATION_FRAME_SIZE];
    begin_frame(STATION_FEATURE_REPLY, (uint8_t)(STATION_PAGE_PARAMETERS + index), STATION_PAGE_OK, ready);
    for (size_t i = 0; i < STATION_PARAMETERS_A_PAGE; ++i)
        station_put_f64(ready + FIRST + 8 * i, parameters->values[i]);
    return finish(index < PARAMETER_PAGES && parameters_are_allowed(parameters), ready, frame);
}

enum station_result station_decode_parameters(const uint8_t* frame, uint8_t index,
                                              struct station_parameters* out) {
    const enum station_result head = check_page(frame, (uint8_t)(STATION_PAGE_PARAMETERS + index));
    if (head != STATION_OK)
        return head;
    struct station_parameters read;
    for (size_t i = 0; i < STATION_PARAMETERS_A_PAGE; ++i)
        read.values[i] = station_get_f64(frame + FIRST + 8 * i);
    if (index >= PARAMETER_PAGES || !parameters_are_allowed(&read))
        return STATION_BAD_VALUE;
    *out = read;
    return STATION_OK;
}

uint32_t station_calibration_crc32(const struct station_axis* axes, uint8_t axis_count,
                                   const struct station_parameters* parameters, uint8_t page_count) {
    uint8_t frame[STATION_FRAME_SIZE];
    uint32_t crc = 0;
    for (uint8_t i = 0; i < axis_count; ++i) {
        if (station_encode_axis(i, axes + i, frame) != STATION_OK)
            return 0;
        crc = station_crc32(crc, frame + FIRST, STATION_CRC_OFFSET - FIRST);
    }
    for (uint8_t i = 0; i < page_count; ++i) {
        if (station_encode_parameters(i, parameters + i, frame) != STATION_OK)
            return 0;
        crc = station_crc32(crc, frame + FIRST, STATION_CRC_OFFSET - FIRST);
    }
    return crc;
}
