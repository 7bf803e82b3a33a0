// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/sphere_apex/scene/apex_mesh.h"
#include "app/exercises/sphere_apex/scene/flat_apex.h"
#include "core/units.h"
#include "desktop/scene3d/camera_fit.h"
#include "desktop/scene3d/drawn_tool.h"
#include "desktop/scene3d/parts/drape_mesh.h"
#include "desktop/scene3d/parts/instrument_mesh.h"
#include "gui/scene3d/scene_samples.h"
#include "modules/exercises/sphere_apex/simulation/hemisphere_contact.h"
#include "modules/exercises/sphere_apex/simulation/sphere_apex_parameters.h"

#include <QTest>
#include <algorithm>
#include <cstring>

using namespace chiron;
using namespace chiron::scene3d;

namespace {

simulation::SphereApexParameters parameters() {
    simulation::SphereApexParameters p;
    p.planeHeight_m = 0.004; // not zero, so that a forgotten one shows
    p.dimpleDepth_m = 0.0015;
    return p;
}

SceneState at(double x_m, double y_m) {
    SceneState state;
    state.objectShown = true;
    state.p_WObject = {x_m, y_m, 0.004};
    return state;
}

core::Vec3 place(const MeshVertex& v) {
    return core::Vec3(v.position_mm[0], v.position_mm[1], v.position_mm[2]) * 1e-3;
}

core::Vec3 normal(const MeshVertex& v) {
    return {v.normal[0], v.normal[1], v.normal[2]};
}

/// Tips in contact, all round the ball and on the plane, to 12 mm deep.
std::vector<core::Vec3> pressedTips(const ApexSurface& surface) {
    std::vector<core::Vec3> tips;
    const core::Vec3 centre(surface.ball.centre_m.x(), surface.ball.centre_m.y(), surface.ball.planeHeight_m);
    for (int i = 0; i < 400; ++i) {
        const double turn = 2.399963 * i; // the golden angle
        const double up = 0.05 + 0.95 * (i % 37) / 36.0;
        const double flat = std::sqrt(1.0 - up * up);
        const core::Vec3 u(flat * std::cos(turn), flat * std::sin(turn), up);
        tips.push_back(centre + (0.020 - 0.0001 - 0.012 * (i % 11) / 10.0) * u);
        tips.push_back(
            {0.045 * std::cos(turn), 0.045 * std::sin(turn), 0.004 - 0.0002 - 0.006 * (i % 7) / 6.0});
    }
    std::erase_if(tips, [&](const core::Vec3& p) { return surface.dentUnder(p).depth_m <= 0.0; });
    return tips;
}

} // namespace

/// What is drawn is what is felt.
class TestSceneGeometry : public QObject {
    Q_OBJECT

private slots:
    void everyVertexLiesOnTheFeltSurface() {
        for (const SceneState& state : {at(0.0, 0.0), at(0.031, -0.017), at(-0.04, 0.0)}) {
            const ApexSurface surface = ApexSurface::of(parameters(), state);
            const simulation::HemisphereOnPlane felt{0.020, 0.004, state.p_WObject.head<2>()};
            double worst = 0.0;
            double highest = 0.0;
            double widest = 0.0;
            for (const MeshVertex& v : apexMesh(surface).vertices) {
                worst = std::max(worst, std::abs(felt.distance(place(v)).signedDistance_m));
                highest = std::max(highest, place(v).z());
                widest = std::max(widest, place(v).head<2>().norm());
            }
            QVERIFY2(worst < 1e-6, qPrintable(QString::number(worst)));
            QVERIFY(std::abs(highest - 0.024) < 1e-6); // the apex is among them
            QVERIFY(widest > 0.065);                   // and the whole workspace is covered
        }
    }

    void aShownDimpleIsTheFeltOne() {
        SceneState state = at(0.01, 0.02);
        state.dimpleShown = true;
        state.dimpleCentre_m = {0.018, 0.026};
        const ApexSurface surface = ApexSurface::of(parameters(), state);
        simulation::HemisphereContact::Parameters contact;
        contact.surface = {0.020, 0.004, {0.01, 0.02}};
        contact.dimple = {0.0015, parameters().dimpleRadius_m, state.dimpleCentre_m};
        const simulation::HemisphereContact felt(contact);
        double deepest = 0.0;
        for (const MeshVertex& v : apexMesh(surface).vertices) {
            const core::Vec3 p = place(v);
            const double h = contact.dimple.sample(p.x(), p.y()).height_m;
            const double d = contact.surface.distance(p).signedDistance_m;
            QVERIFY2(std::abs(d - h) < 1e-6, qPrintable(QString("%1 %2").arg(d).arg(h)));
            deepest = std::min(deepest, d);
            // two micrometres outside nothing is felt, two inside something is
            const core::Vec3 n = normal(v);
            if (std::abs((p.head<2>() - contact.surface.centre_m).norm() - 0.020) < 1e-5)
                continue; // the rim, where ball and plane meet in a corner
            QVERIFY(!felt.respond(p + 2e-6 * n, core::Vec3::Zero()).inContact);
            QVERIFY(felt.respond(p - 2e-6 * n, core::Vec3::Zero()).inContact);
        }
        QVERIFY2(deepest < -0.0013, qPrintable(QString::number(deepest)));
    }

