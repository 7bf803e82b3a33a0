// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace chiron::simulation {

/// When the answer of a slow model takes effect in the tick (architecture.md, Determinism). A request that the scene made at
/// tick n is due at tick n + L.
enum class SlowUpdate : std::uint8_t {
    asDue,     ///< as-fast runs: exactly at n + L, computed in lock-step by the tick itself
    whenReady, ///< real time: at n + L, or at the first tick after it that finds the answer; that tick is recorded
    now,       ///< replay: at this tick, computed in lock-step
    notNow,    ///< replay: not at this tick
};

/// A model that is too slow for the tick, stepped beside it: takes the request of tick n, answers for tick n + L. Its state
/// is changed by step() alone, so that the same requests give the same answers wherever it is stepped.
class ISlowModel {
public:
    ISlowModel() = default;
    ISlowModel(const ISlowModel&) = delete;
    ISlowModel& operator=(const ISlowModel&) = delete;
    virtual ~ISlowModel() = default;

    /// Takes the newest request, if there is one that has not been answered, and answers it; false: there was none. Thread:
    /// the slow model's in real time; else the haptic one, in which case nothing else calls it. Never allocates or throws.
    virtual bool step() noexcept = 0;
};

} // namespace chiron::simulation
