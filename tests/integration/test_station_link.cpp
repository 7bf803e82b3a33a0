// SPDX-License-Identifier: GPL-3.0-or-later
// The station driver against the emulated station, over TCP, a pseudo-terminal and USB HID: what a host
// learns of it, that the line changes nothing, that it lets go when its host dies, and every fault.
#include "devices/drivers/station/station_tool.h"
#include "haptics/haptic_loop.h"
#include "realtime/periodic_runner.h"
#include "support/haptic_bench.h"
#include "support/hid_computer.h"
#include "support/patience.h"
#include "support/station_bench.h"
#include "support/station_conformance.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <arpa/inet.h>
#include <csignal>
#include <cstring>
#include <fstream>
#include <grp.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace chiron;
using namespace chiron::tests;

namespace {

constexpr std::int64_t kTick_ns = 1'000'000;

/// Whether USB HID devices can be plugged in here that are not there.
bool g_hid = false;

#define SKIP_WITHOUT(wire)                                                                                   \
    if (Wire(wire) == Wire::hid && !g_hid)                                                                   \
    QSKIP("takes root and /dev/fuse")

void addWires() {
    QTest::addColumn<int>("wire");
    for (const Wire wire : {Wire::tcp, Wire::terminal, Wire::hid})
        QTest::newRow(nameOf(wire)) << int(wire);
}

devices::StationTool& stationTool(const devices::DriverTool& tool) {
    return dynamic_cast<devices::StationTool&>(*tool.device);
}

/// A spring of 300 N/m to where the tool was first, at most 2 N: what a scene might ask for.
core::Wrench springTo(const core::Vec3& anchor, const core::Vec3& p_DT) {
    core::Vec3 force = 300.0 * (anchor - p_DT);
    if (force.norm() > 2.0)
        force *= 2.0 / force.norm();
    return {force, core::Vec3::Zero()};
}

/// The same mechanism without a line: driven with the efforts that travel, in whole micro-newtons.
class Replica {
public:
    explicit Replica(const std::string& mechanism, std::unique_ptr<mechanisms::HandStrategy> strategy =
                                                       std::move(stationOn("gimbal_hprd").strategy)) {
        devices::DriverRequest request;
        request.mechanism = mechanism;
        request.endoscopeStart_W = stationOn(mechanism).endoscopeStart_D;
        request.tools.push_back({.strategy = std::move(strategy)});
        auto made = devices::usualDriver(devices::MovedBy::scriptedOperator).open(std::move(request));
        if (!made)
            qFatal("%s", made.error().message.c_str());
        m_tool = std::move(made->front());
        (void)m_tool.device->open();
    }
    core::DeviceSample read() { return read(m_ticks.next(0)); }
    core::DeviceSample read(const realtime::HapticTick& now) { return m_tool.device->read(now); }
    void drive(const devices::AxisValues& efforts, const core::DisplayPose& display, bool enabled) {
        devices::AxisValues travelled{};
        for (std::size_t axis = 0; axis < m_tool.device->descriptor().axes.size(); ++axis) {
            const double limit =
                std::round(1e6 * static_cast<double>(static_cast<float>(
                                     m_tool.device->descriptor().axes[axis].continuousRating)));
            travelled[axis] = 1e-6 * std::clamp(std::round(1e6 * efforts[axis]), -limit, limit);
        }
        const core::DisplayPose shown{1e-3 * std::round(1e3 * display.normalForce_N),
                                      1e-4 * std::round(1e4 * display.pitch_rad),
                                      1e-4 * std::round(1e4 * display.roll_rad)};
        m_tool.axes->drive(travelled, shown, enabled);
    }

private:
    devices::DriverTool m_tool;
    realtime::TickSource m_ticks;
};

/// The same mechanism as a device of a whole loop: what the line does to numbers (Replica), and no line.
class InProcess final : public devices::IDevice {
public:
    InProcess(const devices::StationTool& like, const std::string& mechanism,
              station::EmulatedStation::Configuration held)
        : m_like(like), m_replica(mechanism, std::move(held.strategy)) {
        m_replica.drive({}, {}, false); // the one step of open()
    }
    const devices::DeviceDescriptor& descriptor() const noexcept override { return m_like.descriptor(); }
    const devices::IToolKinematics& kinematics() const noexcept override { return m_like.kinematics(); }
    core::Result<void> open() override { return {}; }
    void close() noexcept override {}
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override {
        m_sample = m_replica.read(now);
        m_sample.packet = static_cast<std::uint32_t>(now.index() + 1);
        for (std::size_t i = 0; i < m_sample.measured.size(); ++i) {
            const double unit = i < 3 ? 1e-3 : 1e-4;
            m_sample.measured[i] = unit * std::round(m_sample.measured[i] / unit);
        }
        return m_sample;
    }
    void command(const realtime::HapticTick&, const devices::ForceCommand& command) noexcept override {
        const auto efforts = kinematics().efforts(m_sample, command.wrench_D);
        m_replica.drive(command.enabled ? efforts : devices::AxisValues{}, {}, command.enabled);
    }
    void show(const realtime::HapticTick&, const core::VisibleCues&) noexcept override {}

private:
    const devices::StationTool& m_like;
    Replica m_replica;
    core::DeviceSample m_sample;
};

/// Records six seconds of a session with this device: three of arming and free movement, then contact.
std::vector<core::HapticFrame> recordedWith(devices::IDevice& device) {
    haptics::LiveInputs inputs;
    FrameStore store;
    haptics::SafetySettings safety;
    safety.heartbeatWatched = false;
    LoopBench loop({{device, {}}}, inputs, store, apexScene(benchExercise(2, 60.0)), safety);
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    for (std::int64_t n = 0; n < 6'000; ++n) {
        (void)loop.loop->tick(ticks.next(n * kTick_ns));
        (void)device.awaitStep();
    }
    return store.frames;
}

/// What a peer that is no station does.
enum class Peer { silent, closing, garbage, flood, otherVersion };

/// A TCP server of that kind, for one test.
class OtherPeer {
public:
    explicit OtherPeer(Peer kind) {
        m_listener = ::socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in place{};
        place.sin_family = AF_INET;
        place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof place;
        (void)::bind(m_listener, reinterpret_cast<sockaddr*>(&place), size);
        (void)::listen(m_listener, 1);
        (void)::getsockname(m_listener, reinterpret_cast<sockaddr*>(&place), &size);
        address = "tcp:127.0.0.1:" + std::to_string(ntohs(place.sin_port));
        m_thread = std::thread([this, kind] { serve(kind); });
    }
    ~OtherPeer() {
        ::shutdown(m_listener, SHUT_RDWR);
        m_stop.store(true);
        m_thread.join();
        ::close(m_listener);
    }
    std::string address;

private:
    void serve(Peer kind) {
        const int host = ::accept(m_listener, nullptr, nullptr);
        if (host < 0)
            return;
        station::FrameStream line(host, station::Framing::concatenated);
        if (kind == Peer::closing)
            return;
        station::FrameBytes frame{};
        std::uint8_t next = 1;
        while (!m_stop.load()) {
            const station::Received got =
                line.receive(frame, kind == Peer::flood ? 0 : station::steadyNow_ns() + kTick_ns);
            if (got == station::Received::gone)
                return;
            if ((got != station::Received::frame && kind != Peer::flood) || kind == Peer::silent)
                continue;
            if (kind == Peer::garbage || kind == Peer::flood) {
                for (std::uint8_t& byte : frame)
                    byte = next = static_cast<std::uint8_t>(next * 73 + 41);
            } else {
                station_identity identity{2, 1, 3, 0, 1000, 1000, 0.0F, 0.0F, 0.0F, 0.0, 0};
                (void)station_encode_identity(&identity, frame.data());
                frame[4] = 2;
                frame[5] = 1;
                station_seal(frame.data());
            }
            (void)line.send(frame);
        }
    }
    int m_listener;
    std::atomic<bool> m_stop{false};
    std::thread m_thread;
};

/// When a fault comes: what the session does at that moment.
struct Moment {
    const char* name;
    std::uint64_t fault;  ///< tick
    std::uint64_t ticks;  ///< of the whole loop; the device is closed then
    std::uint64_t paused; ///< tick at which the person pauses; 0: never
};
/// The hand begins to press after kPress_s, and the ball is felt from the first second on.
constexpr double kPress_s = 0.3;
constexpr Moment kMoments[]{{"arming", 100, 600, 0},
                            {"free", 400, 900, 0},
                            {"contact", 1600, 2200, 0},
                            {"pause", 1900, 2400, 1600},
                            {"saving", 1600, 1600, 0}};
constexpr std::size_t kContact = 2;

/// A station that never stops sending inputs.
class FloodTransport final : public devices::IStationTransport {
public:
    explicit FloodTransport(std::atomic<int>& sent) : m_sent(sent) {}
    station::Sent send(const station::FrameBytes&) noexcept override {
        ++m_sent;
        return station::Sent::sent;
    }
    station::Received receive(station::FrameBytes& frame, std::int64_t) noexcept override {
        station_input input{};
        input.sequence = ++m_sequence;
        input.time_us = 1000u * m_sequence;
        input.state = STATION_HOMED;
        input.flags = STATION_INPUT_HOMED;
        (void)station_encode_input(&input, frame.data());
        return station::Received::frame;
    }
    void close() noexcept override {}
    std::uint64_t malformed() const noexcept override { return 0; }

private:
    std::atomic<int>& m_sent;
    std::uint16_t m_sequence = 0;
};

struct FaultRun {
    station::StationTotals totals;
    devices::StationHealth health;
    double largest_N = 0.0;          ///< that the supervisor let through
    double largestBefore_N = 0.0;    ///< the same until the fault
    bool faulted = false;            ///< the supervisor latched a fault after it
    bool heldBack = false;           ///< the supervisor's watchdog acted after it
    std::uint32_t status = 0;        ///< status bits of all samples after it
    std::vector<std::int32_t> limit; ///< of the axes, micro
    bool recorded = true;            ///< every tick is in the recording, in order
};

/// A whole loop in lockstep, to which the fault comes at its moment.
FaultRun runWithFault(const station::FaultPlan& plan, Wire wire, const Moment& moment) {
    FaultRun run;
    auto configuration = pressingStation(kPress_s);
    configuration.fault = plan;
    // The station has taken one step more than the loop: that of open().
    configuration.fault.when_s = 1e-3 * static_cast<double>(moment.fault);
    StationBench bench(std::move(configuration), wire);
    auto made = toolAt(bench.address);
    if (!made)
        qFatal("%s", made.error().message.c_str());
    devices::StationTool& tool = stationTool(made->front());
    if (const auto opened = tool.open(); !opened)
        qFatal("%s", opened.error().message.c_str());
    haptics::LiveInputs inputs;
    FrameStore store;
    haptics::SafetySettings safety;
    safety.heartbeatWatched = false;
    safety.armingRamp_ms = 500;
    LoopBench loop({{tool, {}}}, inputs, store, apexScene(benchExercise(2, 60.0)), safety);
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    for (std::uint64_t n = 0; n < moment.ticks; ++n) {
        if (moment.paused != 0 && n == moment.paused)
            inputs.post({core::CommandKind::pause});
        (void)loop.loop->tick(ticks.next(static_cast<std::int64_t>(n) * kTick_ns));
        (void)tool.awaitStep();
        const core::HapticFrame& frame = store.frames.back();
        run.recorded = run.recorded && store.frames.size() == n + 1 && frame.header.index == n;
        const auto& commanded = frame.tool[0].commanded;
        const double force_N = core::Vec3(commanded[0], commanded[1], commanded[2]).norm();
        run.largest_N = std::max(run.largest_N, force_N);
        if (n < moment.fault - 2) {
            run.largestBefore_N = std::max(run.largestBefore_N, force_N);
            continue;
        }
        run.faulted = run.faulted || frame.header.force == core::ForceState::fault;
        run.heldBack = run.heldBack || (frame.header.guards & core::guard_bits::kWatchdog) != 0;
        run.status |= frame.tool[0].status;
    }
    for (const devices::AxisDescriptor& axis : tool.descriptor().axes)
        run.limit.push_back(station_effort_limit(static_cast<float>(axis.continuousRating)));
    tool.close();
    run.health = tool.health();
    run.totals = bench.stop();
    return run;
}

/// An emulated station at the other end of a driver's transport. Its clock goes on only while this program
/// waits for the next frame.
class TransportLine final : public test::StationLine {
public:
    explicit TransportLine(Wire wire) : m_wire(wire) {
        auto made = station::EmulatedStation::create(stationOn("gimbal_hprd"));
        const auto open = wire == Wire::tcp        ? m_line.listenTcp("127.0.0.1", 0)
                          : wire == Wire::terminal ? m_line.openTerminal(std::string())
                                                   : m_line.openHidraw(HidComputer::kFolder, "C-1");
        if (!made || !open)
            qFatal("no emulated station");
        m_station = std::move(*made);
        if (wire == Wire::hid)
            HidComputer::plugIn(0, "C-1");
        auto transport = devices::connectStation(*devices::readStationAddress(m_line.address()));
        if (!transport)
            qFatal("%s", transport.error().message.c_str());
        m_transport = std::move(*transport);
        if (m_line.admitHost())
            m_station->lineChanged();
    }
    ~TransportLine() override {
        if (m_wire == Wire::hid)
            HidComputer::pullOut(0);
    }
    bool send(const QList<Frame>& frames) override {
        return std::all_of(frames.begin(), frames.end(), [this](const Frame& frame) {
            return m_transport->send(frame) == station::Sent::sent;
        });
    }
    bool next(Frame& frame) override {
        if (m_transport->receive(frame, 0) == station::Received::frame)
            return true;
        station::FrameBytes heard{};
        while (m_line.stream().receive(heard, 0) == station::Received::frame)
            (void)m_station->receive(heard, 0);
        m_station->tick();
        for (station::FrameBytes said{}; m_station->nextToSend(said);)
            (void)m_line.stream().send(said);
        return m_transport->receive(frame,
                                    station::steadyNow_ns() + 1'000'000 * std::int64_t{kPatience_ms}) ==
               station::Received::frame;
    }

private:
    Wire m_wire;
    std::unique_ptr<station::EmulatedStation> m_station;
    station::HostLine m_line;
    std::unique_ptr<devices::IStationTransport> m_transport;
};

QStringList mechanismsToServe() {
    QStringList ids;
    for (const devices::KinematicsEntry& entry :
         devices::usualDriver(devices::MovedBy::scriptedOperator).kinematics)
        ids << QString::fromStdString(std::string(entry.id));
    return ids;
}

} // namespace

