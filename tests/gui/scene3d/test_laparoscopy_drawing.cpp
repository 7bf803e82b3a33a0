// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of tube and ovaries: where the forces say, no longer and no thicker than it is.
#include "app/exercises/elastic_tube/scene/fold_sheet.h"
#include "app/exercises/elastic_tube/scene/mark_ring.h"
#include "app/exercises/elastic_tube/scene/tension_bar.h"
#include "app/exercises/elastic_tube/scene/tube_mesh.h"
#include "app/exercises/object_handling/scene/squeeze_bar.h"
#include "app/exercises/object_handling/scene/squeezed.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/scene3d/abdomen/abdomen_mesh.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/instrument_mesh.h"
#include "gui/scene3d/laparoscopy_samples.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::scene3d;

namespace {

constexpr double kRadius_m = 0.003;
constexpr double kRest_m = 0.045;

core::Vec3 placeOf(const core::LaparoscopyCues& cues, std::size_t i) {
    return {cues.p_WGrip[i][0], cues.p_WGrip[i][1], cues.p_WGrip[i][2]};
}

/// How far the nearest ring is from a place.
double away_m(const TubeCurve& curve, const core::Vec3& p) {
    double least = 1.0;
    for (const TubePiece& piece : curve.pieces)
        for (const TubeRing& ring : piece.rings)
            least = std::min(least, (ring.p_W - p).norm());
    return least;
}

bool isWhole(const TriangleMesh& mesh) {
    if (mesh.indices.empty() || mesh.indices.size() % 3 != 0)
        return false;
    for (const std::uint32_t index : mesh.indices)
        if (index >= mesh.vertices.size())
            return false;
    for (const MeshVertex& v : mesh.vertices) {
        const core::Vec3 normal(double(v.normal[0]), double(v.normal[1]), double(v.normal[2]));
        if (!std::isfinite(v.position_mm[0]) || !std::isfinite(v.position_mm[1]) ||
            !std::isfinite(v.position_mm[2]) || std::abs(normal.norm() - 1.0) > 1e-3)
            return false;
    }
    return true;
}

core::Vec3 vec(const float (&v)[3]) {
    return {double(v[0]), double(v[1]), double(v[2])};
}

int facingInwards(const TriangleMesh& mesh) {
    int wrong = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const MeshVertex& a = mesh.vertices[mesh.indices[i]];
        const MeshVertex& b = mesh.vertices[mesh.indices[i + 1]];
        const MeshVertex& c = mesh.vertices[mesh.indices[i + 2]];
        const core::Vec3 across =
            (vec(b.position_mm) - vec(a.position_mm)).cross(vec(c.position_mm) - vec(a.position_mm));
        wrong +=
            across.norm() > 1e-4 && across.dot(vec(a.normal) + vec(b.normal) + vec(c.normal)) < 0.0 ? 1 : 0;
    }
    return wrong;
}

} // namespace

class TestLaparoscopyDrawing : public QObject {
    Q_OBJECT
private slots:
    /// The line under an instrument shows where what it holds would be set down; of an object that is not
    /// shown it tells nothing.
    void whatIsHeldIsSetDown() {
        SceneState state = samples::handlingState(true);
        core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
        QVERIFY(cues.objectShown && cues.bodies > 0);
        core::BodyCue& body = cues.body[static_cast<std::size_t>(cues.bodies - 1)];
        for (core::BodyCue& each : cues.body)
            each.heldBy = 0;
        const core::Vec3 tip = drawnTip(state.tool[0]);
        QCOMPARE(setDownBy(state, 0), tip);
        body.p_W = {tip.x() + 0.004, tip.y(), tip.z() - 0.006};
        body.heldBy = 1;
        QCOMPARE(setDownBy(state, 0), core::Vec3(body.p_W[0], body.p_W[1], body.p_W[2]));
        body.heldBy = 2; // by the other one
        QCOMPARE(setDownBy(state, 0), tip);
        body.heldBy = 1;
        cues.objectShown = false;
        QCOMPARE(setDownBy(state, 0), tip);
    }

