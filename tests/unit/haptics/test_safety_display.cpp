// SPDX-License-Identifier: GPL-3.0-or-later
// What a fingertip platform is told to display (P3): over random scenes, commands, packets and hands every
// row of the supervisor's table holds for the displayed normal force and lean too; and without the stage, or
// without a guard, the same check finds the row broken.
#include "core/random.h"
#include "haptics/safety_display.h"
#include "unit/haptics/safety_rig.h"

#include <QtTest>
#include <cmath>
#include <limits>
#include <set>

using namespace chiron;
using core::DisplayPose;
using core::Vec3;
using haptics::GuardMask;
using test::SafetyRig;

namespace {

devices::DeviceDescriptor padDevice(double rating = 0.0) {
    devices::DeviceDescriptor d = test::sixAxisDevice(rating, rating);
    d.maximumForce_N = 4.0;
    d.maximumTorque_Nm = 0.0;
    return d;
}

enum class Stage { kept, removed };

/// One random run; the rows that were found broken.
class DisplayEpisode {
public:
    DisplayEpisode(std::uint64_t seed, GuardMask mask, Stage stage)
        : m_random(seed), m_rig(padDevice(), {}, {}, nullptr, mask), m_stage(stage) {}

    std::set<std::string> run(int ticks) {
        for (int n = 0; n < ticks; ++n)
            tick();
        return m_broken;
    }
    double most_N() const { return m_most_N; }

private:
    bool chance(double p) { return m_random.uniform() < p; }

    void makeInputs() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        DisplayPose& asked = m_rig.scene.display[0];
        if (chance(0.02))
            m_push = m_random.uniform(0.0, chance(0.2) ? 40.0 : 6.0);
        const Vec3 side(m_random.normal(), m_random.normal(), 3.0);
        m_rig.ask(m_quiet > 0 ? Vec3(0.0, 0.0, 0.05) : Vec3(m_push * side.normalized()));
        asked.normalForce_N =
            chance(0.05) ? m_random.uniform(-5.0, 50.0) : m_push; // nothing ties it to the wrench
        asked.pitch_rad = chance(0.05) ? m_random.uniform(-3.0, 3.0) : 0.3;
        asked.roll_rad = chance(0.05) ? m_random.uniform(-3.0, 3.0) : -0.1;
        if (chance(0.001))
            asked.pitch_rad = chance(0.5) ? nan : std::numeric_limits<double>::infinity();
        if (chance(0.0003))
            m_rig.scene.tissue.tools[0].force.x() = nan;
        m_quiet = m_quiet > 0 ? m_quiet - 1 : chance(0.01) ? 8 : 0;
        m_fast = chance(0.0003);
        m_rig.states.tools[0].v_WT = Vec3(m_fast ? 1.5 : 0.2, 0.0, 0.0);
        m_frozenFor = m_frozenFor > 0 ? (chance(0.001) ? 0 : m_frozenFor + 1) : chance(0.0002) ? 1 : 0;
        m_rig.heartbeatAge_ms =
            static_cast<std::uint16_t>(m_frozenFor > 0 ? 250 + std::min(m_frozenFor, 5000) : 20);
        m_silentFor = m_silentFor > 0 ? (chance(0.02) ? 0 : m_silentFor + 1) : chance(0.0004) ? 1 : 0;
        m_rig.silent = m_silentFor > 0;
        m_rig.age_us = static_cast<std::uint32_t>(1000 * m_silentFor);
    }

    void command() {
        core::CommandKind kind = core::CommandKind::none;
        if (chance(0.0003))
            kind = core::CommandKind::stopForce;
        else if (chance(0.0003))
            kind = core::CommandKind::pause;
        else if (chance(0.002))
            kind = core::CommandKind::resume;
        else if (chance(0.01))
            kind = core::CommandKind::rearm;
        m_pausedFor = kind == core::CommandKind::pause    ? std::max(m_pausedFor, 1)
                      : kind == core::CommandKind::resume ? 0
                      : m_pausedFor > 0                   ? m_pausedFor + 1
                                                          : 0;
        m_stopped = kind == core::CommandKind::stopForce || (m_stopped && kind != core::CommandKind::rearm);
        m_rig.tick({kind});
    }

