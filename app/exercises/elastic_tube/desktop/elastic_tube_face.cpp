// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/elastic_tube/desktop/elastic_tube_face.h"

#include "app/exercises/elastic_tube/desktop/tube_grasping.h"
#include "app/exercises/elastic_tube/desktop/tube_layer.h"
#include "app/exercises/elastic_tube/desktop/tube_picture.h"
#include "app/exercises/elastic_tube/session_report/tube_report_of.h"
#include "desktop/debrief/part_widgets.h"
#include "desktop/exercise_setup/gate_words.h"
#include "desktop/exercise_setup/level_facts.h"
#include "desktop/training/grasp_part.h"

#include <QVBoxLayout>

namespace chiron::desktop {

namespace {

class TubeDebrief final : public DebriefPart {
public:
    explicit TubeDebrief(report::TubeReport tube) : m_tube(std::move(tube)) {}

    std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const override {
        if (m_tube.rows.empty())
            return nullptr;
        const report::PlotTheme look = plotThemeOf(theme, locale);
        PartColumn column(theme);
        column.layout->addWidget(partPlot(theme, report::tensionPlot(m_tube, look), "debrief.tension", 230));
        if (auto retraction = report::retractionPlot(m_tube, look))
            column.layout->addWidget(partPlot(theme, std::move(retraction), "debrief.retraction", 230));
        column.layout->addWidget(partPlot(theme, report::stretchPlot(m_tube, look), "debrief.stretch", 230));
        column.layout->addWidget(trialTable(theme, report::tubeTable(m_tube, locale), "debrief.tube_trials"));
        return std::move(column.holder);
    }

private:
    report::TubeReport m_tube;
};

QString tubeGoalText(const simulation::ElasticTubeParameters& p, const QLocale& locale) {
    const QString hold_s = locale.toString(p.hold_s, 'g', 3);
    switch (p.task) {
    case simulation::TubeTask::hold:
    case simulation::TubeTask::twoHanded:
        return LevelFactTexts::tr("Goal: a tension between %1 and %2 N, held within ±%3 N for %4 s")
            .arg(factNumber(p.targetLow_N, locale), factNumber(p.targetHigh_N, locale),
                 factNumber(p.band_N, locale), hold_s);
    case simulation::TubeTask::stretch:
        return LevelFactTexts::tr("Goal: stretch the tube to %1 times its length and hold it for %2 s")
            .arg(locale.toString(p.markRatio, 'g', 3), hold_s);
    case simulation::TubeTask::transfer:
        return LevelFactTexts::tr("Goal: hand over the end of the tube and hold it in the target for %1 s")
            .arg(hold_s);
    }
    return {};
}

QStringList tubeFacts(const simulation::ElasticTubeParameters& p, const QLocale& locale) {
    QStringList facts{tubeGoalText(p, locale)};
    facts << (p.hasFold()
                  ? LevelFactTexts::tr("Instruments: three, one in each hand and one that holds tissue back")
              : p.tools() > 1 ? LevelFactTexts::tr("Instruments: two, one in each hand")
                              : LevelFactTexts::tr("Instruments: one"));
    if (p.hasFold())
        facts << LevelFactTexts::tr("Over the tube: a fold of tissue, to be held back with %1 to %2 N")
                     .arg(factNumber(p.retractionLow_N, locale), factNumber(p.retractionHigh_N, locale));
    const QString length_mm = locale.toString(qRound(p.restLength_m * 1e3));
    const QString tears = locale.toString(p.tearRatio, 'g', 3);
    facts
        << (p.tube.stiffening_per_m > 0.0
                ? LevelFactTexts::tr(
                      "Tube: %1 mm long, gets stiffer as it stretches, tears at %2 times its length")
                      .arg(length_mm, tears)
                : LevelFactTexts::tr("Tube: %1 mm long, tears at %2 times its length").arg(length_mm, tears));
    return facts << trialsFact(p.trials, p.trialLimit_s, locale);
}

} // namespace

std::unique_ptr<LevelPicture> ElasticTubeFace::picture(const catalogue::ExerciseLevel& level,
                                                       const PictureFrame& frame) const {
    return std::make_unique<TubePicture>(level.parameters.as<simulation::ElasticTubeParameters>(), frame);
}

QStringList ElasticTubeFace::levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) const {
    return tubeFacts(level.parameters.as<simulation::ElasticTubeParameters>(), locale);
}

QStringList ElasticTubeFace::limitWords(const session::LevelLimits& limits, const QLocale& locale) const {
    QStringList words;
    if (const auto retraction_N = limits.of("retraction_max"))
        words << GateTexts::tr("Pull on the fold: %1 N at most").arg(factNumber(*retraction_N, locale));
    return words;
}

/// A tube tears in one piece, which ends the trial.
QString ElasticTubeFace::yieldedWords(const catalogue::ExerciseLevel& level, bool ends) const {
    if (!ends)
        return ExerciseFace::yieldedWords(level, ends);
    return level.feedback
               ? AnswerTexts::tr("The tube tore: this trial can no longer be completed. Stretch it less far, "
                                 "and pull more gently")
               : AnswerTexts::tr("The tube tore: this trial can no longer be completed");
}

std::unique_ptr<LivePart> ElasticTubeFace::livePart(const catalogue::ExerciseLevel& level,
                                                    LiveSurroundings around) const {
    const auto& p = level.parameters.as<simulation::ElasticTubeParameters>();
    return std::make_unique<GraspPart>(tubeGrasping(p, session::levelLimits(level)), level.feedback,
                                       std::move(around));
}

QString ElasticTubeFace::debriefTitle() const {
    return DebriefPartTexts::tr("How the tube was held and stretched");
}

QString ElasticTubeFace::debriefEmpty() const {
    return DebriefPartTexts::tr("There is no tension to show. The session is kept and listed.");
}

DebriefReading ElasticTubeFace::readDebrief(const catalogue::ExerciseLevel& level,
                                            const scoring::SessionTrace& trace) const {
    return std::make_unique<TubeDebrief>(session_report::tubeReportOf(trace, level));
}

std::unique_ptr<PlaybackLayer> ElasticTubeFace::playbackLayer(const session::SessionSetup& setup,
                                                              const scoring::SessionTrace&) const {
    return std::make_unique<TubeLayer>(setup.level.parameters.as<simulation::ElasticTubeParameters>(),
                                       setup.seed);
}

} // namespace chiron::desktop
