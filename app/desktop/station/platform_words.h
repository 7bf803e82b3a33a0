// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/station/platform_check.h"
#include "report/check_record.h"

#include <QLocale>
#include <QString>
#include <QStringList>

namespace chiron::desktop {

/// What a check of the fingertip platform says, on the screen and on paper. Pure.
QString platformVerdict(const PlatformCheck& check, const QLocale& locale);
/// What plant it was: noise, delay, friction; and what follows for a hand.
QStringList platformFacts(const PlatformCheck& check, const QLocale& locale);
/// Ours beside P3's; the first line are the heads.
report::CheckTable platformFigures(const PlatformCheck& check, const QLocale& locale);
/// What the pad of each of the eight fingers got; the first line are the heads.
report::CheckTable platformFingers(const PlatformCheck& check, const QLocale& locale);
/// What the figures do when one thing gets worse; the first line are the heads.
report::CheckTable platformDegradation(const PlatformCheck& check, const QLocale& locale);

} // namespace chiron::desktop
