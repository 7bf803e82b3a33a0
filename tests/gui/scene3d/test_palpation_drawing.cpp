// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn of a palpation: the felt surface, dents as deep as they are felt, what was searched, and
// nothing that is not told.
#include "app/exercises/palpation/scene/finding_flag.h"
#include "app/exercises/palpation/scene/finger_mesh.h"
#include "app/exercises/palpation/scene/finger_pose.h"
#include "app/exercises/palpation/scene/flat_palpation.h"
#include "app/exercises/palpation/scene/hand_mesh.h"
#include "app/exercises/palpation/scene/map_legend.h"
#include "app/exercises/palpation/scene/map_picture.h"
#include "app/exercises/palpation/scene/palpation_dial.h"
#include "app/exercises/palpation/scene/palpation_overlay.h"
#include "app/exercises/palpation/scene/tissue_mesh.h"
#include "desktop/scene3d/camera_fit.h"
#include "gui/scene3d/palpation_samples.h"
#include "support/image_region.h"
#include "support/painted_shapes.h"

#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>
#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::scene3d;
using samples::Tissue;
using simulation::FindingOutcome;
using simulation::MapBand;
using simulation::SurfaceMapKind;
using simulation::TissueSurface;

namespace {

constexpr std::array kTissues{Tissue::pad, Tissue::prostate, Tissue::breast};

core::Vec3 vec(const float (&v)[3]) {
    return {double(v[0]), double(v[1]), double(v[2])};
}

int facingWrong(const TriangleMesh& mesh) {
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

TissueSurface surfaceOf(Tissue tissue) {
    return TissueSurface(samples::palpationParameters(tissue).tissue.shape);
}

std::vector<tests::PaintedShape> flagPicture(const FindingFlag& flag, const SceneSetup& setup) {
    tests::PaintedShapes picture(QSize(64, 64));
    QPainter painter(&picture);
    paintFindingFlag(painter, QRectF(0, 0, 64, 64), flag, setup);
    painter.end();
    return picture.shapes();
}

/// Where a place of W lies in a map picture.
QPoint placeIn(const QImage& picture, const simulation::SurfaceMap& map, double x_m, double y_m) {
    return {int((0.5 + 0.5 * x_m / map.half_m().x()) * picture.width()),
            int((0.5 - 0.5 * y_m / map.half_m().y()) * picture.height())};
}

/// A shape or picture as it was painted, with what fills it.
struct Painted {
    enum class Kind { picture, ellipse, path } kind;
    QRectF box;
    QBrush fill;

    /// Whether it leaves nothing visible of a place that it covers.
    bool hides() const {
        return kind != Kind::picture && fill.style() == Qt::SolidPattern && fill.isOpaque();
    }
    bool isCircle(const QPointF& middle, double radius) const {
        return kind == Kind::ellipse && (box.center() - middle).manhattanLength() < 0.01 &&
               std::abs(0.5 * box.width() - radius) < 0.01;
    }
};

/// Takes down what is painted, in its order. Words are left out.
class PaintedEngine final : public QPaintEngine {
public:
    PaintedEngine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    Type type() const override { return User; }
    void updateState(const QPaintEngineState&) override {}
    void drawEllipse(const QRectF& rect) override { take(Painted::Kind::ellipse, rect, painter()->brush()); }
    void drawEllipse(const QRect& rect) override { drawEllipse(QRectF(rect)); }
    void drawPath(const QPainterPath& path) override {
        take(Painted::Kind::path, path.boundingRect(), painter()->brush());
    }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode mode) override {
        const QPolygonF corners(QList<QPointF>(points, points + count));
        take(Painted::Kind::path, corners.boundingRect(),
             mode == PolylineMode ? QBrush() : painter()->brush());
    }
    void drawPolygon(const QPoint* points, int count, PolygonDrawMode mode) override {
        const std::vector<QPointF> corners(points, points + count);
        drawPolygon(corners.data(), count, mode);
    }
    void drawPixmap(const QRectF& to, const QPixmap&, const QRectF&) override {
        take(Painted::Kind::picture, to, {});
    }
    void drawImage(const QRectF& to, const QImage&, const QRectF&, Qt::ImageConversionFlags) override {
        take(Painted::Kind::picture, to, {});
    }
    void drawTextItem(const QPointF&, const QTextItem&) override {}

    std::vector<Painted> all;

private:
    void take(Painted::Kind kind, const QRectF& box, const QBrush& fill) {
        all.push_back({kind, painter()->combinedTransform().mapRect(box), fill});
    }
};

/// A surface of 1000 by 800 pixels for it.
class PaintedDevice final : public QPaintDevice {
public:
    QPaintEngine* paintEngine() const override { return &m_engine; }
    const std::vector<Painted>& all() const { return m_engine.all; }

protected:
    int metric(PaintDeviceMetric metric) const override {
        switch (metric) {
        case PdmWidth:
            return 1000;
        case PdmHeight:
            return 800;
        case PdmWidthMM:
        case PdmHeightMM:
            return 200;
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY:
            return 96;
        case PdmNumColors:
            return 1 << 24;
        case PdmDepth:
            return 32;
        case PdmDevicePixelRatio:
            return 1;
        default:
            return QPaintDevice::metric(metric);
        }
    }

private:
    mutable PaintedEngine m_engine;
};

/// Of the shapes that `fits` accepts, the place of the last one in the order of painting; −1: none.
template <class Fits> int lastOf(const std::vector<Painted>& painted, Fits fits) {
    for (int i = static_cast<int>(painted.size()) - 1; i >= 0; --i)
        if (fits(painted[static_cast<std::size_t>(i)]))
            return i;
    return -1;
}

} // namespace