    void tick() {
        makeInputs();
        command();
        const DisplayPose asked = m_rig.scene.display[0];
        const DisplayPose shown = m_stage == Stage::kept ? m_rig.out.tools[0].display : asked;
        check(asked, shown);
        m_last = shown;
        const bool off = m_stopped || m_fast || m_silentFor >= 30 || m_frozenFor > 500 || m_pausedFor > 500;
        m_sinceOff = off ? 0 : m_sinceOff + 1;
        m_most_N = std::max(m_most_N, shown.normalForce_N);
    }

    void require(bool holds, const char* row) {
        if (!holds)
            m_broken.insert(row);
    }

    void check(const DisplayPose& asked, const DisplayPose& shown) {
        constexpr double kEps = 1e-12;
        const bool zero = shown.normalForce_N == 0.0 && shown.pitch_rad == 0.0 && shown.roll_rad == 0.0;
        require(std::isfinite(shown.normalForce_N) && std::isfinite(shown.pitch_rad) &&
                    std::isfinite(shown.roll_rad),
                "finite");
        require(shown.normalForce_N >= 0.0 && shown.normalForce_N <= 4.0 + kEps, "cap");
        require(std::hypot(shown.pitch_rad, shown.roll_rad) <= haptics::kMaximumLean_rad + kEps &&
                    std::abs(shown.roll_rad) <= haptics::kMaximumRoll_rad + kEps,
                "lean"); // |pitch| ≤ 30° is in the first
        require(m_rig.out.tools[0].enabled || zero, "disabled");
        require(shown.normalForce_N <= m_last.normalForce_N + 2.0 + kEps, "slew");
        bool further = false;
        haptics::limitSlew({m_last.pitch_rad, m_last.roll_rad, 0.0}, {shown.pitch_rad, shown.roll_rad, 0.0},
                           haptics::kLeanStep_rad + 1e-9, further);
        require(!further, "lean slew");
        require(!m_stopped || zero, "stop");
        require(m_pausedFor <= 502 || zero, "pause");
        require(m_frozenFor <= 502 || zero, "frozen window");
        require(m_silentFor < 20 || zero, "watchdog");
        require(!m_fast || zero, "over-velocity");
        if (std::isfinite(asked.normalForce_N))
            require(shown.normalForce_N <=
                        std::max(0.0, asked.normalForce_N) * std::min(1.0, (m_sinceOff + 1) / 2000.0) + 1e-9,
                    "arming");
    }

    core::Random m_random;
    SafetyRig m_rig;
    Stage m_stage;
    std::set<std::string> m_broken;
    DisplayPose m_last;
    double m_push = 0.0, m_most_N = 0.0;
    int m_quiet = 0, m_frozenFor = 0, m_silentFor = 0, m_pausedFor = 0, m_sinceOff = 0;
    bool m_stopped = false, m_fast = false;
};

} // namespace

class TestSafetyDisplay : public QObject {
    Q_OBJECT
private slots:
    void noRowIsEverBroken();
    void withoutTheStageEveryRowIsFound();
    void eachGuardSwitchedOffIsFound_data();
    void eachGuardSwitchedOffIsFound();
    void dampingOfAFastHandIsNoTissueForce();
    void aPadBooksNoEnergy();
    void itArmsAndFollows();
    void aLimitedLeanIsTold();
    void aLeanIsLimitedAlongItsOwnDirection();
    void aMirroredToolLeansTheOtherWay();
};

void TestSafetyDisplay::noRowIsEverBroken() {
    double most = 0.0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        DisplayEpisode episode(seed, {}, Stage::kept);
        const auto broken = episode.run(8000);
        QVERIFY2(
            broken.empty(),
            qPrintable(QString("%1, seed %2").arg(broken.empty() ? "" : broken.begin()->c_str()).arg(seed)));
        most = std::max(most, episode.most_N());
    }
    QVERIFY(most > 3.9); // force did come on
}

void TestSafetyDisplay::withoutTheStageEveryRowIsFound() {
    std::set<std::string> found;
    for (std::uint64_t seed = 0; seed < 10; ++seed)
        found.merge(DisplayEpisode(seed, {}, Stage::removed).run(8000));
    for (const char* row : {"finite", "cap", "lean", "disabled", "slew", "lean slew", "stop", "pause",
                            "frozen window", "watchdog", "over-velocity", "arming"})
        QVERIFY2(found.contains(row), row);
}

