// SPDX-License-Identifier: GPL-3.0-or-later
// Takes a person's reports and writes what the recording and the screen show of them. Runs in the tick.
#include "modules/exercises/palpation/simulation/palpation_scene.h"

#include <algorithm>

namespace chiron::simulation {

void PalpationScene::takeReports(const SceneInput& in) noexcept {
    for (std::size_t i = 0; i < m_fingers.size(); ++i) {
        if (m_buttons.marked(i))
            mark(m_fingers[i]);
        if (m_buttons.reported(i))
            report(m_buttons.word(i));
    }
    if (const Finger* finger = in.mark ? markingFinger() : nullptr)
        mark(*finger);
    const int words = std::clamp(in.reports, 0, static_cast<int>(in.report.size()));
    for (int i = 0; i < words; ++i)
        report(in.report[static_cast<std::size_t>(i)]);
}

const PalpationScene::Finger* PalpationScene::markingFinger() const noexcept {
    const auto isBefore = [](const Finger& a, const Finger& b) {
        if (a.response.normalForce_N != b.response.normalForce_N)
            return a.response.normalForce_N > b.response.normalForce_N;
        return a.above_m < b.above_m;
    };
    const Finger* best = nullptr;
    for (const Finger& finger : m_fingers)
        if (finger.used && (best == nullptr || isBefore(finger, *best)))
            best = &finger;
    return best;
}

void PalpationScene::mark(const Finger& finger) noexcept {
    if (finger.used)
        m_waiting.put({ReportField::found, 0, finger.response.surfacePoint});
}

void PalpationScene::report(std::uint16_t word) noexcept {
    if (reportField(word) != ReportField::found) // a mark needs a position
        m_waiting.put({reportField(word), reportValue(word), core::Vec3::Zero()});
}

int PalpationScene::enter(const PalpationReport& report) noexcept {
    if (report.field == ReportField::found)
        return m_findings.found({report.p_W.x(), report.p_W.y(), report.p_W.z()});
    return m_findings.report(report.field, report.value);
}

void PalpationScene::passReport() noexcept {
    if (m_waiting.empty() || m_course.clock() < m_nextReport)
        return;
    namespace q = palpation_quantity;
    m_nextReport = m_course.clock() + kReportTicks;
    const PalpationReport next = m_waiting.take();
    std::array<double, 3> place = {0.0, 0.0, 0.0};
    if (next.field == ReportField::remove && m_findings.has(static_cast<int>(next.value)))
        place = m_findings.list()[next.value].p_W; // reports where it was
    const int finding = enter(next);
    if (finding == FindingsBook::kNone && next.field != ReportField::done)
        return; // it had no effect
    if (finding != FindingsBook::kNone && next.field != ReportField::remove)
        place = m_findings.list()[static_cast<std::size_t>(finding)].p_W;
    m_told[q::kReportCount] += 1.0;
    m_told[q::kReportField] = static_cast<double>(next.field);
    m_told[q::kReportFinding] = static_cast<double>(finding);
    m_told[q::kReportValue] = static_cast<double>(next.value);
    std::copy(place.begin(), place.end(), m_told.begin() + q::kFindingPlace);
}

double PalpationScene::squeezeOf(std::size_t hand) const noexcept {
    const std::size_t finger = hand * static_cast<std::size_t>(std::max(1, m_parameters.fingers));
    return finger < m_fingers.size() ? m_fingers[finger].squeeze_N : 0.0;
}

void PalpationScene::fillQuantities(SceneOutput& out) const noexcept {
    namespace q = palpation_quantity;
    std::copy(m_told.begin(), m_told.end(), out.quantities.begin());
    out.quantities[q::kCoverage] = m_map.coverage();
    unsigned saturated = 0;
    for (std::size_t i = 0; i < m_fingers.size(); ++i) {
        out.quantities[q::kDepth + i] = m_fingers[i].response.depth_m;
        out.quantities[q::kLean + i] = m_fingers[i].response.lean_rad;
        saturated |= m_fingers[i].response.leanSaturated ? 1U << i : 0U;
    }
    out.quantities[q::kLeanSaturated] = static_cast<double>(saturated);
    out.quantities[q::kLumpsMoved] = m_moved ? 1.0 : 0.0;
    static_assert(q::kSqueeze + q::kSqueezes <= core::kMaxQuantities);
    if (m_parameters.pinch)
        for (std::size_t hand = 0; hand < q::kSqueezes; ++hand)
            out.quantities[q::kSqueeze + hand] = squeezeOf(hand);
}

void PalpationScene::showLumps(PalpationCues& cues) const noexcept {
    cues.lumps = m_tissue.lumps();
    for (int i = 0; i < cues.lumps; ++i) {
        const core::Vec3 p_W = m_tissue.lumpCentre_W(i);
        LumpCue& cue = cues.lump[static_cast<std::size_t>(i)];
        cue.p_W = {p_W.x(), p_W.y(), p_W.z()};
        cue.radius_m = m_trials[m_course.trial()].lump[static_cast<std::size_t>(i)].radius_m;
    }
}

void PalpationScene::showBars(PalpationCues& cues) const noexcept {
    cues.bandShown = true;
    cues.bandLow_N = m_parameters.bandLow_N;
    cues.bandHigh_N = m_parameters.bandHigh_N;
    for (std::size_t i = 0; i < m_fingers.size(); ++i) {
        cues.depth_m[i] = m_fingers[i].response.depth_m;
        cues.lean_rad[i] = m_fingers[i].response.lean_rad;
        if (m_fingers[i].response.leanSaturated)
            cues.leanSaturated = static_cast<std::uint8_t>(cues.leanSaturated | (1U << i));
    }
    cues.squeezeShown = m_parameters.pinch.has_value();
    for (std::size_t hand = 0; hand < cues.squeeze_N.size(); ++hand)
        cues.squeeze_N[hand] = squeezeOf(hand);
}

void PalpationScene::fillCues(SceneOutput& out) const noexcept {
    core::VisibleCues& cues = out.cues;
    PalpationCues& shown = cues.exercise.own<PalpationCues>();
    shown.present = true;
    shown.asksSize = m_parameters.asksSize;
    shown.asksHardness = m_parameters.asksHardness;
    shown.asksConfidence = m_parameters.asksConfidence;
    if (!m_course.present())
        return;
    cues.timeLeft_s = m_course.timeLeft_s();
    shown.finding = m_findings.list();
    shown.selected = m_findings.selected();
    if (m_showsLumps)
        showLumps(shown);
    if (m_showsCoverage) {
        shown.coverageShown = true;
        shown.coverage = m_map.coverage();
    }
    if (m_showsBars)
        showBars(shown);
}

} // namespace chiron::simulation
