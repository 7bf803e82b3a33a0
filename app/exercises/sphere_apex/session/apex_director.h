// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/sphere_apex/session/apex_watch.h"
#include "session/tick_director.h"

#include <atomic>
#include <functional>

namespace chiron::session {

/// Watches a scripted session of the sphere-apex exercise and converts its marks to the trials of a study
/// (ApexWatch). The participant marks without being prompted: the director only listens, and ends the session
/// once there is nothing more to present.
class ApexDirector final : public ITickDirector {
public:
    struct Parts {
        StudyProgress& progress;
        const psychophysics::StudyDesign& design;
        const std::atomic<bool>* cancel = nullptr;
        std::function<bool(database::StudyTrial)> store; ///< false ends the session because the trial could
                                                         ///< not be stored
    };
    /// `level`: a level of "sphere_apex"; `seed`: the seed of the session; `station`: in its state before
    /// use.
    /// Errors: badInput (a device without kinematics).
    static core::Result<std::unique_ptr<ApexDirector>>
    create(const catalogue::ExerciseLevel& level, std::uint64_t seed, const Station& station, Parts parts);
    void connect(haptics::LiveInputs& inputs) noexcept override { m_inputs = &inputs; }
    bool tryPush(const core::HapticFrame& frame) noexcept override;

    /// The reason why the run's progress no longer accepted a trial.
    const core::Result<void>& recorded() const noexcept { return m_recorded; }

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
