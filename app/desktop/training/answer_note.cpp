// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/answer_note.h"

#include "cues/laparoscopy_cues.h"
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
    if (const auto face = exerciseFace(level.exercise)) {
        m_face = *face;
        m_found = m_face->foundAnswer();
        m_yielded = m_face->yieldedWords(level, false);
        m_yieldedAndEnded = m_face->yieldedWords(level, true);
    }
}

QString AnswerNote::markedWords(const session::LiveSample& at) const {
    const auto object = truth();
    return object && m_face ? m_face->markWords(*object, at, m_locale) : AnswerTexts::tr("Marked");
}

QString AnswerNote::foundWords() const {
    const auto object = isFound() ? truth() : std::nullopt;
    return object ? m_found->words(*object, m_locale) : QString();
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

/// Keeps what the scene may show of this trial: the sphere whose apex was marked, or the objects to be found.
void AnswerNote::keepTruth(const session::LiveSample& at) {
    const bool marked = (at.events & bits::kMarked) != 0;
    const auto object = truth();
    // Marking a finding does not end the trial.
    if (!object || (!isFound() && object->radius_m <= 0.0) || (isFound() && marked))
        return;
    m_shown.emplace(Shown{*object, {}});
    if (m_found)
        m_found->keep();
    if (marked)
        m_shown->p_WMark = core::Vec3(static_cast<double>(at.p_WT_m[0]), static_cast<double>(at.p_WT_m[1]),
                                      static_cast<double>(at.p_WT_m[2]));
}

void AnswerNote::take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples) {
        QString said;
        if ((sample.events & bits::kTrialStarted) != 0) {
            // The next trial runs, so the last result disappears.
            m_said.clear();
            m_shown.reset();
        }
        if ((sample.events & kEnds) != 0)
            keepTruth(sample);
        if ((sample.events & bits::kMarked) != 0)
            said = markedWords(sample);
        else if ((sample.events & bits::kTimedOut) != 0)
            said = after(AnswerTexts::tr("Time is up"), foundWords());
        else if ((sample.events & bits::kFailed) != 0)
            said = sample.yielded && !sample.paused
                       ? m_yieldedAndEnded
                       : AnswerTexts::tr("This trial can no longer be completed");
        else if ((sample.events & bits::kCompleted) != 0)
            said = after(AnswerTexts::tr("Trial completed"), foundWords());
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
    if (m_found)
        m_found->follow(state);
}

scene3d::SceneNote AnswerNote::note(std::int64_t now_ns) const {
    if (!says(now_ns))
        return {};
    return {scene3d::SceneNote::Kind::said, m_said, {}};
}

void AnswerNote::show(std::int64_t now_ns, scene3d::SceneState& drawn) const {
    if (!m_shown || !says(now_ns))
        return;
    if (isFound())
        return m_found->show(m_shown->object, drawn);
    const session::TrialObject& object = m_shown->object;
    drawn.objectShown = true;
    drawn.p_WObject = object.p_WObject;
    drawn.exercise.own<core::LaparoscopyCues>().body[0].q_W = {std::cos(0.5 * object.turn_rad), 0.0, 0.0,
                                                               std::sin(0.5 * object.turn_rad)};
    drawn.answered = true;
    drawn.p_WAnswer = object.p_WObject + object.radius_m * core::Vec3::UnitZ();
    drawn.marked = m_shown->p_WMark.has_value();
    drawn.p_WMark = m_shown->p_WMark.value_or(core::Vec3::Zero());
}

} // namespace chiron::desktop
