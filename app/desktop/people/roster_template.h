// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// An empty list of people with headings and two example lines in the program's language. It is encoded so
/// that a spreadsheet of that country opens it by a double click: UTF-8 with a byte order mark, CRLF, and the
/// list separator that goes with the decimal sign.
QByteArray rosterTemplate(const QLocale& locale);
core::Result<void> writeRosterTemplate(const QString& file, const QLocale& locale);

} // namespace chiron::desktop
