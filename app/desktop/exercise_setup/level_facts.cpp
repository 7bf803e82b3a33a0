// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/level_facts.h"

#include "desktop/training/endoscopy.h"
#include "desktop/training/insertion_values.h"

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
        return Words::tr("Tissue: tight");
    if (tissue == "stricture")
        return Words::tr("Tissue: with a stricture, a narrow and stiff ring");
    return Words::tr("Tissue: %1").arg(QString::fromStdString(tissue));
}

QString depthOfFieldText(const simulation::UrethraInsertionParameters& p) {
    if (p.depthOfFieldFixed)
        return p.depthOfField ? Words::tr("Depth of field: on, kept on") : Words::tr("Depth of field: off, kept off");
    return p.depthOfField ? Words::tr("Depth of field: on, can be switched off") : Words::tr("Depth of field: off, can be switched on");
}

QString wayText(const simulation::UrethraInsertionParameters& p, const QLocale& locale) {
    const QString goal_mm = locale.toString(qRound(InsertionGauge(p).goal_m() * 1e3));
    return p.withdraws ? Words::tr("Way: %1 mm in and out again").arg(goal_mm) : Words::tr("Way: %1 mm in").arg(goal_mm);
}

bool has(const std::vector<std::string>& cues, const char* cue) { return std::find(cues.begin(), cues.end(), cue) != cues.end(); }

QString viewText(const std::vector<std::string>& cues) {
    const bool overview = has(cues, "overview");
    if (has(cues, "guidance"))
        return overview ? Words::tr("Help: the way is marked in the picture, and a second picture shows it from outside")
                        : Words::tr("Help: the way is marked in the picture");
    return overview ? Words::tr("Help: a second picture shows the endoscope from outside") : Words::tr("Help: none, the endoscope's picture alone");
}

} // namespace

QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) {
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

} // namespace chiron::desktop
