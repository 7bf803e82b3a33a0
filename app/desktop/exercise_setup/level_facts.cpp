// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/level_facts.h"

#include "desktop/exercise_setup/gate_words.h"
#include "app/exercises/urethra_insertion/desktop/endoscopy.h"
#include "desktop/training/grasping.h"
#include "app/exercises/urethra_insertion/desktop/insertion_values.h"
#include "app/exercises/palpation/desktop/palpating.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(LevelFacts)
};

QString tissueText(const std::string& tissue) {
    if (tissue == "normal")
        return Words::tr("Tissue: normal");
    if (tissue == "tight")
        return Words::tr("Tissue: tight urethra");
    if (tissue == "stricture")
        return Words::tr("Tissue: with a stricture, a narrow and stiff ring");
    return Words::tr("Tissue: %1").arg(QString::fromStdString(tissue));
}

QString depthOfFieldText(const simulation::UrethraInsertionParameters& p) {
    if (p.depthOfFieldFixed)
        return p.depthOfField ? Words::tr("Depth of field: on, fixed") : Words::tr("Depth of field: off, fixed");
    return p.depthOfField ? Words::tr("Depth of field: on, can be switched off") : Words::tr("Depth of field: off, can be switched on");
}

QString wayText(const simulation::UrethraInsertionParameters& p, const QLocale& locale) {
    const QString goal_mm = locale.toString(qRound(InsertionGauge(p).goal_m() * 1e3));
    return p.withdraws ? Words::tr("Distance: %1 mm in, then back out").arg(goal_mm) : Words::tr("Distance: %1 mm in").arg(goal_mm);
}

bool has(const std::vector<std::string>& cues, const char* cue) { return std::find(cues.begin(), cues.end(), cue) != cues.end(); }

QString viewText(const std::vector<std::string>& cues) {
    const bool overview = has(cues, "overview");
    if (has(cues, "guidance"))
        return overview ? Words::tr("Help: the path is marked in the picture, and a second picture shows it from outside")
                        : Words::tr("Help: the path is marked in the picture");
    return overview ? Words::tr("Help: a second picture shows the endoscope from outside") : Words::tr("Help: none, only the endoscope's picture");
}

QString newtons(double value, const QLocale& locale) { return locale.toString(value, 'g', 3); }

QString trialsText(int trials, double limit_s, const QLocale& locale) {
    return Words::tr("Trials: %1, at most %2 s each").arg(locale.toString(trials), locale.toString(qRound(limit_s)));
}

QString tubeGoalText(const simulation::ElasticTubeParameters& p, const QLocale& locale) {
    const QString hold_s = locale.toString(p.hold_s, 'g', 3);
    switch (p.task) {
    case simulation::TubeTask::hold:
    case simulation::TubeTask::twoHanded:
        return Words::tr("Goal: a tension between %1 and %2 N, held within ±%3 N for %4 s")
            .arg(newtons(p.targetLow_N, locale), newtons(p.targetHigh_N, locale), newtons(p.band_N, locale), hold_s);
    case simulation::TubeTask::stretch:
        return Words::tr("Goal: stretch the tube to %1 times its length and hold it for %2 s").arg(locale.toString(p.markRatio, 'g', 3), hold_s);
    case simulation::TubeTask::transfer:
        return Words::tr("Goal: hand over the end of the tube and hold it in the target for %1 s").arg(hold_s);
    }
    return {};
}

QStringList tubeFacts(const simulation::ElasticTubeParameters& p, const QLocale& locale) {
    QStringList facts{tubeGoalText(p, locale)};
    facts << (p.hasFold()     ? Words::tr("Instruments: three, one in each hand and one that holds tissue back")
              : p.tools() > 1 ? Words::tr("Instruments: two, one in each hand")
                              : Words::tr("Instruments: one"));
    if (p.hasFold())
        facts << Words::tr("Over the tube: a fold of tissue, to be held back with %1 to %2 N").arg(newtons(p.retractionLow_N, locale), newtons(p.retractionHigh_N, locale));
    const QString length_mm = locale.toString(qRound(p.restLength_m * 1e3));
    const QString tears = locale.toString(p.tearRatio, 'g', 3);
    facts << (p.tube.stiffening_per_m > 0.0
                  ? Words::tr("Tube: %1 mm long, gets stiffer as it stretches, tears at %2 times its length").arg(length_mm, tears)
                  : Words::tr("Tube: %1 mm long, tears at %2 times its length").arg(length_mm, tears));
    return facts << trialsText(p.trials, p.trialLimit_s, locale);
}

