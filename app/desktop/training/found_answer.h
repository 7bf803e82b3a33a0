// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/scene3d/scene_state.h"
#include "haptics/display_state.h"
#include "session/trial_surfaces.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// Assesses a trial's answer if it is not a single mark: the findings reported during the trial, judged like
/// the scoring does.
/// Thread: GUI.
class FoundAnswer {
public:
    FoundAnswer() = default;
    FoundAnswer(const FoundAnswer&) = delete;
    FoundAnswer& operator=(const FoundAnswer&) = delete;
    virtual ~FoundAnswer() = default;

    /// Called every frame while a trial is ready or running, with its newest state.
    virtual void follow(const haptics::DisplayState& state) = 0;
    /// Whether the trial is answered by findings; if not, a mark is its answer.
    virtual bool answers() const = 0;
    /// The result so far in words; empty if nothing can be said.
    virtual QString words(const session::TrialObject& truth, const QLocale& locale) const = 0;
    /// Called when the trial has ended: freezes the answer for drawing.
    virtual void keep() = 0;
    /// Draws the truth and the result of the frozen answer.
    virtual void show(const session::TrialObject& truth, scene3d::SceneState& drawn) const = 0;
};

/// The translation context of texts about answers.
struct AnswerTexts {
    Q_DECLARE_TR_FUNCTIONS(AnswerNote)
};

} // namespace chiron::desktop
