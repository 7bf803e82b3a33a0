// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_device.h"

#include "devices/driver_catalogue.h"
#include "session/station.h"
#include "session/study/study_limits.h"

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

StudyDevice studyDevice() {
    StudyDevice device{studyDeviceRendersForce(), {}};
    if (!device.rendersForce)
        return device;
    if (const auto station = session::keyboardMouseStation(); station && !station->tools.empty())
        device.largestForce_N =
            session::renderingLimits(station->tools.front().device->descriptor()).largestForce_N;
    return device;
}

QString shownOnlyWords() {
    return DeviceWords::tr("The device of this station renders no force: objects are shown, not felt. Such "
                           "runs are left out of groups and comparisons unless you include them under Data.");
}

} // namespace chiron::desktop