class TestPalpationDrawing : public QObject {
    Q_OBJECT
private slots:
    void drawnSurfaceIsTheFeltOne() {
        for (const Tissue tissue : kTissues) {
            const TissueSurface surface = surfaceOf(tissue);
            const TriangleMesh mesh = tissueMesh(surface, 0.06);
            QVERIFY(mesh.vertices.size() > 4000 && mesh.vertices.size() < 12000);
            QCOMPARE(facingWrong(mesh), 0);
            for (const MeshVertex& v : mesh.vertices) {
                const core::Vec3 p = 1e-3 * vec(v.position_mm);
                QVERIFY(std::abs(p.z() - surface.heightAt(p.head<2>()).z_m) < 1e-7);
                QVERIFY((vec(v.normal) - surface.normalAt(p.head<2>())).norm() < 1e-4);
                QVERIFY(v.light > 0.4F && v.light <= 1.0F);
            }
        }
    }

    void borderLiesOnTheSurfaceRoundTheSearchArea() {
        const TissueSurface surface = surfaceOf(Tissue::breast);
        const TriangleMesh mesh = areaMesh(surface, {0.040, 0.030}, 0.8);
        QCOMPARE(facingWrong(mesh), 0);
        for (const MeshVertex& v : mesh.vertices) {
            const core::Vec3 p = vec(v.position_mm);
            const double out = std::max(std::abs(p.x()) - 40.0, std::abs(p.y()) - 30.0);
            QVERIFY2(std::abs(out) < 0.6, qPrintable(QString::number(out)));
            QVERIFY(std::abs(p.z() - 1e3 * surface.heightAt(1e-3 * p.head<2>()).z_m) < 0.4);
        }
    }

