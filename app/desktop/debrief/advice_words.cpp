// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/debrief/advice_words.h"

#include "catalogue/exercise.h"
#include "core/units.h"
#include "desktop/plots/session_token_words.h"
#include "report/report_text.h"
#include "session_report/mark_words.h"
#include "session_report/metric_words.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {

struct AdviceTexts {
    Q_DECLARE_TR_FUNCTIONS(Advice)
};

QString whereWords(const session::WorstMoment& moment, bool several, const QLocale& locale) {
    const QString trial = locale.toString(moment.trial + 1);
    if (moment.wholeTrial)
        return AdviceTexts::tr("in trial %1").arg(trial);
    const QString into = clockText(moment.intoTrial_s, locale);
    const QString when = several ? AdviceTexts::tr("in trial %1, %2 after it began").arg(trial, into)
                                 : AdviceTexts::tr("%1 after the start").arg(into);
    if (!moment.depth_m)
        return when;
    return AdviceTexts::tr("at a depth of %1, %2")
        .arg(report::formatValue(core::mmFromM(*moment.depth_m), QStringLiteral("mm"), locale), when);
}

} // namespace

QString momentSentence(const QString& text, const session::WorstMoment& moment, const std::string& exercise,
                       bool several, const QLocale& locale) {
    if (moment.wholeTrial && !several)
        return {};
    // A count is the session's: it is no value of the one event that the moment is.
    const bool counted = moment.unit == "count";
    const bool hasValue = !(counted && moment.event);
    const QLatin1String valuePlace(catalogue::kMomentValue), eventPlace(catalogue::kMomentEvent),
        wherePlace(catalogue::kMomentWhere);
    const QString where = whereWords(moment, several, locale);
    const QString value = report::formatValue(
        moment.value, session_report::unitText(QString::fromStdString(moment.unit)), locale);
    const bool fits = !text.isEmpty() && (!text.contains(valuePlace) || hasValue) &&
                      (!text.contains(eventPlace) || moment.event) &&
                      (!counted || moment.event); // otherwise the trial with the most of them
    if (!fits)
        return hasValue ? AdviceTexts::tr("It was worst %1: %2.").arg(where, value)
                        : AdviceTexts::tr("It was worst %1.").arg(where);
    QString sentence = text;
    if (moment.event)
        sentence.replace(eventPlace, session_report::whatHappened(*moment.event, exercise, locale));
    return sentence.replace(valuePlace, value).replace(wherePlace, where);
}

} // namespace chiron::desktop
