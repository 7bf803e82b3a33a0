// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/scene3d/scene_note.h"
#include "haptics/display_state.h"
#include "session/live_sample.h"
#include "session/trial_surfaces.h"

#include <QLocale>
#include <QString>
#include <array>
#include <cstdint>
#include <memory>
#include <span>

namespace chiron::desktop {

/// What is said over the scene for two seconds once a trial has its answer or its end: where the level gives feedback, how far a mark
/// lies from the top, or which lumps were found; where it does not, that it was taken; and that time ran out. GUI thread.
class AnswerNote {
public:
    static constexpr std::int64_t kSaid_ns = 2'000'000'000;

    /// `truth`: of the session, what was there to be found; the state on the screen does not tell where a hidden object lies. Empty: marks
    /// are taken without a word about them.
    AnswerNote(const catalogue::ExerciseLevel& level, const QLocale& locale, std::unique_ptr<session::TrialSurfaces> truth);

    /// Each frame: the newest state, and every tick since the frame before.
    void take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples);
    scene3d::SceneNote note(std::int64_t now_ns) const;

private:
    QString markedWords(const session::LiveSample& at) const;
    QString foundWords() const; ///< of the findings as they were at the end; empty where nothing was to be found

    bool m_feedback;
    QLocale m_locale;
    std::unique_ptr<session::TrialSurfaces> m_truth;
    int m_trial = 0; ///< that runs, or ran last
    bool m_palpates = false;
    std::array<core::Finding, core::kMaxFindings> m_findings{}; ///< in the newest state of the trial
    QString m_said;
    std::int64_t m_since_ns = 0;
};

} // namespace chiron::desktop
