// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/haptic_frame.h"
#include "core/result.h"
#include "session/session_setup.h"
#include "simulation/scene.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace chiron::bench {

/// One session of the expert as the loop ran it, kept in memory: the input that every repeat gets again.
struct RecordedSession {
    session::SessionSetup setup;
    std::vector<core::HapticFrame> frames; ///< as many ticks as asked for, or fewer if it finished before
};

/// What a timed pass over a session gave.
struct TickTimes {
    std::vector<double> tick_ns;      ///< of each tick, one clock read included
    std::uint64_t allocations = 0;    ///< malloc and its kin, inside ticks
    std::uint64_t otherForbidden = 0; ///< free, lock, notify, throw, write, inside ticks
    std::uint64_t dropped = 0;        ///< frames that found no room in the ring
};

std::unique_ptr<simulation::IScene> sceneOf(const session::SessionSetup& setup);

/// Runs `level` of the shipped content with the simulated plant, untimed. Failure: the product's own.
core::Result<RecordedSession> recordSession(const char* exercise, int level, std::uint64_t seed,
                                            std::size_t ticks);
/// Whole ticks with the plant and the expert's hand on it, into a crash ring.
core::Result<TickTimes> timeWithPlant(const RecordedSession& session);
/// Whole ticks with the recorded packets as device, into a crash ring: what the loop itself costs.
core::Result<TickTimes> timeWithRecordedDevice(const RecordedSession& session);
/// Frames that the loop makes again, bit for bit, from the recorded packets.
core::Result<std::size_t> sameFrames(const RecordedSession& session);

} // namespace chiron::bench
