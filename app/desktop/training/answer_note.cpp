// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/answer_note.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(AnswerNote)
};
namespace bits = core::event_bits;
constexpr std::uint32_t kEnds = bits::kMarked | bits::kTimedOut | bits::kCompleted;

QString after(const QString& what, const QString& how) { return how.isEmpty() ? what : Words::tr("%1. %2").arg(what, how); }
} // namespace

AnswerNote::AnswerNote(const catalogue::ExerciseLevel& level, const QLocale& locale, std::unique_ptr<session::TrialSurfaces> truth)
    : m_feedback(level.feedback), m_locale(locale), m_truth(level.feedback ? std::move(truth) : nullptr) {}

// A mark is measured as it is scored: across, from the line through the ball's centre.
QString AnswerNote::markedWords(const session::LiveSample& at) const {
    const auto object = truth();
    if (!object || object->radius_m <= 0.0)
        return Words::tr("Marked");
    const double beside_m = std::hypot(static_cast<double>(at.p_WT_m[0]) - object->p_WObject.x(), static_cast<double>(at.p_WT_m[1]) - object->p_WObject.y());
    const QString mm = m_locale.toString(1e3 * beside_m, 'f', 1);
    return beside_m > object->radius_m ? Words::tr("%1 mm from the top: not on the sphere").arg(mm) : Words::tr("%1 mm from the top").arg(mm);
}

// Matched as scoring matches them.
std::vector<scoring::FindingMatch> AnswerNote::matches(const session::TrialObject& object, const Findings& findings) {
    scoring::PalpationTruth truth;
    truth.hitRadius_m = 0.0; // each lump's own reach is its radius here
    for (const session::TrialLump& lump : object.lumps)
        truth.lumps.push_back({.place_W = lump.p_WAbove, .radius_m = lump.reach_m});
    core::FindingsBook book;
    for (std::size_t i = 0; i < findings.size(); ++i)
        if (findings[i].present)
            book.place(static_cast<int>(i), findings[i].p_W);
    return scoring::matchesOf(book, truth);
}

QString AnswerNote::foundWords() const {
    const auto object = m_palpates ? truth() : std::nullopt;
    if (!object)
        return {};
    const std::vector<scoring::FindingMatch> matches = this->matches(*object, m_findings);
    const auto hits = static_cast<int>(std::count_if(matches.begin(), matches.end(), [](const scoring::FindingMatch& match) { return match.hit(); }));
    const int wrong = static_cast<int>(matches.size()) - hits;
    const auto lumps = static_cast<int>(object->lumps.size());
    QString words;
    if (lumps == 0)
        words = wrong == 0 ? Words::tr("Right: there was no lump") : Words::tr("There was no lump");
    else if (lumps > 1)
        words = Words::tr("%1 of %2 lumps found").arg(m_locale.toString(hits), m_locale.toString(lumps));
    else if (hits == 0)
        words = Words::tr("The lump was missed");
    else
        words = Words::tr("Lump found, %1 mm off").arg(m_locale.toString(1e3 * std::find_if(matches.begin(), matches.end(), [](const auto& match) { return match.hit(); })->distance_m, 'f', 1));
    return wrong == 0 ? words : Words::tr("%1, %2").arg(words, Words::tr("%n false alarm(s)", nullptr, wrong));
}

/// What the picture may show of this trial: the ball whose top was marked, or the lumps.
void AnswerNote::keepTruth(const session::LiveSample& at) {
    const bool marked = (at.events & bits::kMarked) != 0;
    const auto object = truth();
    if (!object || (!m_palpates && object->radius_m <= 0.0) || (m_palpates && marked)) // a finding is marked, the trial goes on
        return;
    m_shown.emplace(Shown{*object, m_findings, {}});
    if (marked)
        m_shown->p_WMark = core::Vec3(static_cast<double>(at.p_WT_m[0]), static_cast<double>(at.p_WT_m[1]), static_cast<double>(at.p_WT_m[2]));
}

void AnswerNote::take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples) {
        QString said;
        if ((sample.events & kEnds) != 0)
            keepTruth(sample);
        if ((sample.events & bits::kMarked) != 0)
            said = markedWords(sample);
        else if ((sample.events & bits::kTimedOut) != 0)
            said = after(Words::tr("Time is up"), foundWords());
        else if ((sample.events & bits::kFailed) != 0)
            said = Words::tr("This trial can no longer be completed");
        else if ((sample.events & bits::kCompleted) != 0)
            said = after(Words::tr("Trial completed"), foundWords());
        else if (m_feedback && (sample.events & bits::kDamaged) != 0)
            said = Words::tr("Too much: the tissue was damaged");
        else if (m_feedback && (sample.events & bits::kSlipped) != 0)
            said = Words::tr("It slipped: hold it a little more firmly");
        else if ((sample.events & bits::kTrialStarted) != 0) { // the next one runs: what came of the last is over
            m_said.clear();
            m_shown.reset();
        }
        if (said.isEmpty())
            continue;
        m_said = said;
        m_since_ns = state.now_ns;
    }
    if (state.phase != core::TrialPhase::running && state.phase != core::TrialPhase::ready)
        return;
    m_trial = state.trial;
    m_palpates = state.palpation.present;
    m_findings = state.palpation.finding;
}

scene3d::SceneNote AnswerNote::note(std::int64_t now_ns) const {
    if (!says(now_ns))
        return {};
    return {scene3d::SceneNote::Kind::said, m_said, {}};
}

void AnswerNote::show(std::int64_t now_ns, scene3d::SceneState& drawn) const {
    if (!m_shown || !says(now_ns))
        return;
    if (m_palpates)
        return showLumps(drawn);
    const session::TrialObject& object = m_shown->object;
    drawn.objectShown = true;
    drawn.p_WObject = object.p_WObject;
    drawn.laparoscopy.body[0].q_W = {std::cos(0.5 * object.turn_rad), 0.0, 0.0, std::sin(0.5 * object.turn_rad)};
    drawn.answered = true;
    drawn.p_WAnswer = object.p_WObject + object.radius_m * core::Vec3::UnitZ();
    drawn.marked = m_shown->p_WMark.has_value();
    drawn.p_WMark = m_shown->p_WMark.value_or(core::Vec3::Zero());
}

/// As playback shows them: each lump, whether it was found, and what became of each finding.
void AnswerNote::showLumps(scene3d::SceneState& drawn) const {
    const std::vector<session::TrialLump>& lumps = m_shown->object.lumps;
    const std::vector<scoring::FindingMatch> matches = this->matches(m_shown->object, m_shown->findings);
    core::PalpationCues& cues = drawn.palpation;
    cues.present = true;
    cues.finding = m_shown->findings;
    cues.selected = -1;
    cues.lumps = static_cast<int>(std::min(lumps.size(), cues.lump.size()));
    drawn.lumpsMissed = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cues.lumps); ++i) {
        const core::Vec3& p_W = lumps[i].p_WCentre;
        cues.lump[i] = {{p_W.x(), p_W.y(), p_W.z()}, lumps[i].radius_m};
        if (!scoring::foundBy(matches, static_cast<int>(i)))
            drawn.lumpsMissed = static_cast<std::uint8_t>(drawn.lumpsMissed | 1U << i);
    }
    for (const scoring::FindingMatch& match : matches)
        drawn.outcome[static_cast<std::size_t>(match.finding)] = match.hit() ? core::FindingOutcome::hit : core::FindingOutcome::falseAlarm;
}

} // namespace chiron::desktop
