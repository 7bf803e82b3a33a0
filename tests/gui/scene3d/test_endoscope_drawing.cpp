// SPDX-License-Identifier: GPL-3.0-or-later
// What the endoscope's view draws, without a window.
#include "app/exercises/urethra_insertion/scene/endoscope_layout.h"
#include "app/exercises/urethra_insertion/scene/flat_profile.h"
#include "app/exercises/urethra_insertion/scene/flat_scope_picture.h"
#include "app/exercises/urethra_insertion/scene/lining_mesh.h"
#include "app/exercises/urethra_insertion/scene/lining_picture.h"
#include "app/exercises/urethra_insertion/scene/overview_fit.h"
#include "app/exercises/urethra_insertion/scene/scope_marks.h"
#include "app/exercises/urethra_insertion/scene/thin_lens.h"
#include "app/exercises/urethra_insertion/scene/urethra_buffers.h"
#include "desktop/scene3d/scene_loader.h"
#include "gui/scene3d/urethra_samples.h"
#include "modules/exercises/urethra_insertion/cues/endoscope_cues.h"
#include "support/painted_shapes.h"

#include <QApplication>
#include <QTest>
#include <QWidget>
#include <Qt3DCore/QEntity>
#include <algorithm>
#include <cstring>

using namespace chiron;
using namespace chiron::scene3d;

namespace {

simulation::UrethraInsertionParameters parameters() {
    return samples::urethraSetup().parameters.as<simulation::UrethraInsertionParameters>();
}

std::vector<core::Vec3> ring(const simulation::UrethraSurface& surface, std::size_t first) {
    std::vector<core::Vec3> points;
    for (std::size_t i = first; i < first + surface.ringSize(); ++i)
        points.emplace_back(surface.plane(0)[i], surface.plane(1)[i], surface.plane(2)[i]);
    return points;
}

core::Vec3 place(const MeshVertex& v) {
    return core::Vec3(v.position_mm[0], v.position_mm[1], v.position_mm[2]) * 1e-3;
}

QImage flatPicture(const SceneSetup& setup, const SceneState& state) {
    const auto view = makeFlatSceneView(setup, {}, nullptr);
    view->widget()->resize(900, 600);
    view->show(state);
    return view->widget()->grab().toImage();
}

/// Everything that a level may hide, off.
SceneSetup unguided() {
    SceneSetup setup = samples::urethraSetup();
    setup.cues = {.tool = true, .arrow = false, .object = true, .overview = false, .guidance = false};
    return setup;
}

} // namespace

class TestEndoscopeDrawing : public QObject {
    Q_OBJECT

private slots:
    /// What the driver gets is the simulation's surface, byte for byte, however the tip moves.
    void theBuffersAreTheSurface() {
        const auto p = parameters();
        simulation::UrethraSurface surface(p.anatomy, p.endoscope, p.mesh);
        Qt3DCore::QEntity owner;
        UrethraBuffers buffers(surface, &owner);
        bool changed = false;
        for (double s : {0.0, 0.010, 0.0105, 0.080, 0.081, -0.02, 0.139, 0.150, 0.020}) {
            const auto ranges = surface.update({s > -0.01, s, 0.001, -0.0007});
            buffers.update(surface, ranges);
            changed = changed || !ranges.empty();
            for (int i = 0; i < UrethraBuffers::kPlanes; ++i) {
                const std::span<const float> plane = i < 6 ? surface.plane(i) : surface.arcLength_m();
                const QByteArray bytes = buffers.plane(i).data();
                QCOMPARE(std::size_t(bytes.size()), plane.size_bytes());
                QVERIFY2(std::memcmp(bytes.constData(), plane.data(), plane.size_bytes()) == 0,
                         qPrintable(QString("plane %1 at %2 m").arg(i).arg(s)));
            }
        }
        QVERIFY(changed);
    }

