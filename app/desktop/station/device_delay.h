// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device_descriptor.h"

#include <optional>

namespace chiron::desktop {

class Settings;

/// The delay of a kind of device, s, as it was measured on this station; nothing where it never was. Belongs to the station, not to a person.
std::optional<double> measuredDelay_s(const Settings& settings, const devices::DeviceDescriptor& device);
void setMeasuredDelay_s(Settings& settings, const devices::DeviceDescriptor& device, double delay_s);

} // namespace chiron::desktop
