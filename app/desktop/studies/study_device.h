// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>

namespace chiron::desktop {

/// Whether the device with which this station runs studies (session::keyboardMouseStation) renders force.
bool studyDeviceRendersForce();

/// What that device does to a hand.
struct StudyDevice {
    bool rendersForce = false;
    std::optional<double> largestForce_N{}; ///< empty: none, or the device cannot be asked now
};
StudyDevice studyDevice();

/// What follows for the results of a study if it does not.
QString shownOnlyWords();

} // namespace chiron::desktop
