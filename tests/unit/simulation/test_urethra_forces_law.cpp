// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/exercises/urethra_insertion/simulation/urethra_forces_law.h"
#include "simulation/evaluate_laws.h"
#include "urethra_states.h"

#include <QtTest>
#include <algorithm>
#include <map>
#include <string>

using namespace chiron;
using namespace chiron::simulation;
using namespace chiron::simulation::testing;

namespace {

using Values = std::map<std::string, double>;

Values rowOf(const Values& parameters, const EndoscopeMotion& m) {
    const core::LawDescription& law = urethraForceLaw();
    std::vector<double> p;
    for (const auto& parameter : law.parameters) {
        const auto given = parameters.find(std::string(parameter.name));
        p.push_back(given == parameters.end() ? parameter.defaultValue : given->second);
    }
    const std::vector<double> in{m.p_A.x(), m.p_A.y(), m.p_A.z(), m.axis_A.x(), m.axis_A.y(), m.axis_A.z(),
                                 m.v_A.x(), m.v_A.y(), m.v_A.z(), m.w_A.x(),    m.w_A.y(),    m.w_A.z()};
    std::vector<double> out(law.outputs.size());
    law.evaluate(p, in, out);
    Values row;
    for (std::size_t i = 0; i < out.size(); ++i)
        row[std::string(law.outputs[i].name)] = out[i];
    return row;
}

} // namespace

class TestUrethraForcesLaw : public QObject {
    Q_OBJECT
private slots:
    void isListed();
    void rowsAreTheModel();
    void everyParameterReachesTheModel();
    void axisMayHaveAnyLengthButNone();
    void impossibleUrethrasAreRefused();
};

void TestUrethraForcesLaw::isListed() {
    const auto laws = evaluateLaws();
    QVERIFY(std::any_of(laws.begin(), laws.end(), [](const auto& law) { return law.id == "urethra-force"; }));
}

void TestUrethraForcesLaw::rowsAreTheModel() {
    const UrethraForces forces({}, {});
    core::Random random(41);
    for (int n = 0; n < 50; ++n) {
        EndoscopeMotion motion = randomMotion(random, forces.centreline());
        motion.axis_A /= motion.axis_A.norm();
        const UrethraResponse r = forces.respond(motion);
        Values row = rowOf({}, motion);
        QCOMPARE(row["s_m"], r.foot.at.s_m);
        QCOMPARE(row["normal_N"], r.normal_N);
        QCOMPARE(row["elastic_N"], r.elastic_N);
        QCOMPARE(row["lateral_x_N"], r.lateral_A.x());
        QCOMPARE(row["torque_z_Nm"], r.torqueZ_Nm);
        QCOMPARE(row["fy_N"], r.wrench_A.force.y());
        QCOMPARE(row["tx_Nm"], r.wrench_A.torque.x());
        QCOMPARE(row["energy_J"], r.energy_J);
    }
}

/// Turning any knob within its range changes some output of one of these poses: deep in the canal, in the
/// bladder's wall, or with the free part pulled aside.
void TestUrethraForcesLaw::everyParameterReachesTheModel() {
    const UrethraCentreline line{UrethraAnatomy{}};
    core::Random random(42);
    std::vector<EndoscopeMotion> poses;
    for (const double s : {0.043, 0.079, 0.136}) {
        poses.push_back(motionAt(line, {s, 0.002, 0.001, 0.2, 0.1}));
        poses.back().v_A = randomVector(random, 0.001);
        poses.back().w_A = randomVector(random, 1.0);
    }
    const CentrelinePoint neck = line.at(line.length_m());
    poses.push_back(poses.back());
    poses.back().p_A = neck.p_A + 0.034 * (neck.t_A - std::cos(0.3) * neck.t_A + std::sin(0.3) * neck.n_A);
    poses.push_back(motionAt(line, {.s_m = 0.020, .ex_m = 0.015}));
    for (const auto& parameter : urethraForceLaw().parameters) {
        Values usual{{"change_length_m", 0.012},
                     {"maximum_damping_Ns_per_m", 1000.0},
                     {"count_m", 5e-5}}; // V₀ by the count
        const std::string name(parameter.name);
        Values turned = usual;
        const double from = usual.count(name) > 0 ? usual[name] : parameter.defaultValue;
        turned[name] = name == "basic_sections"             ? 26.0
                       : name == "step_m"                   ? 0.001
                       : name == "maximum_damping_Ns_per_m" ? 1.0
                       : name == "free_hold_N_per_m"        ? 600.0
                       : name == "straight_m"               ? 0.030
                       : name == "pivot_span_m"             ? 0.020
                       : name == "wall_retardation_s"       ? 0.005
                                                            : from * 1.3;
        QVERIFY2(turned[name] <= parameter.maximum, name.c_str());
        const bool changed = std::any_of(poses.begin(), poses.end(), [&](const EndoscopeMotion& pose) {
            return rowOf(usual, pose) != rowOf(turned, pose);
        });
        QVERIFY2(changed, name.c_str());
    }
}

void TestUrethraForcesLaw::axisMayHaveAnyLengthButNone() {
    const UrethraForces forces({}, {});
    EndoscopeMotion motion = motionAt(forces.centreline(), {0.080, 0.001, 0.0, 0.3, 0.0});
    const double torque = rowOf({}, motion)["torque_x_Nm"];
    motion.axis_A *= 7.0;
    QVERIFY(std::abs(rowOf({}, motion)["torque_x_Nm"] - torque) < 1e-15 && torque != 0.0);
    motion.axis_A.setZero();
    QVERIFY(std::isnan(rowOf({}, motion)["torque_x_Nm"]));
}

// Each of these reads as a number in its own range, and no urethra can be like it.
void TestUrethraForcesLaw::impossibleUrethrasAreRefused() {
    const UrethraForces forces({}, {});
    const EndoscopeMotion motion = motionAt(forces.centreline(), {0.080, 0.001, 0.0, 0.3, 0.0});
    const std::vector<Values> impossible{
        {{"change_length_m", 0.005}},
        {{"change_length_m", 0.012}, {"change_edge_m", 0.020}},
        {{"change_length_m", 0.012}, {"change_centre_m", 0.250}},
        {{"free_length_m", 0.200}},
        {{"free_length_m", 0.004}, {"free_blend_m", 0.004}, {"angular_corner_m", 0.005}},
        {{"free_length_m", 0.030}, {"free_blend_m", 0.031}},
        {{"bladder_opening_rad", 0.02}},
        {{"straight_m", 0.036}},
        {{"straight_m", 0.095}, {"free_length_m", 0.1}},
        {{"radius_m", 0.006}, {"curvature_per_m", 100.0}}};
    for (const Values& values : impossible)
        for (const auto& [name, value] : rowOf(values, motion))
            QVERIFY2(std::isnan(value), (values.begin()->first + ": " + name).c_str());
    for (const auto& [name, value] :
         rowOf({{"free_length_m", 0.005}, {"free_blend_m", 0.005}, {"angular_corner_m", 0.005}}, motion))
        QVERIFY2(std::isfinite(value), name.c_str());
}

QTEST_APPLESS_MAIN(TestUrethraForcesLaw)
#include "test_urethra_forces_law.moc"
