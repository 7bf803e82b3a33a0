// SPDX-License-Identifier: GPL-3.0-or-later
// Laws that are not conservative: what strokes over the bumpy mesh and the two-rate organ make, without the
// guard and with it.
#include "core/units.h"
#include "support/two_rate_bench.h"
#include "unit/haptics/safety_rig.h"

#include <QtTest>

using namespace chiron;
using core::Vec3;
using haptics::GuardMask;
using simulation::ApexSurface;

namespace {

struct Made {
    double worst_J = -1.0; ///< of one contact: work of the commanded force on the hand; > 0: energy was made
    double total_J = 0.0;  ///< of all of them
    int contacts = 0;
};

/// Presses at a random place, slides to another, lifts: one contact each. The motion is prescribed, so that
/// no hand hides anything.
Made strokes(ApexSurface surface, std::uint32_t without) {
    simulation::SphereApexParameters p = tests::softDome();
    p.surface = surface;
    p.damping_Ns_per_m = 0.0; // nothing that takes energy helps
    if (surface == ApexSurface::mesh) {
        p.bumpHeight_m = 0.00025;
        p.roughness_m = 0.00002;
    }
    auto dome = std::move(*simulation::TouchedDome::make(p, simulation::planSphereApexTrials(p, 1)));
    dome->begin(0, 0);
    test::SafetyRig rig(test::sixAxisDevice(20.0), {}, {}, nullptr, GuardMask::without(without));
    rig.arm();
    core::Random random(7);
    Made made;
    std::uint64_t n = 0;
    for (int stroke = 0; stroke < 60; ++stroke) {
        const core::Vec2 from(random.uniform(-0.006, 0.006), random.uniform(-0.006, 0.006));
        const core::Vec2 to(random.uniform(-0.006, 0.006), random.uniform(-0.006, 0.006));
        const double depth = random.uniform(0.0005, 0.003);
        const auto place = [&](double s) { // 0 .. 3: down, across, up
            const double across = std::clamp(s - 1.0, 0.0, 1.0);
            const double down = std::clamp(std::min(s, 3.0 - s), 0.0, 1.0);
            const core::Vec2 at = from + across * (to - from);
            const double top = std::sqrt(0.02 * 0.02 - at.squaredNorm());
            return Vec3(at.x(), at.y(), top + 0.002 - down * (0.002 + depth));
        };
        double work = 0.0;
        constexpr int kTicks = 450;
        for (int tick = 0; tick < kTicks; ++tick, ++n) {
            const double s = 3.0 * tick / kTicks, next = 3.0 * (tick + 1) / kTicks;
            const Vec3 v = (place(next) - place(s)) / 1e-3;
            dome->update(n, simulation::SlowUpdate::asDue);
            const auto felt = dome->respond(0, place(s), v);
            dome->ask(n);
            rig.states.tools[0].p_WT = place(s);
            rig.states.tools[0].v_WT = v;
            rig.ask(felt.force);
            rig.scene.storedEnergy_J = felt.energy_J;
            rig.scene.contactStiffness_N_per_m = felt.stiffness_N_per_m;
            rig.tick();
            work += rig.force().dot(place(next) - place(s));
        }
        made.worst_J = std::max(made.worst_J, work);
        made.total_J += work;
        ++made.contacts;
    }
    return made;
}

/// One contact: comes down, goes round and round in the same small circle over the bumps, and lifts: what the
/// law makes in a turn adds up. `centre` of the circle; `way` = ±1: which way round.
double circles(const core::Vec2& centre, double way, std::uint32_t without) {
    simulation::SphereApexParameters p = tests::softDome();
    p.surface = ApexSurface::mesh;
    p.damping_Ns_per_m = 0.0;
    p.bumpHeight_m = 0.0005;
    auto dome = std::move(*simulation::TouchedDome::make(p, simulation::planSphereApexTrials(p, 1)));
    dome->begin(0, 0);
    test::SafetyRig rig(test::sixAxisDevice(20.0), {}, {}, nullptr, GuardMask::without(without));
    rig.arm();
    constexpr int kIn = 200, kTurn = 250, kTurns = 120, kTicks = 2 * kIn + kTurn * kTurns;
    const auto place = [&](int tick) {
        const double angle = way * 2.0 * core::kPi * std::clamp(tick - kIn, 0, kTurn * kTurns) / kTurn;
        const double down = std::clamp(std::min(tick, kTicks - tick) / double(kIn), 0.0, 1.0);
        const core::Vec2 at = centre + 0.002 * core::Vec2(std::cos(angle), std::sin(angle));
        return Vec3(at.x(), at.y(), std::sqrt(0.02 * 0.02 - at.squaredNorm()) + 0.002 - down * 0.005);
    };
    double work = 0.0;
    for (int tick = 0; tick < kTicks; ++tick) {
        const Vec3 v = (place(tick + 1) - place(tick)) / 1e-3;
        dome->update(static_cast<std::uint64_t>(tick), simulation::SlowUpdate::asDue);
        const auto felt = dome->respond(0, place(tick), v);
        rig.states.tools[0].p_WT = place(tick);
        rig.states.tools[0].v_WT = v;
        rig.ask(felt.force);
        rig.scene.storedEnergy_J = felt.energy_J;
        rig.scene.contactStiffness_N_per_m = felt.stiffness_N_per_m;
        rig.tick();
        work += rig.force().dot(place(tick + 1) - place(tick));
    }
    return work;
}

} // namespace

class TestMeshPassivity : public QObject {
    Q_OBJECT
private slots:
    void strokesMakeNoMoreThanTheGuardAllows_data() {
        QTest::addColumn<int>("surface");
        QTest::newRow("bumpy mesh with roughness") << static_cast<int>(ApexSurface::mesh);
        QTest::newRow("organ at two rates") << static_cast<int>(ApexSurface::organ);
    }
    void strokesMakeNoMoreThanTheGuardAllows() {
        QFETCH(int, surface);
        const Made without = strokes(static_cast<ApexSurface>(surface), GuardMask::kPassivity);
        const Made with = strokes(static_cast<ApexSurface>(surface), 0);
        qInfo("%d contacts: worst %.3f mJ and %.2f mJ in all; with the guard %.3f and %.2f mJ",
              without.contacts, 1e3 * without.worst_J, 1e3 * without.total_J, 1e3 * with.worst_J,
              1e3 * with.total_J);
        // The guard lets 1 mJ pass in a contact, and sees what a tick makes only after it.
        QVERIFY(with.worst_J <= 0.0011);
        QVERIFY(with.worst_J <= without.worst_J + 1e-9);
    }
    void aLawThatMakesEnergyIsHeldToTheAllowance() {
        double worst = -1.0, worstWith = -1.0;
        core::Random random(11);
        for (int n = 0; n < 4; ++n) {
            const core::Vec2 centre(random.uniform(-0.005, 0.005), random.uniform(-0.005, 0.005));
            for (const double way : {1.0, -1.0}) {
                const double made = circles(centre, way, GuardMask::kPassivity);
                const double with = circles(centre, way, 0);
                worst = std::max(worst, made);
                worstWith = std::max(worstWith, with);
            }
        }
        qInfo("120 turns in one contact: %.2f mJ made; with the guard %.3f mJ", 1e3 * worst, 1e3 * worstWith);
        QVERIFY(worst > 0.002); // the case can fail
        QVERIFY(worstWith <= 0.001);
    }
};

QTEST_APPLESS_MAIN(TestMeshPassivity)
#include "test_mesh_passivity.moc"
