// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/session/apex_watch.h"

#include "core/units.h"
#include "session/trace_mark.h"

#include <algorithm>

namespace chiron::session {

namespace {

/// The single place of the meter has the sphere's stiffness.
FidelityMeter meterOf(const psychophysics::StudyDesign& design, bool shown) {
    simulation::ComparisonParameters place;
    place.attribute = simulation::ComparedAttribute::stiffness;
    place.places = 1;
    return FidelityMeter(place, design.fidelity, design.trial.mustTouchAll, shown);
}

} // namespace

core::Result<ApexWatch> ApexWatch::create(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                                          const Station& station, const psychophysics::StudyDesign& design) {
    SessionSetup setup;
    setup.level = level;
    setup.seed = seed;
    setup.mappings = station.mappings();
    for (const auto& tool : station.tools)
        setup.devices.push_back(tool.device->descriptor());
    auto positions = ToolPositions::create(setup);
    CHIRON_TRY(positions);
    ApexWatch watch(meterOf(design, !setup.felt()));
    const auto& p = level.parameters.as<simulation::SphereApexParameters>();
    watch.m_positions = std::move(*positions);
    watch.m_plan = simulation::planSphereApexTrials(p, seed);
    for (const simulation::SphereApexTrial& trial : watch.m_plan)
        watch.m_contacts.emplace_back(simulation::sphereApexContact(p, trial));
    watch.m_radius_m = p.radius_m;
    return watch;
}

std::optional<StudyAnswer> ApexWatch::take(const FidelitySample& tick, const core::ToolFrame& tool) {
    const core::Vec3 p_WT = m_positions->p_WT_m(0, tool);
    if ((tick.events & core::event_bits::kTrialStarted) != 0)
        begin(tick, p_WT);
    if (!m_inTrial)
        return std::nullopt;
    explore(tick, p_WT);
    if ((tick.events & kTrialEnds) == 0)
        return std::nullopt;
    return end(tick, p_WT);
}

std::size_t ApexWatch::trialOf(const FidelitySample& tick) const {
    return std::min<std::size_t>(tick.trial, m_plan.size() - 1);
}

void ApexWatch::begin(const FidelitySample& tick, const core::Vec3& p_WT) {
    m_clock.begin(tick.tick);
    m_way.fill(p_WT);
    m_touched = 0;
    m_meter.begin({m_plan[trialOf(tick)].stiffness_N_per_m});
    m_inTrial = true;
}

void ApexWatch::explore(const FidelitySample& tick, const core::Vec3& p_WT) {
    const auto contact = m_contacts[trialOf(tick)].respond(p_WT, core::Vec3::Zero());
    const core::Vec3 v = (p_WT - m_way[m_at]) / (static_cast<double>(kWindow) * core::kTickSeconds);
    m_way[m_at] = p_WT;
    m_at = (m_at + 1) % kWindow;
    m_inContact = contact.inContact;
    m_touched = static_cast<std::uint8_t>(m_touched | (contact.inContact ? 1u : 0u));
    // The quantities of the sample are those of a comparison, which are all zero here.
    FidelitySample felt = tick;
    felt.place = contact.inContact ? 1 : 0;
    felt.touched = m_touched;
    felt.depth_m = felt.displacement_m = contact.depth_m;
    felt.velocity_m_per_s = {v.x(), v.y(), v.z()};
    m_meter.add(felt);
    m_clock.take(tick, m_inContact);
}

StudyAnswer ApexWatch::soFar() const {
    StudyAnswer answer;
    answer.firstTick = m_clock.first();
    answer.lastTick = m_clock.last();
    answer.exploration_s = m_clock.exploration_s();
    answer.answer_s = m_clock.sinceContact_s();
    answer.fidelity = m_meter.finish();
    return answer;
}

StudyAnswer ApexWatch::end(const FidelitySample& tick, const core::Vec3& p_WT) {
    m_inTrial = false;
    ++m_ended;
    StudyAnswer answer = soFar();
    if ((tick.events & core::event_bits::kMarked) != 0) {
        const core::Vec2 error = p_WT.head<2>() - m_plan[trialOf(tick)].centre_m;
        answer.answer = 0;
        answer.value = error.norm();
        answer.fidelity.apex = ApexMark{error.x(), error.y(), m_radius_m, m_inContact, false};
    }
    return answer;
}

} // namespace chiron::session