    void dentIsAsDeepAsThePress() {
        for (const Tissue tissue : kTissues) {
            const SceneSetup setup = samples::palpationSetup(tissue);
            SceneState state;
            samples::pressFinger(state, setup, 0, {0.008, -0.006}, 0.004);
            const Dent dent = fingerDent(surfaceOf(tissue), 0.005, state.tool[0]);
            QVERIFY(std::abs(dent.depth_m - 0.004) < 1e-6);
            QVERIFY((dent.displaced(dent.p_WSurface) - state.tool[0].p_WT).norm() < 1e-6);
            QVERIFY(dent.reach_m > 0.005);
            state.tool[0].drawnAtSurface = true; // nothing is felt: the finger stays on it
            QCOMPARE(fingerDent(surfaceOf(tissue), 0.005, state.tool[0]).depth_m, 0.0);
            samples::pressFinger(state, setup, 1, {0.0, 0.0}, -0.003);
            QCOMPARE(fingerDent(surfaceOf(tissue), 0.005, state.tool[1]).depth_m, 0.0);
        }
        ToolView lost;
        lost.present = true;
        lost.p_WT = core::Vec3::Constant(std::nan(""));
        QCOMPARE(fingerDent(surfaceOf(Tissue::breast), 0.005, lost).depth_m, 0.0);
    }

    void platformLeansAlongTheLateralForceUpToItsLimit() {
        const SceneSetup setup = samples::palpationSetup(Tissue::pad);
        SceneState state;
        samples::pressFinger(state, setup, 0, {0.0, 0.0}, 0.004, {0.3, -0.4});
        FingerLean lean = fingerLean(state, 0, core::Vec3::UnitZ());
        QVERIFY((lean.toward - core::Vec3(0.6, -0.8, 0.0)).norm() < 1e-9);
        QVERIFY(std::abs(lean.angle_rad - std::atan2(0.5, 2.0)) < 1e-9);
        QVERIFY(!lean.saturated);
        samples::pressFinger(state, setup, 0, {0.0, 0.0}, 0.004, {2.0, 0.0});
        lean = fingerLean(state, 0, core::Vec3::UnitZ());
        QVERIFY(std::abs(lean.angle_rad - kMostRoll_rad) < 1e-12); // across the finger
        QVERIFY(lean.saturated);
        samples::pressFinger(state, setup, 0, {0.0, 0.0}, 0.004, {0.0, 2.0});
        QVERIFY(std::abs(fingerLean(state, 0, core::Vec3::UnitZ()).angle_rad - kMostLean_rad) <
                1e-12); // along it
        samples::pressFinger(state, setup, 0, {0.0, 0.0}, 0.004, {2.0, 2.0});
        QVERIFY(std::abs(fingerLean(state, 0, core::Vec3::UnitZ()).angle_rad * std::sqrt(0.5) -
                         kMostRoll_rad) < 1e-12);
        samples::pressFinger(state, setup, 0, {0.0, 0.0}, 0.004, {2.0, 0.0});
        state.exercise.own<simulation::PalpationCues>().lean_rad[0] = 0.0; // a level that does not show it
        QCOMPARE(fingerLean(state, 0, core::Vec3::UnitZ()).angle_rad, 0.0);
    }

    void handsAreToldApart() {
        const SceneSetup two = samples::palpationSetup(Tissue::breast, 2, 2);
        QVERIFY(!isLeftHand(two, 0) && !isLeftHand(two, 1) && isLeftHand(two, 2) && isLeftHand(two, 3));
        QVERIFY(fingerYaw_rad(two, 0) > 0.0 && fingerYaw_rad(two, 2) < 0.0);
        SceneSetup one = samples::palpationSetup(Tissue::breast, 1, 2);
        QVERIFY(!isLeftHand(one, 0) && !isLeftHand(one, 1));
        one.leftHanded = true;
        QVERIFY(isLeftHand(one, 0) && isLeftHand(one, 1));
    }

