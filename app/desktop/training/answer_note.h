// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/scene3d/scene_note.h"
#include "haptics/display_state.h"
#include "session/live_sample.h"

#include <QLocale>
#include <QString>
#include <cstdint>
#include <span>

namespace chiron::desktop {

/// What is said over the scene for two seconds once a trial has its answer or its end: how far a mark lies from the top where the
/// level gives feedback, that it was taken where it does not, and that time ran out. GUI thread.
class AnswerNote {
public:
    static constexpr std::int64_t kSaid_ns = 2'000'000'000;

    AnswerNote(const catalogue::ExerciseLevel& level, const QLocale& locale);

    /// Each frame: the newest state, and every tick since the frame before.
    void take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples);
    scene3d::SceneNote note(std::int64_t now_ns) const;

private:
    QString markedWords(const session::LiveSample& at) const;

    bool m_feedback;
    bool m_marks = false;        ///< a mark answers a trial: not where findings are reported
    double m_radius_m = 0.0;     ///< of the ball whose top is asked for; 0: none
    QLocale m_locale;
    std::array<double, 3> m_p_WObject_m{}; ///< of the trial that runs
    QString m_said;
    std::int64_t m_since_ns = 0;
};

} // namespace chiron::desktop
