// SPDX-License-Identifier: GPL-3.0-or-later
// How a simulated participant of a study explores objects of each attribute and what it makes of what it
// feels, trial after trial, against what was kept: stored answers of simulated participants mean the same
// only while none of this changes.
#include "support/kept_figures.h"

#include "core/random.h"
#include "core/units.h"
#include "operators/comparison/comparison_explorer.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>

using namespace chiron;
using core::Vec3;
using operators::ComparisonBriefing;
using operators::ComparisonExplorer;
using simulation::ComparedAttribute;
using tests::Figures;

namespace {

constexpr double kTick_s = core::kTickSeconds;

ComparisonBriefing briefingOf(ComparedAttribute attribute) {
    ComparisonBriefing briefing;
    briefing.attribute = attribute;
    briefing.x_m = {-0.03, 0.0, 0.03};
    briefing.share = attribute == ComparedAttribute::deformation ? 0.8 : 0.0;
    briefing.usualStiffness_N_per_m = attribute == ComparedAttribute::stiffness ? 150.0 : 400.0;
    return briefing;
}

/// Three objects and an instrument with friction and mass of its own; what lies at a place is `value`.
class Bench {
public:
    Bench(const ComparisonBriefing& briefing, std::array<double, 3> values)
        : m_briefing(briefing), m_values(values) {}

    void choose(std::array<double, 3> values) {
        m_values = values;
        m_hooked.fill(false);
    }
    Vec3 force(const Vec3& p, const Vec3& v, const Vec3& a) {
        Vec3 f = -0.3 * v - 0.08 * a;
        for (int i = 0; i < 3; ++i)
            f[i] -= 0.05 * std::tanh(v[i] / 0.004);
        for (std::size_t i = 0; i < 3; ++i)
            f += simulation::isHooked(m_briefing.attribute) ? hooked(i, p, a) : pressed(i, p, v);
        return f;
    }

private:
    Vec3 hooked(std::size_t i, const Vec3& p, const Vec3& a) {
        const Vec3 ring(m_briefing.x_m[i], 0.0, m_briefing.height_m);
        if ((p - ring).norm() < 0.004)
            m_hooked[i] = true;
        if (p.z() < ring.z() - 0.008)
            m_hooked[i] = false;
        if (!m_hooked[i])
            return Vec3::Zero();
        if (m_briefing.attribute == ComparedAttribute::mass)
            return p.z() > ring.z() ? Vec3(0.0, 0.0, -m_values[i] * (core::kStandardGravity + a.z()))
                                    : Vec3::Zero().eval();
        const Vec3 along = p - Vec3(ring.x(), 0.0, 0.0);
        const double stretch_m = along.norm() - m_briefing.height_m;
        return stretch_m > 0.0 ? Vec3(-m_values[i] * stretch_m * along.normalized()) : Vec3::Zero().eval();
    }
    Vec3 pressed(std::size_t i, const Vec3& p, const Vec3& v) {
        const double depth_m = -p.z();
        if (depth_m <= 0.0 || std::hypot(p.x() - m_briefing.x_m[i], p.y()) > 0.009)
            return Vec3::Zero();
        const double k = m_briefing.usualStiffness_N_per_m;
        double normal_N = k * depth_m, along_N = 0.0;
        switch (m_briefing.attribute) {
        case ComparedAttribute::deformation:
            normal_N += 0.8 * k * (depth_m - m_dent[i]);
            m_dent[i] += (depth_m - m_dent[i]) * (1.0 - std::exp(-kTick_s / m_values[i]));
            break;
        case ComparedAttribute::roughness:
            normal_N += k * m_values[i] * std::sqrt(2.0) * std::sin(p.y() / 0.0007 + 3.0 * p.x() / 0.0016);
            break;
        case ComparedAttribute::friction:
            along_N = -m_values[i] * normal_N * std::tanh(v.y() / 0.002);
            break;
        default:
            along_N = -m_values[i] * v.y();
            break;
        }
        return {0.0, along_N, normal_N};
    }

    ComparisonBriefing m_briefing;
    std::array<double, 3> m_values;
    std::array<bool, 3> m_hooked{};
    std::array<double, 3> m_dent{};
};

} // namespace

class TestKeptExplorer : public QObject {
    Q_OBJECT
private slots:
    void explores_data();
    void explores();
    void isMadeOrRefused();
    void nothingElseIsKept() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    void hold(const QString& name, const Figures& figures) {
        const QString differs = m_kept.differs(name, figures.lines);
        QVERIFY2(differs.isEmpty(), qPrintable(differs));
    }
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/operators/kept_explorer.txt"),
                           tests::sameFigures};
};

