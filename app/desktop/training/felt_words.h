// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::desktop::felt_words {

/// The texts of a session that differ between a person who feels the force and one who is only shown it. No
/// other text that people read while they work speaks of feeling: it says what the tool meets, which is true
/// in both cases (experience.md, Force that is shown, not felt).
/// Thread: GUI.

/// Names a device together with what it does with force.
QString device(const QString& name, bool felt);
/// For a level that shows no measurements.
QString noMeasurements(bool felt);
/// How the participant of a study perceives the objects.
QString objects(bool felt);
/// What Space, Esc and R do in a study. Where no force is rendered, Esc stops none.
QString stopKeys(bool felt);
/// What Esc does in a study, for the button that stops the session.
QString stopHint(bool felt);
/// Title of the page that a stop brings, and name of the command.
QString stopped(bool felt);
QString stop(bool felt);
/// Name of the command that goes on after a stop.
QString goOn(bool felt);

} // namespace chiron::desktop::felt_words
