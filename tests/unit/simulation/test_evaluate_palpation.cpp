// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"
#include "simulation/evaluate_laws.h"
#include "simulation/palpation/lean.h"
#include "tissue_laws.h"

#include <QtTest>
#include <map>
#include <string>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {
constexpr double kPi = core::kPi;

using Row = std::map<std::string, double>;

/// One row of a law; parameters not named keep their defaults.
Row row(std::string_view id, const std::vector<double>& inputs, const Row& set = {}) {
    for (const auto& law : evaluateLaws()) {
        if (law.id != id)
            continue;
        std::vector<double> parameters;
        for (const auto& p : law.parameters)
            parameters.push_back(set.contains(std::string(p.name)) ? set.at(std::string(p.name))
                                                                   : p.defaultValue);
        std::vector<double> out(law.outputs.size());
        if (inputs.size() != law.inputs.size())
            qFatal("inputs");
        law.evaluate(parameters, inputs, out);
        Row named;
        for (std::size_t i = 0; i < out.size(); ++i)
            named[std::string(law.outputs[i].name)] = out[i];
        return named;
    }
    qFatal("no such law");
    return {};
}

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-12 * std::max(1.0, std::abs(b));
}
} // namespace

// The tables of P3's laws against their equations, and the lean's own edges.
class TestEvaluatePalpation : public QObject {
    Q_OBJECT
private slots:
    void voigt();
    void contact();
    void lump();
    void lumpTableIsTheContact();
    void angleIsTheLibrarys();
    void leanIsSplitAlongItsOwnDirection();
    void leanIsContinuous();
    void leanNeedsAFlatFinger();
};

void TestEvaluatePalpation::voigt() {
    Row r = row("voigt", {0.001, -0.002, 0.003, 0.2, 0.0, -0.1});
    QVERIFY(near(r["fx_N"], 0.81) && near(r["fy_N"], -1.4) && near(r["fz_N"], 1.9445));
    QVERIFY(near(r["energy_J"], 0.5 * (800e-6 + 700 * 4e-6 + 650 * 9e-6)));
    r = row("voigt",
            {0, 0, 1e-15, 0.1, 0.1, 0.1}); // 5 mN at 0.1 m/s: about one count of the fingertip's converter
    QVERIFY(near(r["fx_N"], 0.005) && near(r["fy_N"], 0.0045) && near(r["fz_N"], 0.0055));
    QCOMPARE(row("voigt", {0, 0, 0.0001, 0, 0, -5.0})["fz_N"], 0.0); // never pulls
    for (const double depth : {0.0, -1e-9, -0.002}) // no contact, whatever it is stretched by
        for (const auto& [name, value] : row("voigt", {0.001, -0.001, depth, 0.1, 0.1, 0.1}))
            QVERIFY2(value == 0.0, name.c_str());
    QVERIFY(near(row("voigt", {0, 0, 0.002, 0, 0, 0}, {{"kz_N_per_m", 300.0}})["fz_N"], 0.6));
}

