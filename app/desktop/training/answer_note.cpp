// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/answer_note.h"

#include "scoring/detection/finding_matches.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(AnswerNote)
};
namespace bits = core::event_bits;

QString after(const QString& what, const QString& how) { return how.isEmpty() ? what : Words::tr("%1. %2").arg(what, how); }
} // namespace

AnswerNote::AnswerNote(const catalogue::ExerciseLevel& level, const QLocale& locale, std::unique_ptr<session::TrialSurfaces> truth)
    : m_feedback(level.feedback), m_locale(locale), m_truth(std::move(truth)) {}

// A mark is measured as it is scored: across, from the line through the ball's centre.
QString AnswerNote::markedWords(const session::LiveSample& at) const {
    const auto object = m_feedback && m_truth ? m_truth->object(m_trial) : std::nullopt;
    if (!object || object->radius_m <= 0.0)
        return Words::tr("Marked");
    const double beside_m = std::hypot(static_cast<double>(at.p_WT_m[0]) - object->p_WObject.x(), static_cast<double>(at.p_WT_m[1]) - object->p_WObject.y());
    const QString mm = m_locale.toString(1e3 * beside_m, 'f', 1);
    return beside_m > object->radius_m ? Words::tr("%1 mm from the top: not on the sphere").arg(mm) : Words::tr("%1 mm from the top").arg(mm);
}

// Matched as scoring matches them.
QString AnswerNote::foundWords() const {
    const auto object = m_feedback && m_truth && m_palpates ? m_truth->object(m_trial) : std::nullopt;
    if (!object)
        return {};
    scoring::PalpationTruth truth;
    truth.hitRadius_m = 0.0; // each lump's own reach is its radius here
    for (const session::TrialLump& lump : object->lumps)
        truth.lumps.push_back({.place_W = lump.p_WAbove, .radius_m = lump.reach_m});
    core::FindingsBook book;
    for (std::size_t i = 0; i < m_findings.size(); ++i)
        if (m_findings[i].present)
            book.place(static_cast<int>(i), m_findings[i].p_W);
    const std::vector<scoring::FindingMatch> matches = scoring::matchesOf(book, truth);
    const auto hits = static_cast<int>(std::count_if(matches.begin(), matches.end(), [](const scoring::FindingMatch& match) { return match.hit(); }));
    const int wrong = static_cast<int>(matches.size()) - hits;
    const auto lumps = static_cast<int>(truth.lumps.size());
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

void AnswerNote::take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples) {
        QString said;
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
        else if ((sample.events & bits::kTrialStarted) != 0)
            m_said.clear(); // the next one runs: what came of the last is over
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
    if (m_said.isEmpty() || now_ns - m_since_ns > kSaid_ns)
        return {};
    return {scene3d::SceneNote::Kind::said, m_said, {}};
}

} // namespace chiron::desktop
