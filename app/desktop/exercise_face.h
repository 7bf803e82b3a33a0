// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/result.h"
#include "desktop/debrief/debrief_part.h"
#include "desktop/home/level_picture.h"
#include "desktop/playback/playback_layer.h"
#include "desktop/results/results_part.h"
#include "desktop/training/live_part.h"
#include "desktop/training/trial_answer.h"
#include "scoring/trace.h"
#include "session/level_limits.h"
#include "session/session_setup.h"
#include "session/trial_surfaces.h"

#include <QLocale>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <string_view>

namespace chiron::desktop {

/// The depth-of-field setting of a level whose instrument has a lens.
struct DepthOfField {
    bool on = false;
    bool fixed = false; ///< the level does not let the person change it

    /// `wanted` is the person's own choice, if they made one.
    bool shown(std::optional<bool> wanted) const { return fixed ? on : wanted.value_or(on); }
};

/// Everything on the screens that is specific to one kind of exercise. A new kind adds a derived class and
/// its line in app/exercises/exercise_catalogue.h. Implementations are stateless.
class ExerciseFace {
public:
    ExerciseFace() = default;
    ExerciseFace(const ExerciseFace&) = delete;
    ExerciseFace& operator=(const ExerciseFace&) = delete;
    virtual ~ExerciseFace() = default;

    virtual std::string_view id() const noexcept = 0;

    /// The picture of a level in the selection screens; null if the exercise offers none of its levels for
    /// training.
    virtual std::unique_ptr<LevelPicture> picture(const catalogue::ExerciseLevel& level,
                                                  const PictureFrame& frame) const = 0;
    /// Facts about a level to read before starting it, one per line; empty if the level's objective says
    /// everything.
    virtual QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) const = 0;

    /// The limits of the exercise's own metrics (LevelLimits::others) in words, one sentence each without a
    /// full stop, in the context of GateTexts.
    virtual QStringList limitWords(const session::LevelLimits&, const QLocale&) const { return {}; }

    /// The depth of field of the instrument's camera; empty if the instrument has none.
    virtual std::optional<DepthOfField> depthOfField(const catalogue::ExerciseLevel&) const {
        return std::nullopt;
    }
    /// The part of the training screen that is specific to this exercise; never null. `level` outlives it.
    virtual std::unique_ptr<LivePart> livePart(const catalogue::ExerciseLevel& level,
                                               LiveSurroundings around) const = 0;
    /// Judges answers on a level that gives feedback; never null. By default the answer is one mark, of which
    /// it is only said that it was taken.
    virtual std::unique_ptr<TrialAnswer> trialAnswer() const { return std::make_unique<MarkAnswer>(); }

    /// What is said as soon as tissue gives way: on a level that gives feedback with what to do about it.
    /// `ends`: the trial failed with it.
    virtual QString yieldedWords(const catalogue::ExerciseLevel& level, bool ends) const {
        if (ends)
            return AnswerTexts::tr("The tissue gave way: this trial can no longer be completed");
        return level.feedback
                   ? AnswerTexts::tr("Too hard: the tissue gave way. Draw back until you are out of it")
                   : AnswerTexts::tr("The tissue gave way");
    }

    /// Heading of the exercise's part of a debrief.
    virtual QString debriefTitle() const = 0;
    /// Text shown there if no trial was started.
    virtual QString debriefEmpty() const = 0;
    /// Reads the exercise's part of a debrief from a session of `level`, which is a level of this exercise.
    /// Thread: any.
    virtual DebriefReading readDebrief(const catalogue::ExerciseLevel& level,
                                       const scoring::SessionTrace& trace) const = 0;

    /// Adds to a playback what is specific to this exercise; never null.
    /// Thread: any.
    virtual std::unique_ptr<PlaybackLayer> playbackLayer(const session::SessionSetup& setup,
                                                         const scoring::SessionTrace& trace) const = 0;

    /// The part of a person's results that is specific to this exercise; null if there is none. The caller's
    /// layout owns it.
    /// Thread: GUI.
    virtual ResultsPart* resultsPart(const Theme&, const QLocale&) const { return nullptr; }
};

/// Finds the face of the exercise with this id.
/// Errors: notFound naming the exercises that exist.
core::Result<const ExerciseFace*> exerciseFace(std::string_view id);

} // namespace chiron::desktop
