// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "simulation/attributes/roughness.h"
#include "simulation/evaluate_laws.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

using namespace chiron;

namespace {

/// One row of a law by the names of its columns; parameters not named keep their defaults.
class Table {
public:
    explicit Table(std::string_view id) {
        for (const auto& law : simulation::evaluateLaws())
            if (law.id == id)
                m_law = &law;
        if (m_law == nullptr)
            qFatal("no such law");
    }
    Table with(std::string_view parameter, double value) const {
        Table other = *this;
        other.m_set[std::string(parameter)] = value;
        return other;
    }
    std::map<std::string, double> row(const std::vector<double>& inputs) const {
        std::vector<double> parameters;
        for (const auto& p : m_law->parameters) {
            const auto set = m_set.find(std::string(p.name));
            parameters.push_back(set == m_set.end() ? p.defaultValue : set->second);
        }
        std::vector<double> out(m_law->outputs.size());
        if (inputs.size() != m_law->inputs.size())
            qFatal("inputs");
        m_law->evaluate(parameters, inputs, out);
        std::map<std::string, double> named;
        for (std::size_t i = 0; i < out.size(); ++i)
            named[std::string(m_law->outputs[i].name)] = out[i];
        return named;
    }

private:
    const core::LawDescription* m_law = nullptr;
    std::map<std::string, double> m_set;
};

bool near(double a, double b, double relative = 1e-12) {
    return std::abs(a - b) <= relative * std::max(std::abs(a), std::abs(b));
}

} // namespace

// Each table against the equation in its title, written out here anew.
class TestEvaluateAttributes : public QObject {
    Q_OBJECT
private slots:
    void elasticity();
    void strainStiffening();
    void mass();
    void deformation();
    void roughness();
    void bristleOneStep();
    void bristleRowByRow();
    void viscosity();
    void elasticTube();
    void segmentsOfATubeAddUp();
};

void TestEvaluateAttributes::elasticity() {
    const auto row = Table("elasticity").with("stiffness_N_per_m", 300).row({0.004});
    QVERIFY(near(row.at("force_N"), -1.2) && near(row.at("energy_J"), 0.0024) &&
            near(row.at("slope_N_per_m"), 300));
    QVERIFY(near(Table("elasticity").row({-0.002}).at("force_N"), 1.0));
    QCOMPARE(std::signbit(Table("elasticity").row({0.0}).at("force_N")), false);
}

void TestEvaluateAttributes::strainStiffening() {
    const auto row =
        Table("strain-stiffening").with("stiffness_N_per_m", 200).with("stiffening_per_m", 50).row({0.02});
    QVERIFY(near(row.at("force_N"), -4.0 * (std::exp(1.0) - 1.0)));
    QVERIFY(near(row.at("energy_J"), 0.08 * (std::exp(1.0) - 2.0)));
    QVERIFY(near(row.at("slope_N_per_m"), 200 * std::exp(1.0)));
}

void TestEvaluateAttributes::mass() {
    const auto row = Table("mass").row({0.1, 1.0, 0.0, 2.0});
    QVERIFY(near(row.at("weight_z_N"), -0.0980665) && row.at("weight_x_N") == 0.0);
    QVERIFY(near(row.at("energy_J"), 0.00980665));
    QVERIFY(near(row.at("with_inertia_x_N"), -0.01) && near(row.at("with_inertia_z_N"), -0.1180665));
}

void TestEvaluateAttributes::deformation() {
    const double k = 400, k1 = 200, tau = 0.25, d = 0.005;
    const Table table =
        Table("deformation").with("stiffness_N_per_m", k).with("recovery_share", 0.5).with("recovery_s", tau);
    const auto row = table.row({d, 0.1, 0.3});
    const double q = d * (1.0 - std::exp(-0.1 / tau));
    QVERIFY(near(row.at("force_at_once_N"), (k + k1) * d));
    QVERIFY(near(row.at("force_N"), k * d + k1 * (d - q)));
    QVERIFY(near(row.at("force_steady_N"), k * d));
    QVERIFY(near(row.at("energy_J"), 0.5 * k * d * d + 0.5 * k1 * (d - q) * (d - q)));
    const double left = q * std::exp(-0.3 / tau);
    QVERIFY(near(row.at("surface_m"), k1 * left / (k + k1)));
    QVERIFY(near(row.at("energy_released_J"), 0.5 * k * k1 / (k + k1) * left * left));
    QCOMPARE(table.row({-0.001, 1.0, 0.0}).at("force_N"), 0.0);
}

void TestEvaluateAttributes::roughness() {
    const Table table =
        Table("roughness").with("seed", 5).with("roughness_m", 1e-4).with("wavelength_m", 0.004);
    const auto row = table.row({0.0123, -0.004, 0.002});
    const auto h = simulation::Roughness(1e-4, 0.004, 5).sample({0.0123, -0.004, 0.0});
    const double d = 0.002 + h.height_m;
    QVERIFY(h.height_m != 0.0 && row.at("height_m") == h.height_m);
    QVERIFY(near(row.at("fz_N"), 500 * d) && near(row.at("fx_N"), -500 * d * h.gradient.x()));
    QVERIFY(near(row.at("energy_J"), 250 * d * d));
    QCOMPARE(table.row({0.0123, -0.004, -0.01}).at("fz_N"), 0.0); // outside
    QVERIFY(table.with("seed", 6).row({0.0123, -0.004, 0.002}).at("height_m") != h.height_m);
}

