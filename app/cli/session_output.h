// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/score_output.h"
#include "session/training_run.h"

#include <QJsonObject>
#include <QString>
#include <string_view>

namespace chiron::cli {

/// A stored session with its latest scores, as `session show` and `train` print it.
/// Errors: those of the reader.
core::Result<ScoreView> viewOf(database::Connection& connection, const database::Actor& actor,
                               database::SessionId session);

/// The document of `session show`: the view and the other stored facts about the session.
QJsonObject sessionJson(const ScoreView& view, const database::SessionRecord& record);

/// The events of a session: [{tick, time_s, tool, kind, detail}]. Events of tissue that gave way also have
/// `gave_way_to` {quantity, value, unit}, the force or the torque that made it give way.
/// Errors: those of the reader.
core::Result<QJsonArray> eventsJson(database::Connection& connection, const database::Actor& actor,
                                    const database::SessionRecord& record);

/// The events of tissue that gave way: [{trial, tool, time_s, gave_way_to, position_m}], the position of the
/// tool's tip in W where it is stored. Trials count from 1, tools from 0.
QJsonArray yieldsOf(const QJsonArray& events);
/// The same as text in the words of the exercise (an id), one line per event, with tools counted from 1;
/// empty if nothing gave way.
QString yieldsText(const QJsonArray& yields, std::string_view exercise);
/// Decisions about the session, including those taken back since, one per line; empty if there are none.
QString decisionsText(const std::vector<database::SessionDecision>& decisions);

/// One line of a list of sessions.
QJsonObject summaryJson(const database::SessionSummary& summary);

/// Prints a progress line to stderr.
void tell(const QString& line);

} // namespace chiron::cli
