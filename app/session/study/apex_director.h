// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/station.h"
#include "session/study/fidelity_meter.h"
#include "session/study/study_progress.h"
#include "session/tick_director.h"
#include "session/tool_positions.h"
#include "simulation/exercises/sphere_apex/hemisphere_contact.h"
#include "simulation/exercises/sphere_apex/sphere_apex_plan.h"

#include <array>
#include <atomic>
#include <functional>
#include <memory>
#include <vector>

namespace chiron::session {

/// Watches a session of the sphere-apex exercise and makes a study's trials of its marks: error by the stored counts at the tick of the
/// mark, as scores take it; fidelity by FidelityMeter, whose one place is the surface that is touched (|f| = k d). The participant marks
/// by itself: the director only listens, and ends the session where nothing more is to be presented.
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
    static constexpr std::size_t kWindow = 20; ///< ticks over which a speed is taken: counts are too coarse for one

    explicit ApexDirector(Parts parts, FidelityMeter meter) : m_parts(std::move(parts)), m_meter(std::move(meter)) {}
    void direct(const core::HapticFrame& frame);
    void beginTrial(const core::HapticFrame& frame, const core::Vec3& p_WT);
    FidelitySample sampleAt(const core::HapticFrame& frame, const core::Vec3& p_WT);
    void endTrial(const core::HapticFrame& frame, const core::Vec3& p_WT);
    void finish();

    Parts m_parts;
    FidelityMeter m_meter;
    std::unique_ptr<ToolPositions> m_positions;
    std::vector<simulation::SphereApexTrial> m_plan;
    std::vector<simulation::HemisphereContact> m_contacts;
    double m_radius_m = 0.0;
    std::uint64_t m_tickLimit = 0;
    haptics::LiveInputs* m_inputs = nullptr;
    std::uint64_t m_ticks = 0;
    std::uint64_t m_first = 0, m_lastContact = 0;
    std::array<core::Vec3, kWindow> m_way{};
    std::size_t m_at = 0;
    std::uint8_t m_touched = 0;
    bool m_inContact = false, m_inTrial = false, m_over = false;
    core::Result<void> m_recorded;
};

} // namespace chiron::session
