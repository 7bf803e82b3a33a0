// SPDX-License-Identifier: GPL-3.0-or-later
// What every driver says of itself, how its counts become a tool and a wrench becomes efforts, what it
// answers to a fixed hand, and which settings it refuses in which words, against what was looked at and kept.
// Sessions are stored with these descriptors and computed again from them, so none may change unsaid. A
// change that is meant is kept anew, and its difference is read in review: CHIRON_STORE_OUTLINES=1 ctest
// --test-dir build/release -R "^test_kept_devices$"
#include "core/fp_environment.h"
#include "core/units.h"
#include "devices/drivers/endoscope_pointer/endoscope_pointer_device.h"
#include "devices/drivers/keyboard_mouse/keyboard_mouse_device.h"
#include "devices/drivers/replay/replay_device.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "devices/drivers/simulated/simulated_endoscope_device.h"
#include "devices/drivers/simulated/simulated_second_finger.h"
#include "devices/kinematics_catalogue.h"
#include "mechanisms/rotation_vector.h"
#include "support/kept_numbers.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <random>

using namespace chiron;
using namespace chiron::devices;
using core::Vec3;
using tests::NumberLines;

namespace {

const double kNaN = std::nan("");

/// Moves and turns about where it began, opens and closes, presses a button, follows what it sees and gives
/// way to what it feels.
class Wanderer final : public mechanisms::HandStrategy {
public:
    explicit Wanderer(const Vec3& start_D) : m_start_D(start_D) {}
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        const double t = seen.time_s;
        mechanisms::HandIntention wanted;
        wanted.p_DDesired =
            m_start_D + Vec3(0.01 * std::sin(4.0 * t), 0.008 * std::sin(3.0 * t), 0.006 * std::sin(2.0 * t)) +
            2e-4 * seen.f_T_D + 0.02 * seen.p_DObject + 1e-3 * seen.v_DT + 0.02 * (seen.p_DT - m_start_D);
        wanted.v_DDesired = {0.04 * std::cos(4.0 * t), 0.024 * std::cos(3.0 * t), 0.012 * std::cos(2.0 * t)};
        wanted.q_DDesired = mechanisms::turned(m_began ? m_first : seen.q_DT,
                                               Vec3(0.2 * std::sin(t), 0.1 * t, 0.1 * std::sin(2.0 * t)) +
                                                   0.5 * seen.t_T_D + 0.01 * seen.w_DT);
        if (!m_began)
            m_first = seen.q_DT;
        m_began = true;
        wanted.jaw_rad =
            0.8 + 0.5 * std::sin(6.0 * t) + (seen.fingertip ? 0.05 * seen.pad.normalForce_N : 0.0);
        wanted.buttons = t > 0.3 ? core::kButtonMark : 0u;
        return wanted;
    }

private:
    Vec3 m_start_D;
    core::Quat m_first = core::Quat::Identity();
    bool m_began = false;
};

void addDescriptor(NumberLines& lines, const DeviceDescriptor& d) {
    const auto text = [](const std::string& words) { return QString::fromStdString(words); };
    lines.add(QStringLiteral("%1; %2; %3").arg(text(d.driver), text(d.model), text(d.kinematics)));
    lines.add(QStringLiteral("kinematics"), d.kinematicsParameters);
    for (const AxisDescriptor& axis : d.axes)
        lines.add(QStringLiteral("axis %1 (%2)")
                      .arg(text(axis.id),
                           axis.unit == AxisUnit::metre ? QStringLiteral("m") : QStringLiteral("rad")),
                  {axis.resolution, axis.minimum, axis.maximum, axis.continuousRating, axis.coulombFriction,
                   axis.viscousFriction});
    lines.add(QStringLiteral("jaw"), {d.jawResolution_rad});
    lines.add(QStringLiteral("renders %1, measures %2, in process %3, felt %4")
                  .arg(d.rendersForce)
                  .arg(d.measuresForce)
                  .arg(d.inProcess)
                  .arg(d.deviceClass() == DeviceClass::felt));
    lines.add(QStringLiteral("period, most force, torque, damping, compensation"),
              {static_cast<double>(d.period_us), d.maximumForce_N, d.maximumTorque_Nm,
               d.maximumDamping_Ns_per_m, d.frictionCompensation});
}

