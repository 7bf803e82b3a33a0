// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/station/emulated_station.h"

#include "devices/driver_catalogue.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

namespace chiron::station {

namespace {

constexpr const char* kFirmware = "chiron-station";
constexpr std::uint16_t kSupply_mV = 24'000;
constexpr double kMicro = 1e-6;

/// Copies a text into a page's field, cut to its room.
template <std::size_t Room> void copyText(char (&field)[Room], const std::string& text) {
    std::memset(field, 0, Room);
    std::memcpy(field, text.data(), std::min(text.size(), Room - 1));
}

/// Names a mechanism in the room that its page has: without what stands in brackets, and cut after a word.
/// That it is no real one is said by serial number and firmware.
std::string shortModel(const std::string& model) {
    constexpr std::string_view kSimulated = "Simulated ";
    std::string name = model.substr(0, model.find(" ("));
    if (name.starts_with(kSimulated))
        name = name.substr(kSimulated.size());
    if (!name.empty())
        name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
    constexpr std::size_t kRoom = sizeof(station_names::model) - 1;
    if (name.size() > kRoom)
        name = name.substr(0, name.rfind(' ', kRoom));
    return name;
}

core::Result<std::unique_ptr<station_device_config>> describe(const devices::DeviceDescriptor& d,
                                                              const EmulatedStation::Configuration& as) {
    auto config = std::make_unique<station_device_config>();
    station_identity& identity = config->identity;
    identity.axes = static_cast<std::uint8_t>(d.axes.size());
    const bool motors = std::any_of(d.axes.begin(), d.axes.end(), [](const devices::AxisDescriptor& axis) {
        return axis.continuousRating > 0.0;
    });
    identity.bits = static_cast<std::uint8_t>(
        (d.rendersForce ? STATION_RENDERS_FORCE : 0u) | (d.measuresForce ? STATION_MEASURES_FORCE : 0u) |
        (d.rendersForce && !motors ? STATION_HAS_PLATFORM : 0u) |
        (d.jawResolution_rad > 0.0 ? STATION_HAS_JAW : 0u) | (as.lockstep ? STATION_OFFERS_LOCKSTEP : 0u));
    identity.period_us = d.period_us;
    identity.oldest_sample_us = d.oldestSample_us;
    identity.max_force_N = static_cast<float>(d.maximumForce_N);
    identity.max_torque_Nm = static_cast<float>(d.maximumTorque_Nm);
    identity.max_damping_Ns_per_m = static_cast<float>(d.maximumDamping_Ns_per_m);
    identity.jaw_count_rad = d.jawResolution_rad;
    identity.parameters = static_cast<std::uint8_t>(d.kinematicsParameters.size());
    copyText(config->names.model, shortModel(d.model));
    copyText(config->names.serial_number, as.serialNumber);
    copyText(config->kinematics.id, d.kinematics);
    copyText(config->kinematics.firmware, kFirmware);
    if (d.axes.size() > STATION_AXES || d.kinematicsParameters.size() > STATION_MOST_PARAMETERS)
        return core::fail(core::ErrorCode::wrongUse,
                          "mechanism " + d.kinematics + ": more axes or parameters than a station can state");
    for (std::size_t i = 0; i < d.axes.size(); ++i) {
        const devices::AxisDescriptor& from = d.axes[i];
        station_axis& axis = config->axes[i];
        axis.count_size = from.resolution;
        axis.minimum = from.minimum;
        axis.maximum = from.maximum;
        axis.rating = static_cast<float>(from.continuousRating);
        axis.coulomb = static_cast<float>(from.coulombFriction);
        axis.viscous = static_cast<float>(from.viscousFriction);
        axis.unit = from.unit == devices::AxisUnit::metre ? STATION_METRE : STATION_RADIAN;
        copyText(axis.id, from.id);
    }
    for (std::size_t i = 0; i < d.kinematicsParameters.size(); ++i)
        config->parameters[i / STATION_PARAMETERS_A_PAGE].values[i % STATION_PARAMETERS_A_PAGE] =
            d.kinematicsParameters[i];
    return config;
}

std::int16_t toInt16(double value) noexcept {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -32'767.0, 32'767.0)));
}

} // namespace

EmulatedStation::EmulatedStation(Configuration configuration, devices::DriverTool tool)
    : m_configuration(std::move(configuration)), m_tool(std::move(tool)),
      m_line(m_configuration.fault, m_configuration.seed) {}

EmulatedStation::~EmulatedStation() = default;

core::Result<std::unique_ptr<EmulatedStation>> EmulatedStation::create(Configuration configuration) {
    const devices::Driver& driver = devices::usualDriver(devices::MovedBy::scriptedOperator);
    devices::DriverRequest request;
    request.shape = configuration.shape;
    request.mechanism = configuration.mechanism;
    request.hand = configuration.hand;
    request.seed = configuration.seed;
    request.endoscopeStart_W = configuration.endoscopeStart_D;
    request.tools.push_back({.strategy = std::move(configuration.strategy)});
    auto made = driver.open(std::move(request));
    CHIRON_TRY(made);
    devices::DriverTool tool = std::move(made->front());
    if (tool.axes == nullptr)
        return core::fail(core::ErrorCode::wrongUse, "mechanism " + configuration.mechanism +
                                                         ": its motors cannot be driven one by one");
    CHIRON_TRY(tool.device->open());
    auto config = describe(tool.device->descriptor(), configuration);
    CHIRON_TRY(config);
    std::unique_ptr<EmulatedStation> station(new EmulatedStation(std::move(configuration), std::move(tool)));
    station->m_config = std::move(*config);
    if (!station_device_begin(&station->m_device, station->m_config.get(), 0))
        return core::fail(core::ErrorCode::wrongUse, "mechanism " + station->m_configuration.mechanism +
                                                         ": it cannot be stated by the station protocol");
    station_hardware atRest{};
    atRest.at_reference = true;
    station_device_advance(&station->m_device, 0, &atRest);
    return station;
}

