// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/exercise_face.h"

namespace chiron::desktop {

class ObjectHandlingFace final : public ExerciseFace {
public:
    std::string_view id() const noexcept override { return "object_handling"; }
    std::unique_ptr<LevelPicture> picture(const catalogue::ExerciseLevel& level,
                                          const PictureFrame& frame) const override;
    QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) const override;
    QStringList limitWords(const session::LevelLimits& limits, const QLocale& locale) const override;
    std::unique_ptr<LivePart> livePart(const catalogue::ExerciseLevel& level,
                                       LiveSurroundings around) const override;
    std::unique_ptr<TrialAnswer> trialAnswer() const override;
    QString debriefTitle() const override;
    QString debriefEmpty() const override;
    DebriefReading readDebrief(const catalogue::ExerciseLevel& level,
                               const scoring::SessionTrace& trace) const override;
    std::unique_ptr<PlaybackLayer> playbackLayer(const session::SessionSetup& setup,
                                                 const scoring::SessionTrace& trace) const override;
};

} // namespace chiron::desktop
