// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/text_table.h"
#include "database/repositories/study_types.h"
#include "psychophysics/study/apex_study.h"

#include <QJsonObject>

namespace chiron::cli {

/// Summary of the marks of an apex: axes {x, y} with signed bias and standard deviation, and the mean
/// absolute error in the form in which P2 reports it. While the study is blinded, only per cent of the
/// radius: millimetres beside it would reveal the radius, and the radius the condition.
QJsonObject apexJson(const psychophysics::ApexSummary& summary, bool blinded);
/// error_x_m, error_y_m, error_x_percent, error_y_percent, in_contact, planned; empty if the trial holds no
/// mark. Must not be used while the study is blinded.
QJsonObject apexMarkJson(const database::StudyTrial& trial);

/// The precision that a number of participants with a number of marks each can reach, computed with the
/// observer model for planning: mean absolute error with the half width of its interval, and how often that
/// interval excludes the mean of the published earlier device (`against_percent`).
QJsonObject apexPlanJson(int participants, int marksEach, int studies, std::uint64_t seed);

/// A table with one row per run or group.
TextTable apexTable(bool blinded);
void addApexRow(TextTable& table, const QString& who, const QString& condition,
                const psychophysics::ApexSummary& summary, bool blinded);

} // namespace chiron::cli