void TestSafetyDisplay::eachGuardSwitchedOffIsFound_data() {
    QTest::addColumn<unsigned>("guard");
    QTest::addColumn<QString>("row");
    QTest::newRow("slew") << GuardMask::kSlew << "slew";
    QTest::newRow("slew of the lean") << GuardMask::kSlew << "lean slew";
    QTest::newRow("arming") << GuardMask::kArming << "arming";
    QTest::newRow("over-velocity") << GuardMask::kOverVelocity << "over-velocity";
    QTest::newRow("watchdog") << GuardMask::kWatchdog << "watchdog";
    QTest::newRow("stop") << GuardMask::kStop << "stop";
    QTest::newRow("frozen window") << GuardMask::kHeartbeat << "frozen window";
    QTest::newRow("pause") << GuardMask::kPause << "pause";
}

void TestSafetyDisplay::eachGuardSwitchedOffIsFound() {
    QFETCH(unsigned, guard);
    QFETCH(QString, row);
    std::set<std::string> found;
    for (std::uint64_t seed = 0; seed < 40 && !found.contains(row.toStdString()); ++seed)
        found.merge(DisplayEpisode(seed, GuardMask::without(guard), Stage::kept).run(8000));
    QVERIFY2(found.contains(row.toStdString()), qPrintable(row));
}

// A device that pushes the hand damps a fast one; a pad alone shows nothing of it.
void TestSafetyDisplay::dampingOfAFastHandIsNoTissueForce() {
    for (const double rating : {0.0, 6.0}) {
        SafetyRig rig(padDevice(rating));
        rig.arm();
        rig.ask(Vec3(0.0, 0.0, 1.0));
        rig.scene.display[0] = {1.0, 0.1, 0.0};
        rig.ticks(20);
        QVERIFY(rig.out.tools[0].display.normalForce_N > 0.99 && rig.out.tools[0].display.pitch_rad > 0.099);
        rig.states.tools[0].v_WT = Vec3(1.2, 0.0, 0.0);
        rig.ticks(1);
        QCOMPARE(rig.out.tools[0].display.normalForce_N, 0.0);
        QCOMPARE(rig.out.tools[0].display.pitch_rad, 0.0);
        QCOMPARE(rig.force().norm() > 0.0, rating > 0.0);
        QVERIFY((rig.out.guards & core::guard_bits::kOverVelocity) != 0);
    }
}

// Pressed, moved against the force and let go of: with motors on the tool that is work; through a pad it is
// none.
void TestSafetyDisplay::aPadBooksNoEnergy() {
    for (const double rating : {0.0, 6.0}) {
        SafetyRig rig(padDevice(rating));
        rig.arm();
        bool injected = false;
        double largest = 0.0, least = 4.0;
        for (int n = 0; n < 4000; ++n) { // an active body: it pushes harder on the way out than on the way in
            const double phase = 2.0 * 3.14159265358979 * n / 500.0;
            const double v = -0.03 * std::cos(phase);
            rig.states.tools[0].p_WT.z() += 0.001 * v;
            rig.states.tools[0].v_WT = Vec3(0.0, 0.0, v);
            rig.ask(Vec3(0.0, 0.0, v > 0.0 ? 2.0 : 1.0));
            rig.scene.display[0] = {v > 0.0 ? 2.0 : 1.0, 0.0, 0.0};
            rig.scene.storedEnergy_J = 0.002;
            rig.scene.contactStiffness_N_per_m = 500.0;
            rig.tick();
            injected = injected || (rig.out.guards & core::guard_bits::kPassivity) != 0;
            largest = std::max(largest, std::abs(rig.out.energySupplied_J) + rig.out.energyStored_J);
            least = std::min(least, rig.out.tools[0].display.normalForce_N);
        }
        QCOMPARE(injected, rating > 0.0);
        QCOMPARE(largest > 0.0, rating > 0.0);
        if (rating == 0.0)
            QCOMPARE(least, 1.0);
    }
}

void TestSafetyDisplay::itArmsAndFollows() {
    SafetyRig rig(padDevice());
    rig.ask(Vec3(0.0, 0.0, 3.0)); // in contact: it must not come on
    rig.scene.display[0] = {3.0, 0.0, 0.0};
    rig.ticks(3000);
    QCOMPARE(rig.out.tools[0].display.normalForce_N, 0.0);
    rig.arm();
    rig.ask(Vec3(3.0, 0.0, 4.0)); // 5 N asked of a pad that takes 4: scaled as a whole
    rig.scene.display[0] = {4.0, 0.2, 0.0};
    rig.ticks(40);
    QVERIFY(std::abs(rig.out.tools[0].display.normalForce_N - 3.2) < 1e-9);
    QVERIFY(std::abs(rig.out.tools[0].display.pitch_rad - 0.2) < 1e-9);
}

