// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tool_state.h"
#include "devices/driver_catalogue.h"
#include "devices/kinematics_catalogue.h"
#include "mechanisms/fingertip_arm_parameters.h"
#include "mechanisms/five_bar_plant_parameters.h"
#include "mechanisms/gimbal_plant_parameters.h"
#include "support/driver_request.h"

#include <QtTest>
#include <any>
#include <cmath>
#include <set>
#include <utility>
#include <variant>
#include <vector>

using namespace chiron;

namespace {
QString text(std::string_view view) {
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

/// A request that none can serve: no such scale, no such mechanism, nobody and nothing that moves the tool.
devices::DriverRequest wrongRequest() {
    devices::DriverRequest request;
    request.scale = 0.0;
    request.mechanism = "hexapod";
    request.tools.emplace_back();
    return request;
}

void isValid(const devices::DeviceDescriptor& descriptor) {
    QVERIFY(!descriptor.model.empty());
    QVERIFY(!descriptor.axes.empty() && descriptor.axes.size() <= std::size_t(core::kMaxCoordinates));
    std::set<std::string> ids;
    for (const devices::AxisDescriptor& axis : descriptor.axes) {
        QVERIFY2(ids.insert(axis.id).second, axis.id.c_str());
        QVERIFY2(axis.resolution > 0.0 && axis.minimum <= axis.maximum, axis.id.c_str());
        QVERIFY2(axis.continuousRating >= 0.0 && axis.coulombFriction >= 0.0 && axis.viscousFriction >= 0.0,
                 axis.id.c_str());
    }
    QVERIFY(descriptor.period_us > 0);
    QVERIFY(std::isfinite(descriptor.maximumDamping_Ns_per_m) && descriptor.maximumDamping_Ns_per_m > 0.0);
    QVERIFY(descriptor.frictionCompensation >= 0.0 &&
            descriptor.frictionCompensation <= devices::kMostFrictionCompensation);
    if (!descriptor.rendersForce)
        QVERIFY(descriptor.maximumForce_N == 0.0 && descriptor.maximumTorque_Nm == 0.0);
}
} // namespace

/// What every registered driver has to keep. A new driver is asked by its line in the catalogue alone.
class TestEveryDriver : public QObject {
    Q_OBJECT

    static void eachDriver() {
        QTest::addColumn<QString>("id");
        for (const devices::Driver* driver : devices::driverCatalogue())
            QTest::newRow(std::string(driver->id).c_str()) << text(driver->id);
    }
    static const devices::Driver& current() {
        QFETCH(QString, id);
        return *devices::findDriver(id.toStdString());
    }

private slots:
    void idsAndWordsAreUnique() {
        std::set<std::string_view> ids;
        std::set<std::string_view> words;
        for (const devices::Driver* driver : devices::driverCatalogue()) {
            QVERIFY(!driver->id.empty() && !driver->title.empty() && !driver->needs.empty() &&
                    !driver->planWord.empty());
            QVERIFY(ids.insert(driver->id).second && words.insert(driver->planWord).second);
            QCOMPARE(devices::findDriver(driver->id), driver);
            QCOMPARE(devices::findDriverOfPlan(driver->planWord), driver);
        }
        QVERIFY(!devices::findDriver("lathe") && !devices::findDriverOfPlan("lathe"));
    }

    /// Stored plans and the output of the command line name drivers so: neither may change.
    void storedWordsAndOrderAreKept() {
        QStringList all;
        for (const devices::Driver* driver : devices::driverCatalogue())
            all << text(driver->id) + '=' + text(driver->planWord);
        QCOMPARE(all.mid(0, 3),
                 QStringList({"simulated=demonstration", "keyboard_mouse=mouse", "replay=trace"}));
    }

    /// So that no screen falls back to words of the command line for a device that we ship.
    void shippedOnesHaveWordsForPeople_data() { eachDriver(); }
    void shippedOnesHaveWordsForPeople() {
        const devices::Driver& driver = current();
        QVERIFY(!driver.name.empty() && !driver.readiness.empty());
        QCOMPARE(devices::nameOf(driver, "no such kinematics"), driver.name);
    }

    void mechanismsHaveNamesOfTheirOwn() {
        const devices::Driver& mechanisms = *devices::findDriver("simulated");
        std::set<std::string_view> names;
        for (const devices::KinematicsEntry& kinematics : mechanisms.kinematics)
            QVERIFY(!kinematics.name.empty() &&
                    names.insert(devices::nameOf(mechanisms, kinematics.id)).second);
    }

    void thereIsAUsualOneForEachMover() {
        for (const devices::MovedBy mover :
             {devices::MovedBy::person, devices::MovedBy::scriptedOperator, devices::MovedBy::recording})
            QVERIFY(devices::usualDriver(mover).movedBy == mover);
    }

