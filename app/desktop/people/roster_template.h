// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QByteArray>
#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// An empty list of people with headings and two example lines in the program's language, as a spreadsheet of that country opens
/// it by a double click: UTF-8 with a mark, CRLF, and the list separator that goes with the decimal sign.
QByteArray rosterTemplate(const QLocale& locale);
core::Result<void> writeRosterTemplate(const QString& file, const QLocale& locale);

} // namespace chiron::desktop
