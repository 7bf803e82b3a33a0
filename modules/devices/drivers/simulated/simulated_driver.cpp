// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/simulated/simulated_driver.h"

#include "core/marked_texts.h"
#include "core/random.h"
#include "devices/drivers/simulated/fingertip_arm_kinematics.h"
#include "devices/drivers/simulated/fingertip_sliding_kinematics.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "devices/drivers/simulated/simulated_fingertip_device.h"
#include "devices/drivers/simulated/simulated_second_finger.h"

#include <algorithm>
#include <any>
#include <array>
#include <iterator>

namespace chiron::devices {

namespace {
using Tools = core::Result<std::vector<DriverTool>>;

/// Each hand has a tremor of its own; the first hand has that of a single hand.
std::uint64_t seedOfHand(std::uint64_t seed, std::size_t hand) {
    return hand == 0 ? seed : core::Random::mix(seed, "hand " + std::to_string(hand));
}

/// Takes the true parameters of the request, if it has any.
/// Errors: wrongUse if they are those of another mechanism.
template <class Plant> core::Result<void> takePlant(const DriverRequest& request, Plant& plant) {
    if (!request.plant.has_value())
        return {};
    const Plant* given = std::any_cast<Plant>(&request.plant);
    if (!given)
        return core::fail(core::ErrorCode::wrongUse, "simulated mechanism \"" + request.mechanism +
                                                         "\": parameters of another mechanism were given");
    plant = *given;
    return {};
}

constexpr ForceMap kGimbalMaps[]{
    {kExactForceMap, QT_TRANSLATE_NOOP("Drivers", "Exactly")},
    {"as-published", QT_TRANSLATE_NOOP("Drivers", "By the published formulas (error up to 27 %)")},
};
constexpr std::array kPolarMaps{mechanisms::PolarMap::exact, mechanisms::PolarMap::asPublished};
static_assert(kPolarMaps.size() == std::size(kGimbalMaps), "one map for each id, in the same order");

/// The gimbal's map with this id; an empty id gives the usual one.
/// Errors: wrongUse if there is none.
core::Result<mechanisms::PolarMap> polarMapOf(const std::string& id) {
    if (id.empty())
        return kPolarMaps.front();
    for (std::size_t i = 0; i < kPolarMaps.size(); ++i)
        if (kGimbalMaps[i].id == id)
            return kPolarMaps[i];
    return core::fail(core::ErrorCode::wrongUse, "simulated gimbal: no force map \"" + id + "\"");
}

std::string_view gimbalMapOf(const DeviceDescriptor& descriptor) {
    const auto map = std::find(kPolarMaps.begin(), kPolarMaps.end(), GimbalHprdKinematics::mapOf(descriptor));
    return kGimbalMaps[map - kPolarMaps.begin()].id;
}

/// Makes one device for each hand.
template <class Device>
Tools makeDevices(const typename Device::Configuration& usual, DriverRequest& request) {
    std::vector<DriverTool> made;
    for (std::size_t i = 0; i < request.tools.size(); ++i) {
        typename Device::Configuration configuration = usual;
        configuration.seed = seedOfHand(request.seed, i);
        configuration.hand = request.hand;
        configuration.mapping = request.tools[i].mapping;
        auto device = Device::create(configuration, std::move(request.tools[i].strategy));
        CHIRON_TRY(device);
        IDrivenAxes* const axes = device->get();
        made.push_back({.device = std::move(*device), .axes = axes});
    }
    return made;
}

Tools makeGimbals(DriverRequest& request) {
    SimulatedDevice::Configuration configuration;
    CHIRON_TRY(takePlant(request, configuration.plant));
    const auto map = polarMapOf(request.forceMap);
    CHIRON_TRY(map);
    configuration.map = *map;
    configuration.frictionCompensation = request.frictionCompensation;
    if (request.shape == ToolShape::grasper)
        configuration.jaw = mechanisms::JawParameters{};
    return makeDevices<SimulatedDevice>(configuration, request);
}

Tools makeFiveBars(DriverRequest& request) {
    SimulatedEndoscopeDevice::Configuration configuration;
    CHIRON_TRY(takePlant(request, configuration.plant));
    configuration.start_D = request.endoscopeStart_W; // D equals W unless stated otherwise
    return makeDevices<SimulatedEndoscopeDevice>(configuration, request);
}

/// Makes one arm for each hand; further fingers of a hand are tools on the first finger's arm.
Tools makeFingers(DriverRequest& request) {
    mechanisms::FingertipArmParameters arm;
    CHIRON_TRY(takePlant(request, arm));
    std::vector<DriverTool> made;
    const SimulatedFingertipDevice* hand = nullptr;
    for (std::size_t i = 0; i < request.tools.size(); ++i) {
        const int finger = static_cast<int>(i) % std::max(request.fingersPerHand, 1);
        const std::uint64_t seed = seedOfHand(request.seed, i);
        if (finger > 0) {
            auto device = SimulatedSecondFinger::create(*hand, {finger * request.fingerSpacing_m, 0.0, 0.0},
                                                        seed, std::move(request.tools[i].strategy));
            CHIRON_TRY(device);
            made.push_back({std::move(*device), {}, i - static_cast<std::size_t>(finger)});
            continue;
        }
        SimulatedFingertipDevice::Configuration configuration;
        configuration.arm = arm;
        configuration.seed = seed;
        configuration.hand = request.hand;
        configuration.mapping = request.tools[i].mapping;
        auto device = SimulatedFingertipDevice::create(configuration, std::move(request.tools[i].strategy));
        CHIRON_TRY(device);
        hand = device->get();
        IDrivenAxes* const axes = device->get();
        made.push_back({.device = std::move(*device), .axes = axes});
    }
    return made;
}

Tools openMechanisms(DriverRequest request) {
    if (request.mechanism == FiveBarSphericalKinematics::kId)
        return makeFiveBars(request);
    if (request.mechanism == GimbalHprdKinematics::kId)
        return makeGimbals(request);
    if (request.mechanism == FingertipArmKinematics::kId)
        return makeFingers(request);
    return core::fail(core::ErrorCode::wrongUse, "no simulated mechanism \"" + request.mechanism + "\"");
}

std::vector<FoundDevice> discoverMechanisms() {
    return {{"simulated mechanism", {}}};
}

core::Result<std::unique_ptr<IToolKinematics>> makeArm(const DeviceDescriptor& descriptor) {
    // Sessions of models id 1 and 2 have an arm of three sliding axes under the same id.
    const bool slides = !descriptor.axes.empty() && descriptor.axes.front().unit == AxisUnit::metre;
    return slides ? makeKinematicsOf<FingertipSlidingKinematics>(descriptor)
                  : makeKinematicsOf<FingertipArmKinematics>(descriptor);
}

constexpr ForceMaps kGimbalForceMaps{QT_TRANSLATE_NOOP("Drivers", "How the gimbal renders force"),
                                     kGimbalMaps, gimbalMapOf};

constexpr KinematicsEntry kMechanismKinematics[]{
    {GimbalHprdKinematics::kId, makeKinematicsOf<GimbalHprdKinematics>,
     QT_TRANSLATE_NOOP("Drivers", "Simulated gimbal"), &kGimbalForceMaps},
    {FiveBarSphericalKinematics::kId, makeKinematicsOf<FiveBarSphericalKinematics>,
     QT_TRANSLATE_NOOP("Drivers", "Simulated five-bar mechanism")},
    {FingertipArmKinematics::kId, makeArm,
     QT_TRANSLATE_NOOP("Drivers", "Simulated arm with fingertip platform")},
};
} // namespace

const Driver kSimulatedDriver{
    .id = "simulated",
    .title = "Simulated mechanism with a scripted hand",
    .needs = "nothing",
    .planWord = "demonstration",
    .deviceClass = DeviceClass::felt,
    .movedBy = MovedBy::scriptedOperator,
    .kinematics = kMechanismKinematics,
    .discover = discoverMechanisms,
    .open = openMechanisms,
    .name = QT_TRANSLATE_NOOP("Drivers", "Simulated mechanism with a scripted hand"),
    .readiness = QT_TRANSLATE_NOOP("Drivers", "Ready. Nothing needs to be connected."),
};

} // namespace chiron::devices
