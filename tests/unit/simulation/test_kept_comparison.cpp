// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that the scene of a comparison answers, over trials that are explored, answered, adjusted and
// run out of time, for every attribute and every control: no level sweeps it, for studies make it. Against
// what was looked at and kept. A change that is meant is kept anew, and its difference is read in review:
// CHIRON_STORE_OUTLINES=1 ctest --test-dir build/release -R "^test_kept_comparison$"
#include "comparison_driver.h"

#include "core/fp_environment.h"
#include "support/answer_numbers.h"
#include "support/kept_numbers.h"

#include <QtTest>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

constexpr int kBlock_ticks = 250;

/// Steps a scene and takes down its blocks.
class Told {
public:
    explicit Told(const ComparisonParameters& p) : m_parameters(p), m_scene(p, 42) {
        m_in.tools.count = 1;
        m_in.started = true;
        m_in.tools.tools[0].p_WT = Vec3(0.0, 0.0, 0.080);
        m_in.dampingBudget_Ns_per_m[0] = 20.0;
    }
    void tick() {
        core::ToolState& tool = m_in.tools.tools[0];
        tool.v_WT = m_ticks++ == 0 ? Vec3(Vec3::Zero()) : Vec3((tool.p_WT - m_last) / 0.001);
        m_last = tool.p_WT;
        m_in.forceReady = m_ticks % 1000 > 30;
        m_scene.respond(m_source.next(0), m_in, m_out);
        m_in.present = m_in.answer = m_in.mark = false;
        if (m_blocks.add(m_out))
            m_lines.add(m_blocks.line());
    }
    void wait(int ticks) {
        for (int i = 0; i < ticks; ++i)
            tick();
    }
    void present(int candidate, int arrangement) {
        m_in.present = true;
        m_in.presented = core::encode({candidate, arrangement});
        tick();
    }
    void answer(std::uint16_t word) {
        m_in.answer = true;
        m_in.answered = word;
        tick();
    }
    void mark() {
        m_in.mark = true;
        tick();
    }
    void press(bool down) { m_in.tools.tools[0].buttons = down ? core::kButtonMark : 0u; }
    void pause(bool paused) { m_in.paused = paused; }
    void nowhere() {
        const Vec3 p = m_in.tools.tools[0].p_WT;
        m_in.tools.tools[0].p_WT.x() = std::nan("");
        tick();
        m_in.tools.tools[0].p_WT = m_last = p;
    }
    void moveTo(const Vec3& goal, int ticks) {
        const Vec3 from = m_in.tools.tools[0].p_WT;
        for (int i = 1; i <= ticks; ++i) {
            const double s = static_cast<double>(i) / ticks;
            m_in.tools.tools[0].p_WT = from + s * s * s * (10.0 - 15.0 * s + 6.0 * s * s) * (goal - from);
            tick();
        }
    }
    Vec3 at(int place, double z_m, double y_m = 0.0) const {
        return {placeX_m(m_parameters, place), y_m, z_m};
    }
    /// In, along and out, as the attribute is felt; what is hooked is taken hold of, pulled, pressed and let
    /// go.
    void explore(int place) {
        const double h = m_parameters.hookHeight_m;
        if (isHooked(m_parameters.attribute)) {
            const bool tube = m_parameters.attribute == ComparedAttribute::stiffness;
            moveTo(at(place, h + 0.04), 200);
            moveTo(at(place, h - (tube ? 0.003 : -0.001)), 200);
            moveTo(at(place, h + 0.012, 0.002), 150);
            moveTo(at(place, h - (tube ? 0.008 : 0.004), -0.003), 150);
            moveTo(at(place, h + 0.009, 0.004), 100);
            moveTo(at(place, h + (tube ? -0.016 : 0.02), tube ? 0.02 : 0.0), 200);
            moveTo(at(place, h + 0.04), 150);
            return;
        }
        moveTo(at(place, 0.02, -0.006), 150);
        moveTo(at(place, -0.003, -0.006), 100);
        moveTo(at(place, -0.0025, 0.014), 200);
        moveTo(at(place, -0.004, -0.003), 150);
        wait(60);
        moveTo(at(place, 0.02), 100);
    }
    const tests::NumberLines& told() const { return m_lines; }

private:
    ComparisonParameters m_parameters;
    ComparisonScene m_scene;
    realtime::TickSource m_source;
    SceneInput m_in;
    SceneOutput m_out;
    Vec3 m_last = Vec3::Zero();
    long long m_ticks = 0;
    tests::AnswerBlocks m_blocks{kBlock_ticks};
    tests::NumberLines m_lines;
};

