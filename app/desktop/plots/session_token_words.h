// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "database/repositories/session_types.h"
#include "devices/api/device_descriptor.h"

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// Translates stored tokens of sessions into the words of the screen.
/// Thread: GUI.
QString stateTitle(database::SessionState state);
/// An icon (Breeze name) for the state, so that it is not shown by colour alone.
QString stateIcon(database::SessionState state);
/// "Passed", "Not passed", or the state if that says more.
QString outcomeText(const database::SessionSummary& session);
QString outcomeIcon(const database::SessionSummary& session);
/// "Felt" or "Shown, not felt", for a column of its own.
QString feltText(bool felt);
/// "Force felt", "Force shown, not felt", or a text that nobody was there to feel it, for use beside other
/// facts.
QString forceText(const database::SessionSummary& session);
/// The person's name, or "expert (scripted)".
QString whoText(const database::SessionSummary& session);
/// The device that the session was done on.
QString deviceText(const devices::DeviceDescriptor& device);
/// When the session began, in the time zone of the place of recording.
QString whenText(const database::SessionSummary& session, const QLocale& locale);
/// The title in the content's language, or the id if the content no longer contains it.
QString exerciseTitle(const catalogue::Catalogue& catalogue, const std::string& exercise,
                      const QString& language);
QString levelTitle(const catalogue::Catalogue& catalogue, const std::string& exercise, int level,
                   const QString& language);
/// A position in a recording: "1:02.4".
QString clockText(double t_s, const QLocale& locale);

} // namespace chiron::desktop
