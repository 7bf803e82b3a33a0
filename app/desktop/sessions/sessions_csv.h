// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sessions/session_row.h"

#include <QByteArray>

namespace chiron::desktop {

/// The rows as comma-separated values (RFC 4180, UTF-8) with stored tokens and plain numbers, independent of
/// the displayed language.
QByteArray sessionsCsv(const std::vector<SessionRow>& rows);

/// Writes the file and replaces an existing one only when all of it is written.
/// Thread: any; blocks.
/// Errors: storage.
core::Result<void> writeSessionsCsv(const std::vector<SessionRow>& rows, const QString& file);

} // namespace chiron::desktop
