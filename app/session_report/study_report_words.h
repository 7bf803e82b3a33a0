// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QString>
#include <string>
#include <string_view>
#include <vector>

namespace chiron::session_report {

/// Converts stored tokens and SI numbers of a study to the words and units of its printed report.
namespace study_report_words {

QString attribute(psychophysics::Attribute attribute);
QString task(psychophysics::Task task);
QString procedure(std::string_view kind);
QString order(psychophysics::OrderDesign order);
QString state(database::StudyState state);
QString participantState(database::ParticipantState state);
QString runState(database::StudyRunState state);
QString spoiled(const std::string& token); ///< reason why a trial was repeated

/// The codes of participants, one after another.
QString codes(const std::vector<std::string>& list);

/// A number with three significant digits; a dash if it is not finite.
QString number(double value, const QLocale& locale);
QString plainNumber(double value, const QLocale& locale); ///< with the digits of the scale: 4, 4.5
QString percent(double ratio, const QLocale& locale);
QString intervalPercent(double low, double high, const QLocale& locale); ///< a dash if one end is missing
QString value(double si, psychophysics::Attribute attribute, const QLocale& locale);
QString day(const std::string& utc, const QLocale& locale);
/// The text in this language, else in English, else in any language.
QString text(const psychophysics::StudyText& text, const std::string& language);

} // namespace study_report_words

} // namespace chiron::session_report
