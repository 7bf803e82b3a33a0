// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/sitting_sentences.h"

#include "desktop/studies/study_words.h"
#include "desktop/study_run/study_controls.h"

#include <QCoreApplication>
#include <QStringList>

namespace chiron::desktop {

namespace {

struct SittingWords {
    Q_DECLARE_TR_FUNCTIONS(SittingSentences)
};

/// From the limits by which trials are judged (session::FidelityMeter).
QString limitSentence(const psychophysics::FidelityLimits& limits, bool pulls, const QLocale& locale) {
    constexpr double kCentimetres = 100.0;
    const auto with = [&locale](double number, const char* unit) -> QString { // no line begins with the unit
        return study_words::plainNumber(number, locale) + QChar(QChar::Nbsp) + QLatin1String(unit);
    };
    const QString force = with(limits.peakForce_N, "N");
    const QString distance = with(kCentimetres * limits.meanSpeed_m_per_s, "cm");
    return pulls ? SittingWords::tr("Pull gently and move calmly: a trial in which you pull with more than "
                                    "%1, or move faster than %2 per second on average, is repeated.")
                       .arg(force, distance)
                 : SittingWords::tr("Press gently and move calmly: a trial in which you press with more than "
                                    "%1, or move faster than %2 per second on average, is repeated.")
                       .arg(force, distance);
}

} // namespace

QString sittingSentences(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                         bool noise, const QLocale& locale) {
    QStringList said;
    if (noise)
        said << SittingWords::tr("During the trials you hear a steady noise.");
    said << limitSentence(design.fidelity, isTakenHold(condition.stimulus.attribute), locale);
    return said.join(QLatin1Char(' '));
}

} // namespace chiron::desktop