void addVector(NumberLines& lines, const char* name, const Vec3& v) {
    lines.add(QLatin1String(name), {v.x(), v.y(), v.z()});
}

/// Tool, velocity and efforts at places all over the axes' travel.
void addKinematics(NumberLines& lines, const IDevice& device) {
    std::mt19937_64 engine(7);
    const auto between = [&](double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    };
    const auto again = makeKinematics(device.descriptor());
    QVERIFY2(again, again ? "" : again.error().message.c_str());
    for (int place = 0; place < 5; ++place) {
        core::DeviceSample sample;
        AxisValues rates{};
        const DeviceDescriptor& d = device.descriptor();
        for (std::size_t axis = 0; axis < d.axes.size(); ++axis) {
            const double middle = 0.5 * (d.axes[axis].minimum + d.axes[axis].maximum),
                         half = std::min(0.4 * (d.axes[axis].maximum - d.axes[axis].minimum), 2.0);
            sample.counts[axis] = static_cast<std::int32_t>(
                std::lround(between(middle - half, middle + half) / d.axes[axis].resolution));
            rates[axis] = between(-500.0, 500.0);
        }
        sample.jawCounts = 100 * place;
        sample.buttons = static_cast<std::uint32_t>(place);
        const core::Wrench wrench{Vec3(between(-2.0, 2.0), between(-2.0, 2.0), between(-2.0, 2.0)),
                                  Vec3(between(-0.1, 0.1), between(-0.1, 0.1), between(-0.1, 0.1))};
        const core::ToolState tool = device.kinematics().pose(sample), same = (*again)->pose(sample);
        QVERIFY(tool.p_WT == same.p_WT && tool.q_WT.coeffs() == same.q_WT.coeffs() &&
                tool.jaw_rad == same.jaw_rad);
        lines.add(QStringLiteral("place %1").arg(place));
        addVector(lines, "  tip", tool.p_WT);
        lines.add(QStringLiteral("  attitude"), {tool.q_WT.w(), tool.q_WT.x(), tool.q_WT.y(), tool.q_WT.z()});
        lines.add(QStringLiteral("  jaw, buttons"), {tool.jaw_rad, static_cast<double>(tool.buttons)});
        Vec3 v, w, vAgain, wAgain;
        device.kinematics().velocity(sample, rates, v, w);
        (*again)->velocity(sample, rates, vAgain, wAgain);
        QVERIFY(v == vAgain && w == wAgain);
        addVector(lines, "  speed", v);
        addVector(lines, "  spin", w);
        const AxisValues efforts = device.kinematics().efforts(sample, wrench);
        QVERIFY(efforts == (*again)->efforts(sample, wrench));
        lines.add(QStringLiteral("  efforts"), efforts);
    }
}

