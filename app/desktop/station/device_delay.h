// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/device_descriptor.h"

#include <optional>

namespace chiron::desktop {

class Settings;

/// The delay of a device model as measured on this station; empty if it was never measured. It is stored for
/// the station, not for a person.
/// Unit: s.
std::optional<double> measuredDelay_s(const Settings& settings, const devices::DeviceDescriptor& device);
void setMeasuredDelay_s(Settings& settings, const devices::DeviceDescriptor& device, double delay_s);

} // namespace chiron::desktop
