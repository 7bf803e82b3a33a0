// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_state.h"
#include "haptics/display_state.h"
#include "session/trial_surfaces.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// What a trial's answer is worth where it is not one mark: what was reported while the trial ran, judged as scoring judges it. GUI thread.
class FoundAnswer {
public:
    FoundAnswer() = default;
    FoundAnswer(const FoundAnswer&) = delete;
    FoundAnswer& operator=(const FoundAnswer&) = delete;
    virtual ~FoundAnswer() = default;

    /// Each frame while a trial waits or runs: its newest state.
    virtual void follow(const haptics::DisplayState& state) = 0;
    /// Whether the trial is answered in this way; where it is not, a mark is its answer.
    virtual bool answers() const = 0;
    /// What came of it so far, in words; empty where nothing can be said.
    virtual QString words(const session::TrialObject& truth, const QLocale& locale) const = 0;
    /// The trial has ended: what is drawn stays with this answer.
    virtual void keep() = 0;
    /// Draws the truth, and what became of the answer that was kept.
    virtual void show(const session::TrialObject& truth, scene3d::SceneState& drawn) const = 0;
};

/// The translation context of what is said of an answer.
struct AnswerTexts {
    Q_DECLARE_TR_FUNCTIONS(AnswerNote)
};

} // namespace chiron::desktop
