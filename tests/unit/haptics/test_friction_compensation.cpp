// SPDX-License-Identifier: GPL-3.0-or-later
// Feed-forward of the gimbal's friction: less than what is there, nothing at rest, never a source of energy,
// and within the supervisor.
#include "core/random.h"
#include "core/units.h"
#include "devices/drivers/simulated/simulated_device.h"
#include "haptics/friction_compensation.h"
#include "haptics/haptic_loop.h"
#include "haptics/live_inputs.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>

using namespace chiron;
using core::Vec3;
using devices::AxisValues;
using haptics::FrictionCompensation;

namespace {

/// A hand that wanders: sums of sines of drawn frequencies, up to 0.1 m/s, with rests between.
class Wandering final : public mechanisms::HandStrategy {
public:
    explicit Wandering(std::uint64_t seed, bool rests = false) : m_rests(rests) {
        core::Random random(seed);
        for (Term& term : m_terms)
            term = {Vec3(random.uniform(-0.012, 0.012), random.uniform(-0.012, 0.012),
                         random.uniform(-0.012, 0.012)),
                    random.uniform(0.05, 0.8), random.uniform(0.0, 6.0)};
    }
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = Vec3(0.0, 0.0, 0.05);
        force_D = seen.f_T_D;
        const double rise = m_rests ? 0.0 : std::clamp(seen.time_s - 3.0, 0.0, 1.0);
        const bool pauses = std::fmod(seen.time_s, 5.0) > 4.0;
        m_time_s += pauses ? 0.0 : core::kTickSeconds;
        for (const Term& term : m_terms)
            wanted.p_DDesired += rise * term.amplitude_m *
                                 std::sin(2.0 * core::kPi * term.frequency_Hz * m_time_s + term.phase);
        return wanted;
    }
    Vec3 force_D = Vec3::Zero(); ///< on the hand, mean over the last tick

private:
    struct Term {
        Vec3 amplitude_m = Vec3::Zero();
        double frequency_Hz = 0.0, phase = 0.0;
    };
    std::array<Term, 4> m_terms;
    double m_time_s = 0.0;
    bool m_rests;
};

class FreeAir final : public simulation::IScene {
public:
    void respond(const realtime::HapticTick&, const simulation::SceneInput& in,
                 simulation::SceneOutput& out) noexcept override {
        out = simulation::SceneOutput{};
        out.tissue.count = in.tools.count;
        out.phase = core::TrialPhase::running;
    }
};

/// The device with another descriptor, and what it is commanded.
class Listening final : public devices::IDevice {
public:
    Listening(std::unique_ptr<devices::SimulatedDevice> device, double times)
        : m_device(std::move(device)), m_descriptor(m_device->descriptor()) {
        for (auto& axis : m_descriptor.axes)
            axis.coulombFriction *= times;
    }
    const devices::DeviceDescriptor& descriptor() const noexcept override { return m_descriptor; }
    const devices::IToolKinematics& kinematics() const noexcept override { return m_device->kinematics(); }
    core::Result<void> open() override { return m_device->open(); }
    void close() noexcept override { m_device->close(); }
    core::DeviceSample read(const realtime::HapticTick& now) noexcept override { return m_device->read(now); }
    void command(const realtime::HapticTick& now, const devices::ForceCommand& command) noexcept override {
        last = command;
        m_device->command(now, command);
    }
    const mechanisms::GimbalPlant& plant() const { return m_device->plant(); }
    devices::ForceCommand last;

private:
    std::unique_ptr<devices::SimulatedDevice> m_device;
    devices::DeviceDescriptor m_descriptor;
};

class Frames final : public core::IFrameSink {
public:
    bool tryPush(const core::HapticFrame& frame) noexcept override {
        last = frame;
        return true;
    }
    core::HapticFrame last;
};