/// What devices answer to forces and pictures, block after block; all of one arm tick together. Before each
/// tick: `before`.
template <class Before>
void addTrace(NumberLines& lines, const std::vector<IDevice*>& devices, Before before) {
    constexpr int kTicks = 1000, kBlock = 125;
    realtime::TickSource source;
    std::vector<core::DeviceSample> samples(devices.size());
    std::vector<std::array<double, 16>> sums(devices.size());
    for (IDevice* device : devices)
        QVERIFY(device->open());
    for (int tick = 0; tick < kTicks; ++tick) {
        const double t = core::kTickSeconds * tick;
        before(tick);
        const auto now = source.next(1'000'000LL * tick + 5);
        ForceCommand command;
        command.enabled = tick < 600 || tick > 700;
        command.wrench_D = {
            Vec3(0.8 * std::sin(7.0 * t), 0.5 * std::cos(5.0 * t), 0.6 + 0.5 * std::sin(9.0 * t)),
            Vec3(0.02 * std::sin(6.0 * t), 0.015, 0.004 * std::cos(8.0 * t))};
        command.compensation_D = {Vec3(0.02, -0.03 * std::sin(3.0 * t), 0.01), Vec3(0.001, 0.0, -0.0005)};
        command.display = {1.0 + 0.9 * std::sin(5.0 * t), 0.2 * std::sin(4.0 * t), 0.15 * std::cos(3.0 * t)};
        core::VisibleCues cues;
        cues.objectShown = tick > 200;
        cues.p_WObject = cues.objectShown ? Vec3(0.05, 0.02, -0.01) : Vec3::Zero();
        cues.shownForce_N = tick > 500 ? 2.5 : 0.0;
        for (std::size_t i = 0; i < devices.size(); ++i) {
            const core::DeviceSample& s = samples[i] = devices[i]->read(now);
            for (std::size_t axis = 0; axis < 8; ++axis)
                sums[i][axis] += static_cast<double>(s.counts[axis]) / kBlock;
            sums[i][8] += static_cast<double>(s.jawCounts) / kBlock;
            sums[i][9] += static_cast<double>(s.buttons) / kBlock;
            for (std::size_t k = 0; k < 6; ++k)
                sums[i][10 + k] += s.measured[k] / kBlock;
        }
        for (IDevice* device : devices) {
            device->show(now, cues);
            device->command(now, command);
        }
        if ((tick + 1) % kBlock != 0)
            continue;
        for (std::size_t i = 0; i < devices.size(); ++i) {
            lines.add(QStringLiteral("device %1 after %2 ticks: packet %3, status %4, %5 us, %6 ns")
                          .arg(i)
                          .arg(tick + 1)
                          .arg(samples[i].packet)
                          .arg(samples[i].status)
                          .arg(samples[i].deviceTime_us)
                          .arg(samples[i].arrival_ns));
            lines.add(QStringLiteral("  counts"), std::span<const double>(sums[i].data(), 8));
            lines.add(QStringLiteral("  jaw, buttons"), {sums[i][8], sums[i][9]});
            lines.add(QStringLiteral("  measured"), std::span<const double>(sums[i].data() + 10, 6));
            sums[i] = {};
        }
    }
    // Afresh: as at the first opening.
    for (IDevice* device : devices) {
        device->close();
        QVERIFY(device->open());
        const core::DeviceSample s = device->read(source.next(0));
        std::vector<double> counts(s.counts.begin(), s.counts.end());
        lines.add(QStringLiteral("opened again, %1, %2, %3").arg(s.jawCounts).arg(s.buttons).arg(s.status),
                  counts);
    }
}

WorkspaceMapping turnedMapping() {
    WorkspaceMapping mapping;
    mapping.origin_m = {0.01, -0.02, 0.03};
    mapping.scale = 1.5;
    mapping.leftHanded = true;
    const core::Quat q = mechanisms::turned(core::Quat::Identity(), {0.1, 0.2, -0.3});
    mapping.q_WD = {q.w(), q.x(), q.y(), q.z()};
    return mapping;
}

template <class Made> QString taken(const Made& made) {
    return made ? QStringLiteral("taken") : QString::fromStdString(made.error().message);
}

} // namespace

class TestKeptDevices : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void gimbals();
    void endoscope();
    void fingers();
    void pointers();
    void endoscopePointers();
    void traces();
    void descriptorsThatAreRefused();
    void settingsThatAreRefused();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const NumberLines& lines) {
        const QString differs = m_kept.differs(name, lines.lines());
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    template <class Before>
    void hold(const QString& name, const std::vector<IDevice*>& devices, Before before) {
        NumberLines lines;
        for (const IDevice* device : devices) {
            addDescriptor(lines, device->descriptor());
            addKinematics(lines, *device);
        }
        addTrace(lines, devices, before);
        hold(name, lines);
    }
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/devices/kept_devices.txt"),
                           &tests::sameNumbers};
};

void TestKeptDevices::gimbals() {
    SimulatedDevice::Configuration probe;
    SimulatedDevice::Configuration grasper;
    grasper.jaw = mechanisms::JawParameters{};
    grasper.map = mechanisms::PolarMap::asPublished;
    grasper.mapping = turnedMapping();
    grasper.frictionCompensation = 0.6;
    grasper.plant.sampleDelay_ticks = 1;
    grasper.start_D = {0.02, 0.01, 0.03};
    grasper.seed = 4;
    for (const auto& [name, configuration] : {std::pair{"probe", probe}, std::pair{"grasper", grasper}}) {
        auto device =
            SimulatedDevice::create(configuration, std::make_unique<Wanderer>(configuration.start_D));
        QVERIFY2(device, device ? "" : device.error().message.c_str());
        hold(QString::fromLatin1(name), {device->get()}, [](int) {});
    }
}

