// SPDX-License-Identifier: GPL-3.0-or-later
// Every law that `evaluate` knows, against what was looked at and kept: what it says of itself, what it
// refuses at the ends of its parameters, and its numbers at drawn places with drawn parameters. Each law has
// tests against its equation; here no column, default, range or term changes unsaid. A change that is meant
// is kept anew, and its difference is read in review: CHIRON_STORE_OUTLINES=1 ctest --test-dir build/release
// -R "^test_kept_laws$"
#include "core/fp_environment.h"
#include "mechanisms/mechanism_laws.h"
#include "simulation/evaluate_laws.h"
#include "support/kept_numbers.h"

#include <QtTest>
#include <cmath>
#include <map>
#include <random>

using namespace chiron;
using tests::NumberLines;

namespace {

constexpr int kSets = 8, kPlaces = 6;

QString text(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

std::vector<const core::LawDescription*> allLaws() {
    std::vector<const core::LawDescription*> all;
    for (const auto& laws : {simulation::evaluateLaws(), mechanisms::evaluateLaws()})
        for (const core::LawDescription& law : laws)
            all.push_back(&law);
    return all;
}

/// The same numbers with every library.
class Draw {
public:
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(m_engine() >> 11) * 0x1p-53;
    }

private:
    std::mt19937_64 m_engine{20261125};
};

/// Where a column's values lie in use, by its name, or by its unit.
std::pair<double, double> rangeOf(const core::LawColumn& column) {
    static const std::map<std::string_view, std::pair<double, double>> kByName{
        {"s_m", {-0.005, 0.1}},
        {"angle_rad", {-3.1, 3.1}},
        {"depth_m", {-0.0005, 0.006}},
        {"theta1_rad", {1.7, 3.2}},
        {"theta2_rad", {-0.1, 1.5}},
        {"h_rad", {-0.7, 0.7}},
        {"p_rad", {-0.7, 0.7}},
        {"pitch_rad", {-0.6, 0.6}},
        {"yaw_rad", {-0.4, 0.4}},
        {"normal_force_N", {-0.3, 3.0}},
        {"stretch_x_m", {-4e-4, 4e-4}},
        {"stretch_y_m", {-4e-4, 4e-4}},
        {"displacement_x_m", {-4e-4, 4e-4}},
        {"displacement_y_m", {-4e-4, 4e-4}},
        {"held_s", {0.0, 1.0}},
        {"released_s", {0.0, 1.0}},
        {"length_m", {0.03, 0.1}},
        {"rho_m", {0.0, 0.02}},
        {"dz_m", {-0.0005, 0.004}},
        {"height_m", {-0.2, 0.2}}};
    static const std::map<std::string_view, std::pair<double, double>> kByUnit{
        {"m", {-0.02, 0.02}}, {"m/s", {-0.1, 0.1}},  {"rad/s", {-1.0, 1.0}},
        {"N", {-3.0, 3.0}},   {"N·m", {-0.1, 0.1}},  {"1", {-1.0, 1.0}},
        {"s", {0.0, 1.0}},    {"m/s²", {-5.0, 5.0}}, {"rad", {-1.0, 1.0}}};
    const auto named = kByName.find(column.name);
    return named != kByName.end() ? named->second : kByUnit.at(column.unit);
}

/// Of a parameter that is usually 0, a value that shows.
double shownValue(const core::LawParameter& p) {
    static const std::map<std::string_view, double> kByName{{"change_length_m", 0.02},
                                                            {"straight_m", 0.02},
                                                            {"pivot_span_m", 0.05},
                                                            {"stiffness_variation", 0.3},
                                                            {"dimple_depth_m", 0.001},
                                                            {"free_hold_N_per_m", 500.0},
                                                            {"wall_retardation_s", 0.01},
                                                            {"bump_height_m", 0.0005},
                                                            {"stiffening_per_m", 50.0},
                                                            {"basic_sections", 9.0},
                                                            {"dome", 1.0},
                                                            {"count_m", 1e-4},
                                                            {"regularisation_velocity_m_per_s", 0.01},
                                                            {"finger_y", 0.4},
                                                            {"finger_z", 0.2},
                                                            {"plane_height_m", 0.002}};
    const auto named = kByName.find(p.name);
    return named != kByName.end() ? named->second : 0.01 * p.maximum;
}

std::vector<double> parametersOf(const core::LawDescription& law, int set, Draw& draw) {
    std::vector<double> values;
    for (const core::LawParameter& p : law.parameters) {
        double value = p.defaultValue;
        if (set > 0 && value != 0.0)
            value *= draw.between(0.8, 1.2);
        else if (set > 0 && draw.between(0.0, 1.0) > 0.5)
            value = shownValue(p) * draw.between(0.6, 1.0);
        if (p.whole || p.name == "basic_sections")
            value = std::round(value);
        values.push_back(std::clamp(value, p.minimum, p.maximum));
    }
    return values;
}

std::vector<double> inputsOf(const core::LawDescription& law, int place, Draw& draw) {
    std::vector<double> values;
    for (const core::LawColumn& column : law.inputs) {
        const auto [low, high] = rangeOf(column);
        values.push_back(draw.between(low, high));
    }
    if (law.id == "urethra-force") { // about its centre-line, looking along it; the last in the bladder
        const double z = place + 1 < kPlaces ? draw.between(0.0, 0.085) : 0.1, y = 13.0 * z * z;
        values[0] *= 0.1;
        values[1] = y + 0.1 * values[1];
        values[2] = z;
        values[3] *= 0.1;
        values[4] = 26.0 * z + 0.1 * values[4];
        values[5] = 1.0;
    } else if (law.id == "mesh-contact" || law.id == "hemisphere") { // near the surface, mostly inside
        const double most = law.id == "hemisphere" ? 0.0185 : 0.023;
        const double length = std::hypot(values[0], values[1], values[2]);
        for (std::size_t i = 0; i < 3; ++i)
            values[i] *= (place == 0 ? 2.0 : draw.between(0.9, 1.0)) * most / length;
        values[2] = law.id == "hemisphere" ? std::abs(values[2]) : values[2];
    }
    return values;
}

} // namespace

