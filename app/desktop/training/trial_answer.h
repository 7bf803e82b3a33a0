// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "desktop/scene3d/scene_state.h"
#include "haptics/display_state.h"
#include "session/live_sample.h"
#include "session/trial_surfaces.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <optional>

namespace chiron::desktop {

/// Judges the answers to the trials of a level that gives feedback, like the scoring does.
/// Thread: GUI.
class TrialAnswer {
public:
    TrialAnswer() = default;
    TrialAnswer(const TrialAnswer&) = delete;
    TrialAnswer& operator=(const TrialAnswer&) = delete;
    virtual ~TrialAnswer() = default;

    /// Called every frame while a trial is ready or running, with its newest state.
    virtual void follow(const haptics::DisplayState& state) = 0;
    /// What is said as soon as a mark is set; `truth` belongs to the mark's trial.
    virtual QString markWords(const session::TrialObject& truth, const session::LiveSample& at,
                              const QLocale& locale) const = 0;
    /// What is said when a trial has ended without a mark, after how it ended; empty if nothing can be said.
    virtual QString endWords(const session::TrialObject& truth, const QLocale& locale) const = 0;
    /// Called at a mark and at the end of a trial: keeps what show() draws of it. Returns false, and keeps
    /// what it has, if nothing of it may be drawn yet. `p_WMark`: m, W; no value at an end without a mark.
    virtual bool keep(const session::TrialObject& truth, const std::optional<core::Vec3>& p_WMark) = 0;
    /// Draws the truth and the answer that were kept.
    virtual void show(scene3d::SceneState& drawn) const = 0;
};

/// The answer is a mark, of which it is only said that it was taken. Nothing is drawn.
class MarkAnswer : public TrialAnswer {
public:
    void follow(const haptics::DisplayState&) override {}
    QString markWords(const session::TrialObject& truth, const session::LiveSample& at,
                      const QLocale& locale) const override;
    QString endWords(const session::TrialObject&, const QLocale&) const override { return {}; }
    bool keep(const session::TrialObject&, const std::optional<core::Vec3>&) override { return false; }
    void show(scene3d::SceneState&) const override {}
};

/// "Marked": said of a mark of which nothing else may be said.
QString markTaken();

/// The translation context of texts about answers.
struct AnswerTexts {
    Q_DECLARE_TR_FUNCTIONS(AnswerNote)
};

} // namespace chiron::desktop
