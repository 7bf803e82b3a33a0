// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "session/study/trial_fidelity.h"

#include <utility>

namespace chiron::session {

/// The circumstances that a run stores with each trial: the language, the masking sound, and the beginning of
/// the answer.
/// Thread: GUI.
class SittingNotes {
public:
    explicit SittingNotes(std::string language) { m_now.language = std::move(language); }

    void beginTrial() {
        m_now.masking = m_masking;
        m_now.answerTick.reset();
    }
    void hear(const std::string& masking) {
        if (m_now.masking.empty())
            m_now.masking = masking;
        else if (m_now.masking != masking)
            m_now.masking = TrialCircumstances::kMaskingChanged;
        m_masking = masking;
    }
    void answerBegins(std::uint64_t tick) {
        if (!m_now.answerTick)
            m_now.answerTick = tick;
    }
    void takeBack() { m_now.answerTick.reset(); }
    const TrialCircumstances& ofTrial() const noexcept { return m_now; }

private:
    std::string m_masking;
    TrialCircumstances m_now;
};

} // namespace chiron::session