void TestEvaluateAttributes::bristleOneStep() {
    const Table table = Table("bristle-friction").with("mu", 0.5).with("bristle_stiffness_N_per_m", 1000);
    auto row = table.row({0, 0, 3e-4, -4e-4, 2.0}); // 0.5 mm · 1000 N/m < 1 N: sticks
    QVERIFY(near(row.at("fx_N"), -0.3) && near(row.at("fy_N"), 0.4) && row.at("slips") == 0.0);
    QVERIFY(near(row.at("energy_J"), 0.5 * 1000 * 25e-8));
    row = table.row({0, 0, 3e-3, -4e-3, 2.0}); // slips at μN = 1 N along the same direction
    QVERIFY(near(row.at("fx_N"), -0.6) && near(row.at("fy_N"), 0.8) && row.at("slips") == 1.0);
    QVERIFY(near(row.at("stretch_x_m"), 6e-4));
    QCOMPARE(table.row({5e-4, 0, 0, 0, -1.0}).at("fx_N"), 0.0); // a surface does not pull
}

// Fed back row by row it is the law over a path: there and back again, with the lost motion of 2 μN/σ₀.
void TestEvaluateAttributes::bristleRowByRow() {
    const Table table = Table("bristle-friction").with("mu", 0.3).with("bristle_stiffness_N_per_m", 1000);
    double stretch = 0.0;
    double work = 0.0;
    double force = 0.0;
    const auto move = [&](double dx) {
        const auto row = table.row({stretch, 0, dx, 0, 2.0});
        stretch = row.at("stretch_x_m");
        force = row.at("fx_N");
        work -= force * dx;
    };
    for (int n = 0; n < 100; ++n)
        move(1e-4);
    QVERIFY(near(force, -0.6));
    move(-6e-4);
    QVERIFY(std::abs(force) < 1e-12); // the bristle has come back
    for (int n = 0; n < 94; ++n)
        move(-1e-4);
    QVERIFY(near(force, 0.6));
    QVERIFY(work > 2 * 0.6 * 0.009);
}

void TestEvaluateAttributes::viscosity() {
    const Table table = Table("viscosity").with("viscosity_Ns_per_m", 4);
    auto row = table.row({0.002, 0.1, -0.05, 0.0});
    QVERIFY(near(row.at("fx_N"), -0.4) && near(row.at("fy_N"), 0.2) && near(row.at("power_W"), -0.05));
    QVERIFY(near(table.row({0.00025, 0.1, 0, 0}).at("fx_N"), -0.2)); // half the weight at 0.25 mm
    QCOMPARE(table.row({-0.001, 0.1, 0, 0}).at("fx_N"), 0.0);        // outside
}

void TestEvaluateAttributes::elasticTube() {
    const Table linear = Table("elastic-tube").with("rest_length_m", 0.05).with("stiffness_N_per_m", 60);
    auto row = linear.row({0.07});
    QVERIFY(near(row.at("tension_N"), 1.2) && near(row.at("energy_J"), 0.012) &&
            near(row.at("stretch_m"), 0.02));
    row = linear.row({0.049}); // slack
    QVERIFY(row.at("tension_N") == 0.0 && row.at("energy_J") == 0.0 && row.at("slope_N_per_m") == 0.0);
    row = linear.with("stiffening_per_m", 100).row({0.07});
    QVERIFY(near(row.at("tension_N"), 0.6 * (std::exp(2.0) - 1.0)));
}

// A tube gripped at 30 % of its rest length, both parts stretched alike, is the whole tube.
void TestEvaluateAttributes::segmentsOfATubeAddUp() {
    const Table whole = Table("elastic-tube").with("rest_length_m", 0.05).with("stiffening_per_m", 60);
    const Table near30 = whole.with("segment_share", 0.3);
    const Table far70 = whole.with("segment_share", 0.7);
    const double length = 0.073;
    const auto all = whole.row({length});
    const auto a = near30.row({0.3 * length});
    const auto b = far70.row({0.7 * length});
    QVERIFY(near(a.at("tension_N"), all.at("tension_N")) && near(b.at("tension_N"), all.at("tension_N")));
    QVERIFY(near(a.at("energy_J") + b.at("energy_J"), all.at("energy_J")));
    QVERIFY(near(1.0 / (1.0 / a.at("slope_N_per_m") + 1.0 / b.at("slope_N_per_m")), all.at("slope_N_per_m")));
}

QTEST_APPLESS_MAIN(TestEvaluateAttributes)
#include "test_evaluate_attributes.moc"
