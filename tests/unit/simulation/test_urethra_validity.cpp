// SPDX-License-Identifier: GPL-3.0-or-later
#include "simulation/geometry/urethra/urethra_validity_setup.h"

#include <QtTest>
#include <functional>
#include <limits>

using namespace chiron;
using simulation::Endoscope;
using simulation::UrethraAnatomy;
using simulation::UrethraMeshSettings;

namespace {

struct Urethra {
    UrethraAnatomy anatomy;
    Endoscope endoscope;
    UrethraMeshSettings mesh;
};

Urethra withTwoChanges() {
    Urethra u;
    u.anatomy.changes[0] = {0.050, 0.012, 0.004, 0.0015, 15.0, 1.0};
    u.anatomy.changes[1] = {0.090, 0.012, 0.004, 0.0015, 15.0, 1.0};
    u.anatomy.changeCount = 2;
    return u;
}

std::vector<simulation::UrethraProblem> problems(const Urethra& u) {
    return simulation::urethraProblems(u.anatomy, u.endoscope, u.mesh);
}

void row(const char* field, const char* words, std::function<void(Urethra&)> spoil) {
    QTest::addRow("%s %s", field, words) << spoil << QString(field) << QString(words);
}

void addWalls() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    row("curvature_per_m", "more than 0", [](Urethra& u) { u.anatomy.curvature_per_m = 0.0; });
    row("zEnd_m", "at least 0.01", [](Urethra& u) { u.anatomy.zEnd_m = -0.1; });
    row("radius_m", "is 0", [](Urethra& u) { u.anatomy.radius_m = 0.0; });
    row("radius_m", "nan", [nan](Urethra& u) { u.anatomy.radius_m = nan; });
    row("radius_m", "crosses itself", [](Urethra& u) {
        u.anatomy.radius_m = 0.0385;
        u.anatomy.bladderRadius_m = 0.4;
    });
    row("endoscope.radius_m",
        "crosses itself at s = 0:", [](Urethra& u) { u.anatomy.curvature_per_m = 140.0; });
    row("wallStiffness_N_per_m3", "-1", [](Urethra& u) { u.anatomy.wallStiffness_N_per_m3 = -1.0; });
    row("wallStiffening_per_m", "-1", [](Urethra& u) { u.anatomy.wallStiffening_per_m = -1.0; });
    row("friction", "-0.1", [](Urethra& u) { u.anatomy.friction = -0.1; });
    row("wallRetardation_s", "-1", [](Urethra& u) { u.anatomy.wallRetardation_s = -1.0; });
    row("viscosity_Ns_per_m2", "-1", [](Urethra& u) { u.anatomy.viscosity_Ns_per_m2 = -1.0; });
    row("angularStiffness_Nm_per_rad", "-1",
        [](Urethra& u) { u.anatomy.angularStiffness_Nm_per_rad = -1.0; });
    row("freeLength_m", "ends at 0.139", [](Urethra& u) { u.anatomy.freeLength_m = 0.15; });
    row("freeBlend_m", "is 0", [](Urethra& u) { u.anatomy.freeBlend_m = 0.0; });
    row("freeBlend_m", "is 0.041", [](Urethra& u) { u.anatomy.freeBlend_m = 0.041; });
    row("angularCorner_m", "outside the body", [](Urethra& u) {
        u.anatomy.freeLength_m = u.anatomy.freeBlend_m = 0.005;
        u.anatomy.angularCorner_m = 0.0051;
    });
    row("angularCorner_m", "run into", [](Urethra& u) { u.anatomy.freeLength_m = 0.135; });
}

