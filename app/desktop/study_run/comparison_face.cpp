// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/comparison_face.h"

namespace chiron::desktop {

namespace {

class ComparisonLayer final : public PlaybackLayer {
public:
    QString readout(const session::PlaybackTrack&, const session::PlaybackView& view, double,
                    const QLocale& locale) const override {
        return trialReadout(view, locale);
    }
};

} // namespace

std::unique_ptr<LevelPicture> ComparisonFace::picture(const catalogue::ExerciseLevel&,
                                                      const PictureFrame&) const {
    return nullptr; // it has no levels of its own, only those of studies
}

QStringList ComparisonFace::levelFacts(const catalogue::ExerciseLevel&, const QLocale&) const {
    return {};
}

std::unique_ptr<LivePart> ComparisonFace::livePart(const catalogue::ExerciseLevel& level,
                                                   LiveSurroundings around) const {
    return std::make_unique<PointPart>(level, std::move(around));
}

QString ComparisonFace::yieldedWords(const catalogue::ExerciseLevel&, bool) const {
    return AnswerTexts::tr("The object came off the tool");
}

QString ComparisonFace::debriefTitle() const {
    return DebriefPartTexts::tr("What was compared");
}

QString ComparisonFace::debriefEmpty() const {
    return DebriefPartTexts::tr("What was compared and answered is shown with its study.");
}

DebriefReading ComparisonFace::readDebrief(const catalogue::ExerciseLevel&,
                                           const scoring::SessionTrace&) const {
    return nullptr; // its results are shown with its study
}

std::unique_ptr<PlaybackLayer> ComparisonFace::playbackLayer(const session::SessionSetup&,
                                                             const scoring::SessionTrace&) const {
    return std::make_unique<ComparisonLayer>();
}

} // namespace chiron::desktop
