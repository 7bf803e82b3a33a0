// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/score_output.h"
#include "session/training_run.h"

#include <QJsonObject>
#include <QString>

namespace chiron::cli {

/// A stored session with its latest scores, as `session show` and `train` print it. Failure: the reader's.
core::Result<ScoreView> viewOf(database::Connection& connection, const database::Actor& actor,
                               database::SessionId session);

/// `session show`'s document: the view and what is known of the session beside it.
QJsonObject sessionJson(const ScoreView& view, const database::SessionRecord& record);

/// What happened in a session: [{tick, time_s, tool, kind, detail}], and of tissue that gave way `gave_way_to` {quantity, value, unit}: the
/// force or the torque that was its reason. Failure: the reader's.
core::Result<QJsonArray> eventsJson(database::Connection& connection, const database::Actor& actor, const database::SessionRecord& record);

/// Of these events where tissue gave way: [{trial, tool, time_s, gave_way_to}]; trials from 1, tools from 0.
QJsonArray yieldsOf(const QJsonArray& events);
/// The same for people, a line each, tools from 1; empty where nothing gave way.
QString yieldsText(const QJsonArray& yields);
/// What was decided about the session and taken back since, a line each; empty: nothing.
QString decisionsText(const std::vector<database::SessionDecision>& decisions);

/// One line of a list of sessions.
QJsonObject summaryJson(const database::SessionSummary& summary);

/// A progress line for people, to stderr.
void tell(const QString& line);

} // namespace chiron::cli
