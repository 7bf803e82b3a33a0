// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/scene3d/scene_note.h"
#include "desktop/scene3d/scene_state.h"
#include "desktop/training/trial_answer.h"
#include "haptics/display_state.h"
#include "session/live_sample.h"
#include "session/trial_surfaces.h"

#include <QLocale>
#include <QString>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace chiron::desktop {

/// The message over the scene for three seconds after a trial was answered or ended. If the level gives
/// feedback, it says how good the answer was (TrialAnswer), and the truth is drawn beside it. Otherwise it
/// says that the mark was taken. It also says that time ran out, and, as soon as it happens, that tissue gave
/// way: with what to do about it on a level that gives feedback.
/// Thread: GUI.
class AnswerNote {
public:
    static constexpr std::int64_t kSaid_ns = 3'000'000'000;
    /// The next trial is delayed by this time while the true answer is shown; the level's own time between
    /// trials follows.
    static constexpr std::int64_t kHeld_ns = 2'000'000'000;

    /// `truth`: the session's hidden objects, because the state on the screen does not contain the position
    /// of a hidden object. If it is empty, marks are only confirmed. A level without feedback keeps none of
    /// it, so that none of it can be drawn.
    AnswerNote(const catalogue::ExerciseLevel& level, const QLocale& locale,
               std::unique_ptr<session::TrialSurfaces> truth);

    /// Call once per frame with the newest state and every sample since the previous frame.
    void take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples);
    scene3d::SceneNote note(std::int64_t now_ns) const;
    /// Adds the mark and the true answer to the scene while the message is shown.
    void show(std::int64_t now_ns, scene3d::SceneState& drawn) const;
    bool holdsNext(std::int64_t now_ns) const { return m_shown && now_ns - m_since_ns < kHeld_ns; }

private:
    bool says(std::int64_t now_ns) const { return !m_said.isEmpty() && now_ns - m_since_ns <= kSaid_ns; }
    std::optional<session::TrialObject> truth() const {
        return m_truth ? m_truth->object(m_trial) : std::nullopt;
    }
    void keepTruth(const session::LiveSample& at);
    QString markedWords(const session::LiveSample& at) const;
    QString heldWords(const session::LiveSample& at) const; ///< about the tissue and the grip
    QString endWords() const;                               ///< about the answer

    bool m_feedback;
    QString m_yielded, m_yieldedAndEnded; ///< ExerciseFace::yieldedWords()
    QLocale m_locale;
    std::unique_ptr<session::TrialSurfaces> m_truth;
    int m_trial = 0; ///< the running trial, or the last one
    std::unique_ptr<TrialAnswer> m_answer;
    QString m_said;
    bool m_shown = false; ///< m_answer has something to draw of the trial that has just ended
    std::int64_t m_since_ns = 0;
};

} // namespace chiron::desktop