    void hiddenSurfaceTellsNothing() {
        SceneState one = at(0.0, 0.0);
        SceneState other = at(0.03, -0.02);
        other.dimpleShown = true;
        other.dimpleCentre_m = {0.03, -0.01};
        one.objectShown = other.objectShown = false;
        const ApexSurface a = ApexSurface::of(parameters(), one);
        const ApexSurface b = ApexSurface::of(parameters(), other);
        QVERIFY(a == b);
        const TriangleMesh meshA = apexMesh(a);
        const TriangleMesh meshB = apexMesh(b);
        QCOMPARE(meshA.vertices.size(), meshB.vertices.size());
        QCOMPARE(std::memcmp(meshA.vertices.data(), meshB.vertices.data(),
                             meshA.vertices.size() * sizeof(MeshVertex)),
                 0);
        for (const MeshVertex& v : meshA.vertices) {
            QCOMPARE(place(v).z(), double(4.0F) * 1e-3);
            QCOMPARE(v.light, 1.0F);
        }
        QCOMPARE(b.dentUnder({0.03, -0.02, 0.02}).depth_m, 0.0); // no dent either
        QCOMPARE(b.height_m(0.03, -0.02), 0.004);
    }

    void theSurfaceGivesWayToTheTip() {
        for (bool dimple : {false, true}) {
            SceneState state = at(0.012, 0.006);
            state.dimpleShown = dimple;
            state.dimpleCentre_m = {0.016, 0.010};
            const ApexSurface surface = ApexSurface::of(parameters(), state);
            const auto tips = pressedTips(surface);
            QVERIFY(tips.size() > 500);
            for (const core::Vec3& tip : tips) {
                const Dent dent = surface.dentUnder(tip);
                QVERIFY(std::abs(dent.normal.norm() - 1.0) < 1e-9);
                QVERIFY((dent.displaced(dent.p_WSurface) - tip).norm() < 1e-9);
            }
        }
    }

    void theDrawnTrianglesReachTheTip() {
        const ApexSurface surface = ApexSurface::of(parameters(), at(0.012, 0.006));
        const TriangleMesh mesh = apexMesh(surface);
        const core::Vec3 centre(0.012, 0.006, 0.004);
        for (int i = 0; i < 60; ++i) { // the ball, where contacts are
            const double turn = 2.399963 * i;
            const double up = 0.25 + 0.75 * (i % 13) / 12.0;
            const double flat = std::sqrt(1.0 - up * up);
            const core::Vec3 u(flat * std::cos(turn), flat * std::sin(turn), up);
            const core::Vec3 tip = centre + (0.020 - 0.001 - 0.006 * (i % 5) / 4.0) * u;
            const Dent dent = surface.dentUnder(tip);
            double nearest = 1.0;
            for (const MeshVertex& v : mesh.vertices)
                nearest = std::min(nearest, (dent.displaced(place(v)) - tip).norm());
            QVERIFY2(nearest < 0.0010, qPrintable(QString::number(nearest))); // vertices are 1.3 mm apart
        }
    }

    void dentsAreLocalAndContinuous() {
        const ApexSurface surface = ApexSurface::of(parameters(), at(0.0, 0.0));
        const Dent dent = surface.dentUnder({0.004, 0.0, 0.0185});
        QVERIFY(dent.depth_m > 0.001);
        const core::Vec3 side = dent.normal.unitOrthogonal();
        core::Vec3 before = dent.displaced(dent.p_WSurface);
        for (double r = 0.0; r < 2.0 * dent.reach_m; r += 1e-5) {
            const core::Vec3 p = dent.p_WSurface + r * side;
            const core::Vec3 moved = dent.displaced(p);
            QVERIFY((moved - before).norm() < 4e-5);
            if (r > dent.reach_m)
                QCOMPARE((moved - p).norm(), 0.0);
            before = moved;
        }
    }

    void heightIsTheTopOfTheMesh() {
        SceneState state = at(0.01, -0.01);
        state.dimpleShown = true;
        state.dimpleCentre_m = {0.014, -0.004};
        const ApexSurface surface = ApexSurface::of(parameters(), state);
        // straight above a felt point nothing is felt, straight below it something is
        simulation::HemisphereContact::Parameters contact;
        contact.surface = surface.ball;
        contact.dimple = surface.dimple;
        const simulation::HemisphereContact felt(contact);
        for (double x = -0.06; x <= 0.06; x += 0.0013) {
            for (double y = -0.06; y <= 0.06; y += 0.0017) {
                const double z = surface.height_m(x, y);
                QVERIFY(!felt.respond({x, y, z + 3e-6}, core::Vec3::Zero()).inContact);
                QVERIFY(felt.respond({x, y, z - 3e-6}, core::Vec3::Zero()).inContact);
            }
        }
    }

