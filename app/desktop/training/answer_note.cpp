// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/training/answer_note.h"

#include <QCoreApplication>
#include <cmath>

namespace chiron::desktop {

namespace {
struct Words {
    Q_DECLARE_TR_FUNCTIONS(AnswerNote)
};
namespace bits = core::event_bits;
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

void AnswerNote::take(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) {
    for (const session::LiveSample& sample : samples) {
        QString said;
        if ((sample.events & bits::kMarked) != 0)
            said = markedWords(sample);
        else if ((sample.events & bits::kTimedOut) != 0)
            said = Words::tr("Time is up");
        else if ((sample.events & bits::kFailed) != 0)
            said = Words::tr("This trial can no longer be completed");
        else if ((sample.events & bits::kCompleted) != 0)
            said = Words::tr("Trial completed");
        else if ((sample.events & bits::kTrialStarted) != 0)
            m_said.clear(); // the next one runs: what came of the last is over
        if (said.isEmpty())
            continue;
        m_said = said;
        m_since_ns = state.now_ns;
    }
    if (state.phase == core::TrialPhase::running || state.phase == core::TrialPhase::ready)
        m_trial = state.trial;
}

scene3d::SceneNote AnswerNote::note(std::int64_t now_ns) const {
    if (m_said.isEmpty() || now_ns - m_since_ns > kSaid_ns)
        return {};
    return {scene3d::SceneNote::Kind::said, m_said, {}};
}

} // namespace chiron::desktop
