// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QString>
#include <QStringList>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::desktop {

/// Stored tokens and SI numbers of studies as texts in the words and units of the screen, translated at each
/// call.
/// Thread: GUI.
namespace study_words {

QString attribute(psychophysics::Attribute attribute);
QString task(psychophysics::Task task);
/// The participant's task in one sentence, for the researcher.
QString taskInWords(psychophysics::Task task);
/// Other words by which people look for a study of this attribute or task, separated by spaces or commas.
QString otherNames(psychophysics::Attribute attribute);
QString otherNames(psychophysics::Task task);
/// The same for the number of its conditions, and of the attributes in which they differ.
QString otherNames(const std::vector<psychophysics::Condition>& conditions);
/// The question to a participant, without a value or the name of a condition.
QString question(psychophysics::Task task, psychophysics::Attribute attribute);
/// A participant's answer in their words ("2 is heavier"; a ranking from least to most), as
/// psychophysics::answers counts them; `value`: a stated number. Empty if it is no answer of the task.
QString answer(psychophysics::Task task, psychophysics::Attribute attribute, int answer,
               std::optional<double> value, const QLocale& locale);
/// The name of a procedure by kind ("staircase") or by id with version ("staircase@1"); several are separated
/// by commas.
QString procedure(std::string_view id);
QString procedureInWords(std::string_view kind);
QString scale(psychophysics::ProcedureScale scale);
QString order(psychophysics::OrderDesign order);
QString state(database::StudyState state);
/// The name of a study in a selection list. It includes the key, because titles may be alike.
QString studyName(const database::StudySummary& study);
QString participantState(database::ParticipantState state);
QString runState(database::StudyRunState state);
/// The reason why a trial did not count ("force_error"); several are separated by commas.
QString spoiled(std::string_view token);
QString parameter(const std::string& name); ///< of a procedure's estimate

/// The display unit of an attribute: shown = SI · factor.
struct Unit {
    double factor = 1.0;
    QString text;
};
Unit unitOf(psychophysics::Attribute attribute);
inline constexpr int kUsualDigits = 3; ///< significant ones
/// A value in SI with its unit, to three significant digits.
QString value(double si, psychophysics::Attribute attribute, const QLocale& locale);
/// Values that stand beside each other, to as many digits as make neighbours that differ read differently,
/// and at least to three.
QStringList values(const std::vector<double>& si, psychophysics::Attribute attribute, const QLocale& locale);
/// A number with `digits` significant digits; a dash if it is not a number.
QString number(double value, const QLocale& locale, int digits = kUsualDigits);
/// The fewest digits, from `fewest` on, with which neighbours that differ are written differently. `written`
/// writes a number with so many digits.
int digitsThatDiffer(const std::vector<double>& numbers, int fewest,
                     const std::function<QString(double, int)>& written);
/// "0.812 ± 0.024": a number and its error, written to the same decimal place.
QString withError(double value, double error, const QLocale& locale);
QString plainNumber(double value, const QLocale& locale); ///< as people write it: 4, 3.5
/// A ratio in per cent ("12.5 %"); a dash if it is not a number.
QString percent(double ratio, const QLocale& locale);
/// Ratios that stand beside each other, with digits like values().
QStringList percents(const std::vector<double>& ratios, const QLocale& locale);
/// "0.081 … 0.12" from two numbers, with digits like values(); empty if one is missing.
QString interval(double low, double high, const QLocale& locale);
QString intervalPercent(double low, double high, const QLocale& locale);
/// Converts D (log10 of a ratio) into a relative difference of the value: 10^D − 1.
double ratioOf(double difference);
double differenceOf(double ratio);

/// The text in this language, else in English, else in any language.
QString text(const psychophysics::StudyText& text, const QString& language);
/// The language of the text that text() shows, for example "de"; empty if there is none.
std::string shownLanguage(const psychophysics::StudyText& text, const QString& language);
/// The first twelve digits of a SHA-256.
QString shortSha(const std::string& sha256);
/// A stored UTC time in the locale's short form.
QString moment(const std::string& utc, const QLocale& locale);

} // namespace study_words

} // namespace chiron::desktop