QStringList handlingFacts(const simulation::ObjectHandlingParameters& p, const QLocale& locale) {
    QStringList facts;
    if (p.task == simulation::HandlingTask::weigh)
        facts << Words::tr("Goal: put the heaviest of %1 identical-looking objects inside the ring").arg(locale.toString(p.objects));
    else
        facts << Words::tr("Goal: lift the object by %1 mm and put it inside the ring").arg(locale.toString(qRound(p.liftHeight_m * 1e3)));
    if (p.organBed)
        facts << Words::tr("Surface: a soft organ that gives way");
    return facts << trialsText(p.trials, p.trialLimit_s, locale);
}

QString handsText(const simulation::PalpationParameters& p) {
    if (p.hands > 1)
        return p.fingers > 1 ? Words::tr("Hands: two, two fingers each") : Words::tr("Hands: two, one finger each");
    return p.fingers > 1 ? Words::tr("Hands: one, two fingers side by side") : Words::tr("Hands: one, one finger");
}

QString lumpsText(const simulation::PalpationParameters& p, const QLocale& locale) {
    const int least = p.catchTrials > 0 ? 0 : p.lumpsLow;
    if (least == p.lumpsHigh)
        return Words::tr("Lumps per trial: %1").arg(locale.toString(p.lumpsHigh));
    if (least == 0 && p.lumpsHigh == 1)
        return Words::tr("Lumps per trial: one or none");
    return least == 0 ? Words::tr("Lumps per trial: 0 to %1").arg(locale.toString(p.lumpsHigh))
                      : Words::tr("Lumps per trial: %1 to %2").arg(locale.toString(least), locale.toString(p.lumpsHigh));
}

QString reportedText(const simulation::PalpationParameters& p) {
    QStringList asked{Words::tr("where it is")};
    if (p.asksSize)
        asked << Words::tr("how large");
    if (p.asksHardness)
        asked << Words::tr("how hard");
    if (p.asksConfidence)
        asked << Words::tr("how sure you are");
    return Words::tr("To report for each finding: %1").arg(asked.join(QStringLiteral(", ")));
}

QStringList palpationFacts(const simulation::PalpationParameters& p, const QLocale& locale) {
    QStringList facts{handsText(p), lumpsText(p, locale), reportedText(p)};
    facts << Words::tr("Press with %1 to %2 N").arg(newtons(p.bandLow_N, locale), newtons(p.bandHigh_N, locale));
    return facts << trialsText(p.trials, p.trialLimit_s, locale);
}

QStringList taskFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) {
    if (const Grasping grasping = graspingOf(level))
        return grasping.tube ? tubeFacts(*grasping.tube, locale) : handlingFacts(*grasping.handling, locale);
    if (const auto* palpation = palpationOf(level))
        return palpationFacts(*palpation, locale);
    const auto* p = endoscopyOf(level);
    if (!p)
        return {};
    QStringList facts{wayText(*p, locale), tissueText(p->tissue)};
    if (!p->landmarks.empty())
        facts << Words::tr("Landmarks of the bladder to inspect: %1").arg(locale.toString(static_cast<int>(p->landmarks.size())));
    facts << viewText(level.cues) << depthOfFieldText(*p);
    facts << Words::tr("Time: %1 s at most").arg(locale.toString(qRound(p->trialLimit_s)));
    return facts;
}

} // namespace

QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) {
    QStringList facts = taskFacts(level, locale);
    facts << limitsInWords(level, locale);
    if (!level.mounting.empty())
        facts << Words::tr("Devices with a base are mounted as this level specifies; your settings below override it");
    return facts;
}

} // namespace chiron::desktop
