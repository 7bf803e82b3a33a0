// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/session_state.h"
#include "scoring/own_trace.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace chiron::scoring {

/// Which optional columns of a trace file are present (cli.md, Trace files).
struct TraceColumns {
    bool orientation = false; ///< qw,qx,qy,qz
    bool jaw = false;         ///< jaw_deg
    bool buttons = false;
    bool tool = false;
    bool tissue = false;    ///< fx_N,fy_N,fz_N
    bool commanded = false; ///< commanded_fx_N ...
    bool measured = false;  ///< measured_fx_N ...
    bool trial = false;
    bool phase = false;
    bool paused = false;
    bool mark = false;               ///< marked, timed_out, mark_in_contact, mark_x_mm, mark_y_mm, mark_z_mm
    bool target = false;             ///< target_x_mm, target_y_mm, target_radius_mm
    bool forceLimit = false;         ///< force_limit_N
    bool torque = false;             ///< tx_mNm,ty_mNm,tz_mNm
    const OwnColumns* own = nullptr; ///< the columns of one exercise; null: none
    bool completed = false;          ///< per trial
    bool failed = false;             ///< per trial
    bool unfinished = false;         ///< per trial
    bool planned = false;            ///< trials_planned
    bool contact = false;            ///< core::contact_bits
    std::vector<std::string> quantities; ///< ids of the columns quantity_<id>, in the file's order
    std::vector<std::string> truth;      ///< ids of the columns truth_<id>, in the file's order
};

/// One row: frame W, tool tip. SI here; the file uses mm and degrees. Absent columns keep the defaults.
struct TraceRow {
    double t_s = 0.0; ///< whole µs, strictly increasing per tool
    core::Vec3 p_WT_m = core::Vec3::Zero();
    core::Quat q_WT = core::Quat::Identity(); ///< unit length to within 1e-3 in the file, normalised here
    double jaw_rad = 0.0;
    std::uint32_t buttons = 0; ///< bit 0 = mark
    std::uint8_t tool = 0;     ///< 0..3
    core::Vec3 tissue_N = core::Vec3::Zero();
    core::Vec3 commanded_N = core::Vec3::Zero();
    core::Vec3 measured_N = core::Vec3::Zero();
    std::int32_t trial = 0; ///< 0-based; the file counts from 1
    core::TrialPhase phase = core::TrialPhase::running;
    bool paused = false;
    // Per trial, and the same on each of its rows, so that they do not depend on a single row:
    bool marked = false;
    bool timedOut = false;
    bool markInContact = false;
    core::Vec3 p_WMark_m = core::Vec3::Zero();
    core::Vec3 target_m = core::Vec3::Zero(); ///< x, y (z unused)
    double targetRadius_m = 0.0;
    double forceLimit_N = 0.0;
    core::Vec3 tissueTorque_Nm = core::Vec3::Zero(); ///< about the tip
    /// SI, in the order of OwnColumns::columns; empty without such columns.
    std::vector<double> own;
    bool completed = false;   ///< per trial
    bool failed = false;      ///< per trial
    bool unfinished = false;  ///< per trial
    int plannedTrials = 0;    ///< per session
    std::uint8_t contact = 0; ///< core::contact_bits
    /// SI, in the order of TraceColumns::quantities; on the rows of other tools than 0, NaN or empty.
    std::vector<double> quantities;
    /// SI, in the order of TraceColumns::truth; the same on each row of a trial, NaN if it has none.
    std::vector<double> truth;
};

/// The content of a trace file. It also drives the replay of a recorded trace.
struct TraceRows {
    TraceColumns columns;
    std::vector<TraceRow> rows; ///< in file order
    std::string source;         ///< file name for messages
};

} // namespace chiron::scoring
