// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sessions/session_row.h"

#include <QByteArray>

namespace chiron::desktop {

/// The lines as comma-separated values (RFC 4180, UTF-8) with stored words and plain numbers, whatever the language shown.
QByteArray sessionsCsv(const std::vector<SessionRow>& rows);

/// Writes it, in the place of what is there only when all of it is written. Blocking. Failure: storage.
core::Result<void> writeSessionsCsv(const std::vector<SessionRow>& rows, const QString& file);

} // namespace chiron::desktop
