// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "database/repositories/session_types.h"
#include "devices/api/device_descriptor.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// Stored tokens of sessions in the words of the screen. GUI thread.
QString stateTitle(database::SessionState state);
/// A sign for it, so that colour is never alone: a Breeze name.
QString stateIcon(database::SessionState state);
/// Passed, Not passed, or the state where that says more.
QString outcomeText(const database::SessionSummary& session);
QString outcomeIcon(const database::SessionSummary& session);
/// "Felt", "Shown, not felt": in a column of its own.
QString feltText(bool felt);
/// "Force felt", "Force shown, not felt", or that nobody was there to feel it: beside other facts.
QString forceText(const database::SessionSummary& session);
/// Who did it: the person's name, or "expert (scripted)".
QString whoText(const database::SessionSummary& session);
/// What it was done on.
QString deviceText(const devices::DeviceDescriptor& device);
/// When it began, on the clock of the place where it was recorded.
QString whenText(const database::SessionSummary& session, const QLocale& locale);
/// The title in the content's language, or the id where the content no longer has it.
QString exerciseTitle(const catalogue::Catalogue& catalogue, const std::string& exercise, const QString& language);
QString levelTitle(const catalogue::Catalogue& catalogue, const std::string& exercise, int level, const QString& language);
/// Position on a recording: "1:02.4".
QString clockText(double t_s, const QLocale& locale);

} // namespace chiron::desktop
