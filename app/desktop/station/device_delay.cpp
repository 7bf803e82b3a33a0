// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/station/device_delay.h"

#include "desktop/frame/settings.h"

namespace chiron::desktop {

namespace {

constexpr qint64 kStation = 0; // stands for the station, because people are numbered from 1

QString delayKey(const devices::DeviceDescriptor& device) {
    return QStringLiteral("delay_s_%1_%2")
        .arg(QString::fromStdString(device.driver), QString::fromStdString(device.model))
        .replace(QLatin1Char('/'), QLatin1Char('_'));
}

} // namespace

std::optional<double> measuredDelay_s(const Settings& settings, const devices::DeviceDescriptor& device) {
    bool known = false;
    const double delay_s = settings.ofPerson(kStation, delayKey(device), {}).toDouble(&known);
    return known && delay_s > 0.0 ? std::optional(delay_s) : std::nullopt;
}

void setMeasuredDelay_s(Settings& settings, const devices::DeviceDescriptor& device, double delay_s) {
    settings.setOfPerson(kStation, delayKey(device), delay_s);
}

} // namespace chiron::desktop
