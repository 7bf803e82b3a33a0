// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/evaluate_laws.h"

#include <QtTest>
#include <cmath>
#include <set>
#include <string>
#include <vector>

using namespace chiron;

namespace {

const core::LawDescription& law(std::string_view id) {
    for (const auto& description : simulation::evaluateLaws())
        if (description.id == id)
            return description;
    qFatal("no such law");
    return simulation::evaluateLaws()[0];
}

std::vector<double> defaults(const core::LawDescription& description) {
    std::vector<double> values;
    for (const auto& parameter : description.parameters)
        values.push_back(parameter.defaultValue);
    return values;
}

void set(const core::LawDescription& description, std::vector<double>& values, std::string_view name,
         double value) {
    for (std::size_t i = 0; i < values.size(); ++i)
        if (description.parameters[i].name == name) {
            values[i] = value;
            return;
        }
    qFatal("no such parameter");
}

double output(const core::LawDescription& description, const std::vector<double>& parameters,
              const std::vector<double>& inputs, std::string_view name) {
    std::vector<double> outputs(description.outputs.size());
    description.evaluate(parameters, inputs, outputs);
    for (std::size_t i = 0; i < outputs.size(); ++i)
        if (description.outputs[i].name == name)
            return outputs[i];
    qFatal("no such output");
    return 0.0;
}

} // namespace

class TestEvaluateLaws : public QObject {
    Q_OBJECT
private slots:
    void descriptionsAreComplete();
    void hemisphereRows();
    void hemisphereParametersReachTheLaw();
    void frictionRows();
};

void TestEvaluateLaws::descriptionsAreComplete() {
    std::set<std::string> ids;
    for (const auto& description : simulation::evaluateLaws()) {
        QVERIFY(ids.insert(std::string(description.id)).second);
        QVERIFY(!description.title.empty() && !description.source.empty() && description.evaluate != nullptr);
        std::set<std::string> inputs;
        for (const auto& column : description.inputs)
            QVERIFY(!column.unit.empty() && inputs.insert(std::string(column.name)).second);
        std::set<std::string> outputs;
        for (const auto& column : description.outputs)
            QVERIFY(!column.unit.empty() && outputs.insert(std::string(column.name)).second);
        for (const auto& parameter : description.parameters) {
            QVERIFY(!parameter.unit.empty() && !parameter.name.empty());
            QVERIFY(parameter.minimum <= parameter.defaultValue &&
                    parameter.defaultValue <= parameter.maximum);
        }
    }
    QVERIFY(ids.count("hemisphere") == 1 && ids.count("friction") == 1);
}

void TestEvaluateLaws::hemisphereRows() {
    const auto& hemisphere = law("hemisphere");
    const auto values = defaults(hemisphere);
    const std::vector<double> apex{0, 0, 0.017, 0, 0, 0};
    QVERIFY(std::abs(output(hemisphere, values, apex, "fz_N") - 1.5) < 1e-12);
    QVERIFY(std::abs(output(hemisphere, values, apex, "depth_m") - 0.003) < 1e-15);
    QVERIFY(std::abs(output(hemisphere, values, apex, "energy_J") - 0.00225) < 1e-15);
    QCOMPARE(output(hemisphere, values, apex, "nz"), 1.0);
    const std::vector<double> leaving{0, 0, 0.017, 0, 0, 0.1}; // b = 1 N·s/m
    QVERIFY(std::abs(output(hemisphere, values, leaving, "fz_N") - 1.4) < 1e-12);
    const std::vector<double> side{-0.019, 0, 0, 0, 0, 0};
    QVERIFY(std::abs(output(hemisphere, values, side, "fx_N") + 0.5) < 1e-12);
    QCOMPARE(output(hemisphere, values, side, "nx"), -1.0);
    const std::vector<double> away{0.1, 0, 0.1, 1, 1, 1};
    QCOMPARE(output(hemisphere, values, away, "fz_N"), 0.0);
    QCOMPARE(output(hemisphere, values, away, "depth_m"), 0.0);
}

void TestEvaluateLaws::hemisphereParametersReachTheLaw() {
    const auto& hemisphere = law("hemisphere");
    const std::vector<double> place{0.0105, 0.001, 0.014, 0.01, 0.02, 0.05};
    const double before = output(hemisphere, defaults(hemisphere), place, "fz_N");
    const std::vector<std::pair<std::string_view, double>> changes{
        {"radius_m", 0.021},   {"plane_height_m", 0.001},    {"centre_x_m", 0.001},
        {"centre_y_m", 0.002}, {"stiffness_N_per_m", 600.0}, {"damping_Ns_per_m", 2.0}};
    for (const auto& [name, value] : changes) {
        auto values = defaults(hemisphere);
        set(hemisphere, values, name, value);
        QVERIFY2(output(hemisphere, values, place, "fz_N") != before, name.data());
    }
    auto varied = defaults(hemisphere);
    set(hemisphere, varied, "stiffness_variation", 0.3);
    set(hemisphere, varied, "dimple_depth_m", 0.0005);
    const double base = output(hemisphere, varied, place, "fz_N");
    for (const std::string_view name :
         {"stiffness_wavelength_m", "stiffness_phase_x_rad", "stiffness_phase_y_rad", "dimple_radius_m",
          "dimple_x_m", "dimple_y_m"}) {
        auto values = varied;
        set(hemisphere, values, name, 0.0123);
        QVERIFY2(output(hemisphere, values, place, "fz_N") != base, name.data());
    }
}

void TestEvaluateLaws::frictionRows() {
    const auto& friction = law("friction");
    auto values = defaults(friction); // μ = 0.3
    // by the rule: μN/b_max = 0.6/50 = 12 mm/s; 9-12-15
    QVERIFY(std::abs(output(friction, values, {2.0, 0.009}, "regularisation_velocity_m_per_s") - 0.012) <
            1e-15);
    QVERIFY(std::abs(output(friction, values, {2.0, 0.009}, "friction_force_N") + 0.36) < 1e-12);
    set(friction, values, "regularisation_velocity_m_per_s", 0.004); // 3-4-5
    QVERIFY(std::abs(output(friction, values, {2.0, -0.003}, "friction_force_N") - 0.36) < 1e-12);
    QCOMPARE(output(friction, values, {2.0, 0.0}, "friction_force_N"), 0.0);
    QCOMPARE(output(friction, values, {-2.0, 0.01}, "friction_force_N"), 0.0);
    auto coarse = defaults(friction);
    set(friction, coarse, "count_m", 0.0005);
    QCOMPARE(output(friction, coarse, {0.0, 0.01}, "regularisation_velocity_m_per_s"), 0.0005 / 0.015);
}

QTEST_APPLESS_MAIN(TestEvaluateLaws)
#include "test_evaluate_laws.moc"
