// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/sitting_sentences.h"

#include "desktop/studies/participant_sentences.h"

#include <QCoreApplication>
#include <QStringList>

namespace chiron::desktop {

namespace {

struct SittingWords {
    Q_DECLARE_TR_FUNCTIONS(SittingSentences)
};

} // namespace

QString sittingSentences(const psychophysics::StudyDesign& design, const psychophysics::Condition& condition,
                         bool noise, const QLocale& locale) {
    QStringList said;
    if (noise)
        said << SittingWords::tr("During the trials you hear a steady noise.");
    said << limitSentence(design, condition, locale.name().section(u'_', 0, 0));
    return said.join(QLatin1Char(' '));
}

} // namespace chiron::desktop
