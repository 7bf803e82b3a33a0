// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QString>
#include <string>
#include <string_view>

namespace chiron::desktop {

/// Stored tokens and SI numbers of studies in the words and units of the screen. Translated when asked; GUI thread.
namespace study_words {

QString attribute(psychophysics::Attribute attribute);
QString task(psychophysics::Task task);
/// What a participant does, in a sentence for the researcher.
QString taskInWords(psychophysics::Task task);
/// What a participant is asked, without a value or a condition's name.
QString question(psychophysics::Task task, psychophysics::Attribute attribute);
/// By kind ("staircase") or id with version ("staircase@1"), several separated by commas.
QString procedure(std::string_view id);
QString procedureInWords(std::string_view kind);
QString scale(psychophysics::ProcedureScale scale);
QString order(psychophysics::OrderDesign order);
QString state(database::StudyState state);
/// What a study goes by in a list to choose from: titles may be alike, keys are not.
QString studyName(const database::StudySummary& study);
QString participantState(database::ParticipantState state);
QString runState(database::StudyRunState state);
/// Why a trial did not count ("force_error"); several separated by commas.
QString spoiled(std::string_view token);
QString parameter(const std::string& name); ///< of a procedure's estimate

/// What numbers of an attribute are shown in: shown = SI · factor.
struct Unit {
    double factor = 1.0;
    QString text;
};
Unit unitOf(psychophysics::Attribute attribute);
/// A value in SI with its unit, in three digits.
QString value(double si, psychophysics::Attribute attribute, const QLocale& locale);
/// A number in `digits` significant digits; a dash where it is not a number.
QString number(double value, const QLocale& locale, int digits = 3);
QString plainNumber(double value, const QLocale& locale); ///< as somebody would write it: 4, 3.5
/// A ratio in percent ("12.5 %"); a dash where it is not a number.
QString percent(double ratio, const QLocale& locale);
/// "0.081 … 0.12" of two numbers; empty where one is missing.
QString interval(double low, double high, const QLocale& locale);
QString intervalPercent(double low, double high, const QLocale& locale);
/// D (log10 of a ratio) as a difference of the value: 10^D − 1.
double ratioOf(double difference);
double differenceOf(double ratio);

/// The text in this language, else in English, else in any.
QString text(const psychophysics::StudyText& text, const QString& language);
/// Which of them text() then shows: "de"; empty where there is none.
std::string shownLanguage(const psychophysics::StudyText& text, const QString& language);
/// The first twelve digits of a SHA-256.
QString shortSha(const std::string& sha256);
/// A stored UTC moment in the locale's short form.
QString moment(const std::string& utc, const QLocale& locale);

} // namespace study_words

} // namespace chiron::desktop
