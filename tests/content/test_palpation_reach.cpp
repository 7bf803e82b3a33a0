// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "core/contact_bits.h"
#include "core/fp_environment.h"
#include "core/random.h"
#include "core/units.h"
#include "modules/exercises/palpation/simulation/palpation_scene.h"
#include "realtime/haptic_tick.h"

#include <QRandomGenerator>
#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Vec3;

namespace {

const catalogue::ExerciseLevel* levelOf(const char* id) {
    static const auto shipped = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!shipped)
        qFatal("%s", shipped.error().message.c_str());
    for (const auto& level : shipped->find("palpation")->levels)
        if (level.id == id)
            return &level;
    return nullptr;
}

/// A hand that wanders through the whole workspace, at 0.3 m/s at most: three oscillations an axis whose
/// speeds add up to that.
class Wander {
public:
    explicit Wander(core::Random& random) {
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < 3; ++i) {
                m_rate[axis][i] = random.uniform(1.0, 12.0);
                m_phase[axis][i] = random.uniform(0.0, 2.0 * core::kPi);
                m_reach_m[axis][i] = std::min(0.03, kSpeed / std::sqrt(3.0) / 3.0 / m_rate[axis][i]) *
                                     random.uniform(0.3, 1.0);
            }
        m_middle =
            Vec3(random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.01));
    }
    core::ToolState at(double t_s) const {
        core::ToolState tool;
        tool.p_WT = m_middle;
        for (int axis = 0; axis < 3; ++axis)
            for (int i = 0; i < 3; ++i) {
                const double angle = m_rate[axis][i] * t_s + m_phase[axis][i];
                tool.p_WT[axis] += m_reach_m[axis][i] * std::sin(angle);
                tool.v_WT[axis] += m_reach_m[axis][i] * m_rate[axis][i] * std::cos(angle);
            }
        return tool;
    }

private:
    static constexpr double kSpeed = 0.3; // m/s
    double m_rate[3][3]{};
    double m_phase[3][3]{};
    double m_reach_m[3][3]{};
    Vec3 m_middle;
};

} // namespace

// Every level of palpation along random paths through, over and below the tissue: what models.md and data.md
// promise of each.
class TestPalpationReach : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        core::setModelFloatingPointEnvironment();
        m_seed = QRandomGenerator::global()->generate64();
        qInfo("seed %llu", static_cast<unsigned long long>(m_seed));
    }
    void anywhere_data();
    void anywhere();
    void pressedTooHard_data() { anywhere_data(); }
    void pressedTooHard();

private:
    std::uint64_t m_seed = 0;
};

void TestPalpationReach::anywhere_data() {
    QTest::addColumn<QByteArray>("id");
    for (const char* id :
         {"visible_lump", "hidden_single", "size_and_hardness", "several_or_none", "clinical_pattern"})
        QTest::newRow(id) << QByteArray(id);
}