struct Outcome {
    double least_J = 0.0; ///< what the hand has put in less what moves, at any time: below 0, energy was made
    double drop_J = 0.0;  ///< its largest fall from what it had been
    double taken_J = 0.0; ///< the same at the end: what friction took less what the compensation gave
    double most_N = 0.0;  ///< compensation, at the tip
    double commanded_N = 0.0, measured_N = 0.0; ///< recorded; nothing is touched
    bool early = false;                         ///< compensated while force was off
    bool apart = false; ///< what the device gets is not what is rendered and the compensation
};

/// `times`: the friction that the descriptor states, of what was identified. W is D.
Outcome run(const mechanisms::HandParameters& hand, double share, double times, std::uint64_t seed,
            bool rests = false, double seconds = 30.0) {
    devices::SimulatedDevice::Configuration configuration;
    configuration.hand = hand;
    configuration.frictionCompensation = share;
    configuration.seed = seed;
    auto mind = std::make_unique<Wandering>(seed, rests);
    const Wandering& felt = *mind;
    Listening device(std::move(*devices::SimulatedDevice::create(configuration, std::move(mind))), times);
    (void)device.open();
    Frames frames;
    haptics::LiveInputs inputs;
    haptics::SafetySupervisor supervisor;
    haptics::SceneExchange scenes;
    std::unique_ptr<simulation::IScene> scene = std::make_unique<FreeAir>();
    scenes.offer(scene);
    const std::array<haptics::LoopTool, 1> tools{haptics::LoopTool{device, {}}};
    auto loop = std::move(*haptics::HapticLoop::create({tools, inputs, supervisor, {}, scenes, frames}));
    inputs.post({core::CommandKind::start});
    realtime::TickSource ticks;
    Outcome outcome;
    Vec3 before = device.plant().p_DT(), moved = Vec3::Zero();
    double put_J = 0.0, moving_J = 0.0, most_J = 0.0;
    for (std::int64_t n = 0; n < static_cast<std::int64_t>(1000.0 * seconds); ++n) {
        (void)loop->tick(ticks.next(n * 1'000'000));
        // The mind is told of the force of the tick before, in which the tool moved by `moved`.
        put_J -= felt.force_D.dot(moved);
        const double margin = put_J - moving_J;
        most_J = std::max(most_J, margin);
        outcome.least_J = std::min(outcome.least_J, margin);
        outcome.drop_J = std::max(outcome.drop_J, most_J - margin);
        outcome.taken_J = margin;
        const mechanisms::GimbalPlant& plant = device.plant();
        moved = plant.p_DT() - before;
        before = plant.p_DT();
        moving_J = 0.5 * plant.rates().dot(plant.inertia(plant.q()).cwiseProduct(plant.rates()));
        const auto& tool = frames.last.tool[0];
        const Vec3 help = device.last.compensation_D.force,
                   commanded(tool.commanded[0], tool.commanded[1], tool.commanded[2]);
        outcome.most_N = std::max(outcome.most_N, help.norm());
        outcome.commanded_N = std::max(outcome.commanded_N, commanded.norm());
        outcome.measured_N =
            std::max(outcome.measured_N, std::hypot(tool.measured[0], tool.measured[1], tool.measured[2]));
        outcome.early =
            outcome.early || (frames.last.header.force == core::ForceState::off && help != Vec3::Zero());
        outcome.apart = outcome.apart || (device.last.wrench_D.force - help - commanded).norm() > 1e-12;
    }
    return outcome;
}

constexpr double kBooks_J =
    1e-4; ///< what the sums err by: forces are means of a tick; and the bristles' 10 µJ

/// Of hands that nobody chose; CHIRON_FRICTION_SEED repeats one.
std::uint64_t drawnSeed() {
    bool given = false;
    const std::uint64_t seed = qEnvironmentVariable("CHIRON_FRICTION_SEED").toULongLong(&given);
    return given ? seed : 1 + std::random_device{}() % 1000000;
}

} // namespace

class TestFrictionCompensation : public QObject {
    Q_OBJECT
private slots:
    void effortsAreBounded();
    void theWrenchGivesTheEfforts();
    void nothingWithoutASetting();
    void neverMakesEnergy_data();
    void neverMakesEnergy();
    void helps();
    void tooMuchWouldMakeEnergy();
    void aStillHandIsLeftAlone();
    void isNoTissueForce();
};