    void bladderAndGlansJoinTheCanal() {
        const UrethraDrawing drawing(parameters());
        const auto p = parameters();
        simulation::UrethraSurface surface(p.anatomy, p.endoscope, p.mesh);
        const std::size_t last = surface.vertexCount() - surface.ringSize();
        const LiningMesh lining(drawing, ring(surface, 0), ring(surface, last));
        surface.update({true, drawing.centreline().length_m() + 0.001, 0.001, 0.0005}); // the neck gives way
        const std::vector<core::Vec3> neckRing = ring(surface, last);
        const TriangleMesh neck = lining.neck(neckRing);
        const TriangleMesh bladder = lining.bladder();
        const std::size_t row = surface.ringSize() + 1;
        double worst = 0.0;
        for (std::size_t i = 0; i < row; ++i) {
            const core::Vec3 rim = place(neck.vertices[neck.vertices.size() - row + i]);
            worst = std::max(worst, (rim - neckRing[i % surface.ringSize()]).norm());
            worst = std::max(
                worst, (place(neck.vertices[i]) - place(bladder.vertices[bladder.vertices.size() - row + i]))
                           .norm());
        }
        QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
        for (const MeshVertex& v : bladder.vertices) {
            const core::Vec3 from = place(v) - drawing.bladderCentre_A();
            QVERIFY(std::abs(from.norm() - p.anatomy.bladderRadius_m) < 1e-6);
        }
        for (const simulation::BladderLandmark& l : p.landmarks)
            QVERIFY(std::abs((drawing.landmark_A(l) - drawing.bladderCentre_A()).norm() -
                             p.anatomy.bladderRadius_m) < 1e-12);
    }

    /// c = A·f·s/(s−f)·|1/s − 1/d| on a sensor at v = f·s/(s−f), whatever f is.
    void theLensIsThin() {
        const ThinLens lens;
        const double angle = 1.2;
        for (double f : {1.0, 2.5})
            for (double d : {4.0, 9.0, 60.0}) {
                const double s = 12.0;
                const double v = f * s / (s - f);
                const double image = f * d / (d - f);
                const double circle = lens.aperture_mm * std::abs(image - v) / image; // similar triangles
                const double expected = circle / (2.0 * v * std::tan(0.5 * angle)) * 700.0;
                QVERIFY(std::abs(lens.confusion_px(d, s, 700.0, angle) - expected) < 1e-9 * expected);
            }
        QCOMPARE(lens.confusion_px(12.0, 12.0, 700.0, angle), 0.0);
    }

    void theMeteredDistanceIsContinuous() {
        const SceneSetup setup = samples::urethraSetup();
        const UrethraDrawing drawing(parameters());
        double before = UrethraDrawing::kNear_m;
        for (double s = 0.10; s < 0.19; s += 0.0005) {
            const double now = drawing.meteredDistance_m(samples::urethraState(setup, {.s_m = s}).tool[0]);
            QVERIFY2(std::abs(now - before) < 0.006, qPrintable(QString::number(s)));
            if (s < drawing.centreline().length_m())
                QCOMPARE(now, UrethraDrawing::kNear_m);
            before = now;
        }
        QVERIFY(drawing.meteredDistance_m(samples::urethraState(setup, {.s_m = 0.155}).tool[0]) > 0.03);
    }

    void picturesFitAndDoNotOverlap() {
        for (const QSize& size :
             {QSize(1024, 768), QSize(480, 360), QSize(360, 640), QSize(1900, 500), QSize(200, 150)})
            for (bool overview : {false, true}) {
                const int bar = 60;
                const EndoscopeLayout layout = EndoscopeLayout::of(size, bar, overview);
                const QRect room(0, 0, size.width() - bar, size.height());
                QCOMPARE(layout.picture.width(), layout.picture.height());
                QVERIFY(room.contains(layout.picture));
                QVERIFY(layout.picture.width() >= std::min(room.width(), room.height()) / 2);
                QCOMPARE(layout.overview.isEmpty(), !overview);
                QVERIFY(!overview ||
                        (room.contains(layout.overview) && !layout.overview.intersects(layout.picture)));
            }
    }