    /// Its edge is where it is felt, whether it hangs or is held; closed it lies over the tube, drawn back
    /// beside it.
    void aFoldGoesThroughItsEdge() {
        SceneState state = samples::twoHanded(0.050);
        core::LaparoscopyCues& cues = state.exercise.own<core::LaparoscopyCues>();
        QVERIFY(FoldSheet::of(cues).rows.empty());
        cues.fold = true;
        cues.p_WFoldBase = {0.0, -0.004, 0.0};
        const auto covers = [&cues] { // the highest point of it over the tube's middle
            double most = -1.0;
            for (const auto& row : FoldSheet::of(cues).rows)
                for (const core::Vec3& p : row)
                    most = std::hypot(p.x(), p.y()) < 0.008 ? std::max(most, p.z()) : most;
            return most;
        };
        for (const bool held : {false, true}) {
            cues.foldHeldBy = held ? 4 : 0;
            const core::Vec3 edge = held ? core::Vec3(0.0, 0.030, 0.026) : core::Vec3(0.0, -0.004, 0.010);
            cues.p_WFoldEdge = {edge.x(), edge.y(), edge.z()};
            const FoldSheet sheet = FoldSheet::of(cues);
            double nearest = 1.0;
            for (const auto& row : sheet.rows)
                for (const core::Vec3& p : row)
                    nearest = std::min(nearest, (p - edge).norm());
            QVERIFY2(nearest < 0.0015, qPrintable(QString::number(nearest)));
            QCOMPARE(covers() > 0.0, !held);
            const TriangleMesh mesh = foldMesh(sheet, 0.3);
            QVERIFY(isWhole(mesh));
            QCOMPARE(facingInwards(mesh), 0);
        }
    }

    void tautTubeIsStraightAndKeepsItsVolume() {
        const SceneState state = samples::tubeState({0.030, -0.010, 0.055}, true);
        const core::LaparoscopyCues& cues = state.exercise.of<core::LaparoscopyCues>();
        const TubeCurve curve = TubeCurve::of(cues, kRadius_m);
        QCOMPARE(curve.pieces.size(), std::size_t(1));
        const double chord_m = (placeOf(cues, 1) - placeOf(cues, 0)).norm();
        QVERIFY(chord_m > kRest_m);
        QVERIFY(std::abs(curve.length_m() - chord_m) < 1e-9);
        const auto middle = curve.at(0.5);
        QVERIFY(middle.has_value());
        QVERIFY(std::abs(middle->radius_m - kRadius_m * std::sqrt(kRest_m / chord_m)) < 1e-9);
        QVERIFY(middle->pale > 0.0);
        QVERIFY(away_m(curve, placeOf(cues, 0)) < 1e-9 && away_m(curve, placeOf(cues, 1)) < 1e-9);
    }

    void slackTubeIsAsLongAsAtRestAndStaysOnTheFloor() {
        for (const core::Vec3& end : {core::Vec3(0.010, -0.010, 0.020), core::Vec3(-0.004, 0.004, 0.030),
                                      core::Vec3(0.030, 0.010, 0.004)}) {
            const SceneState state = samples::tubeState(end, true);
            const TubeCurve curve = TubeCurve::of(state.exercise.of<core::LaparoscopyCues>(), kRadius_m);
            QVERIFY2(std::abs(curve.length_m() - kRest_m) < 2e-4,
                     qPrintable(QString::number(curve.length_m())));
            QVERIFY(away_m(curve, end) < 1e-9);
            for (const TubeRing& ring : curve.pieces.front().rings)
                QVERIFY(ring.p_W.z() > -1e-9);
            QCOMPARE(curve.at(0.5)->pale, 0.0);
        }
    }

    void smallMovesMoveTheCurveLittle() {
        core::Vec3 before = core::Vec3::Zero();
        for (int i = 0; i < 400; ++i) {
            const core::Vec3 end(0.020 * std::cos(0.01 * i), 0.020 * std::sin(0.013 * i),
                                 0.020 + 0.00008 * i);
            const TubeCurve curve =
                TubeCurve::of(samples::tubeState(end, true).exercise.of<core::LaparoscopyCues>(), kRadius_m);
            const core::Vec3 middle = curve.at(0.5)->p_W;
            if (i > 0)
                QVERIFY2((middle - before).norm() < 0.004, qPrintable(QString::number(i)));
            before = middle;
        }
    }

