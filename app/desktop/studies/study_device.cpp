// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_device.h"

#include "devices/driver_catalogue.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {
struct DeviceWords {
    Q_DECLARE_TR_FUNCTIONS(StudyDevice)
};
} // namespace

bool studyDeviceRendersForce() {
    return devices::usualDriver(devices::MovedBy::person).deviceClass == devices::DeviceClass::felt;
}

QString shownOnlyWords() {
    return DeviceWords::tr("The device of this station renders no force: objects are shown, not felt. Such "
                           "runs are left out of groups and comparisons unless you include them under Data.");
}

} // namespace chiron::desktop
