// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/found_lumps.h"

#include "app/exercises/palpation/scene/palpation_overlay.h"

#include <algorithm>

namespace chiron::desktop {

void FoundLumps::follow(const haptics::DisplayState& state) {
    const auto& cues = state.exercise.of<simulation::PalpationCues>();
    m_palpates = cues.present;
    m_findings = cues.finding;
}

// Matches findings to lumps in the same way as the scoring does.
std::vector<scoring::FindingMatch> FoundLumps::matches(const std::vector<session::TrialLump>& lumps,
                                                       const Findings& findings) {
    scoring::PalpationTruth truth;
    truth.hitRadius_m = 0.0; // here `radius_m` of each lump is already its reach
    for (const session::TrialLump& lump : lumps)
        truth.lumps.push_back({.place_W = lump.p_WAbove, .radius_m = lump.reach_m});
    simulation::FindingsBook book;
    for (std::size_t i = 0; i < findings.size(); ++i)
        if (findings[i].present)
            book.place(static_cast<int>(i), findings[i].p_W);
    return scoring::matchesOf(book, truth);
}

QString FoundLumps::endWords(const session::TrialObject& truth, const QLocale& locale) const {
    if (!m_palpates)
        return {};
    const std::vector<scoring::FindingMatch> matches = this->matches(truth.lumps, m_findings);
    const auto hits = static_cast<int>(std::count_if(
        matches.begin(), matches.end(), [](const scoring::FindingMatch& match) { return match.hit(); }));
    const int wrong = static_cast<int>(matches.size()) - hits;
    const auto lumps = static_cast<int>(truth.lumps.size());
    QString words;
    if (lumps == 0)
        words =
            wrong == 0 ? AnswerTexts::tr("Right: there was no lump") : AnswerTexts::tr("There was no lump");
    else if (lumps > 1)
        words = AnswerTexts::tr("%1 of %2 lumps found").arg(locale.toString(hits), locale.toString(lumps));
    else if (hits == 0)
        words = AnswerTexts::tr("The lump was missed");
    else
        words = AnswerTexts::tr("Lump found, %1 mm off")
                    .arg(locale.toString(1e3 * std::find_if(matches.begin(), matches.end(),
                                                            [](const auto& match) { return match.hit(); })
                                                   ->distance_m,
                                         'f', 1));
    return wrong == 0
               ? words
               : AnswerTexts::tr("%1, %2").arg(words, AnswerTexts::tr("%n false alarm(s)", nullptr, wrong));
}

// Marking a finding does not end the trial.
bool FoundLumps::keep(const session::TrialObject& truth, const std::optional<core::Vec3>& p_WMark) {
    if (!m_palpates || p_WMark)
        return false;
    m_kept = m_findings;
    m_keptLumps = truth.lumps;
    return true;
}

/// Shows the result as playback does: each lump, whether it was found, and the outcome of each finding.
void FoundLumps::show(scene3d::SceneState& drawn) const {
    const std::vector<session::TrialLump>& lumps = m_keptLumps;
    const std::vector<scoring::FindingMatch> matches = this->matches(lumps, m_kept);
    auto& cues = drawn.exercise.own<simulation::PalpationCues>();
    auto& overlay = drawn.overlay.own<scene3d::PalpationOverlay>();
    cues.present = true;
    cues.finding = m_kept;
    cues.selected = -1;
    cues.lumps = static_cast<int>(std::min(lumps.size(), cues.lump.size()));
    overlay.lumpsMissed = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cues.lumps); ++i) {
        const core::Vec3& p_W = lumps[i].p_WCentre;
        cues.lump[i] = {{p_W.x(), p_W.y(), p_W.z()}, lumps[i].radius_m};
        if (!scoring::foundBy(matches, static_cast<int>(i)))
            overlay.lumpsMissed = static_cast<std::uint8_t>(overlay.lumpsMissed | 1U << i);
    }
    for (const scoring::FindingMatch& match : matches)
        overlay.outcome[static_cast<std::size_t>(match.finding)] =
            match.hit() ? simulation::FindingOutcome::hit : simulation::FindingOutcome::falseAlarm;
}

} // namespace chiron::desktop