void TestPalpationReach::anywhere() {
    QFETCH(QByteArray, id);
    const auto parameters = levelOf(id)->parameters.as<simulation::PalpationParameters>();
    QVERIFY(parameters.yield.force_N > parameters.maximumForce_N &&
            parameters.yield.force_N <= 3.0 * parameters.maximumForce_N);
    core::Random random = core::Random::stream(m_seed, id.constData());
    constexpr int kPaths = 200;
    constexpr int kTicks = 1000;
    double most_N = 0.0;
    double steepest_N = 0.0; // change in a tick beyond what the tissue's slope gives
    int contacts = 0;
    int yields = 0;
    int beyond = 0;
    for (int path = 0; path < kPaths; ++path) {
        simulation::PalpationScene scene(parameters, random.next());
        realtime::TickSource source;
        simulation::SceneInput in;
        simulation::SceneOutput out;
        in.started = in.forceReady = true;
        in.tools.count = parameters.tools();
        const Wander wander(random);
        Vec3 before = Vec3::Zero();
        Vec3 place = wander.at(0.0).p_WT;
        bool wasThrough = false;
        for (int tick = 0; tick < kTicks; ++tick) {
            in.tools.tools[0] = wander.at(1e-3 * tick);
            for (int i = 1; i < in.tools.count; ++i)
                in.tools.tools[static_cast<std::size_t>(i)].p_WT = Vec3(0.0, 0.0, 0.05);
            scene.respond(source.next(0), in, out);
            const Vec3& force = out.tissue.tools[0].force;
            const auto& response = scene.tissue();
            const std::uint8_t contact = out.contact[0];
            QVERIFY(force.allFinite());
            most_N = std::max(most_N, force.norm());
            QVERIFY2(force.norm() <= parameters.yield.force_N + 1e-9,
                     qPrintable(QString("%1 N").arg(force.norm())));
            const bool through = (contact & core::contact_bits::kThrough) != 0;
            if (tick > 2 && !through && !wasThrough) {
                // Twice the stiffest of the contact, friction with it, and damping that comes in over its
                // depth. On curved tissue a foot moves 5 times as far as its finger at 0.8 of the radius of
                // curvature, where the change-over begins; there a lump's lateral force changes by ½ k d² χ''
                // 5² = 57 k (d = 8.9 mm, χ'' ≤ 6 χ/H² with χ ≤ 1, H² = 1.05·10⁻⁴ m²: 8 mm deep).
                const double k = response.normalStiffness_N_per_m();
                const auto& tissue = parameters.tissue;
                const double slope =
                    (2.0 * std::max(k, out.contactStiffness_N_per_m) +
                     (response.surface().flat() ? 2.0 : 57.0) * k +
                     0.3 * 1.5 * tissue.damping_Ns_per_m.maxCoeff() / tissue.dampingDepth_m) *
                        (1.0 + tissue.friction) +
                    std::max(tissue.tangentAlong_N_per_m, tissue.tangentAcross_N_per_m);
                const double way = (in.tools.tools[0].p_WT - place).norm();
                steepest_N = std::max(steepest_N, (force - before).norm() - slope * way);
            }
            const double above = in.tools.tools[0].p_WT.z() -
                                 response.surface().heightAt(in.tools.tools[0].p_WT.head<2>()).z_m;
            if (above > 0.0)
                QVERIFY2(force.norm() == 0.0, qPrintable(QString("%1 N in the air").arg(force.norm())));
            contacts += above < 0.0 ? 1 : 0;
            yields += (contact & core::contact_bits::kYielded) != 0 ? 1 : 0;
            beyond += (contact & core::contact_bits::kBeyondChecked) != 0 ? 1 : 0;
            before = force;
            place = in.tools.tools[0].p_WT;
            wasThrough = through;
        }
    }
    qInfo("%s: %d ticks in tissue, %d beyond the checked range, gave way %d times, at most %.2f N, steepest "
          "%.3f N over its slope",
          id.constData(), contacts, beyond, yields, most_N, steepest_N);
    QVERIFY(contacts > kPaths * kTicks / 20 && yields > 0 && beyond > 0);
    QVERIFY2(steepest_N <= 0.1, qPrintable(QString::number(steepest_N)));
}

// A finger that is pressed on and on: once through, nothing holds it, and lifted out and put back it feels
// tissue again.
void TestPalpationReach::pressedTooHard() {
    QFETCH(QByteArray, id);
    const auto parameters = levelOf(id)->parameters.as<simulation::PalpationParameters>();
    simulation::PalpationScene scene(parameters, m_seed);
    realtime::TickSource source;
    simulation::SceneInput in;
    simulation::SceneOutput out;
    in.started = in.forceReady = true;
    in.tools.count = parameters.tools();
    int yields = 0;
    const double top_m = scene.tissue().surface().highest_m() + 0.002;
    const auto at = [&](double z_m) {
        for (int i = 0; i < in.tools.count; ++i)
            in.tools.tools[static_cast<std::size_t>(i)].p_WT = Vec3(0.02 * i, 0.0, i == 0 ? z_m : 0.05);
        scene.respond(source.next(0), in, out);
        yields += (out.contact[0] & core::contact_bits::kYielded) != 0 ? 1 : 0;
    };
    double deep_m = top_m;
    while (yields == 0 && deep_m > -0.2)
        at(deep_m -= 5e-5);
    QCOMPARE(yields, 1);
    for (int i = 0; i < 30; ++i)
        at(deep_m -= 5e-5);
    QCOMPARE(out.tissue.tools[0].force.norm(), 0.0);
    QCOMPARE(out.storedEnergy_J, 0.0);
    at(top_m);
    QVERIFY((out.contact[0] & core::contact_bits::kThrough) == 0);
    for (double z_m = top_m; z_m > top_m - 0.012; z_m -= 5e-5)
        at(z_m);
    QVERIFY(out.tissue.tools[0].force.norm() > 0.05);
    QCOMPARE(yields, 1);
}

QTEST_APPLESS_MAIN(TestPalpationReach)
#include "test_palpation_reach.moc"