namespace {

devices::DeviceDescriptor identified(double share) {
    devices::SimulatedDevice::Configuration configuration;
    configuration.frictionCompensation = share;
    return (*devices::SimulatedDevice::create(configuration, std::make_unique<Wandering>(1)))->descriptor();
}

} // namespace

void TestFrictionCompensation::effortsAreBounded() {
    for (const double share : {0.3, 0.8, 1.0}) {
        devices::DeviceDescriptor device = identified(std::min(share, 0.8));
        device.frictionCompensation = share; // if a descriptor states more than 0.8, it gets 0.8
        const FrictionCompensation compensation(device);
        QVERIFY(compensation.active());
        for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{3}}) {
            const devices::AxisDescriptor& of = device.axes[axis];
            const double most = std::min(share, 0.8) * of.coulombFriction;
            QVERIFY(of.coulombFriction > 0.0 && of.viscousFriction > 0.0);
            double before = 0.0, beforeSpeed = 0.0;
            for (double counts = 0.0; counts < 5e4; counts += 50.0) { // a second
                AxisValues rates{};
                rates[axis] = counts;
                const double forwards = compensation.efforts(rates)[axis];
                rates[axis] = -counts;
                QCOMPARE(compensation.efforts(rates)[axis], -forwards);
                const double speed = counts * of.resolution;
                if (counts * 0.015 <= 2.0)
                    QCOMPARE(forwards, 0.0);
                QVERIFY(forwards <= most * (1.0 + 1e-12) && forwards >= before);
                QVERIFY(forwards - before <= 4.0 * of.viscousFriction * (speed - beforeSpeed) * (1.0 + 1e-9));
                before = forwards;
                beforeSpeed = speed;
            }
            QVERIFY(std::abs(before - most) < 1e-12); // all of it in fast motion
        }
    }
}

void TestFrictionCompensation::theWrenchGivesTheEfforts() {
    devices::SimulatedDevice::Configuration configuration;
    configuration.frictionCompensation = 0.8;
    const auto device =
        std::move(*devices::SimulatedDevice::create(configuration, std::make_unique<Wandering>(1)));
    const FrictionCompensation compensation(device->descriptor());
    core::Random random(3);
    for (int n = 0; n < 500; ++n) {
        core::DeviceSample sample;
        AxisValues rates{};
        for (std::size_t axis = 0; axis < 4; ++axis) {
            const devices::AxisDescriptor& of = device->descriptor().axes[axis];
            sample.counts[axis] =
                static_cast<std::int32_t>(random.uniform(of.minimum, of.maximum) / of.resolution);
            rates[axis] = random.uniform(-2e4, 2e4);
        }
        const AxisValues wanted = compensation.efforts(rates);
        const core::Wrench wrench = compensation.wrench_D(device->kinematics(), sample, rates);
        QCOMPARE(wrench.torque, Vec3(Vec3::Zero())); // the gimbal gives none
        const AxisValues given = device->kinematics().efforts(sample, wrench);
        for (const std::size_t axis : {std::size_t{0}, std::size_t{1}, std::size_t{3}})
            QVERIFY2(std::abs(given[axis] - wanted[axis]) < 1e-6 * (1.0 + std::abs(wanted[axis])),
                     qPrintable(QString::number(given[axis] - wanted[axis])));
    }
}

void TestFrictionCompensation::nothingWithoutASetting() {
    QVERIFY(!FrictionCompensation(identified(0.0)).active());
    devices::DeviceDescriptor unknown = identified(0.8);
    for (auto& axis : unknown.axes)
        axis.coulombFriction = 0.0; // never identified
    QVERIFY(!FrictionCompensation(unknown).active());
    devices::DeviceDescriptor shown = identified(0.8);
    shown.rendersForce = false;
    QVERIFY(!FrictionCompensation(shown).active());
}