    /// In the air a hand is nearly glass, so that what lies under it is seen; touching with one finger makes
    /// that hand solid, and no other.
    void aHandInTheAirIsSeenThrough() {
        SceneSetup setup;
        simulation::PalpationParameters parameters = samples::palpationParameters(Tissue::breast);
        parameters.hands = 2;
        parameters.fingers = 2;
        setup.parameters = parameters;
        const TissueSurface surface(parameters.tissue.shape);
        SceneState state;
        const auto hold = [&](std::size_t tool, double height_m) {
            const core::Vec2 at(0.004 * double(tool), 0.0);
            state.tool[tool].present = true;
            state.tool[tool].p_WT = surface.pointAt(at) + height_m * surface.normalAt(at);
        };
        for (std::size_t tool = 0; tool < 4; ++tool)
            hold(tool, 0.005); // where a finger begins
        for (std::size_t tool = 0; tool < 4; ++tool)
            QVERIFY(gloveOpacity(setup, state, surface, tool) < 0.3);
        hold(3, -0.002);
        QCOMPARE(gloveOpacity(setup, state, surface, 3), 1.0);
        QCOMPARE(gloveOpacity(setup, state, surface, 2), 1.0);
        QVERIFY(gloveOpacity(setup, state, surface, 0) < 0.3);
        double before = 1.0;
        for (const double height_m : {0.0005, 0.001, 0.002, 0.003}) { // it fades, and does not jump
            hold(3, height_m);
            hold(2, height_m);
            const double now = gloveOpacity(setup, state, surface, 3);
            QVERIFY(now < before && now > 0.0);
            before = now;
        }
    }

    void fingerTouchesWithItsPad() {
        const TriangleMesh mesh = fingerMesh();
        QCOMPARE(facingWrong(mesh), 0);
        double lowest = 100.0;
        for (const MeshVertex& v : mesh.vertices) {
            lowest = std::min(lowest, double(v.position_mm[2]));
            QVERIFY(std::abs(v.position_mm[0]) < 12.0F);
        }
        QVERIFY2(std::abs(lowest) < 0.8, qPrintable(QString::number(lowest)));
        for (int i = 1; i < core::kMaxTools; ++i)
            QVERIFY(fingerBands(i + 1).vertices.size() > fingerBands(i).vertices.size());
    }

    /// Whole, from the knuckle to the cuff, on its own side, and never in the tissue before the finger is.
    void theHandIsBehindItsFinger() {
        for (const int used : {1, 2}) {
            const TriangleMesh right = handMesh(used, false);
            const TriangleMesh left = handMesh(used, true);
            QCOMPARE(facingWrong(right), 0);
            QCOMPARE(facingWrong(left), 0);
            QCOMPARE(left.vertices.size(), right.vertices.size());
            double middle_mm = 0.0, lowest_mm = 1e3, farthest_mm = 1e3;
            for (std::size_t i = 0; i < right.vertices.size(); ++i) {
                const auto& p = right.vertices[i].position_mm;
                middle_mm += double(p[0]) / double(right.vertices.size());
                lowest_mm = std::min(lowest_mm, double(p[2]));
                farthest_mm = std::min(farthest_mm, double(p[1]));
                QVERIFY(p[1] < 0.0F);
                QCOMPARE(left.vertices[i].position_mm[0], -p[0]);
            }
            QVERIFY2(lowest_mm > 8.0,
                     qPrintable(QString::number(
                         lowest_mm))); // a finger presses deeper than it without the hand's help
            QVERIFY(middle_mm > 5.0);  // thumb to the left, palm down
            QVERIFY(farthest_mm < -200.0);
        }
        QVERIFY(handMesh(2, false).vertices.size() <
                handMesh(1, false).vertices.size()); // the second finger is drawn by itself
    }

    void mapSaysWhereWasPressed() {
        const SceneSetup setup = samples::palpationSetup(Tissue::pad);
        simulation::SurfaceMap map({0.040, 0.030}, 0.005, 0.5);
        map.press({0.020, 0.015}, 1.0);
        map.press({-0.020, -0.015}, 0.3);
        const QImage picture = mapPicture(map, setup, SurfaceMapKind::coverage);
        const auto inBand = mapColour(setup.colours, SurfaceMapKind::coverage, MapBand::inBand);
        QVERIFY(tests::regionOf(picture, inBand).contains(placeIn(picture, map, 0.0205, 0.0152)));
        const QRegion hatch = tests::regionOf(picture, mapHatch(setup.colours, false)),
                      skin = tests::regionOfAlpha(picture, 0);
        int hatched = 0, bare = 0;
        for (int i = 0; i < 24; ++i) {
            const double x_m = -0.022 + 0.0002 * i;
            hatched += hatch.contains(placeIn(picture, map, x_m, -0.0152)) ? 1 : 0;
            bare += skin.contains(placeIn(picture, map, x_m, 0.0152)) ? 1 : 0;
        }
        QVERIFY(hatched > 0 && hatched < 12); // pressed, but not searched
        QVERIFY(bare > 12 && bare < 24);      // skin with hatching
        const QRegion border = tests::regionOf(picture, QColor(16, 26, 36, 230));
        QVERIFY(tests::areaOf(border) > 40); // round what was searched
    }

