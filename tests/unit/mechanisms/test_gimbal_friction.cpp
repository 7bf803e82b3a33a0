// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "mechanisms/gimbal_plant.h"
#include "mechanisms/hand.h"
#include "simulation/objects/object_contact.h"

#include <QtTest>
#include <algorithm>
#include <array>
#include <cmath>

using namespace chiron;
using core::Vec3;

namespace {

struct Rub {
    double moved_m = 0.0;    ///< how far the true tip went in the time that counts, largest extent of an axis
    double roughest_N = 0.0; ///< largest change of friction from one tick to the next in that time
    double over = 0.0;       ///< largest of ‖friction‖ − μ f_n, all the time
    double friction_N = 0.0; ///< at the end, along x
    double normal_N = 0.0;   ///< at the end
    int reversals = 0; ///< times that friction along x went from over half of μ f_n on one side to the other
};

mechanisms::HandParameters armNamed(const QString& name) {
    auto arm = name == "light"  ? mechanisms::HandParameters::light()
               : name == "firm" ? mechanisms::HandParameters::firm()
                                : mechanisms::HandParameters();
    arm.tremorRms_m = 0.0; // a still hand: what moves then is the loop's own
    return arm;
}

/// The gimbal in a hand that presses a plane (friction μ) and leans sideways: encoder counts to position and
/// velocity, the object's law, its force through Jᵀ to the motors one tick later. W is D here. The first
/// `settle` of `ticks` do not count.
class Station {
public:
    Station(const simulation::ObjectAttributes& attributes, const mechanisms::HandParameters& arm)
        : m_contact(attributes), m_plant(parameters()), m_hand(arm, 1, 0.15) {
        m_plant.reset({0.0, 0.0, 0.0, 0.17});
        m_hand.reset(m_plant.p_DT());
        m_start = m_plant.p_DT();
    }

    Rub run(const Vec3& lean, int settle, int ticks) {
        Rub out;
        Vec3 low = Vec3::Constant(1e9);
        Vec3 high = -low;
        Vec3 before = Vec3::Zero();
        int side = 0;
        for (int n = 0; n < ticks; ++n) {
            const auto answer = tick(lean * std::min(1.0, n / 500.0));
            const double limit = m_contact.friction() * answer.normalForce_N;
            out.over = std::max(out.over, answer.friction.norm() - limit);
            if (n >= settle) {
                low = low.cwiseMin(m_plant.p_DT());
                high = high.cwiseMax(m_plant.p_DT());
                out.roughest_N = std::max(out.roughest_N, (answer.friction - before).norm());
                const double x = answer.friction.x();
                const int now = x > 0.5 * limit ? 1 : x < -0.5 * limit ? -1 : 0;
                out.reversals += now * side < 0 ? 1 : 0;
                side = now != 0 ? now : side;
            }
            before = answer.friction;
            out.friction_N = answer.friction.x();
            out.normal_N = answer.normalForce_N;
        }
        out.moved_m = (high - low).maxCoeff();
        return out;
    }

private:
    static mechanisms::GimbalPlantParameters parameters() {
        mechanisms::GimbalPlantParameters p;
        for (auto& friction : p.friction)
            friction.coulomb = 0.0; // the device's own friction would hold the tool still by itself
        return p;
    }

    mechanisms::GimbalCoordinates sensed() const {
        const auto& counts = m_plant.counts();
        const auto& size = m_plant.parameters().resolution;
        return {counts[0] * size[0], counts[1] * size[1], counts[2] * size[2], counts[3] * size[3]};
    }