    void theOverviewShowsAll() {
        const UrethraDrawing drawing(parameters());
        for (double aspect : {0.5, 1.0, 2.0}) {
            const OverviewFit fit = fitOverview(drawing, aspect);
            const core::Vec3 ahead = (fit.p_WTarget - fit.p_WEye).normalized();
            const core::Vec3 right = ahead.cross(fit.up_W).normalized();
            const double tangent = std::tan(0.5 * fit.fieldOfView_deg * core::kPi / 180.0);
            for (double polar = 0.0; polar < 3.2; polar += 0.4)
                for (double turn = 0.0; turn < 6.0; turn += 0.5) {
                    const core::Vec3 seen =
                        drawing.parameters().pose.pointToW(drawing.bladderWall_A(polar, turn)) - fit.p_WEye;
                    const double depth = seen.dot(ahead);
                    QVERIFY(std::abs(seen.dot(right)) <= 1.02 * depth * tangent * aspect);
                    QVERIFY(std::abs(seen.dot(right.cross(ahead))) <= 1.02 * depth * tangent);
                }
        }
    }

    void marksSayNothingThatTheLevelHides() {
        const UrethraDrawing drawing(parameters());
        SceneState state = samples::urethraState(samples::urethraSetup(), {.s_m = 0.05, .pitch_rad = 0.2});
        state.tool[0].force_N = {0.5, -1.0, 0.7};
        state.exercise.own<simulation::EndoscopeCues>().dwell = 0.5;
        const ScopeMarks all = ScopeMarks::of(samples::urethraSetup(), drawing, state);
        QVERIFY(all.guided && all.force && all.dwell > 0.0 && !all.beyond && all.pictureShown);
        const ScopeMarks none = ScopeMarks::of(unguided(), drawing, state);
        QVERIFY(!none.guided && !none.force && none.dwell == 0.0);
        SceneSetup off = samples::urethraSetup();
        off.cues.object = false;
        QVERIFY(!ScopeMarks::of(off, drawing, state).guided);
        state.objectShown = false;
        QVERIFY(!ScopeMarks::of(samples::urethraSetup(), drawing, state).pictureShown);
    }

    /// Up in the picture is y of T, right is x; a direction behind the camera is an arrow at the rim.
    void theRingLiesWhereTheLumenIs() {
        const UrethraDrawing drawing(parameters());
        SceneState state = samples::urethraState(samples::urethraSetup(), {.s_m = 0.05});
        const double wide = std::tan(0.5 * parameters().endoscope.fieldOfView_rad);
        const core::Vec3 way = core::Vec3(0.2, -0.1, -1.0).normalized();
        state.exercise.own<simulation::EndoscopeCues>().toLumen_T = {way.x(), way.y(), way.z()};
        ScopeMarks marks = ScopeMarks::of(samples::urethraSetup(), drawing, state);
        QVERIFY((marks.lumen - core::Vec2(0.2 / wide, -0.1 / wide)).norm() < 1e-9);
        state.exercise.own<simulation::EndoscopeCues>().toLumen_T = {0.0, 0.6, 0.8};
        marks = ScopeMarks::of(samples::urethraSetup(), drawing, state);
        QVERIFY(marks.beyond && marks.lumen.y() > 0.79);
        state.exercise.own<simulation::EndoscopeCues>().toLumen_T = {0.0, 0.0, -1.0};
        QVERIFY(ScopeMarks::of(samples::urethraSetup(), drawing, state).aligned);
    }