void TestFrictionCompensation::neverMakesEnergy_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"default", "light", "firm"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestFrictionCompensation::neverMakesEnergy() {
    QFETCH(QString, name);
    const mechanisms::HandParameters hand =
        name == QLatin1String("light")  ? mechanisms::HandParameters::light()
        : name == QLatin1String("firm") ? mechanisms::HandParameters::firm()
                                        : mechanisms::HandParameters{};
    const std::uint64_t first = drawnSeed();
    for (const std::uint64_t seed : {std::uint64_t{11}, std::uint64_t{12}, first}) {
        const Outcome with = run(hand, 0.8, 1.0, seed);
        // Friction that has become a tenth less than what was identified is still more than the help.
        const Outcome worn = run(hand, 0.8, 1.0 / 0.9, seed);
        const QString found =
            QStringLiteral("%1, seed %2 (CHIRON_FRICTION_SEED repeats it): with the compensation friction "
                           "takes %3 mJ, worn %4 mJ; largest fall %5 and %6 mJ; at most %7 N")
                .arg(name)
                .arg(seed)
                .arg(1e3 * with.taken_J, 0, 'f', 1)
                .arg(1e3 * worn.taken_J, 0, 'f', 1)
                .arg(1e3 * with.drop_J, 0, 'f', 3)
                .arg(1e3 * worn.drop_J, 0, 'f', 3)
                .arg(with.most_N, 0, 'f', 3);
        qInfo("%s", qPrintable(found));
        QVERIFY2(with.taken_J > 0.0 && with.least_J > -kBooks_J && with.drop_J < kBooks_J, qPrintable(found));
        QVERIFY2(worn.least_J > -kBooks_J && worn.drop_J < kBooks_J, qPrintable(found));
    }
}

/// By how much depends on how fast the hand moves, so with seeds that stay the same.
void TestFrictionCompensation::helps() {
    for (const mechanisms::HandParameters& hand :
         {mechanisms::HandParameters{}, mechanisms::HandParameters::light(),
          mechanisms::HandParameters::firm()})
        for (const std::uint64_t seed : {std::uint64_t{11}, std::uint64_t{12}}) {
            const Outcome without = run(hand, 0.0, 1.0, seed), with = run(hand, 0.8, 1.0, seed);
            qInfo("friction takes %.1f mJ, with the compensation %.1f mJ", 1e3 * without.taken_J,
                  1e3 * with.taken_J);
            QVERIFY(with.taken_J > 0.0 && with.taken_J < 0.75 * without.taken_J);
        }
}

/// The books can tell: friction stated four times as large as it is, so that the help is three times it.
void TestFrictionCompensation::tooMuchWouldMakeEnergy() {
    const Outcome outcome = run({}, 0.8, 4.0, 11);
    QVERIFY2(outcome.drop_J > 5.0 * kBooks_J, qPrintable(QString::number(outcome.drop_J)));
}

void TestFrictionCompensation::aStillHandIsLeftAlone() {
    const Outcome outcome = run({}, 0.8, 1.0, 4, true, 10.0); // trembling, 8 to 12 Hz
    mechanisms::HandParameters calm;
    calm.tremorRms_m = 0.0;
    const Outcome still = run(calm, 0.8, 1.0, 4, true, 10.0);
    QCOMPARE(still.most_N, 0.0);
    QVERIFY(outcome.drop_J < kBooks_J && outcome.least_J > -kBooks_J);
}

void TestFrictionCompensation::isNoTissueForce() {
    const Outcome outcome = run({}, 0.8, 1.0, 7);
    QVERIFY(outcome.most_N > 0.05 && outcome.most_N < 0.3);
    QCOMPARE(outcome.commanded_N, 0.0); // nothing is touched: nothing is recorded as rendered
    QVERIFY2(outcome.measured_N < 0.1,
             qPrintable(QString::number(outcome.measured_N))); // an amplifier's lag of it at turns
    QVERIFY(!outcome.early && !outcome.apart);
}

QTEST_APPLESS_MAIN(TestFrictionCompensation)
#include "test_friction_compensation.moc"