    void flatProfileGoesThroughTheTip() {
        const ApexSurface surface = ApexSurface::of(parameters(), at(0.012, 0.006));
        for (const core::Vec3& tip : pressedTips(surface)) {
            ToolView tool;
            tool.present = true;
            tool.p_WT = tip;
            double nearest = 1.0;
            for (const core::Vec2& p : FlatApex::profile(surface, tool))
                nearest = std::min(nearest, (p - core::Vec2(tip.x(), tip.z())).norm());
            QVERIFY2(nearest < 1e-9, qPrintable(QString::number(nearest)));
        }
    }

    void trianglesFaceOutwards() {
        const ApexSurface surface = ApexSurface::of(parameters(), at(0.02, 0.01));
        for (const TriangleMesh& mesh :
             {apexMesh(surface), instrumentBody(), instrumentJaw(), drapeMesh(75.0)}) {
            QVERIFY(!mesh.indices.empty());
            QCOMPARE(mesh.indices.size() % 3, std::size_t(0));
            int wrong = 0;
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                const MeshVertex& a = mesh.vertices.at(mesh.indices[i]);
                const MeshVertex& b = mesh.vertices.at(mesh.indices[i + 1]);
                const MeshVertex& c = mesh.vertices.at(mesh.indices[i + 2]);
                const core::Vec3 across = (place(b) - place(a)).cross(place(c) - place(a));
                const core::Vec3 said = normal(a) + normal(b) + normal(c);
                if (across.norm() > 1e-9 && across.dot(said) < 0.0)
                    ++wrong;
            }
            QCOMPARE(wrong, 0);
        }
    }

    void theClosedInstrumentEndsAtItsTip() {
        for (const MeshVertex& v : instrumentJaw().vertices)
            QVERIFY(v.position_mm[2] >= 0.0F);
        double nearest = 1.0;
        for (const MeshVertex& v : instrumentJaw().vertices)
            nearest = std::min(nearest, place(v).norm());
        QVERIFY(nearest < 1e-6);
    }

    void cameraSeesTheWorkspaceInEveryShape() {
        for (double aspect : {0.5, 0.8, 1.0, 4.0 / 3.0, 16.0 / 9.0, 3.0}) {
            for (double margin : {0.0, 0.12}) {
                const CameraFit camera = fitCamera(0.077, 0.004, 0.042, aspect, margin);
                const core::Vec3 ahead = (camera.p_WTarget - camera.p_WEye).normalized();
                const core::Vec3 right = ahead.cross(core::Vec3::UnitZ()).normalized();
                const double half = std::tan(0.5 * camera.fieldOfView_deg * core::kPi / 180.0);
                double used = 0.0;
                for (int i = 0; i < 360; ++i) {
                    const double angle = i * core::kPi / 180.0;
                    const core::Vec3 seen =
                        core::Vec3(0.077 * std::cos(angle), 0.077 * std::sin(angle), 0.004) - camera.p_WEye;
                    const double x = seen.dot(right) / seen.dot(ahead) / (half * aspect);
                    const double y = seen.dot(right.cross(ahead)) / seen.dot(ahead) / half;
                    QVERIFY(std::abs(y) < 1.0 && std::abs(x) < 1.0 - margin);
                    used = std::max({used, std::abs(x), std::abs(y)});
                }
                QVERIFY2(used > 0.6, qPrintable(QString::number(used))); // and does not waste the picture
            }
        }
    }

    void aMouseGetsABelievableShaftAndADeviceItsOwn() {
        DrawnOrientation held;
        ToolView tool;
        tool.present = true;
        tool.p_WT = {0.01, 0.0, 0.03};
        const core::Vec3 right = held.of(tool, false) * core::Vec3::UnitZ();
        const core::Vec3 left = held.of(tool, true) * core::Vec3::UnitZ();
        QVERIFY(right.x() > 0.2 && left.x() < -0.2 && right.z() > 0.3 && left.z() > 0.3);
        tool.q_WT = core::Quat(Eigen::AngleAxisd(0.2, core::Vec3::UnitX()));
        QVERIFY(held.of(tool, false).angularDistance(tool.q_WT) < 1e-9);
        tool.q_WT = core::Quat::Identity(); // a device that passes through the middle keeps its own
        QVERIFY(held.of(tool, false).angularDistance(tool.q_WT) < 1e-9);
    }
};

QTEST_GUILESS_MAIN(TestSceneGeometry)
#include "test_scene_geometry.moc"
