// SPDX-License-Identifier: GPL-3.0-or-later
// The canal that the levels' texts describe, in every language, is the one that is drawn and felt.
#include "app/exercises/urethra_insertion/scene/flat_profile.h"
#include "catalogue/catalogue.h"
#include "core/languages.h"
#include "modules/exercises/urethra_insertion/simulation/procedure_plan.h"
#include "modules/exercises/urethra_insertion/simulation/urethra_forces.h"
#include "simulation/geometry/urethra/urethra_surface.h"

#include <QRegularExpression>
#include <QtTest>
#include <algorithm>
#include <cmath>
#include <vector>

using namespace chiron;
using namespace chiron::scene3d;
using Parameters = simulation::UrethraInsertionParameters;

namespace {

const catalogue::Catalogue& shipped() {
    static const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    if (!catalogue)
        qFatal("%s", catalogue.error().message.c_str());
    return *catalogue;
}

const std::vector<catalogue::ExerciseLevel>& levels() {
    return shipped().find("urethra_insertion")->levels;
}

const Parameters& parametersOf(const catalogue::ExerciseLevel& level) {
    return level.parameters.as<Parameters>();
}

/// The lengths in a level's texts in one language, in ascending order.
std::vector<double> described_mm(const catalogue::ExerciseLevel& level, const std::string& language) {
    static const QRegularExpression length(QStringLiteral("(\\d+(?:[.,]\\d+)?)[\\s\u00a0]*mm"));
    std::vector<double> all;
    for (const catalogue::Translated* text : {&level.goal, &level.objective, &level.measured}) {
        const auto found = text->find(language);
        if (found == text->end())
            continue;
        auto each = length.globalMatch(QString::fromStdString(found->second));
        while (each.hasNext())
            all.push_back(each.next().captured(1).replace(',', '.').toDouble());
    }
    std::sort(all.begin(), all.end());
    return all;
}

/// Where the centre-line stops being straight.
double bendOf_m(const simulation::UrethraCentreline& line) {
    constexpr double step_m = 1e-4;
    int straight = 0;
    while (straight * step_m < line.length_m() && line.at((straight + 1) * step_m).psi_rad < 1e-9)
        ++straight;
    return straight * step_m;
}

bool has(const std::vector<double>& lengths_mm, double length_m) {
    return std::any_of(lengths_mm.begin(), lengths_mm.end(),
                       [&](double each) { return std::abs(each - 1e3 * length_m) < 1e-6; });
}

simulation::UrethraResponse felt(const Parameters& p, const core::Vec3& p_A, const core::Vec3& axis_A) {
    simulation::EndoscopeMotion motion;
    motion.p_A = p_A;
    motion.axis_A = axis_A;
    return simulation::UrethraForces(p.anatomy, p.endoscope, p.forces).respond(motion);
}

} // namespace

class TestDescribedCanal : public QObject {
    Q_OBJECT
private slots:
    void everyLanguageDescribesTheSame();
    void whatIsDescribedIsTheCanal();
    void theDrawnCanalBendsThere();
    void theDrawnLiningBendsThere();
    void theFeltCanalBendsThere();
};

void TestDescribedCanal::everyLanguageDescribesTheSame() {
    std::size_t lengths = 0;
    for (const catalogue::ExerciseLevel& level : levels()) {
        const std::vector<double> english = described_mm(level, "en");
        lengths += english.size();
        for (const std::string& language : core::languageIds())
            QVERIFY2(described_mm(level, language) == english,
                     qPrintable(QString::fromStdString(level.id + " in " + language)));
    }
    QVERIFY(lengths > 0); // else nothing was compared
}

/// Each length in the texts is where the bend begins or how far the level goes, and a level that ends at a
/// depth says it.
void TestDescribedCanal::whatIsDescribedIsTheCanal() {
    std::size_t bends = 0, goals = 0;
    for (const catalogue::ExerciseLevel& level : levels()) {
        const Parameters& p = parametersOf(level);
        const double bend_m = bendOf_m(simulation::UrethraCentreline(p.anatomy));
        const double goal_m = simulation::procedurePlan(p).goal_m;
        const std::vector<double> all = described_mm(level, "en");
        for (const double each : all)
            QVERIFY2(has({each}, bend_m) || has({each}, goal_m),
                     qPrintable(QStringLiteral("%1: %2 mm; it bends at %3 mm and ends at %4 mm")
                                    .arg(QString::fromStdString(level.id))
                                    .arg(each)
                                    .arg(1e3 * bend_m)
                                    .arg(1e3 * goal_m)));
        QVERIFY2(p.goalDepth_m == 0.0 || has(all, goal_m), level.id.c_str());
        bends += has(all, bend_m);
        goals += has(all, goal_m);
    }
    QVERIFY(bends > 0 && goals > 0);
}