ComparisonParameters everything(ComparedAttribute attribute, ComparisonControl control) {
    ComparisonParameters p = compared(attribute);
    p.object.stiffening_per_m = 30.0;
    p.object.roughness_m = 2e-5;
    p.object.roughnessWavelength_m = 0.003;
    p.object.friction = 0.1;
    p.object.viscosity_Ns_per_m = 0.7;
    p.object.recoveryShare = 0.5;
    p.object.recoveryTime_s = 0.15;
    p.control = control;
    p.arrangements.push_back({1, -1, 0});
    p.exploreLimit_s = 6.0;
    p.answerLimit_s = 0.8;
    p.buttonAnswers = true;
    p.adjusts = attribute == ComparedAttribute::friction || attribute == ComparedAttribute::mass;
    return p;
}

} // namespace

class TestKeptComparison : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void sittingsAreAsTheyWereKept_data();
    void sittingsAreAsTheyWereKept();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/simulation/kept_comparison.txt"),
                           &tests::sameNumbers};
};

void TestKeptComparison::sittingsAreAsTheyWereKept_data() {
    QTest::addColumn<int>("attribute");
    QTest::addColumn<int>("control");
    const char* const names[] = {"stiffness", "mass", "deformation", "roughness", "friction", "viscosity"};
    const char* const controls[] = {"none", "gain", "swapped", "constant"};
    for (const ComparedAttribute attribute : kComparedAttributes)
        for (int control = 0; control < 4; ++control)
            if (control == 0 || static_cast<int>(attribute) % 3 == control - 1)
                QTest::addRow("%s, control %s", names[static_cast<int>(attribute)], controls[control])
                    << static_cast<int>(attribute) << control;
}

void TestKeptComparison::sittingsAreAsTheyWereKept() {
    QFETCH(int, attribute);
    QFETCH(int, control);
    Told t(everything(static_cast<ComparedAttribute>(attribute), static_cast<ComparisonControl>(control)));
    t.wait(20);
    t.present(0, 0); // explored, and answered by a command
    t.wait(60);
    for (int place = 0; place < 3; ++place)
        t.explore(place);
    t.answer(1);
    t.present(1, 1); // early: it waits; answered by the button at what is touched
    t.wait(80);
    t.nowhere();
    t.explore(2);
    t.moveTo(t.at(0, isHooked(static_cast<ComparedAttribute>(attribute)) ? 0.031 : -0.002), 400);
    t.wait(20);
    t.press(true);
    t.wait(5);
    t.press(false);
    t.moveTo(t.at(1, 0.07), 200);
    t.present(0, 2); // a place without an object; adjusted while it is held, paused, and out of time
    t.wait(60);
    t.moveTo(t.at(0, isHooked(static_cast<ComparedAttribute>(attribute)) ? 0.031 : -0.002), 300);
    t.present(1, 0);
    t.pause(true);
    t.wait(100);
    t.pause(false);
    t.explore(0);
    t.explore(1);
    t.mark();
    t.wait(7500);
    t.present(9, 9); // there is no such thing
    t.wait(100);
    t.present(0, 0);
    t.wait(200);
    t.answer(kAnswerSpoiled);
    t.wait(100);
    t.answer(kAnswerFinish);
    t.wait(150);
    const QString differs = m_kept.differs(QString::fromLatin1(QTest::currentDataTag()), t.told().lines());
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
}

QTEST_APPLESS_MAIN(TestKeptComparison)
#include "test_kept_comparison.moc"