void addChangesAndTheRest() {
    row("changes[1].length_m", "at least 0.01", [](Urethra& u) { u.anatomy.changes[1].length_m = 0.005; });
    row("changes[0].edge_m", "at most 0.012", [](Urethra& u) { u.anatomy.changes[0].edge_m = 0.013; });
    row("changes[0].radius_m", "more than 0", [](Urethra& u) { u.anatomy.changes[0].radius_m = -0.001; });
    row("changes[1].stiffnessFactor", "-2", [](Urethra& u) { u.anatomy.changes[1].stiffnessFactor = -2.0; });
    row("changes[1].frictionFactor", "-2", [](Urethra& u) { u.anatomy.changes[1].frictionFactor = -2.0; });
    row("changes[0].centre_m", "out of the canal", [](Urethra& u) { u.anatomy.changes[0].centre_m = 0.007; });
    row("changes[1].centre_m", "out of the canal", [](Urethra& u) { u.anatomy.changes[1].centre_m = 0.135; });
    row("changes[1].centre_m", "changes[0]", [](Urethra& u) { u.anatomy.changes[1].centre_m = 0.0655; });
    row("changeCount", "at most 8", [](Urethra& u) { u.anatomy.changeCount = 9; });
    row("bladderRadius_m", "is 0", [](Urethra& u) { u.anatomy.bladderRadius_m = 0.0; });
    row("bladderStiffness_N_per_m", "-1", [](Urethra& u) { u.anatomy.bladderStiffness_N_per_m = -1.0; });
    row("bladderOpening_rad", "narrower", [](Urethra& u) { u.anatomy.bladderOpening_rad = 0.05; });
    row("bladderOpeningEdge_rad", "is 0", [](Urethra& u) { u.anatomy.bladderOpeningEdge_rad = 0.0; });
    row("bladderOpeningEdge_rad", "whole bladder",
        [](Urethra& u) { u.anatomy.bladderOpeningEdge_rad = 3.0; });
    row("endoscope.radius_m", "more than 0", [](Urethra& u) { u.endoscope.radius_m = 0.0; });
    row("endoscope.beak_m", "at least 0.001", [](Urethra& u) { u.endoscope.beak_m = 0.0; });
    row("endoscope.behind_m", "more than 0", [](Urethra& u) { u.endoscope.behind_m = 0.0; });
    row("endoscope.fieldOfView_rad", "below pi", [](Urethra& u) { u.endoscope.fieldOfView_rad = 4.0; });
    row("mesh.n", "is 3", [](Urethra& u) { u.mesh.n = 3; });
    row("mesh.n", "is 4",
        [](Urethra& u) { u.mesh.n = 4; }); // three distinct points: the first one counts twice
    row("mesh.n", "at most 129", [](Urethra& u) { u.mesh.n = 130; });
    row("mesh.w", "at least 4", [](Urethra& u) { u.mesh.w = 3; });
    row("mesh.w", "at most 401", [](Urethra& u) { u.mesh.w = 402; });
    row("mesh.perPatch", "at least 1", [](Urethra& u) { u.mesh.perPatch = 0; });
    row("mesh.perPatch", "at most 32", [](Urethra& u) { u.mesh.perPatch = 33; });
    row("mesh.movingSections", "at least 3", [](Urethra& u) { u.mesh.movingSections = 2; });
    row("mesh.movingSections", "at most 33", [](Urethra& u) { u.mesh.movingSections = 34; });
}

} // namespace

class TestUrethraValidity : public QObject {
    Q_OBJECT
private slots:
    void goodOnesPass();
    void badOnesNameTheirField_data();
    void badOnesNameTheirField();
    void everythingWrongIsListed();
};

void TestUrethraValidity::goodOnesPass() {
    QVERIFY(problems(Urethra{}).empty());
    Urethra u = withTwoChanges();
    QVERIFY(problems(u).empty());
    u.endoscope.radius_m = 0.001;           // thinner than the canal
    u.anatomy.changes[1].centre_m = 0.0661; // just not over the first: 16 mm apart at least
    u.mesh = {5, 4, 1, 3};
    QVERIFY(problems(u).empty());
    u.anatomy.freeLength_m = u.anatomy.freeBlend_m = u.anatomy.angularCorner_m =
        0.005; // as short as its corners allow
    QVERIFY(problems(u).empty());
    u.mesh = {129, 401, 32, 33};
    u.anatomy.wallStiffness_N_per_m3 = 0.0;
    QVERIFY(simulation::checkUrethra(u.anatomy, u.endoscope, u.mesh).has_value());
}

void TestUrethraValidity::badOnesNameTheirField_data() {
    QTest::addColumn<std::function<void(Urethra&)>>("spoil");
    QTest::addColumn<QString>("field");
    QTest::addColumn<QString>("words");
    addWalls();
    addChangesAndTheRest();
}

void TestUrethraValidity::badOnesNameTheirField() {
    QFETCH(std::function<void(Urethra&)>, spoil);
    QFETCH(QString, field);
    QFETCH(QString, words);
    Urethra u = withTwoChanges();
    spoil(u);
    const auto found = problems(u);
    QVERIFY(!found.empty());
    QCOMPARE(QString::fromStdString(found.front().field), field);
    QVERIFY2(QString::fromStdString(found.front().reason).contains(words), found.front().reason.c_str());
    QCOMPARE(found.size(), std::size_t(1));
    const auto checked = simulation::checkUrethra(u.anatomy, u.endoscope, u.mesh);
    QVERIFY(!checked && checked.error().code == core::ErrorCode::badInput);
    QVERIFY(QString::fromStdString(checked.error().message).startsWith(field));
}

void TestUrethraValidity::everythingWrongIsListed() {
    Urethra u = withTwoChanges();
    u.anatomy.radius_m = -1.0;
    u.anatomy.friction = -1.0;
    u.anatomy.changes[1].length_m = 0.0;
    u.mesh.n = 3;
    const auto found = problems(u);
    QStringList fields;
    for (const auto& problem : found)
        fields << QString::fromStdString(problem.field);
    QCOMPARE(fields,
             (QStringList{"radius_m", "friction", "changes[1].length_m", "changes[1].edge_m", "mesh.n"}));
    QVERIFY(simulation::checkUrethra(u.anatomy, u.endoscope, u.mesh).error().message.find("4 more") !=
            std::string::npos);
}

QTEST_APPLESS_MAIN(TestUrethraValidity)
#include "test_urethra_validity.moc"