    void everyPlaceOfATransferIsOnTheTube() {
        for (const std::uint8_t holder : {std::uint8_t(0), std::uint8_t(2)}) {
            SceneState state = samples::handOver();
            state.exercise.own<core::LaparoscopyCues>().gripHeldBy[1] = holder;
            const TubeCurve curve = TubeCurve::of(state.exercise.of<core::LaparoscopyCues>(), kRadius_m);
            for (std::size_t i = 0; i < 3; ++i)
                QVERIFY2(away_m(curve, placeOf(state.exercise.of<core::LaparoscopyCues>(), i)) <
                             (holder == 0 && i == 1 ? 0.0015 : 1e-9),
                         qPrintable(QString::number(i)));
        }
    }

    void tornTubeHasTwoPiecesAtBothPlaces() {
        SceneState state = samples::tubeState({0.030, -0.012, 0.078}, true);
        state.exercise.own<core::LaparoscopyCues>().torn = true;
        const TubeCurve curve = TubeCurve::of(state.exercise.of<core::LaparoscopyCues>(), kRadius_m);
        QCOMPARE(curve.pieces.size(), std::size_t(2));
        QCOMPARE(int(curve.pieces[0].last), int(SweepEnd::ragged));
        QCOMPARE(int(curve.pieces[1].first), int(SweepEnd::ragged));
        QVERIFY(away_m(curve, placeOf(state.exercise.of<core::LaparoscopyCues>(), 0)) < 1e-9 &&
                away_m(curve, placeOf(state.exercise.of<core::LaparoscopyCues>(), 1)) < 1e-9);
        QVERIFY(curve.length_m() < 1.2 * kRest_m);
    }

    void noTubeNoRings() {
        QVERIFY(TubeCurve::of(core::LaparoscopyCues{}, kRadius_m).pieces.empty());
        QVERIFY(!TubeCurve::of(core::LaparoscopyCues{}, kRadius_m).at(0.5).has_value());
        QVERIFY(tubeMesh({}).vertices.empty());
    }

    void meshesAreWhole() {
        const SceneState state = samples::handOver();
        const TubeCurve curve = TubeCurve::of(state.exercise.of<core::LaparoscopyCues>(), kRadius_m);
        for (const TriangleMesh& mesh :
             {tubeMesh(curve), tubeMarks(curve, state.exercise.of<core::LaparoscopyCues>()),
              tubeShade(curve, 0.0), peritoneumMesh(55.0), bowelMesh(55.0), fatMesh(55.0), uterusMesh(55.0),
              instrumentRings(4), instrumentCollar()})
            QVERIFY(isWhole(mesh));
        int which = 0;
        for (const TriangleMesh& mesh :
             {tubeMesh(curve), peritoneumMesh(55.0), bowelMesh(55.0), uterusMesh(55.0), instrumentRings(4)}) {
            const int wrong = facingInwards(mesh),
                      all = int(mesh.indices.size() / 3); // a tube bent sharper than it is thick folds inside
            QVERIFY2(wrong * 100 < all,
                     qPrintable(QStringLiteral("mesh %1: %2 of %3").arg(which).arg(wrong).arg(all)));
            ++which;
        }
        for (const MeshVertex& v : peritoneumMesh(55.0).vertices)
            if (std::hypot(v.position_mm[0], v.position_mm[1]) < 55.0F)
                QCOMPARE(v.position_mm[2], 0.0F); // flat where the instruments work
        for (const TriangleMesh& mesh : {bowelMesh(55.0), fatMesh(55.0), uterusMesh(55.0)})
            for (const MeshVertex& v : mesh.vertices)
                QVERIFY(std::hypot(v.position_mm[0], v.position_mm[1]) > 55.0F); // and nothing else is there
    }

    void squeezedBodyKeepsItsVolumeAndIsThinAcrossTheJaws() {
        core::BodyCue body;
        body.radius_m = 0.011;
        body.squeeze_m = 0.004;
        const core::Vec3 jaws = core::Vec3(0.3, -0.5, 0.8).normalized();
        const core::Mat3 map = squeezed(body, jaws);
        QVERIFY(std::abs(map.determinant() - std::pow(0.011, 3)) < 1e-12);
        QVERIFY(std::abs((map * jaws).norm() - (0.011 - 0.002)) < 1e-12);
        body.squeeze_m = 0.0;
        QVERIFY((squeezed(body, jaws) - 0.011 * core::Mat3::Identity()).norm() < 1e-12);
        const core::Quat turned(
            Eigen::AngleAxisd(0.7, core::Vec3(0.2, -0.6, 0.8).normalized())); // about no axis of its own
        body.q_W = {turned.w(), turned.x(), turned.y(), turned.z()};
        QVERIFY((squeezed(body, jaws) - 0.011 * turned.toRotationMatrix()).norm() < 1e-8);
        body.q_W = {}; // stored without an orientation
        QVERIFY((squeezed(body, jaws) - 0.011 * core::Mat3::Identity()).norm() < 1e-12);
    }

