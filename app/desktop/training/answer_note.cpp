// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/answer_note.h"

#include "desktop/exercise_face.h"

namespace chiron::desktop {

namespace {
QString after(const QString& what, const QString& how) {
    return how.isEmpty() ? what : AnswerTexts::tr("%1. %2").arg(what, how);
}

namespace bits = core::event_bits;
constexpr std::uint32_t kEnds = bits::kMarked | bits::kTimedOut | bits::kCompleted;
} // namespace

AnswerNote::AnswerNote(const catalogue::ExerciseLevel& level, const QLocale& locale,
                       std::unique_ptr<session::TrialSurfaces> truth)
    : m_feedback(level.feedback), m_locale(locale), m_truth(level.feedback ? std::move(truth) : nullptr) {
    const auto face = exerciseFace(level.exercise);
    m_answer = face ? (*face)->trialAnswer() : std::make_unique<MarkAnswer>();
    if (face) {
        m_yielded = (*face)->yieldedWords(level, false);
        m_yieldedAndEnded = (*face)->yieldedWords(level, true);
    }
}

QString AnswerNote::markedWords(const session::LiveSample& at) const {
    const auto object = truth();
    return object ? m_answer->markWords(*object, at, m_locale) : markTaken();
}

QString AnswerNote::endWords() const {
    const auto object = truth();
    return object ? m_answer->endWords(*object, m_locale) : QString();
}

/// What went wrong while the trial goes on; empty if nothing did. The worst comes first. A perforation that
/// does not count, because no trial is running, is not told.
QString AnswerNote::heldWords(const session::LiveSample& at) const {
    const bool counts = at.phase == core::TrialPhase::running && !at.paused;
    if (at.yielded && counts)
        return m_yielded;
    if (m_feedback && (at.events & bits::kDamaged) != 0)
        return AnswerTexts::tr("Too much: the tissue was damaged");
    if (m_feedback && (at.events & bits::kSlipped) != 0)
        return AnswerTexts::tr("It slipped: hold it a little more firmly");
    return {};
}

/// Keeps what the scene may show of this trial.
void AnswerNote::keepTruth(const session::LiveSample& at) {
    const auto object = truth();
    if (!object)
        return;
    std::optional<core::Vec3> p_WMark;
    if ((at.events & bits::kMarked) != 0)
        p_WMark = core::Vec3(static_cast<double>(at.p_WT_m[0]), static_cast<double>(at.p_WT_m[1]),
                             static_cast<double>(at.p_WT_m[2]));
    if (m_answer->keep(*object, p_WMark))
        m_shown = true;
}

void AnswerNote::take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples) {
        QString said;
        if ((sample.events & bits::kTrialStarted) != 0) {
            // The next trial runs, so the last result disappears.
            m_said.clear();
            m_shown = false;
        }
        if ((sample.events & kEnds) != 0)
            keepTruth(sample);
        if ((sample.events & bits::kMarked) != 0)
            said = markedWords(sample);
        else if ((sample.events & bits::kTimedOut) != 0)
            said = after(AnswerTexts::tr("Time is up"), endWords());
        else if ((sample.events & bits::kFailed) != 0)
            said = sample.yielded && !sample.paused
                       ? m_yieldedAndEnded
                       : AnswerTexts::tr("This trial can no longer be completed");
        else if ((sample.events & bits::kCompleted) != 0)
            said = after(AnswerTexts::tr("Trial completed"), endWords());
        else
            said = heldWords(sample);
        if (said.isEmpty())
            continue;
        m_said = said;
        m_since_ns = state.now_ns;
    }
    if (state.phase != core::TrialPhase::running && state.phase != core::TrialPhase::ready)
        return;
    m_trial = state.trial;
    m_answer->follow(state);
}

scene3d::SceneNote AnswerNote::note(std::int64_t now_ns) const {
    if (!says(now_ns))
        return {};
    return {scene3d::SceneNote::Kind::said, m_said, {}};
}

void AnswerNote::show(std::int64_t now_ns, scene3d::SceneState& drawn) const {
    if (m_shown && says(now_ns))
        m_answer->show(drawn);
}

} // namespace chiron::desktop
