// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/plots/driver_words.h"

#include <QCoreApplication>
#include <string>

namespace chiron::desktop {

QString driverWords(std::string_view marked) {
    return marked.empty() ? QString() : QCoreApplication::translate("Drivers", std::string(marked).c_str());
}

QString deviceName(const devices::Driver& driver, std::string_view kinematics) { return driverWords(devices::nameOf(driver, kinematics)); }

} // namespace chiron::desktop
