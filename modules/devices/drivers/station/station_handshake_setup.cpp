// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/station/station_handshake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace chiron::devices {

namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;
constexpr std::int64_t kReply_ns = 300 * kMillisecond_ns;
constexpr int kAsked = 3; ///< times that a page is asked for, because a line may lose a frame
constexpr std::int64_t kFirstInput_ns = 1000 * kMillisecond_ns;
constexpr std::int64_t kSettle_ns = 3000 * kMillisecond_ns;  ///< to home, or to clear a fault
constexpr std::int64_t kMeasure_ns = 2000 * kMillisecond_ns; ///< the longest that kRoundTrips may take
/// Round trips that must come back for a measurement to say something.
constexpr std::size_t kFewestRoundTrips = 50;
/// The slowest station that is of any use, and more than any.
constexpr std::uint32_t kSlowest_us = 100'000;

tl::unexpected<core::Error> refuse(const std::string& where, const std::string& why) {
    return core::fail(core::ErrorCode::device, "station at " + where + ": " + why);
}

/// Asks for pages and explains what comes instead.
class PageReader {
public:
    PageReader(IStationTransport& transport, const std::string& where)
        : m_transport(transport), m_where(where) {}

    core::Result<station::FrameBytes> read(std::uint8_t page) {
        station::FrameBytes request{};
        (void)station_encode_feature_request(page, request.data());
        bool answered = false;
        for (int asked = 0; asked < kAsked; ++asked) {
            station::FrameBytes reply{};
            const station::Received got =
                m_transport.exchangeFeature(request, reply, station::steadyNow_ns() + kReply_ns);
            if (got == station::Received::gone)
                return refuse(m_where, "it closed the connection before it said what it is; another program "
                                       "may be using it, or it is not a station");
            std::uint8_t replied = 0, status = 0;
            if (got == station::Received::frame &&
                station_decode_feature_head(reply.data(), &replied, &status) == STATION_OK &&
                replied == page) {
                if (status != STATION_PAGE_OK)
                    return refuse(m_where, "it has no feature page " + std::to_string(page) +
                                               ", which the station protocol requires");
                return reply;
            }
            answered = answered || got == station::Received::frame || hearsAnything();
        }
        return refuse(m_where, answered
                                   ? "it answers, but not by the station protocol; check the address, and "
                                     "the speed of a serial line"
                                   : "it does not answer; check that it is switched on and that the "
                                     "address is right");
    }
    tl::unexpected<core::Error> wrong(std::uint8_t page) const {
        return refuse(m_where, "its feature page " + std::to_string(page) +
                                   " holds values that the station protocol does not allow");
    }

private:
    bool hearsAnything() {
        station::FrameBytes frame{};
        return m_transport.malformed() > 0 ||
               m_transport.receive(frame, station::steadyNow_ns()) == station::Received::frame;
    }

    IStationTransport& m_transport;
    const std::string& m_where;
};

AxisDescriptor describeAxis(const station_axis& axis) {
    return {.id = axis.id,
            .unit = axis.unit == STATION_METRE ? AxisUnit::metre : AxisUnit::radian,
            .resolution = axis.count_size,
            .minimum = axis.minimum,
            .maximum = axis.maximum,
            .continuousRating = static_cast<double>(axis.rating),
            .coulombFriction = static_cast<double>(axis.coulomb),
            .viscousFriction = static_cast<double>(axis.viscous)};
}

core::Result<station_axis> readAxis(PageReader& pages, std::uint8_t index) {
    const auto page = static_cast<std::uint8_t>(STATION_PAGE_AXIS + index);
    const auto reply = pages.read(page);
    CHIRON_TRY(reply);
    station_axis axis{};
    if (station_decode_axis(reply->data(), index, &axis) != STATION_OK || axis.minimum > axis.maximum)
        return pages.wrong(page);
    return axis;
}

core::Result<std::vector<station_parameters>> readParameters(PageReader& pages, std::size_t count) {
    std::vector<station_parameters> read;
    for (std::uint8_t index = 0; STATION_PARAMETERS_A_PAGE * read.size() < count; ++index) {
        const auto page = static_cast<std::uint8_t>(STATION_PAGE_PARAMETERS + index);
        const auto reply = pages.read(page);
        CHIRON_TRY(reply);
        station_parameters parameters{};
        if (station_decode_parameters(reply->data(), index, &parameters) != STATION_OK)
            return pages.wrong(page);
        read.push_back(parameters);
    }
    return read;
}

