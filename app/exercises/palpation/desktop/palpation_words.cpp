// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/palpation/desktop/palpation_words.h"

#include <QCoreApplication>
#include <algorithm>

namespace chiron::desktop {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PalpationWords)
};

QStringList missingOf(const simulation::Finding& finding, const simulation::PalpationCues& cues) {
    QStringList missing;
    if (cues.asksSize && finding.radius_m <= 0.0)
        missing << Words::tr("size");
    if (cues.asksHardness && finding.hardness == 0)
        missing << Words::tr("hardness");
    if (cues.asksConfidence && finding.confidence == 0)
        missing << Words::tr("confidence");
    return missing;
}

} // namespace

QString hardnessWord(int rating) {
    switch (rating) {
    case 1: return Words::tr("soft");
    case 2: return Words::tr("rather soft");
    case 3: return Words::tr("medium");
    case 4: return Words::tr("firm");
    case 5: return Words::tr("stony hard");
    default: return Words::tr("not given");
    }
}

QString confidenceWord(int rating) {
    switch (rating) {
    case 1: return Words::tr("a guess");
    case 2: return Words::tr("unsure");
    case 3: return Words::tr("fairly sure");
    case 4: return Words::tr("sure");
    case 5: return Words::tr("certain");
    default: return Words::tr("not given");
    }
}

QString sizeText(double radius_m, const QLocale& locale) {
    return radius_m > 0.0 ? Words::tr("%1 mm across").arg(locale.toString(qRound(2e3 * radius_m))) : Words::tr("not given");
}

QString findingText(int finding, const simulation::PalpationCues& cues, const QLocale& locale) {
    const simulation::Finding& said = cues.finding[static_cast<std::size_t>(finding)];
    QStringList parts;
    if (cues.asksSize)
        parts << (said.radius_m > 0.0 ? sizeText(said.radius_m, locale) : Words::tr("size not given"));
    if (cues.asksHardness)
        parts << (said.hardness > 0 ? hardnessWord(said.hardness) : Words::tr("hardness not given"));
    if (cues.asksConfidence)
        parts << (said.confidence > 0 ? confidenceWord(said.confidence) : Words::tr("confidence not given"));
    const QString number = locale.toString(finding + 1);
    return parts.isEmpty() ? Words::tr("Finding %1").arg(number) : Words::tr("Finding %1: %2").arg(number, parts.join(QStringLiteral(", ")));
}

QStringList missingRatings(const simulation::PalpationCues& cues, const QLocale& locale) {
    QStringList all;
    for (std::size_t i = 0; i < cues.finding.size(); ++i) {
        if (!cues.finding[i].present)
            continue;
        const QStringList missing = missingOf(cues.finding[i], cues);
        if (!missing.isEmpty())
            all << Words::tr("Finding %1: %2").arg(locale.toString(static_cast<int>(i) + 1), missing.join(QStringLiteral(", ")));
    }
    return all;
}

int findingCount(const simulation::PalpationCues& cues) {
    return static_cast<int>(std::count_if(cues.finding.begin(), cues.finding.end(), [](const simulation::Finding& one) { return one.present; }));
}

} // namespace chiron::desktop