// 30° asked at once: limited for both, told of where somebody's pad is turned.
void TestSafetyDisplay::aLimitedLeanIsTold() {
    for (const double rating : {0.0, 6.0}) {
        SafetyRig rig(padDevice(rating));
        rig.arm();
        rig.ask(Vec3(0.0, 0.0, 1.0));
        rig.scene.display[0] = {1.0, 0.5, 0.0};
        rig.tick();
        QVERIFY(std::abs(rig.out.tools[0].display.pitch_rad - haptics::kLeanStep_rad) < 1e-12);
        QCOMPARE((rig.out.guards & core::guard_bits::kSlew) != 0, rating == 0.0);
        rig.ticks(60);
        QVERIFY(std::abs(rig.out.tools[0].display.pitch_rad - 0.5) < 1e-12);
        QCOMPARE(rig.out.guards & core::guard_bits::kSlew, 0u);
        rig.scene.display[0] = {1.0, 0.0, 0.0}; // back is free
        rig.tick();
        QCOMPARE(rig.out.tools[0].display.pitch_rad, 0.0);
    }
}

// models.md §3: 30° in all, roll 20°, and the lean keeps its direction.
void TestSafetyDisplay::aLeanIsLimitedAlongItsOwnDirection() {
    for (int degrees = 0; degrees < 360; ++degrees)
        for (const double angle : {0.2, 0.34, 0.6, 1.5}) {
            const double way = degrees * 3.14159265358979 / 180.0;
            const DisplayPose asked{1.0, angle * std::cos(way), angle * std::sin(way)};
            const DisplayPose shown = haptics::displayUnder(asked, 1.0, 1.0, true, 4.0);
            const double lean = std::hypot(shown.pitch_rad, shown.roll_rad);
            QVERIFY(std::abs(shown.pitch_rad * asked.roll_rad - shown.roll_rad * asked.pitch_rad) < 1e-12);
            QVERIFY(shown.pitch_rad * asked.pitch_rad >= 0.0 && shown.roll_rad * asked.roll_rad >= 0.0);
            const double largest =
                std::min(haptics::kMaximumLean_rad,
                         haptics::kMaximumRoll_rad / std::max(1e-9, std::abs(std::sin(way))));
            QVERIFY(std::abs(lean - std::min(angle, largest)) < 1e-12);
        }
}

// Left-handed, R_W = H R_D H: what leans the tool's pad towards l in W leans it towards H l in D. The lean
// vector from roll and pitch: roll·x − pitch·(n × x), in D's own terms and mirrored, against the scene's in
// W.
void TestSafetyDisplay::aMirroredToolLeansTheOtherWay() {
    const auto leanVector = [](const DisplayPose& pose, const Vec3& x, const Vec3& n) {
        return Vec3(pose.roll_rad * x - pose.pitch_rad * n.cross(x));
    };
    for (const bool left : {false, true}) {
        devices::WorkspaceMapping mapping;
        mapping.leftHanded = left;
        const Vec3 h(left ? -1.0 : 1.0, 1.0, 1.0);
        const core::Quat q_D(Eigen::AngleAxisd(0.4, Vec3::UnitZ()));
        const devices::WorkspaceMap map(mapping);
        const Vec3 x_D = q_D * Vec3::UnitX(), x_W = map.orientationToW(q_D) * Vec3::UnitX();
        const DisplayPose shown{1.0, 0.2, -0.1}, told = map.displayToD(shown);
        const Vec3 inW = leanVector(shown, x_W, Vec3::UnitZ()), inD = leanVector(told, x_D, Vec3::UnitZ());
        QVERIFY((h.cwiseProduct(inD) - inW).norm() < 1e-12);
        SafetyRig rig(padDevice(), {}, mapping);
        rig.arm();
        rig.ask(Vec3(0.0, 0.0, 1.0));
        rig.scene.display[0] = shown;
        rig.ticks(60);
        QVERIFY(std::abs(rig.out.tools[0].display.roll_rad + 0.1) < 1e-12); // the picture is W's
        QVERIFY(std::abs(rig.out.tools[0].display_D.roll_rad - (left ? 0.1 : -0.1)) < 1e-12);
        QVERIFY(std::abs(rig.out.tools[0].display_D.pitch_rad - 0.2) < 1e-12 &&
                rig.out.tools[0].display_D.normalForce_N > 0.99);
    }
}

QTEST_APPLESS_MAIN(TestSafetyDisplay)
#include "test_safety_display.moc"
