// SPDX-License-Identifier: GPL-3.0-or-later
// Feature pages: what a station is. A host asks for a page by a frame of type 3 and gets one of type 4
// (docs/station-protocol.md).
#ifndef CHIRON_STATION_FEATURES_H
#define CHIRON_STATION_FEATURES_H

#include "station/protocol/station_frame.h"

#ifdef __cplusplus
extern "C" {
#endif

enum station_page {
    STATION_PAGE_IDENTITY = 0,
    STATION_PAGE_NAMES = 1,
    STATION_PAGE_KINEMATICS = 2,
    STATION_PAGE_CALIBRATION = 3,
    STATION_PAGE_COUNTERS = 4,
    STATION_PAGE_AXIS = 16,      // 16..23, one page an axis
    STATION_PAGE_PARAMETERS = 32 // 32..39, six parameters a page
};

#define STATION_PARAMETERS_A_PAGE 6
#define STATION_MOST_PARAMETERS 48

enum station_page_status { STATION_PAGE_OK = 0, STATION_NO_SUCH_PAGE = 1 };

// Bits of the identity.
#define STATION_RENDERS_FORCE 0x01u
#define STATION_MEASURES_FORCE 0x02u
#define STATION_HAS_PLATFORM 0x04u
#define STATION_HAS_JAW 0x08u
#define STATION_OFFERS_LOCKSTEP 0x10u
#define STATION_HAS_DEAD_MAN 0x20u  // it arms only while the switch is held
#define STATION_HOMES_BY_FLAG 0x40u // the home flag takes the present position as the reference

struct station_identity {
    uint8_t major;
    uint8_t minor;
    uint8_t axes; // 1..STATION_AXES
    uint8_t bits;
    uint32_t period_us;        // 1 or more
    uint32_t oldest_sample_us; // age of the oldest samples that it sends as new ones
    float max_force_N;
    float max_torque_Nm;
    float max_damping_Ns_per_m;
    double jaw_count_rad; // size of a count
    uint8_t parameters;   // number of kinematics parameters, 0..STATION_MOST_PARAMETERS
};

// Texts are UTF-8 without control characters, as many bytes as the page has room for; here a 0 follows.
struct station_names {
    char model[29];
    char serial_number[29];
};

struct station_kinematics {
    char id[25];
    char firmware[29]; // version
};

struct station_calibration {
    uint32_t unix_time; // 0: never calibrated
    uint32_t crc32;     // of its values: station_calibration_crc32()
    char by_whom[25];
};

struct station_counters {
    uint32_t bad_crc;        // with wrong CRC, and broken blocks of a serial line
    uint32_t lost_outputs;   // numbers that were skipped
    uint32_t watchdog_trips; // times that the hold time ran out while armed
    uint32_t faults;
    uint32_t uptime_s;
    uint32_t bad_frames;    // with right CRC and a wrong type or hold
    uint32_t stale_outputs; // whose number was not newer
};

enum station_unit { STATION_METRE = 0, STATION_RADIAN = 1 };

struct station_axis {
    double count_size; // m or rad; more than 0
    double minimum;    // m or rad
    double maximum;
    float rating; // continuous, N or N·m; 0: no motor
    float coulomb;
    float viscous; // N·s/m or N·m·s/rad
    uint8_t unit;  // enum station_unit
    char id[14];
};

struct station_parameters {
    double values[STATION_PARAMETERS_A_PAGE];
};

enum station_result station_encode_feature_request(uint8_t page, uint8_t* frame);
enum station_result station_decode_feature_request(const uint8_t* frame, uint8_t* page);

// Checks CRC and type of a reply and gives its page and status.
enum station_result station_decode_feature_head(const uint8_t* frame, uint8_t* page, uint8_t* status);
// A reply that says that there is no such page.
void station_encode_no_page(uint8_t page, uint8_t* frame);

// Each writes a whole reply. STATION_BAD_VALUE, and nothing written, where the decoder would refuse it.
enum station_result station_encode_identity(const struct station_identity* identity, uint8_t* frame);
enum station_result station_encode_names(const struct station_names* names, uint8_t* frame);
enum station_result station_encode_kinematics(const struct station_kinematics* kinematics, uint8_t* frame);
enum station_result station_encode_calibration(const struct station_calibration* calibration, uint8_t* frame);
enum station_result station_encode_counters(const struct station_counters* counters, uint8_t* frame);
enum station_result station_encode_axis(uint8_t index, const struct station_axis* axis, uint8_t* frame);
enum station_result station_encode_parameters(uint8_t index, const struct station_parameters* parameters,
                                              uint8_t* frame);

// Each checks CRC, type, page, status and values, and leaves *out as it was unless the result is STATION_OK.
// STATION_BAD_TYPE: another page, or one that the station does not have. STATION_BAD_VALUE: numbers that are
// not finite or out of range, texts that are not UTF-8, have control characters or go on after a 0. The major
// version is not judged: that is the host's business.
enum station_result station_decode_identity(const uint8_t* frame, struct station_identity* out);
enum station_result station_decode_names(const uint8_t* frame, struct station_names* out);
enum station_result station_decode_kinematics(const uint8_t* frame, struct station_kinematics* out);
enum station_result station_decode_calibration(const uint8_t* frame, struct station_calibration* out);
enum station_result station_decode_counters(const uint8_t* frame, struct station_counters* out);
enum station_result station_decode_axis(const uint8_t* frame, uint8_t index, struct station_axis* out);
enum station_result station_decode_parameters(const uint8_t* frame, uint8_t index,
                                              struct station_parameters* out);

// CRC-32 over bytes 4..61 of the axis pages and then of the parameter pages, in their order: what the
// calibration page holds. 0 where a page cannot be written. parameters: as many pages as the number of values
// needs.
uint32_t station_calibration_crc32(const struct station_axis* axes, uint8_t axis_count,
                                   const struct station_parameters* parameters, uint8_t page_count);

#ifdef __cplusplus
}
#endif
#endif
