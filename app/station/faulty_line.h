// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/station/fault_plan.h"
#include "core/random.h"
#include "station/stream/frame_stream.h"

#include <cstdint>
#include <deque>

namespace chiron::station {

/// What a fault does to frames on their way. Seeded: the same frames at the same times meet the same fate.
/// Times are milliseconds of the station's clock.
class FaultyLine {
public:
    FaultyLine(const FaultPlan& plan, std::uint64_t seed);

    /// Takes a frame that the station sends.
    void push(const FrameBytes& frame, std::uint64_t now_ms);
    /// Gives the next frame that leaves by now; false if there is none.
    bool pop(FrameBytes& frame, std::uint64_t now_ms);
    /// What becomes of a frame that has come: false if it is lost.
    bool admits(FrameBytes& frame, std::uint64_t now_ms);

    bool frozen(std::uint64_t now_ms) const noexcept;    ///< nothing is sent and nothing is taken
    bool unplugged(std::uint64_t now_ms) const noexcept; ///< the line is gone
    bool acts(std::uint64_t now_ms) const noexcept;      ///< the fault's time has come
    void forget() noexcept { m_waiting.clear(); }        ///< what is on its way is lost with the line

private:
    struct Waiting {
        FrameBytes frame;
        std::uint64_t leaves_ms;
    };
    bool draws() noexcept { return m_random.uniform() < m_plan.amount; }
    bool during(FaultKind kind, std::uint64_t now_ms) const noexcept;
    void damage(FrameBytes& frame) noexcept;

    FaultPlan m_plan;
    std::uint64_t m_begin_ms;
    core::Random m_random;
    std::deque<Waiting> m_waiting;
};

} // namespace chiron::station
