// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study/apex_director.h"

#include "core/units.h"
#include "session/trace_mark.h"

#include <algorithm>
#include <cmath>

namespace chiron::session {

namespace {

/// The meter's one place holds the sphere's stiffness.
FidelityMeter meterOf(const psychophysics::StudyDesign& design) {
    simulation::ComparisonParameters place;
    place.attribute = simulation::ComparedAttribute::stiffness;
    place.places = 1;
    return FidelityMeter(place, design.fidelity, design.trial.mustTouchAll);
}

} // namespace

core::Result<std::unique_ptr<ApexDirector>> ApexDirector::create(const catalogue::ExerciseLevel& level, std::uint64_t seed,
                                                                 const Station& station, Parts parts) {
    const auto kind = exerciseKind(level.exercise);
    if (!kind)
        return tl::unexpected(kind.error());
    SessionSetup setup;
    setup.level = level;
    setup.seed = seed;
    setup.mappings = station.mappings;
    for (const auto& device : station.devices)
        setup.devices.push_back(device->descriptor());
    auto positions = ToolPositions::create(setup);
    if (!positions)
        return tl::unexpected(positions.error());
    FidelityMeter meter = meterOf(parts.design);
    std::unique_ptr<ApexDirector> director(new ApexDirector(std::move(parts), std::move(meter)));
    const auto& p = std::get<simulation::SphereApexParameters>(level.parameters);
    director->m_positions = std::move(*positions);
    director->m_plan = simulation::planSphereApexTrials(p, seed);
    for (const simulation::SphereApexTrial& trial : director->m_plan)
        director->m_contacts.emplace_back(simulation::sphereApexContact(p, trial));
    director->m_radius_m = p.radius_m;
    director->m_tickLimit = (*kind)->tickLimit(level);
    return director;
}

bool ApexDirector::tryPush(const core::HapticFrame& frame) noexcept {
    ++m_ticks;
    if (m_inputs && !m_over)
        direct(frame);
    return true;
}

void ApexDirector::direct(const core::HapticFrame& frame) {
    const std::uint32_t events = frame.header.events;
    const core::Vec3 p_WT = m_positions->p_WT_m(0, frame.tool[0]);
    if ((events & core::event_bits::kTrialStarted) != 0)
        beginTrial(frame, p_WT);
    if (m_inTrial) {
        const FidelitySample sample = sampleAt(frame, p_WT);
        m_meter.add(sample);
        if (m_inContact)
            m_lastContact = sample.tick;
        if ((events & kTrialEnds) != 0)
            endTrial(frame, p_WT);
    }
    const bool cancelled = m_parts.cancel && m_parts.cancel->load(std::memory_order_relaxed);
    if (!m_over && (cancelled || m_ticks >= m_tickLimit)) // a hand that is stuck would go on for ever
        finish();
}

void ApexDirector::beginTrial(const core::HapticFrame& frame, const core::Vec3& p_WT) {
    m_first = m_lastContact = frame.header.index;
    m_way.fill(p_WT);
    m_touched = 0;
    const std::size_t trial = std::min<std::size_t>(frame.header.trial, m_plan.size() - 1);
    m_meter.begin({m_plan[trial].stiffness_N_per_m});
    m_inTrial = true;
}

FidelitySample ApexDirector::sampleAt(const core::HapticFrame& frame, const core::Vec3& p_WT) {
    const std::size_t trial = std::min<std::size_t>(frame.header.trial, m_plan.size() - 1);
    const auto contact = m_contacts[trial].respond(p_WT, core::Vec3::Zero());
    const core::Vec3 v = (p_WT - m_way[m_at]) / (static_cast<double>(kWindow) * core::kTickSeconds);
    m_way[m_at] = p_WT;
    m_at = (m_at + 1) % kWindow;
    m_inContact = contact.inContact;
    m_touched = static_cast<std::uint8_t>(m_touched | (contact.inContact ? 1u : 0u));
    FidelitySample out = fidelitySampleOf(frame); // its quantities are those of a comparison: all zero here
    out.place = contact.inContact ? 1 : 0;
    out.touched = m_touched;
    out.depth_m = out.displacement_m = contact.depth_m;
    out.velocity_m_per_s = {v.x(), v.y(), v.z()};
    return out;
}

void ApexDirector::endTrial(const core::HapticFrame& frame, const core::Vec3& p_WT) {
    m_inTrial = false;
    const core::TickHeader& header = frame.header;
    const std::size_t trial = std::min<std::size_t>(header.trial, m_plan.size() - 1);
    StudyAnswer answer;
    answer.firstTick = m_first;
    answer.lastTick = header.index;
    answer.exploration_s = static_cast<double>(header.index - m_first) * core::kTickSeconds;
    answer.answer_s = static_cast<double>(header.index - std::min(header.index, m_lastContact)) * core::kTickSeconds;
    answer.fidelity = m_meter.finish();
    if ((header.events & core::event_bits::kMarked) != 0) {
        const core::Vec2 error = p_WT.head<2>() - m_plan[trial].centre_m;
        answer.answer = 0;
        answer.value = error.norm();
        answer.fidelity.apex = ApexMark{error.x(), error.y(), m_radius_m, m_inContact, false};
    }
    auto stored = m_parts.progress.record(answer); // without a mark the time was up: "time"
    if (!stored)
        m_recorded = tl::unexpected(stored.error());
    const bool kept = stored && m_parts.store(std::move(*stored));
    if (m_parts.progress.needsExperimenter())
        m_parts.progress.experimenterSays(false); // nobody is there to help: the run stops
    if (!kept || (m_parts.progress.done() && trial + 1 < m_plan.size()))
        finish();
}

void ApexDirector::finish() {
    m_over = true;
    m_inputs->postOwn({core::CommandKind::end});
}

} // namespace chiron::session