void TestEvaluatePalpation::contact() {
    Row r = row("palpation-contact", {0.3, 0.0, 0.4, 0, 0, 1});
    QVERIFY(near(r["alpha_rad"], std::acos(0.8)) && near(r["normal_force_N"], 0.4)); // eq. 2, eq. 3
    QVERIFY(near(r["roll_rad"], kPi / 9.0) && r["pitch_rad"] == 0.0 && r["saturated"] == 1.0);
    r = row("palpation-contact", {0.0, 0.3, 0.4, 0, 0, 1},
            {{"largest_pitch_rad", 1.0}, {"largest_lean_rad", 1.0}});
    QVERIFY(near(r["pitch_rad"], -std::acos(0.8)) && r["saturated"] == 0.0);
    r = row("palpation-contact", {0.0, 0.3, 0.4, 0, 0, 1}, {{"largest_pitch_rad", 1.0}}); // 30° in all
    QVERIFY(near(r["pitch_rad"], -kPi / 6.0) && r["saturated"] == 1.0);
    // Roll at its 20°, pitch 30°: 36° in all, shown is 30°, its direction kept.
    const double slope = std::tan(std::hypot(kPi / 6.0, kPi / 9.0)) / std::hypot(3.0, 2.0);
    r = row("palpation-contact", {2.0 * slope, 3.0 * slope, 1.0, 0, 0, 1});
    QVERIFY(near(std::hypot(r["pitch_rad"], r["roll_rad"]), kPi / 6.0) &&
            near(r["roll_rad"], -r["pitch_rad"] * 2.0 / 3.0) && r["saturated"] == 1.0);
    // Limiting first would show 1.35 times as much at 50°: cos 30°/cos 50°.
    r = row("palpation-contact", {0, std::sin(50 * kPi / 180), std::cos(50 * kPi / 180), 0, 0, 1});
    QVERIFY(near(r["normal_force_N"], std::cos(50 * kPi / 180)) && near(std::abs(r["pitch_rad"]), kPi / 6));
    QVERIFY(std::abs(std::cos(kPi / 6) / r["normal_force_N"] - 1.347) < 1e-3);
    r = row("palpation-contact", {0.02, 0.0, 0.015, 0, 0, 1}); // 25 mN: half of the way in
    QVERIFY(near(r["alpha_rad"], 0.5 * std::atan2(4, 3)) && near(r["normal_force_N"], 0.015));
    r = row("palpation-contact", {0.0, 0.0, -1.0, 0, 0, 1}); // nothing pulls on a pad
    QVERIFY(r["normal_force_N"] == 0.0 && r["alpha_rad"] == 0.0);
    r = row("palpation-contact", {1, 0, 1, 0, 0, 0});
    QVERIFY(r["alpha_rad"] == 0.0 && r["normal_force_N"] == 0.0);
    // The normal turned with the force and the finger changes nothing.
    const Eigen::AngleAxisd turn(0.7, Vec3(1, 2, 2).normalized());
    const Vec3 f = turn * Vec3(0.1, 0.05, 1.0), n = turn * Vec3::UnitZ(), x = turn * Vec3::UnitX();
    const Row a = row("palpation-contact", {0.1, 0.05, 1.0, 0, 0, 1});
    const Row b = row("palpation-contact", {f.x(), f.y(), f.z(), n.x(), n.y(), n.z()},
                      {{"finger_x", x.x()}, {"finger_y", x.y()}, {"finger_z", x.z()}});
    for (const auto& [name, value] : a)
        QVERIFY(near(value, b.at(name)));
}

void TestEvaluatePalpation::lump() {
    const double a = 0.004, R = 0.006, h = 0.011, m = 5.0, k = 300.0, lambda = 0.2, d = 0.003, rho = 0.005;
    const Row set{{"a_m", a}, {"R_m", R}, {"h_m", h}, {"m", m}, {"k_N_per_m", k}, {"lambda", lambda}};
    const auto chi = [&](double depth, double away) {
        const double H2 = std::pow(h - lambda * depth, 2) + 5.0 / 3.0 * a * a;
        return 8.0 / kPi * a * R * R * R * H2 / std::pow(away * away + H2, 3) * (m - 1.0) /
               (1.0 + 0.4 * (m - 1.0));
    };
    const auto U = [&](double depth, double away) {
        return 0.5 * k * depth * depth * (1.0 + chi(depth, away));
    };
    Row r = row("palpation-lump", {d, rho}, set);
    constexpr double e = 1e-6;
    QVERIFY(near(r["chi"], chi(d, rho)) && near(r["energy_J"], U(d, rho)));
    QVERIFY(std::abs(r["normal_force_N"] - (U(d + e, rho) - U(d - e, rho)) / (2 * e)) < 1e-7);
    QVERIFY(std::abs(r["lateral_force_N"] + (U(d, rho + e) - U(d, rho - e)) / (2 * e)) < 1e-7);
    QVERIFY(r["lateral_force_N"] > 0.0 && row("palpation-lump", {d, -rho}, set)["lateral_force_N"] < 0.0);
    r = row("palpation-lump", {-0.001, rho}, set);
    QVERIFY(r["normal_force_N"] == 0.0 && r["energy_J"] == 0.0 && r["chi"] > 0.0);
    QCOMPARE(row("palpation-lump", {d, rho}, {{"m", 1.0}})["chi"], 0.0);
    QVERIFY(near(row("palpation-lump", {d, 0.0}, {{"m", 1.0}})["normal_force_N"], 680.0 / 3.0 * d));
}

void TestEvaluatePalpation::lumpTableIsTheContact() {
    for (const double rho : {0.0, 0.003, 0.012})
        for (const double d : {0.0005, 0.002, 0.004}) {
            Row r = row("palpation-lump", {d, rho});
            const TissueResponse felt = pressAt(contactOf(quietPad(), {Lump{}}), Vec3(rho, 0, -d));
            QVERIFY(near(r["normal_force_N"], felt.force.z()) && near(r["lateral_force_N"], felt.force.x()) &&
                    near(r["energy_J"], felt.energy_J));
        }
}

