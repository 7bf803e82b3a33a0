// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace chiron::desktop {

/// Whether the device with which this station runs studies (session::keyboardMouseStation) renders force.
bool studyDeviceRendersForce();

/// What follows for the results of a study if it does not.
QString shownOnlyWords();

} // namespace chiron::desktop
