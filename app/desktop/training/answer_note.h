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

/// What is said over the scene for three seconds once a trial has its answer or its end: where the level gives feedback, how far a mark
/// lies from the top, or which lumps were found, with the true place drawn beside the mark; where it does not, that it was taken; and that
/// time ran out. GUI thread.
class AnswerNote {
public:
    static constexpr std::int64_t kSaid_ns = 3'000'000'000;
    /// For so long the next trial is kept from coming while a truth is looked at; the level's own time between trials follows.
    static constexpr std::int64_t kHeld_ns = 2'000'000'000;

    /// `truth`: of the session, what was there to be found; the state on the screen does not tell where a hidden object lies. Empty: marks
    /// are taken without a word about them. A level without feedback keeps none of it, so that none of it can be drawn.
    AnswerNote(const catalogue::ExerciseLevel& level, const QLocale& locale, std::unique_ptr<session::TrialSurfaces> truth);

    /// Each frame: the newest state, and every tick since the frame before.
    void take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples);
    scene3d::SceneNote note(std::int64_t now_ns) const;
    /// Adds the mark and what was true to the picture, as long as it is spoken of.
    void show(std::int64_t now_ns, scene3d::SceneState& drawn) const;
    bool holdsNext(std::int64_t now_ns) const { return m_shown && now_ns - m_since_ns < kHeld_ns; }

private:
    /// Of the trial that has just ended.
    struct Shown {
        session::TrialObject object;
        std::optional<core::Vec3> p_WMark; ///< nothing where time ran out
    };

    bool says(std::int64_t now_ns) const { return !m_said.isEmpty() && now_ns - m_since_ns <= kSaid_ns; }
    std::optional<session::TrialObject> truth() const { return m_truth ? m_truth->object(m_trial) : std::nullopt; }
    void keepTruth(const session::LiveSample& at);
    QString markedWords(const session::LiveSample& at) const;
    QString foundWords() const; ///< of what was reported by the end; empty where nothing was to be
    bool isFound() const { return m_found && m_found->answers(); }

    const ExerciseFace* m_face = nullptr; ///< of the level's exercise; null where that is not known
    bool m_feedback;
    QLocale m_locale;
    std::unique_ptr<session::TrialSurfaces> m_truth;
    int m_trial = 0; ///< that runs, or ran last
    std::unique_ptr<FoundAnswer> m_found; ///< null where a mark is the answer
    QString m_said;
    std::optional<Shown> m_shown;
    std::int64_t m_since_ns = 0;
};

} // namespace chiron::desktop