    /// Behind the tip the canal lies round the rigid shaft; at the tip it is as wide as the endoscope, beyond
    /// the beak at rest.
    void theProfileHoldsTheShaft() {
        const SceneSetup setup = samples::urethraSetup();
        const UrethraDrawing drawing(parameters());
        const auto p = parameters();
        const SceneState state = samples::urethraState(setup, {.s_m = 0.060, .pitch_rad = 0.1});
        const FlatProfile::Edges edges = FlatProfile(drawing, setup).edges(state.tool[0]);
        const core::Vec3 back = p.pose.vectorToW(drawing.axes_A(state.tool[0]).col(2));
        const std::size_t n = edges.low.size() - 1;
        const double length = drawing.centreline().length_m();
        for (std::size_t i = 0; i <= n; ++i) {
            const double s = length * double(i) / double(n);
            const double wide = (edges.high[i] - edges.low[i]).norm();
            const core::Vec3 middle = 0.5 * (edges.high[i] + edges.low[i]);
            if (s < 0.059) {
                const core::Vec3 from = middle - state.tool[0].p_WT;
                QVERIFY2((from - from.dot(back) * back).norm() < 1e-4, qPrintable(QString::number(s)));
                QVERIFY(std::abs(wide - 2.0 * p.endoscope.radius_m) < 1e-6);
            } else if (s > 0.0701) {
                QVERIFY(std::abs(wide - 2.0 * p.anatomy.radius_m) < 1e-9);
            }
        }
    }

    void theFlatPictureHidesWhatTheLevelHides() {
        const SceneSetup setup = unguided();
        SceneState one = samples::urethraState(setup, {.s_m = 0.05});
        SceneState other = one;
        other.exercise.own<simulation::EndoscopeCues>().toLumen_T = {0.3, 0.3, -0.9};
        other.exercise.own<simulation::EndoscopeCues>().landmarksSeen = 7;
        other.tool[0].force_N = {2.0, 1.0, 0.0};
        QCOMPARE(flatPicture(setup, one), flatPicture(setup, other));
        QVERIFY(flatPicture(samples::urethraSetup(), one) != flatPicture(samples::urethraSetup(), other));
        SceneSetup off = setup;
        off.cues.object = false;
        QCOMPARE(flatPicture(off, one),
                 flatPicture(off, samples::urethraState(setup, {.s_m = 0.09, .yaw_rad = 0.2})));
        QVERIFY(flatPicture(setup, one) !=
                flatPicture(setup, samples::urethraState(setup, {.s_m = 0.09, .yaw_rad = 0.2})));
        // The picture is round: what it shows lies in a circle, and there is a lot of it.
        const auto view = makeFlatSceneView(setup, {}, nullptr);
        view->widget()->resize(900, 600);
        view->show(one);
        int inside = 0;
        for (const tests::PaintedShape& shape : tests::PaintedShapes::of(*view->widget())) {
            const QRectF square = shape.clip.boundingRect();
            if (shape.clip.contains(square.topLeft() + QPointF(2.0, 2.0)))
                continue; // clipped by a rectangle
            if (square.width() > 100.0 && std::abs(square.width() - square.height()) < 2.0 &&
                shape.clip.contains(square.center()))
                ++inside;
        }
        QVERIFY2(inside > 10, qPrintable(QString::number(inside)));
    }

    /// A landmark that is a ureter's mouth is drawn where the parameters have it, and nowhere else.
    void orificesArePaintedAtTheirPlaces() {
        const auto red = [](const LiningPicture& picture, double polar, double azimuth) {
            const int y = int(polar / core::kPi * picture.high);
            int most = 0;
            for (int dy = -2; dy <= 2; ++dy) {
                const int x = int(std::lround((azimuth < 0 ? azimuth + 2 * core::kPi : azimuth) /
                                              (2 * core::kPi) * picture.wide));
                most = std::max(
                    most,
                    int(picture.bytes[std::size_t(((y + dy) * picture.wide + x % picture.wide) * 4 + 2)]));
            }
            return most;
        };
        const LiningPicture with = bladderPicture({{"left_ureter", 1.0, -2.0}});
        const LiningPicture without = bladderPicture({{"left_wall", 1.0, -2.0}});
        QCOMPARE(std::size_t(with.wide * with.high * 4), with.bytes.size());
        QVERIFY2(red(with, 1.0, -2.0) > 230, qPrintable(QString::number(red(with, 1.0, -2.0))));
        QVERIFY(red(without, 1.0, -2.0) < 200);
        QCOMPARE(red(with, 2.0, 1.0), red(without, 2.0, 1.0));
    }
};

QTEST_MAIN(TestEndoscopeDrawing)
#include "test_endoscope_drawing.moc"