class TestStationLink : public QObject {
    Q_OBJECT

private slots:
    void itSaysWhatItIs_data();
    void itSaysWhatItIs();
    void itKeepsWhatIsPromised_data() { addWires(); }
    void itKeepsWhatIsPromised();
    void theLineChangesNothing_data();
    void theLineChangesNothing();
    void theSameForcesAreRecorded_data();
    void theSameForcesAreRecorded();
    void addresses();
    void whatIsNoStationIsRefused_data();
    void whatIsNoStationIsRefused();
    void aSecondHostIsTurnedAway();
    void anotherStationIsNotTaken();
    void aKilledHostIsLetGo_data();
    void aKilledHostIsLetGo();
    void aFloodDoesNotHoldTheLine();
    void whichUsbDevice();
    void whoMayNotOpenAUsbDeviceIsToldWhy();
    void goneAtEveryMoment_data() { addWires(); }
    void goneAtEveryMoment();
    void itComesBack_data() { addWires(); }
    void itComesBack();
    void itGoesOnAfterRearming();
    void itGoesOnAfterItWasUnplugged();
    void eachFault_data();
    void eachFault();
    void faultPlans();
    void byTheClock();
};

void TestStationLink::itSaysWhatItIs_data() {
    QTest::addColumn<QString>("mechanism");
    for (const QString& id : mechanismsToServe())
        QTest::newRow(qPrintable(id)) << id;
}

