// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "desktop/debrief/debrief_part.h"
#include "desktop/home/level_picture.h"
#include "desktop/playback/playback_layer.h"
#include "desktop/results/results_part.h"
#include "desktop/training/found_answer.h"
#include "desktop/training/live_part.h"
#include "scoring/trace.h"
#include "session/live_sample.h"
#include "session/session_setup.h"
#include "session/trial_surfaces.h"

#include <QLocale>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <string_view>

namespace chiron::desktop {

/// How the optics of an instrument with a lens are set on a level.
struct DepthOfField {
    bool on = false;
    bool fixed = false; ///< the level keeps it so

    /// `wanted`: as the person switched it.
    bool shown(std::optional<bool> wanted) const { return fixed ? on : wanted.value_or(on); }
};

/// What the screens show of one kind of exercise alone. A new kind adds a class and one line in app/exercises/face_catalogue.cpp.
/// Stateless.
class ExerciseFace {
public:
    ExerciseFace() = default;
    ExerciseFace(const ExerciseFace&) = delete;
    ExerciseFace& operator=(const ExerciseFace&) = delete;
    virtual ~ExerciseFace() = default;

    virtual std::string_view id() const noexcept = 0;

    /// The picture of a level, where one is chosen; null: none of its levels is offered for training.
    virtual std::unique_ptr<LevelPicture> picture(const catalogue::ExerciseLevel& level, const PictureFrame& frame) const = 0;
    /// What is particular about a level, a line each, before one begins with it; empty where its objective says it all.
    virtual QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) const = 0;

    /// Of the instrument that looks into the body; empty where there is none.
    virtual std::optional<DepthOfField> depthOfField(const catalogue::ExerciseLevel&) const { return std::nullopt; }
    /// What the training screen has for it alone; never null. `level` outlives it.
    virtual std::unique_ptr<LivePart> livePart(const catalogue::ExerciseLevel& level, LiveSurroundings around) const = 0;
    /// How a trial is judged at its end where its answer is not one mark; null where it is one.
    virtual std::unique_ptr<FoundAnswer> foundAnswer() const { return nullptr; }

    /// What is said of a mark on a level that gives feedback; `truth`: of its trial. As it stands here: that it was taken.
    virtual QString markWords(const session::TrialObject& /*truth*/, const session::LiveSample& /*at*/, const QLocale&) const {
        return AnswerTexts::tr("Marked");
    }

    /// What stands above its part of a debrief.
    virtual QString debriefTitle() const = 0;
    /// What is said there where no trial was begun.
    virtual QString debriefEmpty() const = 0;
    /// Reads that part from a session of `level`, which is of this kind. Any thread.
    virtual DebriefReading readDebrief(const catalogue::ExerciseLevel& level, const scoring::SessionTrace& trace) const = 0;

    /// What a playback of this session shows beside what it shows of all; never null. Any thread.
    virtual std::unique_ptr<PlaybackLayer> playbackLayer(const session::SessionSetup& setup, const scoring::SessionTrace& trace) const = 0;

    /// What the results of a person show of it alone; null: nothing. Whoever lays it out owns it. GUI thread.
    virtual ResultsPart* resultsPart(const Theme&, const QLocale&) const { return nullptr; }
};

/// The face of the exercise with this id. Failure: notFound naming the exercises that exist.
core::Result<const ExerciseFace*> exerciseFace(std::string_view id);

} // namespace chiron::desktop