void TestDescribedCanal::theDrawnCanalBendsThere() {
    for (const catalogue::ExerciseLevel& level : levels()) {
        const Parameters& p = parametersOf(level);
        const UrethraDrawing drawing(p);
        const double bend_m = bendOf_m(drawing.centreline()), length_m = drawing.centreline().length_m();
        const SceneSetup setup;
        const FlatProfile::Edges edges = FlatProfile(drawing, setup).edges(ToolView{}); // at rest
        const std::size_t last = edges.low.size() - 1;
        double before_m = 0.0;
        for (std::size_t i = 0; i <= last; ++i) {
            const double s_m = length_m * double(i) / double(last);
            const core::Vec3 middle_A = p.pose.pointToA(0.5 * (edges.low[i] + edges.high[i]));
            if (s_m <= bend_m)
                QVERIFY((middle_A - core::Vec3(0.0, 0.0, s_m)).norm() < 1e-9);
            else
                QVERIFY2(middle_A.y() > before_m, qPrintable(QString::number(s_m)));
            before_m = std::max(0.0, middle_A.y());
        }
        const double goal_m = simulation::procedurePlan(p).goal_m;
        QVERIFY(before_m > 0.03 && goal_m > bend_m); // it goes round the bend, and so does the level
    }
}

/// The same of the surface in three dimensions, which is interpolated between sections.
void TestDescribedCanal::theDrawnLiningBendsThere() {
    for (const catalogue::ExerciseLevel& level : levels()) {
        const Parameters& p = parametersOf(level);
        const double bend_m = bendOf_m(simulation::UrethraCentreline(p.anatomy));
        const simulation::UrethraSurface surface(p.anatomy, p.endoscope, p.mesh);
        const std::size_t ring = surface.ringSize();
        std::size_t straight = 0, bent = 0;
        for (std::size_t first = 0; first + ring <= surface.vertexCount(); first += ring) {
            double y_m = 0.0;
            for (std::size_t i = first; i < first + ring; ++i)
                y_m += surface.plane(1)[i] / double(ring);
            const double s_m = surface.arcLength_m()[first];
            if (s_m <= bend_m) {
                QVERIFY2(std::abs(y_m) < 3e-4, qPrintable(QString::number(s_m)));
                ++straight;
            } else if (s_m > bend_m + 0.010) {
                QVERIFY2(y_m > 1e-3, qPrintable(QString::number(s_m)));
                ++bent;
            }
        }
        QVERIFY(straight > 5 && bent > 5);
    }
}

/// On the centre-line nothing presses aside, before the bend and in it; who goes straight on meets the wall.
void TestDescribedCanal::theFeltCanalBendsThere() {
    for (const catalogue::ExerciseLevel& level : levels()) {
        const Parameters& p = parametersOf(level);
        const simulation::UrethraCentreline line(p.anatomy);
        const double bend_m = bendOf_m(line);
        for (const double s_m : {bend_m, bend_m + 0.025}) {
            const simulation::CentrelinePoint at = line.at(s_m);
            const simulation::UrethraResponse along = felt(p, at.p_A, at.t_A);
            QVERIFY2(along.lateral_A.norm() < 0.01, qPrintable(QString::number(along.lateral_A.norm())));
            QVERIFY(std::abs(along.foot.at.s_m - s_m) < 1e-6); // the depth that is told
        }
        const simulation::UrethraResponse straightOn =
            felt(p, core::Vec3(0.0, 0.0, bend_m + 0.025), core::Vec3::UnitZ());
        QVERIFY2(straightOn.lateral_A.norm() > 1.0, qPrintable(QString::number(straightOn.lateral_A.norm())));
        QVERIFY(straightOn.lateral_A.y() > 0.0); // towards the canal, which has turned up
    }
}

QTEST_GUILESS_MAIN(TestDescribedCanal)
#include "test_described_canal.moc"
