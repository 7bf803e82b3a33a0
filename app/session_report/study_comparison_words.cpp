// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/study_comparison_words.h"

#include "psychophysics/measures/exact_tests.h"
#include "psychophysics/planning/study_plan.h"
#include "session_report/study_report_text.h"
#include "session_report/study_report_words.h"

#include <cmath>

namespace chiron::session_report {

namespace {

QString pWords(double p, const QLocale& locale) {
    if (!std::isfinite(p))
        return QStringLiteral("–");
    return p < 0.001 ? QStringLiteral("< ") + locale.toString(0.001, 'f', 3) : locale.toString(p, 'f', 3);
}

bool holdsOne(const psychophysics::Interval& ratio) {
    return ratio.low <= 1.0 && ratio.high >= 1.0;
}

/// The interval of a ratio. A very wide one that excludes 1 still says which condition has the larger value.
QString rangeWords(const psychophysics::Interval& ratio, const QLocale& locale) {
    if (!std::isfinite(ratio.low) || !std::isfinite(ratio.high))
        return QStringLiteral("–");
    const QString written = QStringLiteral("%1 … %2").arg(study_report_words::number(ratio.low, locale),
                                                          study_report_words::number(ratio.high, locale));
    return holdsOne(ratio) ? intervalOrUnbounded(ratio, written) : written;
}

/// The p that decides: the one adjusted for all comparisons, where it was adjusted.
double decidingP(const psychophysics::ConditionComparison& weber) {
    return std::isfinite(weber.pHolm) ? weber.pHolm : weber.pValue;
}

/// "p = 0.012" or "adjusted p < 0.001".
QString decidingWords(const psychophysics::ConditionComparison& weber, const QLocale& locale) {
    const double p = decidingP(weber);
    const QString name = p == weber.pValue ? QStringLiteral("p") : Words::tr("adjusted p");
    const QString words = pWords(p, locale);
    return name + (words.startsWith(QLatin1Char('<')) ? QStringLiteral(" ") : QStringLiteral(" = ")) + words;
}

/// How many people a study would need to find a stated ratio. It follows from how much the differences
/// between these people scatter, and not from the ratio that was found: a sample size that is reckoned from a
/// ratio that was not significant says nothing new. Fewer than three people have no scatter worth the name.
/// Of two groups, Welch's degrees of freedom are at most those used here, so the number is rather too high.
QString howManyAreNeeded(const psychophysics::ConditionComparison& weber, const QLocale& locale) {
    constexpr double kRatio = 1.5, kPower = 0.8;
    const int fewest = weber.paired ? weber.participants : std::min(weber.first, weber.second);
    if (fewest < 3 || psychophysics::isUnbounded(weber.ratio95))
        return Words::tr("So few participants cannot show how many are needed: the study's page “Expected "
                         "precision” shows it for the planned trials.");
    const int freedom = weber.paired ? weber.participants - 1 : weber.first + weber.second - 2;
    const double error = (std::log10(weber.ratio95.high) - std::log10(weber.ratio95.low)) /
                         (2.0 * psychophysics::studentQuantile(0.975, freedom));
    psychophysics::PowerQuestion question;
    question.differenceLog10 = std::log10(kRatio);
    question.runSdLog10 = 0.0; // part of the scatter
    question.paired = weber.paired;
    if (weber.paired)
        question.effectSdLog10 = error * std::sqrt(static_cast<double>(weber.participants));
    else
        question.personSdLog10 = error / std::sqrt(1.0 / weber.first + 1.0 / weber.second);
    const int needed = psychophysics::participantsFor(question, kPower);
    if (needed >= 0 && needed <= fewest)
        return {};
    const QString ratio = locale.toString(kRatio, 'g', 2);
    const QString number = needed < 0 ? Words::tr("more than %1").arg(locale.toString(1000))
                                      : Words::tr("about %1").arg(locale.toString(needed));
    return (weber.paired
                ? Words::tr("If other people vary as much as these do, %1 participants in both conditions "
                            "are needed to "
                            "find, with 80 % power, a Weber fraction that is %2 times the other.")
                : Words::tr(
                      "If other people vary as much as these do, %1 participants in each group are needed to "
                      "find, with 80 % power, a Weber fraction that is %2 times the other."))
        .arg(number, ratio);
}

/// That no difference was shown does not show that there is none: what remains possible.
QString whatRemains(const psychophysics::ConditionComparison& weber, const QLocale& locale) {
    const QString people =
        weber.paired
            ? Words::tr("%1 participants in both conditions").arg(locale.toString(weber.participants))
            : Words::tr("two groups of %1 and %2 participants")
                  .arg(locale.toString(weber.first), locale.toString(weber.second));
    QStringList said{psychophysics::isUnbounded(weber.ratio95)
                         ? Words::tr("With %1, even a tenfold difference remains possible.").arg(people)
                         : Words::tr("With %1, every ratio in this interval remains possible: it is not "
                                     "shown that the two are alike.")
                               .arg(people),
                     howManyAreNeeded(weber, locale)};
    said.removeAll(QString());
    return said.join(QLatin1Char(' '));
}

QString whoIsCompared(const session::ComparedConditions& compared, const QString& first,
                      const QString& second) {
    if (compared.firstPeople.empty() || compared.secondPeople.empty())
        return {};
    return compared.weber.paired ? Words::tr("Compared in both conditions: %1.")
                                       .arg(study_report_words::codes(compared.firstPeople))
                                 : Words::tr("Two groups are compared: %2, with a value only in “%1”, and "
                                             "%4, with a value only in “%3”.")
                                       .arg(first, study_report_words::codes(compared.firstPeople), second,
                                            study_report_words::codes(compared.secondPeople));
}

/// The statistical test that the p and the interval come from; empty where there is no p.
QString testWords(const psychophysics::ConditionComparison& weber, const QLocale& locale) {
    if (!std::isfinite(weber.pValue))
        return {};
    return weber.paired
               ? Words::tr("Test: paired t test on the log Weber fractions (df = %1; random effects with "
                           "the Hartung–Knapp correction, which weights participants by the precision of "
                           "their values).")
                     .arg(locale.toString(weber.participants - 1))
               : Words::tr("Test: Welch's t test on the log Weber fractions of two independent groups "
                           "(random effects with the Hartung–Knapp correction in each).");
}

QString verdictAlone(const psychophysics::ConditionComparison& weber, const QString& first,
                     const QString& second, const QLocale& locale) {
    constexpr double kShown = 0.05;
    if (!std::isfinite(weber.pValue))
        return Words::tr(
                   "It is not known whether the Weber fractions of “%1” and “%2” differ: these values give "
                   "no interval and no p.")
            .arg(first, second);
    if (decidingP(weber) > kShown) {
        const QString verdict =
            Words::tr("The values show no difference between “%1” and “%2” (ratio %3, 95 % interval: "
                      "%4; %5).")
                .arg(first, second, study_report_words::number(weber.ratio, locale),
                     rangeWords(weber.ratio95, locale), decidingWords(weber, locale));
        return verdict + QLatin1Char(' ') +
               (holdsOne(weber.ratio95)
                    ? whatRemains(weber, locale)
                    : Words::tr("The interval is that of this comparison alone: once p is adjusted for all "
                                "comparisons, the difference is not significant."));
    }
    const bool larger = weber.ratio >= 1.0; // people read "1.4 times" more easily than "0.71 times"
    const psychophysics::Interval interval =
        larger ? weber.ratio95 : psychophysics::Interval{1.0 / weber.ratio95.high, 1.0 / weber.ratio95.low};
    return Words::tr("The Weber fraction of “%1” is %2 times that of “%3” (95 % interval: %4; %5).")
        .arg(larger ? second : first,
             study_report_words::number(larger ? weber.ratio : 1.0 / weber.ratio, locale),
             larger ? first : second, rangeWords(interval, locale), decidingWords(weber, locale));
}

} // namespace

QString intervalOrUnbounded(const psychophysics::Interval& interval, const QString& written) {
    return psychophysics::isUnbounded(interval) ? Words::tr("unbounded in practice (too few participants)")
                                                : written;
}

QString predictionOrUnbounded(const psychophysics::Interval& prediction, const QString& written) {
    return psychophysics::isUnbounded(prediction)
               ? Words::tr("unbounded in practice (participants are too few, or differ too much)")
               : written;
}

QString comparisonVerdict(const session::ComparedConditions& compared, const QString& first,
                          const QString& second, const QLocale& locale) {
    QStringList said{verdictAlone(compared.weber, first, second, locale), testWords(compared.weber, locale),
                     whoIsCompared(compared, first, second)};
    said.removeAll(QString());
    return said.join(QLatin1Char(' '));
}

QString weberOfCondition(const psychophysics::GroupEstimate& group, const QString& name,
                         const QLocale& locale) {
    if (!std::isfinite(group.weber))
        return {};
    const QString value = study_report_words::percent(group.weber, locale);
    const QString interval = intervalOrUnbounded(
        group.weber95, study_report_words::intervalPercent(group.weber95.low, group.weber95.high, locale));
    if (group.participants == 1) // its interval is of one person, not of a group
        return Words::tr("“%1”: Weber fraction %2, of one participant.").arg(name, value);
    return Words::tr("“%1”: Weber fraction %2 (95 % interval: %3), of %4 participants.")
        .arg(name, value, interval, locale.toString(group.participants));
}

std::vector<QString> comparisonHeadings(bool thresholds) {
    std::vector<QString> headings{Words::tr("Conditions"),    Words::tr("Ratio"),
                                  Words::tr("95 % interval"), Words::tr("p"),
                                  Words::tr("p, adjusted"),   Words::tr("Participants")};
    if (thresholds)
        headings.push_back(Words::tr("p, separate thresholds"));
    return headings;
}

std::vector<QString> comparisonRow(const session::ComparedConditions& compared, const QString& first,
                                   const QString& second, bool thresholds, const QLocale& locale) {
    const psychophysics::ConditionComparison& weber = compared.weber;
    std::vector<QString> cells{Words::tr("%1 over %2").arg(second, first),
                               study_report_words::number(weber.ratio, locale),
                               rangeWords(weber.ratio95, locale),
                               pWords(weber.pValue, locale),
                               pWords(weber.pHolm, locale),
                               weber.paired
                                   ? Words::tr("%1 in both").arg(locale.toString(weber.participants))
                                   : Words::tr("two groups: %1 and %2")
                                         .arg(locale.toString(weber.second), locale.toString(weber.first))};
    if (thresholds)
        cells.push_back(pWords(compared.models.pValue, locale));
    return cells;
}

QString comparisonNote(bool thresholds) {
    const QString ratio =
        Words::tr("Ratio of the Weber fractions; 1 means that both are alike. It comes from the "
                  "people who have a value in both conditions if there are at least two of them, "
                  "otherwise from two groups, each with a value in only one condition. Adjusted: "
                  "for this number of comparisons (Holm).");
    if (!thresholds)
        return ratio;
    return ratio + QLatin1Char(' ') +
           Words::tr("Separate thresholds: whether one threshold for each condition describes these "
                     "people's answers better than a common one. This p is given only where the "
                     "same people answered in both and the differences did not depend on the "
                     "answers: after adaptive runs a fitted slope is biased, and p would be too "
                     "small.");
}

QString comparisonSealed() {
    return Words::tr("Conditions are compared once the study is unblinded: looking at the difference while "
                     "data come in would invalidate "
                     "the test.");
}

QString influenceWords(double influence, const QLocale& locale) {
    if (!std::isfinite(influence))
        return {};
    return Words::tr("The answers narrowed the prior to %1 of its width. Near 0 % the answers decide the "
                     "result; near 100 % the prior does.")
        .arg(study_report_words::percent(influence, locale));
}

QString influenceMeaning() {
    return Words::tr("How much of the result comes from the prior: near 0 % the answers decide it, near 100 "
                     "% the prior does.");
}

} // namespace chiron::session_report