    void stepsOfForceDifferInLightness() {
        for (const SceneColours& colours : {SceneColours{}, samples::dark(), samples::highContrast()}) {
            const double way = qGray(colours.arrow.rgb()) - qGray(colours.background.rgb());
            int before = qGray(colours.background.rgb());
            for (const MapBand band : {MapBand::light, MapBand::gentle, MapBand::inBand, MapBand::hard}) {
                const QColor colour = mapColour(colours, SurfaceMapKind::force, band);
                QVERIFY((qGray(colour.rgb()) - before) * way > 0.0 &&
                        std::abs(qGray(colour.rgb()) - before) > 10);
                before = qGray(colour.rgb());
            }
        }
    }

    void legendSaysHowMuchAndInNewtons() {
        const SceneSetup setup = samples::palpationSetup(Tissue::pad);
        const MapLegend coverage(setup, SurfaceMapKind::coverage, 40);
        const MapLegend force(setup, SurfaceMapKind::force, 40);
        QVERIFY(force.size().height() > coverage.size().height() + 30.0);
        QVERIFY(!(coverage == force));
        QVERIFY(!(coverage == MapLegend(setup, SurfaceMapKind::coverage, 41)));
        SceneState state;
        const simulation::SurfaceMap map = samples::searched(setup, 1.0);
        state.overlay.own<PalpationOverlay>().map = &map;
        QVERIFY(MapLegend::of(setup, state) ==
                MapLegend(setup, SurfaceMapKind::coverage, int(std::lround(100.0 * map.coverage()))));
    }

    void outcomesDifferInShape() {
        SceneSetup setup = samples::palpationSetup(Tissue::pad);
        setup.colours.over = setup.colours.arrow = setup.colours.ink; // where colours say nothing
        const auto flag = [&](int number, FindingOutcome outcome, bool chosen) {
            return flagPicture({number, outcome, chosen}, setup);
        };
        const auto open = flag(1, FindingOutcome::open, false), hit = flag(1, FindingOutcome::hit, false),
                   wrong = flag(1, FindingOutcome::falseAlarm, false);
        using tests::differingForms_px;
        QVERIFY(differingForms_px(open, hit) > 120.0 && differingForms_px(open, wrong) > 120.0 &&
                differingForms_px(hit, wrong) > 120.0);
        QVERIFY(differingForms_px(open, flag(1, FindingOutcome::open, true)) > 100.0);
        QVERIFY(differingForms_px(open, flag(2, FindingOutcome::open, false)) > 20.0);
    }

    void bandIsShownWhereTheLevelShowsIt() {
        const SceneSetup setup = samples::palpationSetup(Tissue::pad);
        simulation::PalpationCues cues;
        cues.bandLow_N = 0.8;
        cues.bandHigh_N = 2.5;
        cues.present = true;
        QCOMPARE(forceDial(setup, cues).bandHigh_N, 0.0);
        cues.bandShown = true;
        QCOMPARE(forceDial(setup, cues).bandHigh_N, 2.5);
        QCOMPARE(forceDial(setup, cues).limit_N, forceDial(setup).limit_N);
    }