void TestEvaluatePalpation::angleIsTheLibrarys() {
    core::Random random(13);
    for (int n = 0; n < 100000; ++n) {
        const double lateral = std::pow(10.0, random.uniform(-9.0, 1.0)),
                     along = std::pow(10.0, random.uniform(-9.0, 1.0)) * (n % 5 == 0 ? -1.0 : 1.0);
        QVERIFY(std::abs(leanAngle(lateral, along) - std::atan2(lateral, along)) < 2e-15);
    }
    QVERIFY(std::abs(leanAngle(1.0, 0.0) - 0.5 * kPi) < 1e-15 &&
            std::abs(leanAngle(1.0, 1.0) - 0.25 * kPi) < 1e-15);
}

// Whatever its direction, the shown lean points along the lateral force and ends within 30° and on the
// platform's rectangle.
void TestEvaluatePalpation::leanIsSplitAlongItsOwnDirection() {
    for (int n = 0; n < 360; ++n) {
        const double way = n * kPi / 180.0;
        const Vec3 lateral(std::cos(way), std::sin(way), 0.0);
        for (const double angle : {0.1, 0.3, 0.6, 1.2}) {
            const Lean lean = leanOf(2.0 * (std::sin(angle) * lateral + std::cos(angle) * Vec3::UnitZ()),
                                     Vec3::UnitZ(), Vec3::UnitX());
            QVERIFY(near(lean.angle_rad, angle));
            const double roll = lean.display.roll_rad, pitch = lean.display.pitch_rad;
            QVERIFY(std::abs(roll * lateral.y() + pitch * lateral.x()) < 1e-12 && roll * lateral.x() >= 0.0 &&
                    pitch * lateral.y() <= 0.0);
            const double shown = std::hypot(roll, pitch);
            QVERIFY(std::abs(roll) <= kPi / 9 + 1e-12 && shown <= kPi / 6 + 1e-12); // so |pitch| ≤ 30° too
            if (lean.saturated)
                QVERIFY(shown < angle && (near(std::abs(roll), kPi / 9) || near(shown, kPi / 6)));
            else
                QVERIFY(near(shown, angle));
        }
    }
}

// By force: |Δ(angle)| ≤ 90° · the smoothstep's slope 1.5/50 mN · 1 µN plus 1 µN/50 mN, into and out of
// saturation too.
void TestEvaluatePalpation::leanIsContinuous() {
    core::Random random(8);
    for (int n = 0; n < 200000; ++n) {
        const double size = std::pow(10.0, random.uniform(-6.0, 0.5));
        const Vec3 f = size * randomUnit(random);
        const Vec3 step = 1e-6 * randomUnit(random);
        if (std::hypot(f.x(), f.y()) < 1e-4 && f.z() < 0.0) // pulled straight: no contact does
            continue;
        const Lean a = leanOf(f, Vec3::UnitZ(), Vec3::UnitX()),
                   b = leanOf(f + step, Vec3::UnitZ(), Vec3::UnitX());
        const double bound = 1e-6 * (0.5 * kPi * 1.5 / 0.05 + 1.0 / 0.05) * 2.0 + 1e-9;
        QVERIFY(std::abs(a.normalForce_N - b.normalForce_N) <= 1.001e-6);
        if (f.z() < 0.0)
            continue;
        QVERIFY2(std::abs(a.angle_rad - b.angle_rad) <= bound,
                 qPrintable(QString::number(std::abs(a.angle_rad - b.angle_rad))));
        const double shown =
            std::hypot(a.display.pitch_rad - b.display.pitch_rad, a.display.roll_rad - b.display.roll_rad);
        // The lean vector α·t/‖t‖ turns no faster than α/‖t‖ ≤ (π/2)·(1/‖F‖)·min(1, 3(‖F‖/50 mN)²) a newton.
        QVERIFY2(shown <= 2.0 * bound + 1e-6 * 0.5 * kPi * 3.0 / 0.05, qPrintable(QString::number(shown)));
    }
}

void TestEvaluatePalpation::leanNeedsAFlatFinger() {
    const Vec3 f(0.1, 0.05, 1.0);
    QVERIFY(leanOf(f, Vec3::UnitZ(), Vec3::UnitZ()).display.roll_rad ==
            0.0); // the finger's x on the normal: no direction, no lean
    double before = 0.0;
    for (int i = 0; i <= 2000; ++i) { // tipping it over
        const double up = 0.5 * kPi * (1.0 - i / 2000.0);
        const Lean lean = leanOf(f, Vec3::UnitZ(), Vec3(std::cos(up), 0.0, std::sin(up)));
        const double now = lean.display.roll_rad;
        QVERIFY(std::abs(now - before) < 1e-3);
        QVERIFY(near(lean.angle_rad, std::atan(std::hypot(0.1, 0.05))));
        before = now;
    }
    QVERIFY(near(before, leanOf(f, Vec3::UnitZ(), Vec3::UnitX()).display.roll_rad));
}

QTEST_APPLESS_MAIN(TestEvaluatePalpation)
#include "test_evaluate_palpation.moc"