void TestKeptDevices::endoscope() {
    SimulatedEndoscopeDevice::Configuration configuration;
    configuration.startAngles = {0.1, -0.05, 0.3};
    configuration.mapping = turnedMapping();
    auto device =
        SimulatedEndoscopeDevice::create(configuration, std::make_unique<Wanderer>(configuration.start_D));
    QVERIFY2(device, device ? "" : device.error().message.c_str());
    hold(QStringLiteral("endoscope"), {device->get()}, [](int) {});
}

void TestKeptDevices::fingers() {
    SimulatedFingertipDevice::Configuration configuration;
    configuration.mapping = turnedMapping();
    configuration.start_D = {0.02, -0.03, 0.06};
    auto first =
        SimulatedFingertipDevice::create(configuration, std::make_unique<Wanderer>(configuration.start_D));
    QVERIFY2(first, first ? "" : first.error().message.c_str());
    auto second = SimulatedSecondFinger::create(**first, {0.018, 0.002, -0.001}, 9,
                                                std::make_unique<Wanderer>(configuration.start_D));
    QVERIFY2(second, second ? "" : second.error().message.c_str());
    hold(QStringLiteral("two fingers"), {first->get(), second->get()}, [](int) {});
}

void TestKeptDevices::pointers() {
    KeyboardMouseSettings grasper;
    grasper.widestJaw_rad = 1.2;
    grasper.homeJaw_rad = 0.4;
    grasper.following_s = 0.02;
    grasper.pseudoHaptics.slowestRatio = 0.5;
    for (const auto& [name, settings] :
         {std::pair{"pointer", KeyboardMouseSettings{}}, std::pair{"pointer with a grasper", grasper}}) {
        auto device = KeyboardMouseDevice::create(settings);
        QVERIFY(device);
        PointerMailbox& box = (*device)->mailbox();
        hold(QString::fromLatin1(name), {device->get()}, [&box](int tick) {
            if (tick % 16 == 0)
                box.move(1e-4 * std::sin(0.01 * tick), 2e-4, -3e-4);
            if (tick % 100 == 0) {
                box.setRate(0.05 * std::cos(0.01 * tick), -0.02, tick > 400 ? 0.1 : 0.0);
                box.setJawRate(tick < 500 ? 2.0 : -3.0);
            }
            if (tick % 250 == 20)
                box.press(core::kButtonMark);
            if (tick % 250 == 60)
                box.release(core::kButtonMark);
            if (tick == 333) {
                box.press(core::kButtonStop);
                box.release(core::kButtonStop);
            }
            if (tick == 444)
                box.move(std::nan(""), 1.0, 1.0);
        });
    }
}

void TestKeptDevices::endoscopePointers() {
    EndoscopePointerSettings free;
    free.planar = false;
    free.following_s = 0.05;
    for (const auto& [name, settings] : {std::pair{"endoscope by pointer", EndoscopePointerSettings{}},
                                         std::pair{"endoscope by pointer, flying", free}}) {
        auto device = EndoscopePointerDevice::create(settings);
        QVERIFY(device);
        EndoscopeMailbox& box = (*device)->mailbox();
        hold(QString::fromLatin1(name), {device->get()}, [&box](int tick) {
            if (tick % 20 == 0)
                box.move({1e-3, 2e-4, -1e-4, 0.01 * std::sin(0.02 * tick), 0.008, 0.02});
            if (tick % 100 == 0)
                box.setRate({0.05, 0.0, 0.02, 0.1 * std::cos(0.01 * tick), -0.2, 0.3});
            if (tick == 200)
                box.press(core::kButtonMark);
            if (tick == 260)
                box.release(core::kButtonMark);
        });
    }
}

