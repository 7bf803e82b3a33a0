// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/evaluate_laws.h"
#include "support/urethra_reference_geometry.h"

#include <QtTest>
#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace chiron;
using Values = std::map<std::string, double>;

namespace {

const core::LawDescription& law(std::string_view id) {
    for (const auto& description : simulation::evaluateLaws())
        if (description.id == id)
            return description;
    qFatal("no such law");
    return simulation::evaluateLaws()[0];
}

Values evaluated(const core::LawDescription& of, const std::vector<double>& inputs,
                 const Values& changed = {}) {
    std::vector<double> parameters;
    std::size_t known = 0;
    for (const auto& parameter : of.parameters) {
        const auto given = changed.find(std::string(parameter.name));
        known += given == changed.end() ? 0 : 1;
        parameters.push_back(given == changed.end() ? parameter.defaultValue : given->second);
    }
    if (known != changed.size())
        qFatal("no such parameter");
    std::vector<double> outputs(of.outputs.size());
    of.evaluate(parameters, inputs, outputs);
    Values values;
    for (std::size_t i = 0; i < outputs.size(); ++i)
        values[std::string(of.outputs[i].name)] = outputs[i];
    return values;
}

bool near(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance;
}

/// A parameter's value that is not its default.
struct Other {
    const char* name;
    double value;
};
constexpr Other kOfTheWall[] = {
    {"radius_m", 0.0026},     {"beak_m", 0.012},          {"endoscope_radius_m", 0.004},
    {"behind_m", 0.03},       {"change_length_m", 0.013}, {"change_centre_m", 0.05},
    {"change_edge_m", 0.005}, {"change_radius_m", 0.001}, {"tip_s_m", 0.0455}};
constexpr Other kOfTheProfile[] = {
    {"wall_stiffness_N_per_m3", 2e6}, {"friction", 0.2},
    {"free_length_m", 0.05}, // where offsets cost force; drawn they are everywhere
    {"free_blend_m", 0.02},           {"change_stiffness_factor", 3.0},
    {"change_friction_factor", 3.0}};
constexpr Other kOfTheSurface[] = {{"curvature_per_m", 12.0},
                                   {"z_end_m", 0.09},
                                   {"straight_m", 0.02},
                                   {"inside", 0.0},
                                   {"ex_m", 0.0},
                                   {"en_m", 0.0},
                                   {"n", 18.0},
                                   {"w", 27.0},
                                   {"moving_sections", 8.0}};

} // namespace

class TestUrethraLaws : public QObject {
    Q_OBJECT
private slots:
    void centrelineByHand();
    void profileByHand();
    void everyParameterReachesItsLaw_data();
    void everyParameterReachesItsLaw();
    void surfaceIsTheReferences();
    void impossibleIsNotANumber();
};

void TestUrethraLaws::centrelineByHand() {
    const auto& line = law("urethra-centreline");
    const double z = 0.05; // slope 26 z = 1.3
    const double s = 0.5 * z * std::sqrt(1.0 + 1.69) + std::asinh(1.3) / 52.0;
    Values row = evaluated(line, {s});
    QVERIFY(near(row["z_m"], z, 1e-15) && near(row["y_m"], 13.0 * z * z, 1e-15));
    QVERIFY(near(row["psi_rad"], std::atan(1.3), 1e-14));
    QVERIFY(near(row["curvature_per_m"], 26.0 / std::pow(2.69, 1.5), 1e-12));
    QVERIFY(near(row["to_neck_m"], 0.13922485126556 - s, 1e-13));
    row = evaluated(line, {-0.01});
    QVERIFY(row["z_m"] == -0.01 && row["y_m"] == 0.0 && row["psi_rad"] == 0.0 &&
            row["curvature_per_m"] == 0.0);
    QVERIFY(near(evaluated(line, {0.0}, {{"curvature_per_m", 20.0}})["curvature_per_m"], 40.0, 1e-13));
    QVERIFY(evaluated(line, {0.0}, {{"z_end_m", 0.1}})["to_neck_m"] > 0.16);
    const Values bent{{"straight_m", 0.035}, {"z_end_m", 0.1}};
    row = evaluated(line, {0.0349}, bent); // straight up to B …
    QVERIFY(row["z_m"] == 0.0349 && row["y_m"] == 0.0 && row["psi_rad"] == 0.0 &&
            row["curvature_per_m"] == 0.0);
    row = evaluated(line, {0.035}, bent); // … and sharpest there
    QVERIFY(near(row["curvature_per_m"], 26.0, 1e-12) && row["psi_rad"] == 0.0);
    row = evaluated(line, {0.035 + s}, bent);
    QVERIFY(near(row["z_m"], 0.035 + z, 1e-15) && near(row["y_m"], 13.0 * z * z, 1e-15) &&
            near(row["psi_rad"], std::atan(1.3), 1e-14));
    QVERIFY(std::isnan(evaluated(line, {0.0}, {{"straight_m", 0.1}, {"z_end_m", 0.1}})["z_m"]));
}

