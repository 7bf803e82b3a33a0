// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/session_view.h"

#include <QJsonObject>
#include <QString>

namespace chiron::session {

/// Writes a session's raw samples as a trace file (cli.md, Trace files): every executed tick, with trial,
/// phase, pause, commanded and measured force, the scene's quantities and the truth. `metrics` on this file
/// gives the session's own scores. Replaces `path` only once the whole file is written.
/// Errors: storage; those of the reader.
core::Result<void> exportCsv(SessionView& session, const QString& path);

/// Writes everything stored about a session except its samples (setup, states, trials, events, scores) as one
/// JSON document.
core::Result<void> exportJson(SessionView& session, const QJsonObject& summary, const QString& path);

} // namespace chiron::session
