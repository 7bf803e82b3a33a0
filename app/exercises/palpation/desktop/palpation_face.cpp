// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_face.h"

#include "app/exercises/palpation/desktop/found_lumps.h"
#include "app/exercises/palpation/desktop/palpating.h"
#include "app/exercises/palpation/desktop/palpation_box.h"
#include "app/exercises/palpation/desktop/palpation_layer.h"
#include "app/exercises/palpation/desktop/palpation_part.h"
#include "app/exercises/palpation/desktop/palpation_picture.h"
#include "app/exercises/palpation/desktop/roc_box.h"
#include "app/exercises/palpation/session/palpation_record.h"
#include "desktop/exercise_setup/level_facts.h"

namespace chiron::desktop {

namespace {

class PalpationDebrief final : public DebriefPart {
public:
    PalpationDebrief(const simulation::PalpationParameters& level,
                     std::vector<session::PalpationTrialRecord> records)
        : m_level(level), m_records(std::move(records)) {}

    std::unique_ptr<QWidget> widget(const Theme& theme, const QLocale& locale) const override {
        return m_records.empty() ? nullptr
                                 : std::make_unique<PalpationBox>(theme, locale, m_level, m_records);
    }

private:
    simulation::PalpationParameters m_level;
    std::vector<session::PalpationTrialRecord> m_records; ///< one per trial that was started
};

QString handsText(const simulation::PalpationParameters& p) {
    if (p.hands > 1)
        return p.fingers > 1 ? LevelFactTexts::tr("Hands: two, two fingers each")
                             : LevelFactTexts::tr("Hands: two, one finger each");
    return p.fingers > 1 ? LevelFactTexts::tr("Hands: one, two fingers side by side")
                         : LevelFactTexts::tr("Hands: one, one finger");
}

QString lumpsText(const simulation::PalpationParameters& p, const QLocale& locale) {
    const int least = p.catchTrials > 0 ? 0 : p.lumpsLow;
    if (least == p.lumpsHigh)
        return LevelFactTexts::tr("Lumps per trial: %1").arg(locale.toString(p.lumpsHigh));
    if (least == 0 && p.lumpsHigh == 1)
        return LevelFactTexts::tr("Lumps per trial: one or none");
    return least == 0 ? LevelFactTexts::tr("Lumps per trial: 0 to %1").arg(locale.toString(p.lumpsHigh))
                      : LevelFactTexts::tr("Lumps per trial: %1 to %2")
                            .arg(locale.toString(least), locale.toString(p.lumpsHigh));
}

QString reportedText(const simulation::PalpationParameters& p) {
    QStringList asked{LevelFactTexts::tr("where it is")};
    if (p.asksSize)
        asked << LevelFactTexts::tr("how large");
    if (p.asksHardness)
        asked << LevelFactTexts::tr("how hard");
    if (p.asksConfidence)
        asked << LevelFactTexts::tr("how sure you are");
    return LevelFactTexts::tr("To report for each finding: %1").arg(asked.join(QStringLiteral(", ")));
}

QStringList palpationFacts(const simulation::PalpationParameters& p, const QLocale& locale) {
    QStringList facts{handsText(p), lumpsText(p, locale), reportedText(p)};
    facts << LevelFactTexts::tr("Press with %1 to %2 N")
                 .arg(factNumber(p.bandLow_N, locale), factNumber(p.bandHigh_N, locale));
    return facts << trialsFact(p.trials, p.trialLimit_s, locale);
}

} // namespace

std::unique_ptr<LevelPicture> PalpationFace::picture(const catalogue::ExerciseLevel& level,
                                                     const PictureFrame& frame) const {
    return std::make_unique<PalpationPicture>(*palpationOf(level), frame);
}

QStringList PalpationFace::levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) const {
    return palpationFacts(*palpationOf(level), locale);
}

std::unique_ptr<TrialAnswer> PalpationFace::trialAnswer() const {
    return std::make_unique<FoundLumps>();
}

/// Tissue gives way under a finger that presses and between jaws that squeeze.
QString PalpationFace::yieldedWords(const catalogue::ExerciseLevel& level, bool ends) const {
    if (ends || !level.feedback || !palpationOf(level)->pinch)
        return ExerciseFace::yieldedWords(level, ends);
    return AnswerTexts::tr("Too hard: the tissue gave way. Draw back until you are out of it, or open the "
                           "jaws if they squeezed it");
}

std::unique_ptr<LivePart> PalpationFace::livePart(const catalogue::ExerciseLevel& level,
                                                  LiveSurroundings around) const {
    return std::make_unique<PalpationPart>(*palpationOf(level), std::move(around));
}

QString PalpationFace::debriefTitle() const {
    return DebriefPartTexts::tr("What was searched and what was found");
}

QString PalpationFace::debriefEmpty() const {
    return DebriefPartTexts::tr("There is no search to show. The session is kept and listed.");
}

DebriefReading PalpationFace::readDebrief(const catalogue::ExerciseLevel& level,
                                          const scoring::SessionTrace& trace) const {
    const simulation::PalpationParameters& parameters = *palpationOf(level);
    auto records = session::palpationRecord(trace, parameters);
    if (!records)
        return tl::unexpected(DebriefPartLost{
            QCoreApplication::translate("chiron::desktop::DebriefScreen",
                                        "Findings and maps could not be read from the recording. The scores "
                                        "above are as they were stored."),
            std::move(records.error())});
    return std::make_unique<PalpationDebrief>(parameters, std::move(*records));
}

std::unique_ptr<PlaybackLayer> PalpationFace::playbackLayer(const session::SessionSetup& setup,
                                                            const scoring::SessionTrace& trace) const {
    const simulation::PalpationParameters& level = *palpationOf(setup.level);
    auto records = session::palpationRecord(trace, level);
    if (!records)
        return std::make_unique<PalpationLayer>(std::move(records.error()));
    return std::make_unique<PalpationLayer>(PalpationReplay(level, std::move(*records)));
}

ResultsPart* PalpationFace::resultsPart(const Theme& theme, const QLocale& locale) const {
    auto* box = new RocBox(theme, locale);
    box->setObjectName(QStringLiteral("results.detection"));
    return box;
}

} // namespace chiron::desktop
