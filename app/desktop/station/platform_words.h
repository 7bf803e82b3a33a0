// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/station/platform_check.h"
#include "report/check_record.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace chiron::desktop {

/// The result of a check of the fingertip platform in words, for the screen and on paper. Pure.
QString platformVerdict(const PlatformCheck& check, const QLocale& locale);
/// Describes the plant (noise, delay, friction) and the consequences for touch.
QStringList platformFacts(const PlatformCheck& check, const QLocale& locale);
/// Chiron's figures beside P3's; the first line contains the headings.
report::CheckTable platformFigures(const PlatformCheck& check, const QLocale& locale);
/// The true force on the pad of each of the eight fingers; the first line contains the headings.
report::CheckTable platformFingers(const PlatformCheck& check, const QLocale& locale);
/// The figures with one degraded part at a time; the first line contains the headings.
report::CheckTable platformDegradation(const PlatformCheck& check, const QLocale& locale);

} // namespace chiron::desktop