// The descriptor on the host is that of the mechanism behind the line, but for what single precision rounds.
void TestStationLink::itSaysWhatItIs() {
    QFETCH(QString, mechanism);
    auto configuration = stationOn(mechanism.toStdString());
    configuration.serialNumber = "S-17";
    configuration.lockstep = true;
    StationBench bench(std::move(configuration));
    const auto made = toolAt(bench.address);
    QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
    const devices::DeviceDescriptor& told = made->front().device->descriptor();
    const devices::DeviceDescriptor& given = bench.emulated().descriptor();
    QCOMPARE(told.driver, std::string("station"));
    QCOMPARE(told.serialNumber, std::string("S-17"));
    QCOMPARE(told.kinematics, given.kinematics);
    QCOMPARE(told.kinematicsParameters, given.kinematicsParameters);
    QCOMPARE(told.period_us, given.period_us);
    QCOMPARE(told.oldestSample_us, given.oldestSample_us);
    QCOMPARE(told.jawResolution_rad, given.jawResolution_rad);
    QCOMPARE(told.rendersForce, given.rendersForce);
    QCOMPARE(told.measuresForce, given.measuresForce);
    QVERIFY(!told.inProcess);
    QCOMPARE(float(told.maximumForce_N), float(given.maximumForce_N));
    QCOMPARE(float(told.maximumTorque_Nm), float(given.maximumTorque_Nm));
    QCOMPARE(float(told.maximumDamping_Ns_per_m), float(given.maximumDamping_Ns_per_m));
    QCOMPARE(told.axes.size(), given.axes.size());
    for (std::size_t i = 0; i < told.axes.size(); ++i) {
        QVERIFY(given.axes[i].id.starts_with(told.axes[i].id)); // a page has room for 13 bytes
        QCOMPARE(told.axes[i].unit, given.axes[i].unit);
        QCOMPARE(told.axes[i].resolution, given.axes[i].resolution);
        QCOMPARE(told.axes[i].minimum, given.axes[i].minimum);
        QCOMPARE(told.axes[i].maximum, given.axes[i].maximum);
        QCOMPARE(float(told.axes[i].continuousRating), float(given.axes[i].continuousRating));
    }
}

// What every station promises, through the transports that the driver has.
void TestStationLink::itKeepsWhatIsPromised() {
    QFETCH(int, wire);
    SKIP_WITHOUT(wire);
    TransportLine line{Wire(wire)};
    QCOMPARE(test::StationConformance(line).all(), QString());
}

void TestStationLink::theLineChangesNothing_data() {
    QTest::addColumn<QString>("mechanism");
    QTest::addColumn<int>("wire");
    QTest::addColumn<int>("ticks");
    for (const QString& id : mechanismsToServe()) {
        const int ticks = id == mechanismsToServe().front() ? 10'000 : 2'000;
        for (const Wire wire : {Wire::tcp, Wire::terminal, Wire::hid})
            QTest::newRow(qPrintable(id + ", " + nameOf(wire))) << id << int(wire) << ticks;
    }
}

