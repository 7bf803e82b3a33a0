// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/scene3d/scene_note.h"
#include "desktop/scene3d/scene_state.h"
#include "desktop/training/found_answer.h"
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

class ExerciseFace;

/// The message over the scene for three seconds after a trial was answered or ended. If the level gives
/// feedback, it says how far a mark lies from the apex, or which lumps were found, and the true place is
/// drawn beside the mark. Otherwise it says that the mark was taken. It also says that time ran out, and, as
/// soon as it happens, that tissue gave way: with what to do about it on a level that gives feedback.
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
    /// The trial that has just ended.
    struct Shown {
        session::TrialObject object;
        std::optional<core::Vec3> p_WMark; ///< no value if time ran out
    };

    bool says(std::int64_t now_ns) const { return !m_said.isEmpty() && now_ns - m_since_ns <= kSaid_ns; }
    std::optional<session::TrialObject> truth() const {
        return m_truth ? m_truth->object(m_trial) : std::nullopt;
    }
    void keepTruth(const session::LiveSample& at);
    QString markedWords(const session::LiveSample& at) const;
    QString heldWords(const session::LiveSample& at) const; ///< about the tissue and the grip
    QString foundWords() const; ///< about what was reported by the end; empty if there was nothing to find
    bool isFound() const { return m_found && m_found->answers(); }

    const ExerciseFace* m_face = nullptr; ///< of the level's exercise; null if that is not known
    bool m_feedback;
    QString m_yielded, m_yieldedAndEnded; ///< ExerciseFace::yieldedWords()
    QLocale m_locale;
    std::unique_ptr<session::TrialSurfaces> m_truth;
    int m_trial = 0;                      ///< the running trial, or the last one
    std::unique_ptr<FoundAnswer> m_found; ///< null if the answer is a mark
    QString m_said;
    std::optional<Shown> m_shown;
    std::int64_t m_since_ns = 0;
};

} // namespace chiron::desktop