void TestKeptDevices::traces() {
    for (const bool turns : {false, true}) {
        std::vector<TracePoint> trace;
        for (int row = 0; row < 180; ++row) {
            TracePoint point;
            point.t_s = 3.0 + 0.0041 * row;
            point.p_WT_m = {0.01 * std::sin(0.05 * row), -0.02, 1e-4 * row};
            if (turns)
                point.q_WT =
                    mechanisms::turned(core::Quat::Identity(), {0.05 * row, 0.3, 0.0}); // more than a turn
            point.jaw_rad = 0.5 + 0.3 * std::sin(0.1 * row);
            point.buttons = row % 40 == 7 ? core::kButtonMark : 0u;
            trace.push_back(point);
        }
        auto device = ReplayDevice::create(trace);
        QVERIFY(device);
        hold(turns ? QStringLiteral("trace that turns") : QStringLiteral("trace"), {device->get()},
             [](int) {});
        QCOMPARE((*device)->ticks(), std::size_t(734)); // 179 rows of 4.1 ms, and the first
    }
}

/// Descriptors that a stored session could hold and that make no kinematics.
void TestKeptDevices::descriptorsThatAreRefused() {
    NumberLines lines;
    std::vector<std::pair<QString, DeviceDescriptor>> sound;
    auto probe = SimulatedDevice::create({}, std::make_unique<Wanderer>(Vec3(0.0, 0.0, 0.05)));
    auto endoscope = SimulatedEndoscopeDevice::create({}, std::make_unique<Wanderer>(Vec3(0.0, -0.069, 0.0)));
    auto finger = SimulatedFingertipDevice::create({}, std::make_unique<Wanderer>(Vec3(0.0, 0.0, 0.05)));
    sound.emplace_back(QStringLiteral("gimbal"), (*probe)->descriptor());
    sound.emplace_back(QStringLiteral("five-bar linkage"), (*endoscope)->descriptor());
    sound.emplace_back(QStringLiteral("finger"), (*finger)->descriptor());
    sound.emplace_back(QStringLiteral("pointer"), (*KeyboardMouseDevice::create())->descriptor());
    sound.emplace_back(QStringLiteral("endoscope by pointer"),
                       (*EndoscopePointerDevice::create())->descriptor());
    sound.emplace_back(QStringLiteral("trace that turns"),
                       (*ReplayDevice::create({{.q_WT = core::Quat::Identity()}}))->descriptor());
    DeviceDescriptor sliding = (*finger)->descriptor();
    for (std::size_t axis = 0; axis < 3; ++axis)
        sliding.axes[axis].unit = AxisUnit::metre;
    sliding.kinematicsParameters = {0.01, 0.0, 0.0};
    sound.emplace_back(QStringLiteral("sliding finger"), sliding);
    for (const auto& [name, d] : sound) {
        const auto say = [&](const QString& what, const DeviceDescriptor& changed) {
            lines.add(QStringLiteral("%1, %2: %3").arg(name, what, taken(makeKinematics(changed))));
        };
        say(QStringLiteral("as it is"), d);
        DeviceDescriptor other = d;
        other.kinematics = "wheel";
        say(QStringLiteral("of another kind"), other);
        other = d;
        other.axes.pop_back();
        say(QStringLiteral("an axis less"), other);
        other = d;
        other.axes.push_back(other.axes.back());
        say(QStringLiteral("an axis more"), other);
        for (std::size_t axis = 0; axis < d.axes.size(); ++axis) {
            other = d;
            other.axes[axis].unit = d.axes[axis].unit == AxisUnit::metre ? AxisUnit::radian : AxisUnit::metre;
            say(QStringLiteral("axis %1 in another unit").arg(axis), other);
            for (const double resolution : {0.0, -1e-6, kNaN, std::numeric_limits<double>::infinity()}) {
                other = d;
                other.axes[axis].resolution = resolution;
                say(QStringLiteral("axis %1 with a resolution of %2").arg(axis).arg(resolution), other);
            }
        }
        for (std::size_t i = 0; i < d.kinematicsParameters.size(); ++i)
            for (const double value : {0.0, 0.5, -0.1, kNaN}) {
                other = d;
                other.kinematicsParameters[i] = value;
                say(QStringLiteral("parameter %1 of %2").arg(i).arg(value), other);
            }
        other = d;
        other.kinematicsParameters.push_back(0.1);
        say(QStringLiteral("a parameter more"), other);
        if (!d.kinematicsParameters.empty()) {
            other = d;
            other.kinematicsParameters.pop_back();
            say(QStringLiteral("a parameter less"), other);
        }
    }
    hold(QStringLiteral("descriptors"), lines);
}