// In lockstep, the counts at the host are, bit for bit, those of the same mechanism in the program under the
// same efforts: the line adds no delay of its own.
void TestStationLink::theLineChangesNothing() {
    QFETCH(QString, mechanism);
    QFETCH(int, wire);
    QFETCH(int, ticks);
    SKIP_WITHOUT(wire);
    auto configuration = stationOn(mechanism.toStdString());
    configuration.lockstep = true;
    StationBench bench(std::move(configuration), Wire(wire));
    auto made = toolAt(bench.address);
    QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
    devices::StationTool& tool = stationTool(made->front());
    const auto opened = tool.open();
    QVERIFY2(opened.has_value(), opened ? "" : opened.error().message.c_str());

    Replica replica(mechanism.toStdString());
    replica.drive({}, {}, false); // the one step of open()
    realtime::TickSource ticker;
    core::Vec3 anchor = core::Vec3::Zero();
    bool moved = false;
    core::DeviceSample first;
    for (int n = 0; n < ticks; ++n) {
        const realtime::HapticTick now = ticker.next(n * kTick_ns);
        const core::DeviceSample sample = tool.read(now);
        const core::DeviceSample expected = replica.read();
        QVERIFY2(sample.counts == expected.counts && sample.jawCounts == expected.jawCounts,
                 qPrintable(QStringLiteral("tick %1").arg(n)));
        QCOMPARE(sample.packet, std::uint32_t(n + 1));
        QCOMPARE(sample.status & core::sample_status::kDeviceFault, 0u);
        for (std::size_t i = 0; i < 6; ++i) // in thousandths of a newton, or tenths of a millinewton-metre
            QVERIFY(std::abs(sample.measured[i] - expected.measured[i]) <= (i < 3 ? 0.51e-3 : 0.51e-4));
        const core::Vec3 p_DT = tool.kinematics().pose(sample).p_WT;
        if (n == 0) {
            anchor = p_DT;
            first = sample;
        }
        moved = moved || sample.counts != first.counts;
        devices::ForceCommand command;
        command.enabled = n >= 10;
        if (command.enabled) {
            command.wrench_D = springTo(anchor, p_DT);
            command.display = {0.5 + 0.4 * std::sin(1e-3 * n), 0.05, -0.03};
        }
        tool.command(now, command);
        QVERIFY2(tool.awaitStep(), qPrintable(QStringLiteral("tick %1").arg(n)));
        const auto efforts = tool.kinematics().efforts(sample, command.wrench_D);
        const bool platform = tool.identity().platform;
        replica.drive(command.enabled ? efforts : devices::AxisValues{},
                      platform ? command.display : core::DisplayPose{}, command.enabled);
    }
    QVERIFY(moved);
    tool.close();
    const devices::StationHealth health = tool.health();
    QCOMPARE(health.lost + health.stale + health.badCrc + health.badFrames + health.notTaken, 0u);
    const station::StationTotals totals = bench.stop();
    QVERIFY(totals.applied >= std::uint64_t(ticks));
    QCOMPARE(totals.counters.bad_crc + totals.counters.lost_outputs + totals.counters.bad_frames, 0u);
    QVERIFY(totals.lastForce_us > 1000u * std::uint64_t(ticks) - 100'000u);
}

void TestStationLink::theSameForcesAreRecorded_data() {
    addWires();
}

// A whole session in lockstep: what is recorded of it over the line is bit for bit what is recorded of the
// same mechanism in the program.
void TestStationLink::theSameForcesAreRecorded() {
    QFETCH(int, wire);
    SKIP_WITHOUT(wire);
    StationBench bench(pressingStation(), Wire(wire));
    auto made = toolAt(bench.address);
    QVERIFY2(made.has_value(), made ? "" : made.error().message.c_str());
    devices::StationTool& tool = stationTool(made->front());
    const auto opened = tool.open();
    QVERIFY2(opened.has_value(), opened ? "" : opened.error().message.c_str());
    const std::vector<core::HapticFrame> linked = recordedWith(tool);
    tool.close();
    InProcess inside(tool, "gimbal_hprd", pressingStation());
    const std::vector<core::HapticFrame> local = recordedWith(inside);
    QCOMPARE(linked.size(), local.size());
    double largest_N = 0.0;
    const auto same = [](const core::Array6& a, const core::Array6& b) {
        return std::memcmp(a.data(), b.data(), sizeof(core::Array6)) == 0;
    };
    for (std::size_t n = 0; n < linked.size(); ++n) {
        const core::ToolFrame &a = linked[n].tool[0], &b = local[n].tool[0];
        QVERIFY2(a.counts == b.counts && same(a.tissue, b.tissue) && same(a.commanded, b.commanded),
                 qPrintable(QStringLiteral("tick %1").arg(n)));
        QVERIFY2(linked[n].header.force == local[n].header.force &&
                     linked[n].header.guards == local[n].header.guards &&
                     linked[n].header.energySupplied_J == local[n].header.energySupplied_J &&
                     linked[n].header.energyStored_J == local[n].header.energyStored_J &&
                     linked[n].header.quantities == local[n].header.quantities,
                 qPrintable(QStringLiteral("tick %1").arg(n)));
        for (std::size_t i = 0; i < 6; ++i)
            QVERIFY(std::abs(a.measured[i] - b.measured[i]) <= (i < 3 ? 1.01e-3 : 1.01e-4));
        largest_N = std::max(largest_N, std::abs(a.commanded[2]));
    }
    QVERIFY2(largest_N > 0.5, "the ball was never felt");
}

void TestStationLink::addresses() {
    using devices::readStationAddress;
    QCOMPARE(readStationAddress("tcp:localhost:7000")->port, std::uint16_t(7000));
    QCOMPARE(readStationAddress("tcp:[::1]:7000")->host, std::string("::1"));
    QCOMPARE(readStationAddress("serial:/dev/ttyACM0")->path, std::string("/dev/ttyACM0"));
    const auto usb = readStationAddress("hid:1209:00fA:S 1:x");
    QVERIFY(usb && usb->vendor == 0x1209 && usb->product == 0xFA && usb->serialNumber == "S 1:x");
    QVERIFY(readStationAddress("hid:ffff:0001")->serialNumber.empty());
    for (const char* wrong :
         {"", "tcp", "tcp:", "tcp:7000", "tcp::7000", "tcp:a:0", "tcp:a:65536", "tcp:a:7x", "tcp:::1:7000",
          "serial:", "serial:ttyS0", "hid:", "hid:1209", "hid:1209:1", "hid:12090001", "hid:1209:00012",
          "hid:xyzw:0001", "hid:1209:0001:", "usb:1:2"}) {
        const auto refused = readStationAddress(wrong);
        QVERIFY2(!refused && refused.error().code == core::ErrorCode::badInput, wrong);
        QVERIFY2(refused.error().message.find("tcp:HOST:PORT") != std::string::npos, wrong);
    }
    const auto twice = [] {
        devices::DriverRequest request;
        for (int i = 0; i < 2; ++i) {
            request.tools.emplace_back();
            request.tools.back().address = "tcp:localhost:7000";
        }
        return devices::findDriver("station")->open(std::move(request));
    }();
    QVERIFY(!twice && twice.error().code == core::ErrorCode::badInput);
}

void TestStationLink::whatIsNoStationIsRefused_data() {
    QTest::addColumn<int>("peer");
    QTest::addColumn<QString>("words");
    QTest::newRow("silent") << int(Peer::silent) << "does not answer";
    QTest::newRow("closing") << int(Peer::closing) << "closed the connection";
    QTest::newRow("garbage") << int(Peer::garbage) << "not by the station protocol";
    QTest::newRow("flood") << int(Peer::flood) << "not by the station protocol";
    QTest::newRow("another version") << int(Peer::otherVersion) << "speaks version 2.1";
}

void TestStationLink::whatIsNoStationIsRefused() {
    QFETCH(int, peer);
    QFETCH(QString, words);
    const OtherPeer other{Peer(peer)};
    const auto refused = toolAt(other.address);
    QVERIFY(!refused);
    QCOMPARE(refused.error().code, core::ErrorCode::device);
    QVERIFY2(QString::fromStdString(refused.error().message).contains(words),
             refused.error().message.c_str());
    QVERIFY2(refused.error().message.find(other.address) != std::string::npos,
             refused.error().message.c_str());
}

void TestStationLink::aSecondHostIsTurnedAway() {
    auto configuration = stationOn("gimbal_hprd");
    configuration.lockstep = true;
    StationBench bench(std::move(configuration));
    auto first = toolAt(bench.address);
    QVERIFY(first && first->front().device->open());
    const auto second = toolAt(bench.address);
    QVERIFY(!second);
    QCOMPARE(second.error().code, core::ErrorCode::device);
    realtime::TickSource ticks; // the first one never notices
    const realtime::HapticTick now = ticks.next(0);
    (void)first->front().device->read(now);
    first->front().device->command(now, {});
    QVERIFY(first->front().device->awaitStep());
}

// Between set-up and opening, somebody may have put another device there.
void TestStationLink::anotherStationIsNotTaken() {
    auto configuration = stationOn("gimbal_hprd");
    configuration.lockstep = true;
    auto bench = std::make_unique<StationBench>(std::move(configuration));
    auto made = toolAt(bench->address);
    QVERIFY(made.has_value());
    const std::string port = bench->address.substr(bench->address.rfind(':') + 1);
    bench.reset();
    auto others = station::EmulatedStation::create([] {
        auto other = stationOn("gimbal_hprd");
        other.lockstep = true;
        other.serialNumber = "another";
        return other;
    }());
    QVERIFY(others.has_value());
    station::HostLine line;
    QVERIFY(line.listenTcp("127.0.0.1", static_cast<std::uint16_t>(std::stoi(port))).has_value());
    std::atomic<bool> stop{false};
    std::thread thread([&] { (void)station::runLockstep(**others, line, {}, stop); });
    const auto opened = made->front().device->open();
    stop.store(true);
    thread.join();
    QVERIFY(!opened);
    QVERIFY2(opened.error().message.find("another") != std::string::npos, opened.error().message.c_str());
}

// A pseudo-terminal and a USB device do not notice that nobody is there: their hold time alone lets go.
void TestStationLink::aKilledHostIsLetGo_data() {
    addWires();
}

// The station is a program of its own, and its host dies without a word (kill -9) while a motor gives 1 N. By
// the station's own clock, no force is left when the hold time after the last command has passed.
void TestStationLink::aKilledHostIsLetGo() {
    QFETCH(int, wire);
    SKIP_WITHOUT(wire);
    QProcess station;
    station.setProgram(QStringLiteral(CHIRON_STATION));
    QStringList arguments{"--mechanism", "gimbal_hprd", "--seed", "3"};
    arguments += Wire(wire) == Wire::tcp ? QStringList{"--tcp", "0"}
                 : Wire(wire) == Wire::terminal
                     ? QStringList{"--pty"}
                     : QStringList{"--fuse", HidComputer::kFolder, "--serial", "K-1"};
    if (Wire(wire) == Wire::hid)
        HidComputer::plugIn(0, "K-1");
    const auto pulledOut = qScopeGuard([&] {
        if (Wire(wire) == Wire::hid)
            HidComputer::pullOut(0);
    });
    station.setArguments(arguments);
    station.start();
    QVERIFY(station.waitForStarted(tests::kPatience_ms));
    while (!station.canReadLine() && station.state() == QProcess::Running) {
        station.setReadChannel(QProcess::StandardError);
        QVERIFY(station.canReadLine() || station.waitForReadyRead(tests::kPatience_ms));
    }
    const std::string said = station.readLine().trimmed().toStdString();
    const std::string address = said.substr(said.rfind(" at ") + 4);

    const pid_t host = ::fork();
    QVERIFY(host >= 0);
    if (host == 0) { // a host that arms, gives force for a third of a second, and dies
        auto made = toolAt(address);
        const auto opened = made ? made->front().device->open() : tl::unexpected(made.error());
        if (!opened) {
            std::fprintf(stderr, "%s\n", opened.error().message.c_str());
            ::_exit(7);
        }
        devices::IDevice& device = *made->front().device;
        realtime::TickSource ticks;
        for (int n = 0; n < 400; ++n) {
            const realtime::HapticTick now = ticks.next(station::steadyNow_ns());
            (void)device.read(now);
            devices::ForceCommand command;
            command.enabled = n > 50;
            command.wrench_D.force = command.enabled ? core::Vec3(0.0, 0.0, 1.0) : core::Vec3(0.0, 0.0, 0.0);
            device.command(now, command);
            ::usleep(1000);
        }
        ::raise(SIGKILL);
    }
    int status = 0;
    QCOMPARE(::waitpid(host, &status, 0), host);
    QVERIFY2(WIFSIGNALED(status), qPrintable(QStringLiteral("status %1").arg(status)));
    ::usleep(100'000); // well past any hold time
    station.terminate();
    QVERIFY(station.waitForFinished(tests::kPatience_ms));
    station.setReadChannel(QProcess::StandardOutput);
    const QJsonObject told = QJsonDocument::fromJson(station.readAll()).object();
    QVERIFY(told.value("watchdog_trips").toInt() >= 1);
    const qint64 force_us = told.value("last_force_us").toInteger();
    const qint64 output_us = told.value("last_output_us").toInteger();
    QVERIFY(force_us > 0 && output_us > 0);
    // Its motors change once a millisecond.
    QVERIFY2(force_us <= output_us + 1000 * devices::kStationHold_ms + 1000,
             qPrintable(QStringLiteral("%1 after %2 us").arg(force_us).arg(output_us)));
}

// Commands go out, the newest input is handed on, and the line ends when it is to end.
void TestStationLink::aFloodDoesNotHoldTheLine() {
    std::atomic<int> sent{0};
    devices::StationStart start;
    start.newest.state = STATION_HOMED;
    devices::StationLink link(std::make_unique<FloodTransport>(sent), {}, start);
    station_output output{};
    output.hold_ms = devices::kStationHold_ms;
    output.sequence = 1;
    link.put(output);
    QTRY_VERIFY_WITH_TIMEOUT(sent.load() > 0, kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(link.newest().packet > 10, kPatience_ms);
    link.finish();
    QVERIFY(!link.health().connected);
}

// A USB device is found by its numbers, and by its serial number where several have the same.
void TestStationLink::whichUsbDevice() {
    SKIP_WITHOUT(Wire::hid);
    const auto refusedAt = [](const std::string& address, const char* words) {
        const auto refused = toolAt(address);
        return !refused && refused.error().code == core::ErrorCode::device &&
               refused.error().message.find(words) != std::string::npos &&
               refused.error().message.find(address) != std::string::npos;
    };
    QVERIFY(refusedAt("hid:1209:0001", "no such USB device is plugged in"));
    QVERIFY(devices::findDriver("station")->discover().empty());
    auto configuration = stationOn("gimbal_hprd");
    configuration.serialNumber = "A-1";
    configuration.lockstep = true;
    const StationBench bench(std::move(configuration), Wire::hid);
    const auto found = [] { return devices::findDriver("station")->discover(); };
    QCOMPARE(found().size(), 1u);
    QCOMPARE(found().front().model, std::string("Emulated station"));
    QCOMPARE(found().front().serialNumber, std::string("A-1"));
    QCOMPARE(found().front().address, bench.address);
    QVERIFY(toolAt("hid:1209:0001").has_value());
    QVERIFY(toolAt("hid:1209:0001:A-1").has_value());
    QVERIFY(refusedAt("hid:1209:0001:B-2", "no such USB device"));
    QVERIFY(refusedAt("hid:1209:0002", "no such USB device"));
    HidComputer::plugIn(1, "B-2"); // nothing is behind it
    const auto pulledOut = qScopeGuard([] { HidComputer::pullOut(1); });
    QCOMPARE(found().size(), 2u);
    QCOMPARE(found().back().address, std::string("hid:1209:0001:B-2"));
    QVERIFY(refusedAt("hid:1209:0001", "A-1"));
    QVERIFY(refusedAt("hid:1209:0001", "B-2"));
    QVERIFY(toolAt("hid:1209:0001:A-1").has_value());
    QVERIFY(refusedAt("hid:1209:0001:B-2", "cannot be opened"));
    // A node that opens and answers nothing, as one may whose device is just being pulled out.
    std::ofstream(HidComputer::nodeOf(1)) << "no device";
    const auto removed = qScopeGuard([] { std::filesystem::remove(HidComputer::nodeOf(1)); });
    QVERIFY(refusedAt("hid:1209:0001:B-2", "cannot be opened"));
}

void TestStationLink::whoMayNotOpenAUsbDeviceIsToldWhy() {
    SKIP_WITHOUT(Wire::hid);
    auto configuration = stationOn("gimbal_hprd");
    configuration.lockstep = true;
    const StationBench bench(std::move(configuration), Wire::hid);
    constexpr int kTold = 7, kNobody = 65534;
    const pid_t other = ::fork();
    QVERIFY(other >= 0);
    if (other == 0) { // another person
        if (::setgroups(0, nullptr) != 0 || ::setgid(kNobody) != 0 || ::setuid(kNobody) != 0)
            ::_exit(1);
        const auto refused = toolAt(bench.address);
        const std::string said = refused ? "it was opened" : refused.error().message;
        if (said.find("may not open " + HidComputer::nodeOf(0)) != std::string::npos &&
            said.find("70-chiron-station.rules") != std::string::npos)
            ::_exit(kTold);
        std::fprintf(stderr, "%s\n", said.c_str());
        ::_exit(2);
    }
    int status = 0;
    QCOMPARE(::waitpid(other, &status, 0), other);
    QVERIFY(WIFEXITED(status));
    QCOMPARE(WEXITSTATUS(status), kTold);
    QVERIFY(toolAt(bench.address).has_value());
}

// Unplugged before it is opened, while it gives force, and when it is closed.
void TestStationLink::goneAtEveryMoment() {
    QFETCH(int, wire);
    SKIP_WITHOUT(wire);
    const auto lockstepped = [] {
        auto configuration = stationOn("gimbal_hprd");
        configuration.lockstep = true;
        return configuration;
    };
    {
        auto bench = std::make_unique<StationBench>(lockstepped(), Wire(wire));
        auto made = toolAt(bench->address);
        QVERIFY(made.has_value());
        const std::string address = bench->address;
        bench.reset();
        const auto opened = made->front().device->open();
        QVERIFY(!opened && opened.error().code == core::ErrorCode::device);
        QVERIFY2(opened.error().message.find("switched on") != std::string::npos,
                 opened.error().message.c_str());
        made->front().device->close();
        const auto never = toolAt(address);
        QVERIFY(!never && never.error().code == core::ErrorCode::device);
    }
    auto bench = std::make_unique<StationBench>(lockstepped(), Wire(wire));
    auto made = toolAt(bench->address);
    QVERIFY(made.has_value());
    devices::StationTool& tool = stationTool(made->front());
    QVERIFY(tool.open().has_value());
    realtime::TickSource ticks;
    std::uint32_t status = 0;
    for (int n = 0; n < 200; ++n) {
        const realtime::HapticTick now = ticks.next(n * kTick_ns);
        status = tool.read(now).status;
        devices::ForceCommand command;
        command.enabled = n > 10;
        command.wrench_D.force = core::Vec3(0.0, 0.0, command.enabled ? 1.0 : 0.0);
        tool.command(now, command);
        if (n == 100) {
            const station::StationTotals totals = bench->stop();
            QVERIFY(totals.largestEffort[0] > 0 || totals.largestEffort[1] > 0 ||
                    totals.largestEffort[3] > 0);
        }
        if (tool.awaitStep())
            QVERIFY(n <= 100);
    }
    QVERIFY((status & core::sample_status::kDeviceFault) != 0);
    tool.close(); // with nobody there
    QVERIFY(!tool.health().connected);
    QCOMPARE(tool.health().interruptions, 1u);
}

// A station that is plugged in again is used again, and its packets and its clock go on.
void TestStationLink::itComesBack() {
    QFETCH(int, wire);
    SKIP_WITHOUT(wire);
    auto configuration = stationOn("gimbal_hprd");
    configuration.fault = *station::readFaultPlan("unplug:4:500");
    StationBench bench(std::move(configuration), Wire(wire));
    auto made = toolAt(bench.address);
    QVERIFY(made.has_value());
    devices::StationTool& tool = stationTool(made->front());
    const auto opened = tool.open();
    QVERIFY2(opened.has_value(), opened ? "" : opened.error().message.c_str());
    realtime::TickSource ticks;
    bool gone = false, back = false;
    std::uint32_t packet = 0;
    std::uint64_t time_us = 0;
    const auto step = [&] {
        const realtime::HapticTick now = ticks.next(station::steadyNow_ns());
        const core::DeviceSample sample = tool.read(now);
        const bool fault = (sample.status & core::sample_status::kDeviceFault) != 0;
        const bool inOrder =
            static_cast<std::int32_t>(sample.packet - packet) >= 0 && sample.deviceTime_us >= time_us;
        packet = sample.packet;
        time_us = sample.deviceTime_us;
        back = back || (gone && !fault);
        gone = gone || fault;
        tool.command(now, {});
        return inOrder;
    };
    for (QElapsedTimer timer =
             [] {
                 QElapsedTimer t;
                 t.start();
                 return t;
             }();
         !back && !timer.hasExpired(tests::kPatience_ms);) {
        QVERIFY(step());
        QTest::qSleep(1);
    }
    QVERIFY(gone && back);
    tool.close();
    QCOMPARE(tool.health().interruptions, 1u);
}

// After a station that hung, the session goes on once a person has re-armed it, and force is felt again.
void TestStationLink::itGoesOnAfterRearming() {
    auto configuration = pressingStation();
    configuration.fault = *station::readFaultPlan("freeze:2.5:100");
    StationBench bench(std::move(configuration));
    auto made = toolAt(bench.address);
    QVERIFY(made.has_value());
    devices::StationTool& tool = stationTool(made->front());
    QVERIFY(tool.open().has_value());
    haptics::LiveInputs inputs;
    FrameStore store;
    haptics::SafetySettings safety;
    safety.heartbeatWatched = false;
    LoopBench loop({{tool, {}}}, inputs, store, apexScene(benchExercise(2, 60.0)), safety);
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    bool latched = false;
    for (std::int64_t n = 0; n < 6'000; ++n) {
        if (n == 2'900)
            inputs.post({core::CommandKind::rearm});
        (void)loop.loop->tick(ticks.next(n * kTick_ns));
        (void)tool.awaitStep();
        latched = latched || store.frames.back().header.force == core::ForceState::fault;
    }
    QVERIFY(latched);
    QVERIFY(store.frames.back().header.force == core::ForceState::on);
    double largest_N = 0.0;
    for (std::size_t n = 5'000; n < store.frames.size(); ++n)
        largest_N = std::max(largest_N, std::abs(store.frames[n].tool[0].commanded[2]));
    QVERIFY(largest_N > 0.5);
    tool.close();
    const station::StationTotals totals = bench.stop();
    QVERIFY(totals.lastForce_us > 5'800'000);
    QCOMPARE(totals.counters.watchdog_trips, 1u);
}

// The same for one that was unplugged and is plugged in again.
void TestStationLink::itGoesOnAfterItWasUnplugged() {
    auto configuration = pressingStation();
    configuration.fault = *station::readFaultPlan("unplug:1.5:300");
    StationBench bench(std::move(configuration));
    auto made = toolAt(bench.address);
    QVERIFY(made.has_value());
    devices::StationTool& tool = stationTool(made->front());
    QVERIFY(tool.open().has_value());
    haptics::LiveInputs inputs;
    FrameStore store(200'000);
    haptics::SafetySettings safety;
    safety.heartbeatWatched = false;
    LoopBench loop({{tool, {}}}, inputs, store, apexScene(benchExercise(2, 600.0)), safety);
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    bool gone = false, felt = false;
    QElapsedTimer timer;
    timer.start();
    for (std::int64_t n = 0; !(gone && felt) && !timer.hasExpired(kPatience_ms); ++n) {
        if (gone && store.frames.back().header.force == core::ForceState::fault)
            inputs.post({core::CommandKind::rearm}); // refused while the cause is there
        (void)loop.loop->tick(ticks.next(n * kTick_ns));
        const core::HapticFrame& frame = store.frames.back();
        gone = gone || frame.header.force == core::ForceState::fault;
        felt = gone && frame.header.force == core::ForceState::on && frame.tool[0].commanded[2] > 0.5;
        if (!tool.awaitStep())
            QTest::qSleep(1); // until the thread of the line has opened it again
    }
    QVERIFY(gone);
    QVERIFY2(felt, "it was not armed again");
    tool.close();
    QCOMPARE(tool.health().interruptions, 1u);
}

void TestStationLink::eachFault_data() {
    QTest::addColumn<QString>("plan");
    QTest::addColumn<int>("wire");
    QTest::addColumn<int>("moment");
    for (const char* plan :
         {"none", "delay:0:20", "jitter:0:20", "drop:0:0.05", "drop:0:1", "duplicate:0:0.2", "reorder:0:0.2",
          "corrupt:0:0.05", "freeze:0:100", "unplug:0:0", "saturate:0:0.1", "drift:0:100000000"})
        for (const Wire wire : {Wire::tcp, Wire::terminal, Wire::hid})
            // A USB device differs from a serial line in how it is reached and lost: one moment is enough.
            for (std::size_t moment = wire == Wire::hid ? kContact : 0;
                 moment < (wire == Wire::hid ? kContact + 1 : std::size(kMoments)); ++moment)
                QTest::newRow(qPrintable(QStringLiteral("%1, %2, %3")
                                             .arg(QLatin1String(plan), QLatin1String(nameOf(wire)),
                                                  QLatin1String(kMoments[moment].name))))
                    << QString::fromLatin1(plan) << int(wire) << int(moment);
}

// Whatever happens on the line, and whenever: no force beyond the limits on either side; what must stop stops
// on both, by the station's own clock; every tick is recorded; and the rest is counted.
void TestStationLink::eachFault() {
    QFETCH(QString, plan);
    QFETCH(int, wire);
    QFETCH(int, moment);
    SKIP_WITHOUT(wire);
    station::FaultPlan fault;
    if (plan != QLatin1String("none"))
        fault = *station::readFaultPlan(plan.toStdString());
    const Moment& when = kMoments[moment];
    const FaultRun run = runWithFault(fault, Wire(wire), when);
    QVERIFY(run.recorded);
    if (when.fault > 1500)
        QVERIFY2(run.largestBefore_N > 0.5, "the ball was never felt");
    QVERIFY(run.largest_N <= 4.0 + 1e-9);
    for (std::size_t axis = 0; axis < run.limit.size(); ++axis)
        QVERIFY(run.totals.largestEffort[axis] <= run.limit[axis]);
    const bool looped = when.ticks > when.fault; // the loop saw it
    const std::uint64_t fault_us = 1000 * when.fault;
    const auto letGo = [&](std::uint64_t within_ms) {
        return run.totals.lastForce_us <= fault_us + 1000 * within_ms;
    };
    const auto stopped = [&](std::uint64_t within_ms) {
        return letGo(within_ms) && (run.faulted || !looped);
    };
    if (!looped)
        QVERIFY2(letGo(20), qPrintable(QString::number(run.totals.lastForce_us)));
    using station::FaultKind;
    switch (fault.kind) {
    case FaultKind::none:
        QVERIFY(!run.faulted && !run.heldBack);
        QCOMPARE(run.health.lost + run.health.stale + run.health.badCrc + run.health.badFrames, 0u);
        if (looped && when.paused == 0 && when.fault > 1500)
            QVERIFY(run.totals.lastForce_us > 1000 * (when.ticks - 100));
        break;
    case FaultKind::delay: // its samples are older than was measured: a fault once they come
        QVERIFY(run.heldBack || !looped);
        QVERIFY(stopped(60));
        break;
    case FaultKind::jitter:
        QVERIFY(run.heldBack || run.faulted || !looped);
        break;
    case FaultKind::drop:
        if (fault.amount >= 1.0) {
            QVERIFY(stopped(20));
            QVERIFY(run.totals.counters.watchdog_trips == 1);
        } else if (looped) {
            QVERIFY(run.health.lost > 5 && run.totals.counters.lost_outputs > 5);
        }
        break;
    case FaultKind::duplicate:
        QVERIFY(run.health.lost == 0 && !run.faulted);
        QVERIFY(run.health.stale > 50 || !looped);
        break;
    case FaultKind::reorder:
        QVERIFY(run.health.lost >= run.health.stale && run.health.lost <= run.health.stale + 1);
        QVERIFY(!run.faulted);
        QVERIFY(run.health.stale > 30 || !looped);
        break;
    case FaultKind::corrupt:
        if (looped) {
            QVERIFY(run.health.badCrc + run.health.badFrames > 5);
            QVERIFY(run.totals.counters.bad_crc + run.totals.counters.bad_frames > 5);
        }
        break;
    case FaultKind::freeze: // the hold time goes on without the line
        QVERIFY(stopped(20));
        QVERIFY(run.totals.counters.watchdog_trips == 1);
        break;
    case FaultKind::unplug:
        QVERIFY(stopped(20));
        QVERIFY(run.health.interruptions == 1);
        break;
    case FaultKind::saturate:
        QVERIFY((run.status & core::sample_status::kSaturated) != 0 || !looped);
        break;
    case FaultKind::drift: // a tool that jumps is not believed
        QVERIFY(stopped(60));
        QVERIFY((run.status & core::sample_status::kRefused) != 0 || !looped);
        break;
    }
}

void TestStationLink::faultPlans() {
    const auto plan = station::readFaultPlan("drop:2.5:0.25");
    QVERIFY(plan && plan->kind == station::FaultKind::drop && plan->when_s == 2.5 && plan->amount == 0.25);
    const auto usual = station::readFaultPlan("freeze");
    QVERIFY(usual && usual->when_s == 1.0 && usual->amount == 100.0);
    for (const char* wrong :
         {"", "burn", "drop:", "drop:x", "drop:-1", "drop:1:", "drop:1:1.1", "drop:1:nan", "delay:1:5:2"}) {
        const auto refused = station::readFaultPlan(wrong);
        QVERIFY2(!refused && refused.error().code == core::ErrorCode::badInput, wrong);
    }
}

// By its own clock: the delay of the line is measured, never assumed, and what is stated is the larger one.
void TestStationLink::byTheClock() {
    StationBench bench(stationOn("gimbal_hprd"));
    auto made = toolAt(bench.address);
    QVERIFY(made.has_value());
    devices::StationTool& tool = stationTool(made->front());
    const std::uint32_t stated_us = tool.descriptor().oldestSample_us;
    const auto opened = tool.open();
    QVERIFY2(opened.has_value(), opened ? "" : opened.error().message.c_str());
    QVERIFY(tool.roundTrip99_us() > 0);
    QCOMPARE(tool.descriptor().oldestSample_us, std::max(stated_us, tool.roundTrip99_us()));
    QVERIFY(!tool.steppedByHost() && !tool.awaitStep());
    realtime::TickSource ticks;
    std::uint32_t packets = 0, last = 0;
    QElapsedTimer timer;
    for (timer.start(); packets <= 50 && !timer.hasExpired(kPatience_ms);) {
        const realtime::HapticTick now = ticks.next(station::steadyNow_ns());
        const core::DeviceSample sample = tool.read(now);
        packets += sample.packet != last ? 1 : 0;
        last = sample.packet;
        tool.command(now, {});
        QTest::qSleep(1);
    }
    QVERIFY(packets > 50);
    tool.close();
    const station::StationTotals totals = bench.stop();
    QVERIFY(totals.applied > 50);
    QCOMPARE(totals.lastForce_us, 0u);
    QCOMPARE(totals.counters.watchdog_trips, 0u);
}

// The view with USB devices is for the whole program, and made while it has one thread.
int main(int argc, char** argv) {
    g_hid = HidComputer::enter() && station::HidrawNode::serve(HidComputer::kFolder).has_value();
    const QCoreApplication application(argc, argv);
    TestStationLink test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_station_link.moc"