void TestKeptExplorer::explores_data() {
    QTest::addColumn<int>("attribute");
    QTest::addColumn<int>("places");
    QTest::addColumn<double>("least");
    QTest::newRow("stiffness") << static_cast<int>(ComparedAttribute::stiffness) << 3 << 120.0;
    QTest::newRow("mass") << static_cast<int>(ComparedAttribute::mass) << 2 << 0.06;
    QTest::newRow("deformation") << static_cast<int>(ComparedAttribute::deformation) << 3 << 0.1;
    QTest::newRow("roughness") << static_cast<int>(ComparedAttribute::roughness) << 2 << 1e-4;
    QTest::newRow("friction") << static_cast<int>(ComparedAttribute::friction) << 3 << 0.2;
    QTest::newRow("viscosity") << static_cast<int>(ComparedAttribute::viscosity) << 1 << 2.0;
}

void TestKeptExplorer::explores() {
    QFETCH(int, attribute);
    QFETCH(int, places);
    QFETCH(double, least);
    ComparisonBriefing briefing = briefingOf(static_cast<ComparedAttribute>(attribute));
    briefing.places = places;
    auto made = operators::makeComparisonExplorer(briefing);
    QVERIFY(made);
    ComparisonExplorer& explorer = **made;
    Bench bench(briefing, {least, 1.2 * least, 1.5 * least});
    core::Random random(23);
    Figures out;
    mechanisms::HandPerception seen;
    seen.p_DT = Vec3(0.0, 0.0, 0.06);
    Vec3 v = Vec3::Zero();
    int trial = 0, over_ticks = 0;
    for (int tick = 0; tick < 45'000 && trial < 4; ++tick) {
        seen.time_s = tick * kTick_s;
        const bool running = over_ticks == 0 && tick > 1200;
        seen.cues.phase = running ? core::TrialPhase::running : core::TrialPhase::ready;
        seen.cues.trial = static_cast<std::uint16_t>(trial);
        seen.cues.force = core::ForceState::on;
        const mechanisms::HandIntention wanted = explorer.decide(seen);
        const Vec3 before = v,
                   to = wanted.p_DDesired + 2e-5 * Vec3(random.normal(), random.normal(), random.normal());
        v += 0.06 * ((to - seen.p_DT) * 60.0 + wanted.v_DDesired - v); // comes after
        seen.p_DT += v * kTick_s;
        seen.v_DT = v;
        seen.f_T_D = bench.force(seen.p_DT, v, (v - before) / kTick_s);
        if (tick % 100 == 0)
            out.add(QStringLiteral("%1").arg(tick), 1e3 * wanted.p_DDesired.x(), 1e3 * wanted.p_DDesired.y(),
                    1e3 * wanted.p_DDesired.z(), 1e3 * wanted.v_DDesired.y(), 1e3 * wanted.v_DDesired.z(),
                    explorer.explored());
        if (running && explorer.explored()) {
            out.add(QStringLiteral("trial %1 says").arg(trial), explorer.estimate(-1),
                    1e3 * explorer.estimate(0), 1e3 * explorer.estimate(1), 1e3 * explorer.estimate(2),
                    explorer.estimate(3));
            if (trial == 1 && over_ticks == 0 && tick % 2 == 0)
                explorer.again(); // an adjustment
            over_ticks = 1;
        } else if (over_ticks > 0 && ++over_ticks > 2500) { // something harder, or more, next
            ++trial;
            over_ticks = 0;
            bench.choose({least * (1.0 + trial), 1.3 * least, 0.8 * least * (1.0 + trial)});
        }
    }
    out.add(QStringLiteral("ends with trial"), trial);
    hold(QString::fromLatin1(QTest::currentDataTag()), out);
}

void TestKeptExplorer::isMadeOrRefused() {
    Figures out;
    for (const int places : {0, 1, 3, 4})
        for (const double stiffness : {0.0, 100.0}) {
            ComparisonBriefing briefing = briefingOf(ComparedAttribute::mass);
            briefing.places = places;
            briefing.usualStiffness_N_per_m = stiffness;
            const auto made = operators::makeComparisonExplorer(briefing);
            out.say(QStringLiteral("%1 places, %2 N/m").arg(places).arg(stiffness),
                    made ? std::string("made") : made.error().message);
        }
    simulation::ComparisonParameters parameters;
    for (const ComparedAttribute attribute : {ComparedAttribute::stiffness, ComparedAttribute::viscosity}) {
        parameters.attribute = attribute;
        const ComparisonBriefing told = operators::comparisonBriefing(parameters);
        out.add(QStringLiteral("told"), static_cast<int>(told.attribute), told.places, 1e3 * told.x_m[0],
                1e3 * told.x_m[1], 1e3 * told.x_m[2], 1e3 * told.height_m, told.usualStiffness_N_per_m,
                1e3 * told.padRadius_m, told.share);
        parameters.values = {{321.0, 330.0, 340.0}};
    }
    const mechanisms::HandParameters hand = operators::comparisonHand();
    out.add(QStringLiteral("hand"), hand.stiffness_N_per_m, hand.gripStiffness_N_per_m, hand.reactionDelay_s,
            1e6 * hand.tremorRms_m);
    hold(QStringLiteral("made or refused"), out);
}

QTEST_APPLESS_MAIN(TestKeptExplorer)
#include "test_kept_explorer.moc"
