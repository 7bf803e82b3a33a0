// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/haptic_frame.h"

#include <filesystem>
#include <sqlite3.h>
#include <vector>

namespace chiron::bench {

/// The answer to both questions, of one session.
struct Totals {
    double peakForce_N = 0.0;
    double path_m = 0.0;
};

/// One sample as the peer keeps it: the tool's place in W is stored, so that it computes no kinematics.
struct Sample {
    core::HapticFrame frame;
    core::Vec3 p_WT_m = core::Vec3::Zero();
};

/// The peer: one SQLite row of 24 REAL columns a sample, of one session. The file goes with the object.
class SampleRows {
public:
    SampleRows(const std::filesystem::path& file, const std::vector<Sample>& samples);
    SampleRows(const SampleRows&) = delete;
    SampleRows& operator=(const SampleRows&) = delete;
    ~SampleRows();

    Totals ask(); ///< one scan for both, unpaused samples

private:
    std::filesystem::path m_file;
    sqlite3* m_database = nullptr;
};

} // namespace chiron::bench
