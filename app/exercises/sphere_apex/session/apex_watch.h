// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_plan.h"
#include "session/station.h"
#include "session/study/fidelity_meter.h"
#include "session/study/study_progress.h"
#include "session/study/trial_clock.h"
#include "session/tool_positions.h"

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace chiron::session {

/// Converts the ticks of a session of the sphere-apex exercise, in their order, to the trials of a study. The
/// error is computed from the stored counts at the tick of the mark, as in the scores. The fidelity comes
/// from a FidelityMeter whose single place is the touched surface (|f| = k d).
/// Thread: any one.
class ApexWatch {
public:
    /// `level`: a level of "sphere_apex"; `seed`: the seed of the session; `station`: in its state before
    /// use.
    /// Errors: badInput (a device without kinematics).
    static core::Result<ApexWatch> create(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                                          const Station& station, const psychophysics::StudyDesign& design);

    /// Returns the outcome of a trial at the tick that ends it. There is no answer without a mark (when the
    /// time was up).
    std::optional<StudyAnswer> take(const FidelitySample& tick, const core::ToolFrame& tool);
    /// The current trial as far as it went, without an answer.
    StudyAnswer soFar() const;

    bool inTrial() const noexcept { return m_inTrial; }
    bool touched() const noexcept { return m_touched != 0; }                               ///< in this trial
    bool nearForceLimit() const noexcept { return m_inTrial && m_meter.nearForceLimit(); } ///< now
    bool cameNearForceLimit() const noexcept { return m_inTrial && m_meter.cameNearForceLimit(); }
    bool over() const noexcept { return m_ended == m_plan.size(); } ///< every trial of the session has ended
    const TrialClock& clock() const noexcept { return m_clock; }    ///< of the current trial

private:
    static constexpr std::size_t kWindow = 20; ///< ticks over which a speed is computed: counts are too
                                               ///< coarse for one tick

    explicit ApexWatch(FidelityMeter meter) : m_meter(std::move(meter)) {}
    void begin(const FidelitySample& tick, const core::Vec3& p_WT);
    void explore(const FidelitySample& tick, const core::Vec3& p_WT);
    StudyAnswer end(const FidelitySample& tick, const core::Vec3& p_WT);
    std::size_t trialOf(const FidelitySample& tick) const;

    FidelityMeter m_meter;
    std::unique_ptr<ToolPositions> m_positions;
    std::vector<simulation::SphereApexTrial> m_plan;
    std::vector<simulation::HemisphereContact> m_contacts;
    double m_radius_m = 0.0;
    TrialClock m_clock;
    std::array<core::Vec3, kWindow> m_way{};
    std::size_t m_at = 0;
    std::size_t m_ended = 0;
    std::uint8_t m_touched = 0;
    bool m_inContact = false, m_inTrial = false;
};

} // namespace chiron::session