/// Whether the values are those that were calibrated, where a station says that it was.
core::Result<void> checkCalibration(PageReader& pages, const std::vector<station_axis>& axes,
                                    const std::vector<station_parameters>& parameters,
                                    const std::string& where) {
    const auto reply = pages.read(STATION_PAGE_CALIBRATION);
    CHIRON_TRY(reply);
    station_calibration calibration{};
    if (station_decode_calibration(reply->data(), &calibration) != STATION_OK)
        return pages.wrong(STATION_PAGE_CALIBRATION);
    const std::uint32_t found =
        station_calibration_crc32(axes.data(), static_cast<std::uint8_t>(axes.size()), parameters.data(),
                                  static_cast<std::uint8_t>(parameters.size()));
    if (calibration.unix_time != 0 && calibration.crc32 != found)
        return refuse(where,
                      "its axes and parameters are not those with which it was calibrated; calibrate it "
                      "again");
    return {};
}

/// Checks what a page may state and a device may not be.
core::Result<void> checkIdentity(const station_identity& page, const std::string& where) {
    if (page.axes < 1 || page.axes > STATION_AXES)
        return refuse(where, "it states " + std::to_string(page.axes) + " axes; expected 1 to 8");
    if (page.period_us < 100 || page.period_us > kSlowest_us)
        return refuse(where, "it states a period of " + std::to_string(page.period_us) +
                                 " us; expected 100 us to 100 ms");
    if ((page.bits & STATION_RENDERS_FORCE) != 0 && !(page.max_damping_Ns_per_m > 0.0F))
        return refuse(where, "it renders force, but states no damping that it can render");
    return {};
}

/// The sequence of outputs and the newest input while nothing runs yet.
class Exchange {
public:
    Exchange(IStationTransport& transport, bool lockstep) : m_transport(transport), m_lockstep(lockstep) {}

    /// Sends one output and takes all input until the deadline; a stepped station answers each output once.
    /// False if the connection is gone.
    bool step(std::uint8_t flags, std::int64_t until_ns) {
        const bool first = !m_have;
        m_sequence = static_cast<std::uint16_t>(m_sequence + 1);
        m_sentAt_ns[m_sequence % m_sentAt_ns.size()] = station::steadyNow_ns();
        const auto frame = idleOutput(m_sequence, m_newest.sequence, flags);
        if (m_transport.send(frame) == station::Sent::gone)
            return false;
        for (;;) {
            station::FrameBytes bytes{};
            const station::Received got = m_transport.receive(bytes, until_ns);
            if (got == station::Received::gone)
                return false;
            if (got == station::Received::nothing)
                return true;
            if (take(bytes) && first) // its number may come from an earlier host: go on from there
                m_sequence = m_newest.applied_age_ms < 255 ? m_newest.applied_sequence : m_sequence;
            if (m_lockstep && station_frame_type(bytes.data()) == STATION_FEATURE_REPLY)
                return true; // the end of the step
            if (station::steadyNow_ns() >= until_ns)
                return true;
        }
    }
    bool have() const { return m_have; }
    StationStart start() const { return {m_newest, m_arrival_ns, m_sequence, 0}; }
    const station_input& newest() const { return m_newest; }
    const std::vector<std::int64_t>& roundTrips() const { return m_roundTrips; }
    void forgetRoundTrips() { m_roundTrips.clear(); }

private:
    bool take(const station::FrameBytes& bytes) {
        station_input input{};
        if (station_decode_input(bytes.data(), &input) != STATION_OK)
            return false;
        if (m_have && !station_newer(input.sequence, m_newest.sequence))
            return false;
        m_arrival_ns = station::steadyNow_ns();
        // The first input that tells of an output ends its round trip.
        if (m_have && input.applied_age_ms < 255 && input.applied_sequence != m_newest.applied_sequence &&
            !station_newer(input.applied_sequence, m_sequence))
            m_roundTrips.push_back(m_arrival_ns - m_sentAt_ns[input.applied_sequence % m_sentAt_ns.size()]);
        m_newest = input;
        m_have = true;
        return true;
    }

    IStationTransport& m_transport;
    bool m_lockstep;
    bool m_have = false;
    std::uint16_t m_sequence = 0;
    std::array<std::int64_t, 256> m_sentAt_ns{}; ///< by number
    std::int64_t m_arrival_ns = 0;
    station_input m_newest{};
    std::vector<std::int64_t> m_roundTrips;
};

tl::unexpected<core::Error> wentAway(const std::string& where) {
    return refuse(where, "it closed the connection; another program may be using it");
}