void TestUrethraLaws::profileByHand() {
    const auto& profile = law("urethra-profile");
    Values row = evaluated(profile, {0.065}); // half-way from the tip at 60 mm to the opening's end
    QVERIFY(near(row["radius_m"], 0.0025, 1e-18) && near(row["opening"], 0.5, 1e-12));
    QVERIFY(near(row["opened_radius_m"], 0.5 * (0.0025 + 0.022 / 6.0), 1e-15));
    QVERIFY(row["wall_stiffness_N_per_m3"] == 3e6 && row["friction"] == 0.1 && row["constrained"] == 1.0);
    row = evaluated(profile, {0.040}); // half of the window behind, in the middle of the free part's blend
    QVERIFY(near(row["following"], 0.5, 1e-12) && near(row["constrained"], 0.5, 1e-12) &&
            row["opening"] == 1.0);
    row = evaluated(profile, {0.080}, {{"change_length_m", 0.012}, {"change_stiffness_factor", 15.0}});
    QVERIFY(near(row["radius_m"], 0.0015, 1e-18) && near(row["wall_stiffness_N_per_m3"], 45e6, 1e-6));
}

void TestUrethraLaws::everyParameterReachesItsLaw_data() {
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("name");
    QTest::addColumn<double>("value");
    for (const Other& other : kOfTheWall)
        for (const char* id : {"urethra-profile", "urethra-surface"})
            QTest::addRow("%s %s", id, other.name) << QString(id) << QString(other.name) << other.value;
    for (const Other& other : kOfTheProfile)
        QTest::addRow("profile %s", other.name)
            << QString("urethra-profile") << QString(other.name) << other.value;
    for (const Other& other : kOfTheSurface)
        QTest::addRow("surface %s", other.name)
            << QString("urethra-surface") << QString(other.name) << other.value;
}

void TestUrethraLaws::everyParameterReachesItsLaw() {
    QFETCH(QString, id);
    QFETCH(QString, name);
    QFETCH(double, value);
    const auto& of = law(id.toStdString());
    Values base{
        {"tip_s_m", 0.0450},        {"change_length_m", 0.012},       {"change_centre_m", 0.053},
        {"change_radius_m", 0.002}, {"change_stiffness_factor", 2.0}, {"change_friction_factor", 2.0}};
    if (id == QLatin1String("urethra-surface"))
        base.insert({{"inside", 1.0}, {"ex_m", 0.001}, {"en_m", -0.001}});
    Values changed = base;
    changed[name.toStdString()] = value;
    bool differs = false;
    for (const double s : {0.030, 0.0462, 0.0478}) {
        std::vector<double> inputs{s};
        if (of.inputs.size() > 1)
            inputs.push_back(0.9);
        const Values before = evaluated(of, inputs, base);
        const Values after = evaluated(of, inputs, changed);
        for (const auto& [output, number] : after)
            QVERIFY2(std::isfinite(number), output.c_str());
        differs = differs || before != after;
    }
    QVERIFY(differs);
}

void TestUrethraLaws::surfaceIsTheReferences() {
    const auto& surface = law("urethra-surface");
    testing::UrethraReferenceGeometry reference({}, {}, {});
    for (const double tip : {-1.0, 0.033, 0.0712, 0.137}) {
        reference.deform({tip > -1.0, tip, 0.001, 0.002});
        for (const double s : {0.0, 0.021, 0.0345, 0.0766, 0.1392})
            for (const double angle : {0.0, 1.1, 5.9}) {
                const Values given{
                    {"inside", tip > -1.0 ? 1.0 : 0.0}, {"tip_s_m", tip}, {"ex_m", 0.001}, {"en_m", 0.002}};
                Values row = evaluated(surface, {s, angle}, given);
                const core::Vec3 p(row["x_m"], row["y_m"], row["z_m"]);
                const core::Vec3 n(row["nx"], row["ny"], row["nz"]);
                QVERIFY((p - reference.at(s, angle)).norm() < 1e-12);
                QVERIFY(near(n.norm(), 1.0, 1e-12));
                QVERIFY(
                    near(evaluated(surface, {s, angle - 6.283185307179586}, given)["ny"], row["ny"], 1e-9));
            }
    }
}

void TestUrethraLaws::impossibleIsNotANumber() {
    const auto& surface = law("urethra-surface");
    QVERIFY(std::isnan(evaluated(surface, {-0.001, 0.0})["x_m"]));
    QVERIFY(std::isnan(evaluated(surface, {0.14, 0.0})["x_m"]));
    QVERIFY(std::isfinite(evaluated(surface, {0.139, -50.0})["x_m"]));
    const Values tight{{"curvature_per_m", 60.0}, {"radius_m", 0.009}}; // radius of curvature 8.3 mm
    QVERIFY(std::isnan(evaluated(surface, {0.05, 0.0}, tight)["nz"]));
    QVERIFY(std::isnan(evaluated(law("urethra-profile"), {0.05}, tight)["radius_m"]));
}

QTEST_APPLESS_MAIN(TestUrethraLaws)
#include "test_urethra_laws.moc"