void EmulatedStation::lineChanged() {
    station_device_link_lost(&m_device, now_us(0));
    m_line.forget();
}

bool EmulatedStation::receive(const FrameBytes& came, std::uint32_t into_us) {
    FrameBytes frame = came;
    std::uint8_t page = 0;
    const bool request = station_decode_feature_request(frame.data(), &page) == STATION_OK;
    if (!request && (frozen() || !m_line.admits(frame, m_ticks.executed())))
        return true;
    FrameBytes reply{};
    switch (station_device_receive(&m_device, now_us(into_us), frame.data(), reply.data())) {
    case STATION_TOOK_OUTPUT:
        ++m_totals.applied;
        m_totals.lastOutput_us = 1000 * m_ticks.executed() + into_us;
        break;
    case STATION_TOOK_REQUEST:
        m_line.push(reply, m_ticks.executed());
        break;
    default:
        break;
    }
    return !request;
}

/// One millisecond of the mechanism under the efforts that the device lets through now.
void EmulatedStation::drive() {
    const bool saturates =
        m_configuration.fault.kind == FaultKind::saturate && m_line.acts(m_ticks.executed());
    devices::AxisValues efforts{};
    bool gives = false;
    for (std::size_t axis = 0; axis < STATION_AXES; ++axis) {
        std::int32_t effort = station_device_effort(&m_device, static_cast<std::uint8_t>(axis));
        if (saturates) {
            const auto most = static_cast<std::int32_t>(
                m_configuration.fault.amount *
                static_cast<double>(station_effort_limit(m_config->axes[axis].rating)));
            effort = std::clamp(effort, -most, most);
        }
        efforts[axis] = kMicro * effort;
        gives = gives || effort != 0;
        m_totals.largestEffort[axis] = std::max(m_totals.largestEffort[axis], std::abs(effort));
    }
    std::int16_t force_mN = 0, pitch = 0, roll = 0;
    core::DisplayPose display;
    if (station_device_display(&m_device, &force_mN, &pitch, &roll))
        display = {1e-3 * force_mN, 1e-4 * pitch, 1e-4 * roll};
    gives = gives || force_mN != 0;
    m_totals.largestDisplay_N = std::max(m_totals.largestDisplay_N, std::abs(display.normalForce_N));
    m_tool.axes->drive(efforts, display, station_device_state(&m_device) == STATION_ARMED);
    if (gives)
        m_totals.lastForce_us = 1000 * m_ticks.executed() + 1000; // until the end of this millisecond
}

void EmulatedStation::makeInput(const core::DeviceSample& sample) {
    station_sample input{};
    std::copy(sample.counts.begin(), sample.counts.end(), std::begin(input.counts));
    if (m_configuration.fault.kind == FaultKind::drift && m_line.acts(m_ticks.executed())) {
        m_drift_counts += 1e-3 * m_configuration.fault.amount;
        input.counts[0] = static_cast<std::int32_t>(input.counts[0] + std::llround(m_drift_counts));
    }
    input.jaw = static_cast<std::int16_t>(sample.jawCounts);
    input.wrench_valid = (sample.status & core::sample_status::kMeasuredForce) != 0;
    for (std::size_t i = 0; i < 6; ++i)
        input.wrench[i] = toInt16(sample.measured[i] * (i < 3 ? 1e3 : 1e4));
    input.buttons = static_cast<std::uint8_t>(((sample.buttons & core::kButtonMark) != 0 ? 1 : 0) |
                                              ((sample.buttons & core::kButtonStop) != 0 ? 2 : 0));
    input.supply_mV = kSupply_mV;
    FrameBytes frame{};
    station_device_input(&m_device, &input, frame.data());
    if (!frozen())
        m_line.push(frame, m_ticks.executed());
}

void EmulatedStation::tick() {
    drive();
    const realtime::HapticTick now =
        m_ticks.next(static_cast<std::int64_t>(m_ticks.executed() + 1) * 1'000'000);
    m_tool.device->show(now, m_cues);
    const core::DeviceSample sample = m_tool.device->read(now);
    station_hardware hardware{};
    hardware.at_reference = true; // its counts are absolute
    hardware.motor_at_limit =
        (sample.status & core::sample_status::kSaturated) != 0 ||
        (m_configuration.fault.kind == FaultKind::saturate && m_line.acts(m_ticks.executed()));
    station_device_advance(&m_device, now_us(0), &hardware);
    makeInput(sample);
    ++m_totals.ticks;
}

bool EmulatedStation::nextToSend(FrameBytes& frame) {
    return !frozen() && m_line.pop(frame, m_ticks.executed());
}

FrameBytes EmulatedStation::endOfStep() const {
    FrameBytes frame{};
    (void)station_encode_counters(&m_device.counters, frame.data());
    return frame;
}

StationTotals EmulatedStation::totals() const {
    StationTotals totals = m_totals;
    totals.counters = m_device.counters;
    return totals;
}

} // namespace chiron::station