    /// A mechanism that can convert force in several ways names each, and makes a device that says which one
    /// it uses.
    void everyForceMapCanBeChosen() {
        int choices = 0;
        for (const devices::Driver* driver : devices::driverCatalogue())
            for (const devices::KinematicsEntry& kinematics : driver->kinematics) {
                QVERIFY(devices::hasForceMap(&kinematics, {}));
                QVERIFY(devices::hasForceMap(&kinematics, devices::kExactForceMap));
                QVERIFY(!devices::hasForceMap(&kinematics, "by-feel"));
                if (kinematics.forceMaps == nullptr)
                    continue;
                const devices::ForceMaps& choice = *kinematics.forceMaps;
                QVERIFY(!choice.title.empty() && choice.maps.size() > 1);
                QCOMPARE(text(choice.maps.front().id), text(devices::kExactForceMap));
                std::set<std::string_view> ids;
                for (const devices::ForceMap& map : choice.maps) {
                    QVERIFY(!map.name.empty() && ids.insert(map.id).second);
                    QVERIFY(devices::hasForceMap(&kinematics, map.id));
                    devices::DriverRequest request = tests::requestForAnyDriver(kinematics.id);
                    request.forceMap = std::string(map.id);
                    const auto made = driver->open(std::move(request));
                    QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
                    QCOMPARE(text(choice.of(made->front().device->descriptor())), text(map.id));
                    ++choices;
                }
                devices::DriverRequest unknown = tests::requestForAnyDriver(kinematics.id);
                unknown.forceMap = "by-feel";
                QVERIFY(!driver->open(std::move(unknown)));
            }
        QVERIFY(choices >= 2);
    }

    void discoveryNeedsNoHardware_data() { eachDriver(); }
    void discoveryNeedsNoHardware() {
        for (const devices::FoundDevice& found : current().discover())
            QVERIFY(!found.model.empty());
    }

    /// What is felt, limits and damping come from the descriptor, and the catalogue says the same.
    void itsDevicesAreAsItSays_data() { eachDriver(); }
    void itsDevicesAreAsItSays() {
        const devices::Driver& driver = current();
        QVERIFY(!driver.kinematics.empty());
        for (const devices::KinematicsEntry& kinematics : driver.kinematics) {
            auto made = driver.open(tests::requestForAnyDriver(kinematics.id));
            QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
            QCOMPARE(made->size(), std::size_t(1));
            devices::IDevice& device = *made->front().device;
            const devices::DeviceDescriptor& descriptor = device.descriptor();
            QCOMPARE(text(descriptor.driver), text(driver.id));
            QVERIFY(descriptor.deviceClass() == driver.deviceClass);
            // Whoever moves the tools with mouse and keyboard reads how; whoever holds a handle reads that.
            QCOMPARE(!std::holds_alternative<std::monostate>(made->front().input),
                     driver.movedBy == devices::MovedBy::person &&
                         driver.hand == devices::HandKind::mouseAndKeyboard);
            isValid(descriptor);
            QVERIFY(devices::makeKinematics(descriptor).has_value());
            const auto opened = device.open();
            if (driver.discover().empty()) // real hardware that is not here
                QVERIFY(opened ||
                        (opened.error().code == core::ErrorCode::device && !opened.error().message.empty()));
            else
                QVERIFY2(opened.has_value(), opened ? "" : opened.error().message.c_str());
            QVERIFY(!device.finished());
            device.close();
        }
    }

    /// A request may say what a simulated mechanism is truly like: each takes its own parameters, and none
    /// those of another.
    void mechanismsTakeTheirOwnParameters() {
        mechanisms::GimbalPlantParameters gimbal;
        gimbal.resolution[0] = 1e-3;
        mechanisms::FiveBarPlantParameters fiveBar;
        fiveBar.resolution[0] = 2e-3;
        mechanisms::FingertipArmParameters arm;
        arm.encoderBits = 12;
        const std::vector<std::pair<std::string, std::any>> all{
            {"gimbal_hprd", gimbal}, {"five_bar_spherical", fiveBar}, {"fingertip_arm", arm}};
        const std::vector<double> resolutions{1e-3, 2e-3, arm.encoderResolution_rad()};
        const devices::Driver& driver = *devices::findDriver("simulated");
        QCOMPARE(driver.kinematics.size(), all.size()); // a mechanism more is asked here, too
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (std::size_t of = 0; of < all.size(); ++of) {
                devices::DriverRequest request = tests::requestForAnyDriver(all[i].first);
                request.plant = all[of].second;
                const auto made = driver.open(std::move(request));
                if (of == i) {
                    QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
                    QCOMPARE(made->front().device->descriptor().axes[0].resolution, resolutions[i]);
                } else {
                    QVERIFY(!made && made.error().code == core::ErrorCode::wrongUse);
                    QVERIFY2(made.error().message.find(all[i].first) != std::string::npos,
                             made.error().message.c_str());
                }
            }
            const auto usual = driver.open(tests::requestForAnyDriver(all[i].first));
            QVERIFY(usual.has_value());
            QVERIFY(usual->front().device->descriptor().axes[0].resolution != resolutions[i]);
        }
    }

    void aWrongChoiceSaysWhy_data() { eachDriver(); }
    void aWrongChoiceSaysWhy() {
        const auto refused = current().open(wrongRequest());
        QVERIFY(!refused);
        QVERIFY(!refused.error().message.empty());
        QVERIFY(refused.error().code == core::ErrorCode::badInput ||
                refused.error().code == core::ErrorCode::wrongUse);
    }
};

QTEST_APPLESS_MAIN(TestEveryDriver)
#include "test_every_driver.moc"