    simulation::ObjectContactResponse tick(const Vec3& lean) {
        const auto q = sensed();
        const Vec3 p = m_plant.kinematics().tip_D(q);
        simulation::ContactPlace place;
        place.depth_m = m_start.z() - p.z();
        place.foot = Vec3(p.x(), p.y(), 0.0);
        place.position = p;
        Vec3& old = m_past[m_tick % m_past.size()];
        place.velocity = m_tick >= m_past.size()
                             ? Vec3((p - old) / (core::kTickSeconds * static_cast<double>(m_past.size())))
                             : Vec3(Vec3::Zero()); // over 15 ms, as the estimator's window is at rest
        old = p;
        ++m_tick;
        const auto answer = m_contact.respond(place, core::kTickSeconds, m_state);
        core::Wrench wrench;
        wrench.force = answer.force;
        const auto efforts = mechanisms::GimbalKinematics::efforts(q, wrench, mechanisms::PolarMap::exact);
        mechanisms::HandIntention wanted;
        wanted.p_DDesired = m_start + lean;
        m_hand.beginTick(wanted);
        m_plant.beginTick(m_due, true);
        m_due = efforts; // acts one tick later
        for (int i = 0; i < m_plant.substeps(); ++i) {
            const double dt = core::kTickSeconds / m_plant.substeps();
            const Vec3 grip = m_hand.gripForceOnTool(m_plant.p_DT(), m_plant.v_DT());
            m_plant.integrate(dt, grip);
            m_hand.integrate(dt, grip);
        }
        m_plant.endTick();
        return answer;
    }

    simulation::ObjectContact m_contact;
    simulation::ObjectContactState m_state;
    mechanisms::GimbalPlant m_plant;
    mechanisms::Hand m_hand;
    mechanisms::GimbalVector m_due = mechanisms::GimbalVector::Zero();
    Vec3 m_start = Vec3::Zero();
    std::array<Vec3, 15> m_past{};
    std::size_t m_tick = 0;
};

simulation::ObjectAttributes surface(double mu) {
    simulation::ObjectAttributes a;
    a.stiffness_N_per_m = 500.0;
    a.friction = mu;
    a.damping_Ns_per_m = 1.0;
    return a;
}

} // namespace

/// models.md §2.2: friction sticks, holds a still tool for ten seconds without chatter, and never exceeds μ
/// f_n; here with the simulated gimbal (encoder grid, a tick of delay) and a hand in the loop.
class TestGimbalFriction : public QObject {
    Q_OBJECT
private slots:
    void holdsAStillTool_data();
    void holdsAStillTool();
    void letsGoWhenPulledHarder();
};

void TestGimbalFriction::holdsAStillTool_data() {
    QTest::addColumn<QString>("arm");
    QTest::addColumn<double>("mu");
    for (const char* arm : {"default", "light", "firm"})
        for (const double mu : {0.3, 0.8})
            QTest::addRow("%s, %g", arm, mu) << arm << mu;
}

void TestGimbalFriction::holdsAStillTool() {
    QFETCH(QString, arm);
    QFETCH(double, mu);
    const auto hand = armNamed(arm);
    const double sideways = 0.3 / hand.stiffness_N_per_m; // pulls with at most 0.3 N
    const double down = 2.0 / hand.stiffness_N_per_m;
    Station station(surface(mu), hand);
    const Rub rub = station.run(Vec3(sideways, 0.0, -down), 3000, 13000);
    const QByteArray told = QByteArray::number(rub.moved_m * 1e6) + " um, steps of " +
                            QByteArray::number(rub.roughest_N) + " N, friction " +
                            QByteArray::number(rub.friction_N) + " N at " + QByteArray::number(rub.normal_N) +
                            " N";
    QVERIFY2(rub.over <= 1e-12, told.constData());
    QVERIFY2(rub.normal_N > 0.5, told.constData());
    QVERIFY2(rub.friction_N < -0.05, told.constData()); // it is friction that holds it
    QVERIFY2(rub.moved_m < 60e-6, told.constData());    // within two counts of the gimbal at the tip
    QVERIFY2(rub.roughest_N < 0.1, told.constData());   // one count is 0.03 N of bristle
    QCOMPARE(rub.reversals, 0);
}

void TestGimbalFriction::letsGoWhenPulledHarder() {
    const auto hand = armNamed("default");
    Station station(surface(0.1), hand);
    const Rub rub = station.run(Vec3(0.01, 0.0, -2.0 / hand.stiffness_N_per_m), 0, 3000); // 3 N against 0.2
    QVERIFY(rub.moved_m > 0.005 && rub.over <= 1e-12);
}

QTEST_APPLESS_MAIN(TestGimbalFriction)
#include "test_gimbal_friction.moc"