void TestKeptDevices::settingsThatAreRefused() {
    NumberLines lines;
    const auto probe = [&](const QString& what, auto change, bool mind = true) {
        SimulatedDevice::Configuration c;
        change(c);
        lines.add(QStringLiteral("probe, %1: %2")
                      .arg(what, taken(SimulatedDevice::create(c, mind ? std::make_unique<Wanderer>(c.start_D)
                                                                       : nullptr))));
    };
    probe(
        QStringLiteral("without a hand"), [](auto&) {}, false);
    for (const Vec3& start :
         {Vec3(0.0, 0.0, 0.2), Vec3(0.3, 0.0, 0.0), Vec3(0.0, 0.3, 0.0), Vec3(0.0, 0.0, 0.101),
          Vec3(0.0, 0.0, 0.099), Vec3(0.0, 0.0, -0.141), Vec3(0.0, 0.0, -0.139)})
        probe(QStringLiteral("from %1 %2 %3").arg(start.x()).arg(start.y()).arg(start.z()),
              [&](auto& c) { c.start_D = start; });
    using mechanisms::JawParameters;
    for (const JawParameters& jaw :
         {JawParameters{.widest_rad = 0.0}, JawParameters{.widest_rad = 3.1416},
          JawParameters{.widest_rad = 3.1417}, JawParameters{.steps = 0}, JawParameters{.steps = 1},
          JawParameters{.fingerLag_s = 0.0}, JawParameters{.fingerSpeed_rad_per_s = 0.0}})
        probe(QStringLiteral("a jaw of %1 in %2, %3, %4")
                  .arg(jaw.widest_rad)
                  .arg(jaw.steps)
                  .arg(jaw.fingerLag_s)
                  .arg(jaw.fingerSpeed_rad_per_s),
              [&](auto& c) { c.jaw = jaw; });
    for (const double share : {-0.1, 0.8, 0.81})
        probe(QStringLiteral("compensates %1").arg(share), [&](auto& c) { c.frictionCompensation = share; });

    const auto endoscope = [&](const QString& what, auto change, bool mind = true) {
        SimulatedEndoscopeDevice::Configuration c;
        change(c);
        lines.add(QStringLiteral("endoscope, %1: %2")
                      .arg(what, taken(SimulatedEndoscopeDevice::create(
                                     c, mind ? std::make_unique<Wanderer>(c.start_D) : nullptr))));
    };
    endoscope(
        QStringLiteral("without a hand"), [](auto&) {}, false);
    endoscope(QStringLiteral("out of reach"), [](auto& c) { c.start_D = {0.0, 0.5, 0.0}; });
    endoscope(QStringLiteral("beside its plane"), [](auto& c) { c.start_D = {0.3, -0.069, 0.0}; });
    for (const double angle_deg : {-30.1, -29.9, 29.9, 30.1, 96.2, 96.4})
        endoscope(QStringLiteral("pitched and yawed by %1°").arg(angle_deg), [&](auto& c) {
            c.startAngles = {core::radFromDeg(angle_deg),
                             angle_deg > 0.0 && angle_deg < 31.0 ? core::radFromDeg(angle_deg) : 0.0, 0.0};
        });
    endoscope(QStringLiteral("spun too far"), [](auto& c) { c.startAngles.roll = 3.2; });

    const auto finger = [&](const QString& what, auto change, bool mind = true) {
        SimulatedFingertipDevice::Configuration c;
        change(c);
        lines.add(QStringLiteral("finger, %1: %2")
                      .arg(what, taken(SimulatedFingertipDevice::create(
                                     c, mind ? std::make_unique<Wanderer>(c.start_D) : nullptr))));
    };
    finger(
        QStringLiteral("without a hand"), [](auto&) {}, false);
    double mechanisms::FingertipArmParameters::*const lengths[] = {
        &mechanisms::FingertipArmParameters::handleMass_kg,
        &mechanisms::FingertipArmParameters::handleRadius_m,
        &mechanisms::FingertipArmParameters::ringMass_kg,
        &mechanisms::FingertipArmParameters::ringRadius_m,
        &mechanisms::FingertipArmParameters::leverMass_kg,
        &mechanisms::FingertipArmParameters::leverLength_m,
        &mechanisms::FingertipArmParameters::columnInertia_kgm2};
    for (const auto length : lengths)
        for (const double value : {0.0, kNaN, std::numeric_limits<double>::infinity()})
            finger(QStringLiteral("a length or mass of %1").arg(value),
                   [&](auto& c) { c.arm.*length = value; });
    finger(QStringLiteral("an upper arm of 0"), [](auto& c) { c.arm.geometry.upper_m = 0.0; });
    finger(QStringLiteral("a forearm of 0"), [](auto& c) { c.arm.geometry.fore_m = 0.0; });
    finger(QStringLiteral("an attitude without counts"), [](auto& c) { c.arm.imu.resolution_rad = 0.0; });
    finger(QStringLiteral("a jaw that does not open"), [](auto& c) { c.arm.grasp.widest_rad = 0.0; });
    for (const int bits : {7, 8, 26, 27})
        finger(QStringLiteral("encoders of %1 bits").arg(bits), [&](auto& c) { c.arm.encoderBits = bits; });
    for (const Vec3& start : {Vec3(0.0, 0.6, 0.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 0.34, 0.3),
                              Vec3(0.0, 0.3, 0.2), Vec3(kNaN, 0.0, 0.0)})
        finger(QStringLiteral("from %1 %2 %3").arg(start.x()).arg(start.y()).arg(start.z()),
               [&](auto& c) { c.start_D = start; });
    finger(QStringLiteral("nobody's"), [](auto& c) { c.platform.pad.surface_m = 0.02; });
    auto first = SimulatedFingertipDevice::create({}, std::make_unique<Wanderer>(Vec3(0.0, 0.0, 0.05)));
    for (const double apart_m : {0.0, 0.2, 0.201})
        lines.add(
            QStringLiteral("a finger %1 m away: %2")
                .arg(apart_m)
                .arg(taken(SimulatedSecondFinger::create(**first, {apart_m, 0.0, 0.0}, 1,
                                                         std::make_unique<Wanderer>(Vec3(0.0, 0.0, 0.05))))));
    lines.add(QStringLiteral("a finger of nobody: %1")
                  .arg(taken(SimulatedSecondFinger::create(**first, {0.02, 0.0, 0.0}, 1, nullptr))));

    const auto pointer = [&](const QString& what, auto change) {
        KeyboardMouseSettings s;
        change(s);
        lines.add(QStringLiteral("pointer, %1: %2").arg(what, taken(KeyboardMouseDevice::create(s))));
    };
    const auto endoscopePointer = [&](const QString& what, auto change) {
        EndoscopePointerSettings s;
        change(s);
        lines.add(QStringLiteral("endoscope by pointer, %1: %2")
                      .arg(what, taken(EndoscopePointerDevice::create(s))));
    };
    const auto both = [&](const QString& what, auto change) {
        pointer(what, change);
        endoscopePointer(what, change);
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        both(QStringLiteral("home at the start of %1").arg(axis),
             [&](auto& s) { s.minimum_m[axis] = s.home_m[axis]; });
        both(QStringLiteral("home at the end of %1").arg(axis),
             [&](auto& s) { s.maximum_m[axis] = s.home_m[axis]; });
        for (const double end : {1.0, 1.001}) {
            both(QStringLiteral("%1 from %2").arg(axis).arg(-end),
                 [&](auto& s) { s.minimum_m[axis] = -end; });
            both(QStringLiteral("%1 to %2").arg(axis).arg(end), [&](auto& s) { s.maximum_m[axis] = end; });
        }
        endoscopePointer(QStringLiteral("home at the start of turn %1").arg(axis),
                         [&](auto& s) { s.minimum_rad[axis] = s.home_rad[axis]; });
        endoscopePointer(QStringLiteral("home at the end of turn %1").arg(axis),
                         [&](auto& s) { s.maximum_rad[axis] = s.home_rad[axis]; });
        for (const double end : {1.3962, 1.3964, 6.3, 6.31}) {
            endoscopePointer(QStringLiteral("turn %1 from %2").arg(axis).arg(-end),
                             [&](auto& s) { s.minimum_rad[axis] = -end; });
            endoscopePointer(QStringLiteral("turn %1 to %2").arg(axis).arg(end),
                             [&](auto& s) { s.maximum_rad[axis] = end; });
        }
    }
    for (const auto& [home, widest] : {std::pair{-0.01, 1.0}, std::pair{0.0, 0.0}, std::pair{1.0, 1.0},
                                       std::pair{1.01, 1.0}, std::pair{0.5, 1.6}, std::pair{0.5, 1.601}})
        pointer(QStringLiteral("a jaw of %1 to %2").arg(home).arg(widest),
                [&, home = home, widest = widest](auto& s) {
                    s.homeJaw_rad = home;
                    s.widestJaw_rad = widest;
                });
    for (const double x : {0.0, 1.0, 1.001})
        both(QStringLiteral("slowest %1").arg(x), [&](auto& s) { s.pseudoHaptics.slowestRatio = x; });
    for (const double x : {0.0, 100.0, 100.1})
        both(QStringLiteral("slowest at %1").arg(x), [&](auto& s) { s.pseudoHaptics.slowestAt_N = x; });
    for (const double x : {-0.001, 0.0, 0.2, 0.201})
        both(QStringLiteral("follows in %1").arg(x), [&](auto& s) { s.following_s = x; });

    const auto trace = [&](const QString& what, auto change) {
        std::vector<TracePoint> rows(3);
        for (std::size_t row = 0; row < rows.size(); ++row) {
            rows[row].t_s = 0.5 + 0.1 * static_cast<double>(row);
            rows[row].q_WT = core::Quat::Identity();
        }
        change(rows);
        lines.add(QStringLiteral("trace, %1: %2").arg(what, taken(ReplayDevice::create(rows))));
    };
    trace(QStringLiteral("as it is"), [](auto&) {});
    trace(QStringLiteral("without rows"), [](auto& rows) { rows.clear(); });
    trace(QStringLiteral("at no time"), [](auto& rows) { rows[1].t_s = kNaN; });
    trace(QStringLiteral("twice at a time"), [](auto& rows) { rows[2].t_s = rows[1].t_s; });
    trace(QStringLiteral("backwards"), [](auto& rows) { rows[1].t_s = 0.4; });
    trace(QStringLiteral("too long"), [](auto& rows) { rows[2].t_s = 0.5 + 4.0 * 3600.0 + 0.001; });
    trace(QStringLiteral("nowhere"), [](auto& rows) { rows[0].p_WT_m.y() = kNaN; });
    trace(QStringLiteral("10 m away"), [](auto& rows) { rows[0].p_WT_m.z() = -10.0; });
    trace(QStringLiteral("farther away"), [](auto& rows) { rows[0].p_WT_m.z() = -10.001; });
    trace(QStringLiteral("a jaw of a turn"), [](auto& rows) { rows[2].jaw_rad = -6.283; });
    trace(QStringLiteral("a jaw of more"), [](auto& rows) { rows[2].jaw_rad = 6.284; });
    trace(QStringLiteral("an attitude missing"), [](auto& rows) { rows[1].q_WT.reset(); });
    trace(QStringLiteral("an attitude too many"), [](auto& rows) { rows[0].q_WT.reset(); });
    trace(QStringLiteral("almost a unit"),
          [](auto& rows) { rows[1].q_WT = core::Quat(1.0099, 0.0, 0.0, 0.0); });
    trace(QStringLiteral("no unit"), [](auto& rows) { rows[1].q_WT = core::Quat(0.9899, 0.0, 0.0, 0.0); });
    hold(QStringLiteral("settings"), lines);
}

QTEST_APPLESS_MAIN(TestKeptDevices)
#include "test_kept_devices.moc"