core::Result<void> settle(Exchange& exchange, const StationIdentity& identity, const std::string& where,
                          std::int64_t period_ns) {
    const std::int64_t end_ns = station::steadyNow_ns() + kSettle_ns;
    while (exchange.newest().state == STATION_FAULT ||
           (exchange.newest().state == STATION_UNKNOWN && identity.homesByFlag)) {
        if (station::steadyNow_ns() >= end_ns)
            break;
        const std::uint8_t flags =
            exchange.newest().state == STATION_FAULT ? STATION_OUTPUT_CLEAR_FAULT : STATION_OUTPUT_HOME;
        if (!exchange.step(flags, station::steadyNow_ns() + (identity.lockstep ? kFirstInput_ns : period_ns)))
            return wentAway(where);
    }
    if (exchange.newest().state == STATION_FAULT)
        return refuse(where, std::string("it reports a fault that stays: ") +
                                 faultWords(exchange.newest().fault) + "; remove its cause and try again");
    if (exchange.newest().state == STATION_UNKNOWN)
        return refuse(where, "it does not know its position yet; move its tool to the reference position as "
                             "its manual says, and try again");
    return {};
}

} // namespace

const char* faultWords(std::uint8_t code) noexcept {
    switch (code) {
    case STATION_OVERSPEED:
        return "too fast";
    case STATION_OVER_CURRENT:
        return "too much current";
    case STATION_OVER_TEMPERATURE:
        return "too hot";
    case STATION_ENCODER_FAULT:
        return "an encoder failed";
    case STATION_SUPPLY_FAULT:
        return "its supply voltage is out of range";
    case STATION_PROTOCOL_FAULT:
        return "it could not follow what it was sent";
    case STATION_EMERGENCY_STOP:
        return "the emergency stop is pressed";
    case STATION_INTERNAL_FAULT:
        return "an internal error";
    default:
        return "a fault that this version does not know";
    }
}

station::FrameBytes idleOutput(std::uint16_t sequence, std::uint16_t answered, std::uint8_t flags) {
    station_output output{};
    output.flags = flags;
    output.sequence = sequence;
    output.answered_sequence = answered;
    output.hold_ms = kStationHold_ms;
    station::FrameBytes frame{};
    (void)station_encode_output(&output, frame.data());
    return frame;
}

core::Result<StationIdentity> identifyStation(IStationTransport& transport, const std::string& where) {
    PageReader pages(transport, where);
    const auto first = pages.read(STATION_PAGE_IDENTITY);
    CHIRON_TRY(first);
    // Bytes 4 and 5 are the version in every version: read before anything that another one may change.
    const unsigned major = (*first)[4], minor = (*first)[5];
    if (major != STATION_MAJOR)
        return refuse(where, "it speaks version " + std::to_string(major) + "." + std::to_string(minor) +
                                 " of the station protocol; this program speaks version " +
                                 std::to_string(STATION_MAJOR) + ": update the older of the two");
    station_identity identity{};
    if (station_decode_identity(first->data(), &identity) != STATION_OK)
        return pages.wrong(STATION_PAGE_IDENTITY);
    CHIRON_TRY(checkIdentity(identity, where));
    const auto second = pages.read(STATION_PAGE_NAMES);
    CHIRON_TRY(second);
    station_names names{};
    if (station_decode_names(second->data(), &names) != STATION_OK)
        return pages.wrong(STATION_PAGE_NAMES);
    const auto third = pages.read(STATION_PAGE_KINEMATICS);
    CHIRON_TRY(third);
    station_kinematics kinematics{};
    if (station_decode_kinematics(third->data(), &kinematics) != STATION_OK)
        return pages.wrong(STATION_PAGE_KINEMATICS);

    StationIdentity found;
    found.firmware = kinematics.firmware;
    found.lockstep = (identity.bits & STATION_OFFERS_LOCKSTEP) != 0;
    found.deadMan = (identity.bits & STATION_HAS_DEAD_MAN) != 0;
    found.homesByFlag = (identity.bits & STATION_HOMES_BY_FLAG) != 0;
    found.platform = (identity.bits & STATION_HAS_PLATFORM) != 0;
    DeviceDescriptor& d = found.descriptor;
    d.model = names.model[0] != 0 ? names.model : "Haptic station";
    d.serialNumber = names.serial_number;
    d.kinematics = kinematics.id;
    const auto parameters = readParameters(pages, identity.parameters);
    CHIRON_TRY(parameters);
    for (std::size_t i = 0; i < identity.parameters; ++i)
        d.kinematicsParameters.push_back(
            (*parameters)[i / STATION_PARAMETERS_A_PAGE].values[i % STATION_PARAMETERS_A_PAGE]);
    std::vector<station_axis> axes;
    for (std::uint8_t index = 0; index < identity.axes; ++index) {
        const auto axis = readAxis(pages, index);
        CHIRON_TRY(axis);
        axes.push_back(*axis);
        d.axes.push_back(describeAxis(*axis));
    }
    CHIRON_TRY(checkCalibration(pages, axes, *parameters, where));
    d.jawResolution_rad = (identity.bits & STATION_HAS_JAW) != 0 ? identity.jaw_count_rad : 0.0;
    d.rendersForce = (identity.bits & STATION_RENDERS_FORCE) != 0;
    d.measuresForce = (identity.bits & STATION_MEASURES_FORCE) != 0;
    d.period_us = identity.period_us;
    d.oldestSample_us = std::max(identity.oldest_sample_us, identity.period_us);
    d.maximumForce_N = d.rendersForce ? static_cast<double>(identity.max_force_N) : 0.0;
    d.maximumTorque_Nm = d.rendersForce ? static_cast<double>(identity.max_torque_Nm) : 0.0;
    if (d.rendersForce)
        d.maximumDamping_Ns_per_m = static_cast<double>(identity.max_damping_Ns_per_m);
    return found;
}

