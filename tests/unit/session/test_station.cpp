// SPDX-License-Identifier: GPL-3.0-or-later
// Which tools a session is done with follows from its exercise.
#include "core/units.h"
#include "devices/api/workspace_map.h"
#include "scoring/trace_csv.h"
#include "session/station.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Vec3;
using session::PointerTool;

namespace {

/// A hand that stays where it is.
class Stayer final : public mechanisms::HandStrategy {
public:
    mechanisms::HandIntention decide(const mechanisms::HandPerception& seen) noexcept override {
        mechanisms::HandIntention stay;
        stay.p_DDesired = seen.p_DT;
        stay.q_DDesired = seen.q_DT;
        return stay;
    }
};

/// An exercise done on any mechanism.
class AnyKind final : public session::ExerciseKind {
public:
    explicit AnyKind(std::string_view mechanism) : m_mechanism(mechanism) {}
    std::string_view id() const noexcept override { return "any"; }
    std::string_view mechanism() const noexcept override { return m_mechanism; }
    std::unique_ptr<simulation::IScene> makeScene(const session::SessionSetup&) const override { return nullptr; }
    core::Result<session::ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel&, const std::string& name,
                                                        std::uint64_t) const override {
        if (name != "stayer")
            return core::fail(core::ErrorCode::notFound, "operator: expected stayer");
        return session::oneHanded(std::make_unique<Stayer>(), {});
    }
    std::vector<std::string> operatorNames() const override { return {"stayer"}; }
    int trialCount(const catalogue::ExerciseLevel&) const override { return 1; }
    double forceLimit_N(const catalogue::ExerciseLevel&) const override { return 4.0; }
    std::uint64_t tickLimit(const catalogue::ExerciseLevel&) const override { return 1; }
    void addTruth(const catalogue::ExerciseLevel&, std::uint64_t, scoring::TrialTrace&) const override {}
    std::unique_ptr<session::TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel&, std::uint64_t) const override { return nullptr; }

private:
    std::string_view m_mechanism;
};

/// The tool in W after so many ticks.
core::ToolState poseOf(session::Station& station, int ticks = 1) {
    core::ToolState tool;
    realtime::TickSource source;
    const devices::WorkspaceMap map(station.mappings.at(0));
    for (int n = 0; n < ticks; ++n) {
        const auto now = source.next(static_cast<std::int64_t>(n) * 1'000'000);
        tool = map.pose(station.devices.at(0)->kinematics(), station.devices.at(0)->read(now));
        station.devices.at(0)->command(now, {});
    }
    return tool;
}

const Vec3 kBeforeTheEntrance(0.0, -0.069, 0.0); // 25 mm before A at y = −44 mm

} // namespace

class TestStation : public QObject {
    Q_OBJECT
private slots:
    void aMouseMovesWhatTheExerciseHolds() {
        auto point = session::keyboardMouseStation();
        QVERIFY(point && point->pointer != nullptr && point->endoscope == nullptr);
        for (const double scale : {0.25, 1.0, 4.0}) {
            auto station = session::keyboardMouseStation({.scale = scale, .origin_m = {}}, PointerTool::endoscope);
            QVERIFY(station && station->pointer == nullptr && station->endoscope != nullptr);
            QVERIFY(station->devices[0]->open().has_value());
            const core::ToolState tool = poseOf(*station);
            QVERIFY((tool.p_WT - kBeforeTheEntrance).norm() < 3e-6); // whatever the scale
            QVERIFY((tool.q_WT * -Vec3::UnitZ() - Vec3::UnitY()).norm() < 1e-9);
            station->endoscope->move({.advance_m = 0.010 / scale});
            QVERIFY((poseOf(*station, 300).p_WT - kBeforeTheEntrance - Vec3(0.0, 0.010, 0.0)).norm() < 6e-6);
        }
        QVERIFY(!session::keyboardMouseStation({.scale = 9.0, .origin_m = {}}, PointerTool::endoscope));
    }

    void theScriptedOperatorHoldsTheMechanismOfTheExercise() {
        auto endoscope = session::scriptedStation(AnyKind("five_bar_spherical"), {}, "stayer", 5);
        QVERIFY(endoscope.has_value());
        QCOMPARE(endoscope->devices[0]->descriptor().kinematics, std::string("five_bar_spherical"));
        QVERIFY(endoscope->devices[0]->open().has_value());
        const core::ToolState tool = poseOf(*endoscope);
        QVERIFY((tool.p_WT - kBeforeTheEntrance).norm() < 30e-6);
        QVERIFY((tool.q_WT * -Vec3::UnitZ() - Vec3::UnitY()).norm() < 3e-4);
        auto gimbal = session::scriptedStation(AnyKind("gimbal_hprd"), {}, "stayer", 5);
        QVERIFY(gimbal.has_value());
        QCOMPARE(gimbal->devices[0]->descriptor().kinematics, std::string("gimbal_hprd"));
        const auto unknown = session::scriptedStation(AnyKind("hexapod"), {}, "stayer", 5);
        QVERIFY(!unknown && unknown.error().code == core::ErrorCode::wrongUse);
        QVERIFY(unknown.error().message.find("hexapod") != std::string::npos);
        QVERIFY(!session::scriptedStation(AnyKind("gimbal_hprd"), {}, "nobody", 5));
    }

    /// Row by row the pose that was recorded, orientation included; without it an endoscope is refused, a point is not.
    void aTraceBringsItsOrientation() {
        std::string text = "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
        std::string bare = "t_s,x_mm,y_mm,z_mm\n";
        const auto poseAt = [](int row) {
            const double pitch = 0.02 * row;
            return core::Quat(Eigen::AngleAxisd(0.5 * core::kPi + pitch, Vec3::UnitX()));
        };
        for (int row = 0; row <= 50; ++row) {
            const core::Quat q = poseAt(row);
            const std::string place = QString::asprintf("%.3f,0,%.4f,%.4f", 0.01 * row, -69.0 + row, 0.1 * row).toStdString();
            text += place + QString::asprintf(",%.9f,%.9f,%.9f,%.9f\n", q.w(), q.x(), q.y(), q.z()).toStdString();
            bare += place + "\n";
        }
        auto station = session::traceStation(*scoring::readTraceCsv(text, "with.csv"), PointerTool::endoscope);
        QVERIFY(station.has_value());
        QVERIFY(station->devices[0]->open().has_value());
        QVERIFY(poseOf(*station).q_WT.angularDistance(poseAt(0)) < 3e-6);
        const core::ToolState last = poseOf(*station, 600);
        QVERIFY(last.q_WT.angularDistance(poseAt(50)) < 3e-6);
        QVERIFY((last.p_WT - Vec3(0.0, -0.019, 0.005)).norm() < 3e-6);

        const auto rows = scoring::readTraceCsv(bare, "bare.csv");
        QVERIFY(rows && session::traceStation(*rows).has_value());
        const auto refused = session::traceStation(*rows, PointerTool::endoscope);
        QVERIFY(!refused && refused.error().code == core::ErrorCode::badInput); // exit 3
        QVERIFY(refused.error().message.find("bare.csv") != std::string::npos);
        QVERIFY(refused.error().message.find("qw") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(TestStation)
#include "test_station.moc"