    void lookFollowsTheTissue() {
        QVERIFY(tissueLookOf(samples::palpationParameters(Tissue::pad).tissue) == TissueLook::pad);
        QVERIFY(tissueLookOf(samples::palpationParameters(Tissue::prostate).tissue) == TissueLook::gland);
        QVERIFY(tissueLookOf(samples::palpationParameters(Tissue::breast).tissue) == TissueLook::skin);
        QVERIFY(areolaOf(samples::palpationParameters(Tissue::breast).tissue).radius_m > 0.0);
        QCOMPARE(areolaOf(samples::palpationParameters(Tissue::prostate).tissue).radius_m, 0.0);
        // Where content names none, it is on the highest bump; flat skin has none.
        simulation::TissueParameters skin = samples::palpationParameters(Tissue::breast).tissue;
        skin.regions.clear();
        skin.shape.bumps = {simulation::SurfaceBump{.centre_m = {0.01, 0.0}, .height_m = 0.004},
                            simulation::SurfaceBump{.centre_m = {-0.02, 0.005}, .height_m = 0.009}};
        QCOMPARE(areolaOf(skin).centre_m.x(), -0.02);
        QVERIFY(areolaOf(skin).radius_m > 0.0);
        skin.shape.bumps.clear();
        QCOMPARE(areolaOf(skin).radius_m, 0.0);
    }

    void cameraSeesTheSearchAreaFromTheNearSide() {
        for (const Tissue tissue : kTissues) {
            const simulation::PalpationParameters parameters = samples::palpationParameters(tissue);
            const TissueSurface surface(parameters.tissue.shape);
            const double aspect = 4.0 / 3.0;
            const double elevation = 57.0 * core::kPi / 180.0;
            const CameraFit camera = fitCamera(
                palpationField_m(parameters) + 0.012, parameters.tissue.shape.planeHeight_m,
                surface.highest_m() - parameters.tissue.shape.planeHeight_m + 0.018, aspect, 0.1, elevation);
            const core::Vec3 ahead = (camera.p_WTarget - camera.p_WEye).normalized();
            QVERIFY(std::abs(std::asin(-ahead.z()) - elevation) < 1e-9);
            QVERIFY(camera.p_WEye.y() < 0.0);
            const core::Vec3 right = ahead.cross(core::Vec3::UnitZ()).normalized();
            const double up = std::tan(0.5 * camera.fieldOfView_deg * core::kPi / 180.0);
            for (const double x : {-1.0, 1.0})
                for (const double y : {-1.0, 1.0}) {
                    const core::Vec3 seen =
                        surface.pointAt(parameters.areaHalf_m.cwiseProduct(core::Vec2(x, y))) - camera.p_WEye;
                    QVERIFY(std::abs(seen.dot(right.cross(ahead))) < up * seen.dot(ahead));
                    QVERIFY(std::abs(seen.dot(right)) < up * aspect * seen.dot(ahead));
                }
        }
    }

    void flatPictureHasTheSameGeometry() {
        const SceneSetup setup = samples::palpationSetup(Tissue::breast);
        const auto content = makeFlatContent(setup);
        QVERIFY(content && content->frame().ownTools && !content->name().isEmpty());
        const simulation::PalpationParameters parameters = samples::palpationParameters(Tissue::breast);
        const FlatPalpation flat(parameters);
        const TissueSurface surface(parameters.tissue.shape);
        SceneState state;
        samples::pressFinger(state, setup, 0, {0.012, -0.010}, 0.005);
        double least = 1.0; // the outline goes through the tip
        for (const core::Vec2& p : flat.profile(state))
            least = std::min(least, (p - core::Vec2(state.tool[0].p_WT.x(), state.tool[0].p_WT.z())).norm());
        QVERIFY2(least < 2e-4, qPrintable(QString::number(1e3 * least)));
        QVERIFY(flat.heightLines().size() > 50);
        for (const QLineF& line : flat.heightLines()) { // both ends at one height, on a step
            const double a = 1e3 * surface.heightAt({1e-3 * line.x1(), 1e-3 * line.y1()}).z_m;
            const double b = 1e3 * surface.heightAt({1e-3 * line.x2(), 1e-3 * line.y2()}).z_m;
            QVERIFY(std::abs(a - b) < 0.08);
        }
        QVERIFY(FlatPalpation(samples::palpationParameters(Tissue::pad)).heightLines().empty());
        QCOMPARE(content->groundHeight_m(state, 0.01, 0.02), surface.heightAt({0.01, 0.02}).z_m);
    }

