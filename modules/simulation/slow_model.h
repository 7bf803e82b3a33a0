// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::simulation {

/// Says at which tick the answer of a slow model takes effect (architecture.md, Determinism). The answer to a
/// request that the scene made at tick n is due at tick n + L.
enum class SlowUpdate : std::uint8_t {
    asDue, ///< faster than real time: exactly at n + L; the tick itself computes the answer, in lock-step
    /// Real time: at n + L, or at the first later tick that finds the answer; that tick is recorded.
    whenReady,
    now,    ///< replay: at this tick, computed in lock-step
    notNow, ///< replay: not at this tick
};

/// A model that is too slow for the tick and is stepped beside it. It takes the request of tick n and answers
/// it for tick n + L. Only step() changes its state, so that the same requests give the same answers on
/// whichever thread it is stepped.
class ISlowModel {
public:
    ISlowModel() = default;
    ISlowModel(const ISlowModel&) = delete;
    ISlowModel& operator=(const ISlowModel&) = delete;
    virtual ~ISlowModel() = default;

    /// Answers the newest request if it has not been answered yet. Returns false if there was nothing to
    /// answer.
    /// Thread: the slow model's in real time, otherwise haptic, in which case no other thread calls it; never
    /// allocates or throws.
    virtual bool step() noexcept = 0;
};

} // namespace chiron::simulation
