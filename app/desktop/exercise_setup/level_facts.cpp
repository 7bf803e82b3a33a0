// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/level_facts.h"

#include "desktop/exercise_face.h"
#include "desktop/exercise_setup/gate_words.h"

namespace chiron::desktop {

QString factNumber(double value, const QLocale& locale) {
    return locale.toString(value, 'g', 3);
}

QString trialsFact(int trials, double limit_s, const QLocale& locale) {
    return LevelFactTexts::tr("Trials: %1; each ends after %2 s at the latest")
        .arg(locale.toString(trials), locale.toString(qRound(limit_s)));
}

QStringList levelFacts(const catalogue::ExerciseLevel& level, const QLocale& locale) {
    const auto face = exerciseFace(level.exercise);
    QStringList facts = face ? (*face)->levelFacts(level, locale) : QStringList();
    facts << limitsInWords(level, locale);
    if (!level.mounting.empty())
        facts << LevelFactTexts::tr(
            "Devices with a base are mounted as this level specifies; your settings below override it");
    return facts;
}

} // namespace chiron::desktop
