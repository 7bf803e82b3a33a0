// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/session/apex_watch.h"
#include "session/tick_director.h"

#include <atomic>
#include <functional>

namespace chiron::session {

/// Watches a scripted session of the sphere-apex exercise and makes a study's trials of its marks (ApexWatch). The participant marks by
/// itself: the director only listens, and ends the session where nothing more is to be presented.
class ApexDirector final : public ITickDirector {
public:
    struct Parts {
        StudyProgress& progress;
        const psychophysics::StudyDesign& design;
        const std::atomic<bool>* cancel = nullptr;
        std::function<bool(database::StudyTrial)> store; ///< false ends the session: it could not be stored
    };
    /// `level`: of "sphere_apex"; `seed`: the session's; `station` before it is used. Failure: badInput (a device without kinematics).
    static core::Result<std::unique_ptr<ApexDirector>> create(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                                                              const Station& station, Parts parts);
    void connect(haptics::LiveInputs& inputs) noexcept override { m_inputs = &inputs; }
    bool tryPush(const core::HapticFrame& frame) noexcept override;

    const core::Result<void>& recorded() const noexcept { return m_recorded; } ///< why the run's progress took a trial no more

private:
    ApexDirector(Parts parts, ApexWatch watch) : m_parts(std::move(parts)), m_watch(std::move(watch)) {}
    void direct(const core::HapticFrame& frame);
    void record(const StudyAnswer& answer);
    void finish();

    Parts m_parts;
    ApexWatch m_watch;
    std::uint64_t m_tickLimit = 0;
    haptics::LiveInputs* m_inputs = nullptr;
    std::uint64_t m_ticks = 0;
    bool m_over = false;
    core::Result<void> m_recorded;
};

} // namespace chiron::session