    /// The circle within which a lump counts as found has the level's size and lies round the mark, above
    /// finger and hatching. It is empty, so that both are seen in it, and of the finger's dial the mark
    /// covers no more than the middle.
    void theToleranceIsDrawnAndNothingHidesAnother() {
        const SceneSetup setup = samples::palpationSetup(Tissue::pad);
        for (const double hit_m : {0.005, 0.012}) {
            simulation::PalpationParameters parameters = samples::palpationParameters(Tissue::pad);
            parameters.hitRadius_m = hit_m;
            const FlatPalpation flat(parameters);
            SceneState state;
            samples::pressFinger(state, setup, 0, {0.004, 0.002}, 0.004); // pressing on the mark
            samples::addFinding(state, setup, 0, {0.004, 0.002}, FindingOutcome::open);
            const simulation::SurfaceMap map = samples::searched(setup, 0.4);
            state.overlay.own<PalpationOverlay>().map = &map;
            PaintedDevice device;
            FlatPanel panel(FlatPanel::Side::above, flat.frame().above_mm, setup);
            panel.place({0, 0}, 4.0);
            {
                QPainter painter(&device);
                flat.paint(painter, panel, setup, state);
            }
            const std::vector<Painted>& painted = device.all();
            const auto& mark = state.exercise.of<simulation::PalpationCues>().finding[0].p_W;
            const QPointF foot = panel.project({mark[0], mark[1], mark[2]});
            const int circle = lastOf(painted, [&](const Painted& each) {
                return each.isCircle(foot, panel.pixels(1e3 * hit_m)) && each.fill.style() == Qt::NoBrush;
            });
            const int hatching = lastOf(painted, [&](const Painted& each) {
                return each.kind == Painted::Kind::picture &&
                       each.box.width() < panel.plot().width(); // the relief is as wide as the plot
            });
            const int finger = lastOf(painted, [](const Painted& each) {
                return each.hides() && each.box.height() > 40.0; // far larger than a mark or a number
            });
            const QPointF tip = panel.project(state.tool[0].p_WT);
            const double rim = panel.pixels(kPlatformRing_mm);
            const int dial = lastOf(painted, [&](const Painted& each) { return each.isCircle(tip, rim); });
            QVERIFY2(circle >= 0, qPrintable(QString::number(hit_m)));
            QVERIFY(hatching >= 0 && finger >= 0 && dial >= 0);
            QVERIFY(hatching < finger && finger < dial && dial < circle);
            for (std::size_t i = static_cast<std::size_t>(dial) + 1; i < painted.size(); ++i) {
                const Painted& later = painted[i];
                QVERIFY2(!later.hides() || later.box.width() < 1.5 * rim,
                         qPrintable(QStringLiteral("%1 px wide").arg(later.box.width())));
            }
        }
    }

    void hiddenHandLeavesNoDentInTheFlatPicture() {
        SceneSetup setup = samples::palpationSetup(Tissue::pad);
        const FlatPalpation flat(samples::palpationParameters(Tissue::pad));
        SceneState state;
        samples::pressFinger(state, setup, 0, {0.0, 0.0}, 0.006);
        state.exercise.own<simulation::PalpationCues>() = {};
        const auto picture = [&](const SceneState& shown) {
            tests::PaintedShapes image(QSize(400, 300));
            QPainter painter(&image);
            FlatPanel panel(FlatPanel::Side::side, flat.frame().side_mm, setup);
            panel.place({0, 0}, 3.0);
            flat.paint(painter, panel, setup, shown);
            painter.end();
            return image.shapes();
        };
        QVERIFY(tests::differingForms_px(picture(state), picture({})) > 500.0);
        setup.cues.tool = false;
        QVERIFY(picture(state) == picture({}));
    }
};

QTEST_MAIN(TestPalpationDrawing)
#include "test_palpation_drawing.moc"