class TestKeptLaws : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }
    void lawsAreAsTheyWereKept_data();
    void lawsAreAsTheyWereKept();
    void everythingKeptIsSeen() { QCOMPARE(m_kept.unseen(), QStringList()); }

private:
    tests::KeptText m_kept{QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/simulation/kept_laws.txt"),
                           &tests::sameNumbers};
};

void TestKeptLaws::lawsAreAsTheyWereKept_data() {
    QTest::addColumn<int>("index");
    int index = 0;
    for (const core::LawDescription* law : allLaws())
        QTest::newRow(std::string(law->id).c_str()) << index++;
}

void TestKeptLaws::lawsAreAsTheyWereKept() {
    QFETCH(int, index);
    const core::LawDescription& l = *allLaws()[static_cast<std::size_t>(index)];
    NumberLines lines;
    lines.add(text(l.title) + QStringLiteral("; ") + text(l.source));
    for (const core::LawParameter& p : l.parameters)
        lines.add(QStringLiteral("parameter %1 (%2)%3")
                      .arg(text(p.name), text(p.unit), p.whole ? QStringLiteral(", whole") : QString()),
                  {p.defaultValue, p.minimum, p.maximum});
    for (const core::LawColumn& column : l.inputs)
        lines.add(QStringLiteral("input %1 (%2)").arg(text(column.name), text(column.unit)));
    for (const core::LawColumn& column : l.outputs)
        lines.add(QStringLiteral("output %1 (%2)").arg(text(column.name), text(column.unit)));

    Draw draw;
    const std::vector<double> usual = parametersOf(l, 0, draw);
    if (l.problem)
        for (std::size_t i = 0; i < usual.size(); ++i)
            for (const double end : {l.parameters[i].minimum, l.parameters[i].maximum}) {
                std::vector<double> values = usual;
                values[i] = end;
                if (const std::string problem = l.problem(values, {}); !problem.empty())
                    lines.add(QStringLiteral("with %1 %2: %3")
                                  .arg(text(l.parameters[i].name))
                                  .arg(end)
                                  .arg(text(problem)));
            }
    std::vector<double> out(l.outputs.size());
    for (int set = 0; set < kSets; ++set) {
        const std::vector<double> parameters = parametersOf(l, set, draw);
        lines.add(QStringLiteral("with"), parameters);
        if (const std::string problem = l.problem ? l.problem(parameters, {}) : std::string();
            !problem.empty()) {
            lines.add(QStringLiteral("  no: %1").arg(text(problem)));
            continue;
        }
        for (int place = 0; place < kPlaces; ++place) {
            const std::vector<double> inputs = inputsOf(l, place, draw);
            lines.add(QStringLiteral("  at"), inputs);
            if (const std::string problem = l.problem ? l.problem(parameters, inputs) : std::string();
                !problem.empty()) {
                lines.add(QStringLiteral("    no: %1").arg(text(problem)));
                continue;
            }
            l.evaluate(parameters, inputs, out);
            for (std::size_t i = 0; i < out.size();
                 ++i) // where nothing is said to be wrong, there is an answer
                QVERIFY2(std::isfinite(out[i]), l.outputs[i].name.data());
            lines.add(QStringLiteral("    gives"), out);
        }
    }
    const QString differs = m_kept.differs(text(l.id), lines.lines());
    QVERIFY2(differs.isEmpty(), qPrintable(differs));
}

QTEST_APPLESS_MAIN(TestKeptLaws)
#include "test_kept_laws.moc"
