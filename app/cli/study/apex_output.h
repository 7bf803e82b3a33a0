// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/text_table.h"
#include "database/repositories/study_types.h"
#include "psychophysics/study/apex_study.h"

#include <QJsonObject>

namespace chiron::cli {

/// What marks of an apex say: axes {x, y} with signed bias and sd, the mean absolute error as P2 reports it. While blinded per cent of the
/// radius alone: the millimetres beside it would tell the radius, and the radius the condition.
QJsonObject apexJson(const psychophysics::ApexSummary& summary, bool blinded);
/// error_x_m, error_y_m, error_x_percent, error_y_percent, in_contact, planned; empty where the trial holds no mark. Not while blinded.
QJsonObject apexMarkJson(const database::StudyTrial& trial);

/// What so many participants with so many marks each can show, by the observer for planning: mean absolute error with the half width of its
/// interval, and how often it leaves out the mean of the published earlier device (`against_percent`).
QJsonObject apexPlanJson(int participants, int marksEach, int studies, std::uint64_t seed);

/// One line a run, or group, for people.
TextTable apexTable(bool blinded);
void addApexRow(TextTable& table, const QString& who, const QString& condition, const psychophysics::ApexSummary& summary, bool blinded);

} // namespace chiron::cli