    void markFollowsTheHeldEnd() {
        const SceneSetup setup = samples::tubeSetup(simulation::TubeTask::stretch);
        const auto& parameters = setup.parameters.as<simulation::ElasticTubeParameters>();
        const SceneState held = samples::tubeState({0.024, 0.004, 0.040}, true);
        const auto ring = markRing(parameters, held.exercise.of<core::LaparoscopyCues>());
        QVERIFY(ring.has_value());
        const core::Vec3 base = placeOf(held.exercise.of<core::LaparoscopyCues>(), 0);
        QVERIFY(std::abs((ring->p_W - base).norm() - parameters.markRatio * kRest_m) < 1e-9);
        QVERIFY(ring->along.cross((placeOf(held.exercise.of<core::LaparoscopyCues>(), 1) - base).normalized())
                    .norm() < 1e-9);
        core::LaparoscopyCues hidden = held.exercise.of<core::LaparoscopyCues>();
        hidden.objectShown = false;
        QVERIFY(!markRing(parameters, hidden).has_value());
        QVERIFY(!markRing(samples::tubeSetup().parameters.as<simulation::ElasticTubeParameters>(),
                          held.exercise.of<core::LaparoscopyCues>())
                     .has_value());
    }

    void secondBarShowsWhatTheCuesAllow() {
        const SceneState tube = samples::tubeState({0.030, -0.010, 0.055}, true);
        const core::ExerciseParameters level = samples::tubeSetup().parameters;
        core::LaparoscopyCues cues = tube.exercise.of<core::LaparoscopyCues>();
        const SecondBar tension = tensionBar(level.as<simulation::ElasticTubeParameters>(), cues);
        QVERIFY(tension.dial.bandHigh_N == cues.bandHigh_N && tension.dial.limit_N == 0.0);
        QVERIFY(tension.dial.range_N > tension.dial.bandHigh_N);
        QVERIFY(tension.shown && tension.value_N == cues.tension_N);
        cues.tensionShown = false;
        QVERIFY(!tensionBar(level.as<simulation::ElasticTubeParameters>(), cues).shown);
        const SceneState ovary = samples::handlingState(true);
        const SecondBar squeeze =
            squeezeBar(samples::handlingSetup().parameters.as<simulation::ObjectHandlingParameters>(),
                       ovary.exercise.of<core::LaparoscopyCues>());
        QVERIFY(squeeze.dial.limit_N == 2.0 && squeeze.dial.range_N > 2.0);
        QCOMPARE(squeeze.value_N, 1.3);
        QVERIFY(makeFlatContent(samples::tubeSetup())->bars(samples::tubeSetup(), tube).second.has_value());
        QVERIFY(
            !makeFlatContent(samples::setup())->bars(samples::setup(), {}).second.has_value()); // of the ball
    }

    void instrumentsEnterFromTheirOwnSides() {
        QVERIFY(!entersLeft(0, true, true) && entersLeft(1, true, false) && !entersLeft(2, true, true) &&
                entersLeft(3, true, false));
        QVERIFY(entersLeft(0, false, true) && !entersLeft(0, false, false)); // alone: the working hand's
        QCOMPARE(toolsOf(samples::twoHanded(0.06)), 2);
        for (int i = 0; i < core::kMaxTools; ++i)
            for (int k = 0; k < i; ++k)
                QVERIFY(ringColour(i) != ringColour(k));
    }

    void flatPicturesKnowBothExercises() {
        QVERIFY(makeFlatContent(samples::tubeSetup()));
        QVERIFY(makeFlatContent(samples::handlingSetup()));
        QVERIFY(!makeFlatContent(samples::tubeSetup())->name().isEmpty());
        QVERIFY(!makeFlatContent(samples::handlingSetup())->name().isEmpty());
    }
};

QTEST_MAIN(TestLaparoscopyDrawing)
#include "test_laparoscopy_drawing.moc"