bool isSameStation(const StationIdentity& a, const StationIdentity& b) {
    const DeviceDescriptor &x = a.descriptor, &y = b.descriptor;
    bool same = x.model == y.model && x.serialNumber == y.serialNumber && x.kinematics == y.kinematics &&
                x.kinematicsParameters == y.kinematicsParameters && x.axes.size() == y.axes.size() &&
                x.jawResolution_rad == y.jawResolution_rad && x.rendersForce == y.rendersForce &&
                x.period_us == y.period_us && x.maximumForce_N == y.maximumForce_N &&
                x.maximumTorque_Nm == y.maximumTorque_Nm &&
                x.maximumDamping_Ns_per_m == y.maximumDamping_Ns_per_m && a.lockstep == b.lockstep &&
                a.deadMan == b.deadMan && a.homesByFlag == b.homesByFlag && a.platform == b.platform;
    for (std::size_t i = 0; same && i < x.axes.size(); ++i)
        same = x.axes[i].id == y.axes[i].id && x.axes[i].unit == y.axes[i].unit &&
               x.axes[i].resolution == y.axes[i].resolution && x.axes[i].minimum == y.axes[i].minimum &&
               x.axes[i].maximum == y.axes[i].maximum &&
               x.axes[i].continuousRating == y.axes[i].continuousRating &&
               x.axes[i].coulombFriction == y.axes[i].coulombFriction &&
               x.axes[i].viscousFriction == y.axes[i].viscousFriction;
    return same;
}

core::Result<StationStart> startStation(IStationTransport& transport, const StationIdentity& identity,
                                        const std::string& where) {
    const std::int64_t period_ns = 1000 * static_cast<std::int64_t>(identity.descriptor.period_us);
    Exchange exchange(transport, identity.lockstep);
    const std::int64_t end_ns = station::steadyNow_ns() + kFirstInput_ns;
    while (!exchange.have() && station::steadyNow_ns() < end_ns)
        if (!exchange.step(0, station::steadyNow_ns() + (identity.lockstep ? kFirstInput_ns : period_ns)))
            return wentAway(where);
    if (!exchange.have())
        return refuse(where, "it said what it is, but sends no positions");
    CHIRON_TRY(settle(exchange, identity, where, period_ns));
    StationStart start = exchange.start();
    if (identity.lockstep)
        return start;
    exchange.forgetRoundTrips();
    // Each command has its own period, however late this computer is: it measures the line, not its own
    // haste.
    const std::int64_t measured_ns = station::steadyNow_ns() + kMeasure_ns;
    while (exchange.roundTrips().size() < kRoundTrips && station::steadyNow_ns() < measured_ns)
        if (!exchange.step(0, station::steadyNow_ns() + std::max(period_ns, kMillisecond_ns)))
            return wentAway(where);
    std::vector<std::int64_t> trips = exchange.roundTrips();
    if (trips.size() < kFewestRoundTrips)
        return refuse(where, "only " + std::to_string(trips.size()) +
                                 " commands were answered within 2 s; the link is too slow or loses too much "
                                 "to render force");
    std::sort(trips.begin(), trips.end());
    start = exchange.start();
    start.roundTrip99_us = static_cast<std::uint32_t>(trips[(trips.size() * 99) / 100 - 1] / 1000) + 1;
    return start;
}

} // namespace chiron::devices
