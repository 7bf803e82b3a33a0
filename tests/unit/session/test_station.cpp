// SPDX-License-Identifier: GPL-3.0-or-later
// Which tools a session is done with follows from its exercise.
#include "catalogue/catalogue.h"
#include "core/units.h"
#include "devices/api/workspace_map.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "scoring/trace_csv.h"
#include "session/exercise_kind.h"
#include "session/station.h"
#include "simulation/palpation/tissue_surface.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using core::Vec3;
using session::PointerTool;

namespace {

const Vec3 kBeforeTheEntrance(0.0, -0.069, 0.0); // 25 mm before A at y = −44 mm

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
    std::span<const std::string_view> mechanisms() const noexcept override { return {&m_mechanism, 1}; }
    std::optional<Vec3> toolStart_W(const catalogue::ExerciseLevel&,
                                    const devices::WorkspaceMapping&) const override {
        return m_mechanism == "five_bar_spherical" ? std::optional(kBeforeTheEntrance) : std::nullopt;
    }
    std::unique_ptr<simulation::IScene> makeScene(const session::SessionSetup&) const override {
        return nullptr;
    }
    core::Result<session::ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel&,
                                                        const std::string& name, std::uint64_t,
                                                        const session::HeldDevices&) const override {
        if (name != "stayer")
            return core::fail(core::ErrorCode::notFound, "operator: expected stayer");
        return session::oneHanded(std::make_unique<Stayer>(), {});
    }
    std::vector<std::string> operatorNames() const override { return {"stayer"}; }
    int trialCount(const catalogue::ExerciseLevel&) const override { return 1; }
    double forceLimit_N(const catalogue::ExerciseLevel&) const override { return 4.0; }
    std::uint64_t tickLimit(const catalogue::ExerciseLevel&) const override { return 1; }
    void addTruth(const catalogue::ExerciseLevel&, std::uint64_t, scoring::TrialTrace&) const override {}
    std::unique_ptr<session::TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel&,
                                                         std::uint64_t) const override {
        return nullptr;
    }

private:
    std::string_view m_mechanism;
};

/// Instruments through entry points 60 mm to either side, `hands` of them held.
class Graspers final : public session::ExerciseKind {
public:
    explicit Graspers(int tools, int hands = 0) : m_tools(tools), m_hands(hands > 0 ? hands : tools) {}
    std::string_view id() const noexcept override { return "any"; }
    PointerTool pointerTool() const noexcept override { return PointerTool::grasper; }
    session::LevelTools tools(const catalogue::ExerciseLevel&) const override { return {.count = m_tools}; }
    devices::WorkspaceMapping toolPlace(const catalogue::ExerciseLevel&, int tool) const override {
        return {{tool % 2 == 0 ? 0.060 : -0.060, 0.0, 0.0}, 1.0, false};
    }
    std::unique_ptr<simulation::IScene> makeScene(const session::SessionSetup&) const override {
        return nullptr;
    }
    core::Result<session::ScriptedTrainee> makeOperator(const catalogue::ExerciseLevel&, const std::string&,
                                                        std::uint64_t,
                                                        const session::HeldDevices&) const override {
        session::ScriptedTrainee trainee;
        for (int hand = 0; hand < m_hands; ++hand)
            trainee.strategies.push_back(std::make_unique<Stayer>());
        return trainee;
    }
    std::vector<std::string> operatorNames() const override { return {"stayer"}; }
    int trialCount(const catalogue::ExerciseLevel&) const override { return 1; }
    double forceLimit_N(const catalogue::ExerciseLevel&) const override { return 4.0; }
    std::uint64_t tickLimit(const catalogue::ExerciseLevel&) const override { return 1; }
    void addTruth(const catalogue::ExerciseLevel&, std::uint64_t, scoring::TrialTrace&) const override {}
    std::unique_ptr<session::TrialSurfaces> makeSurfaces(const catalogue::ExerciseLevel&,
                                                         std::uint64_t) const override {
        return nullptr;
    }

private:
    int m_tools;
    int m_hands;
};

/// One tool in W after so many ticks of its device.
core::ToolState poseOf(session::Station& station, int ticks = 1, std::size_t index = 0) {
    core::ToolState tool;
    realtime::TickSource source;
    devices::IDevice& device = *station.tools.at(index).device;
    const devices::WorkspaceMap map(station.tools.at(index).mapping);
    for (int n = 0; n < ticks; ++n) {
        const auto now = source.next(static_cast<std::int64_t>(n) * 1'000'000);
        tool = map.pose(device.kinematics(), device.read(now));
        device.command(now, {});
    }
    return tool;
}

} // namespace

class TestStation : public QObject {
    Q_OBJECT
private slots:
    void aMouseMovesWhatTheExerciseHolds() {
        auto point = session::keyboardMouseStation();
        QVERIFY(point && point->pointers().size() == 1 && point->endoscope() == nullptr);
        const auto& urethra = **session::exerciseKind("urethra_insertion");
        for (const double scale : {0.25, 1.0, 4.0}) {
            auto station = session::keyboardMouseStation({.scale = scale, .origin_m = {}}, urethra, {});
            QVERIFY(station && station->pointers().empty() && station->endoscope() != nullptr);
            QVERIFY(station->tools[0].device->open().has_value());
            const core::ToolState tool = poseOf(*station);
            QVERIFY((tool.p_WT - kBeforeTheEntrance).norm() < 3e-6); // whatever the scale
            QVERIFY((tool.q_WT * -Vec3::UnitZ() - Vec3::UnitY()).norm() < 1e-9);
            station->endoscope()->move({.advance_m = 0.010 / scale});
            QVERIFY((poseOf(*station, 300).p_WT - kBeforeTheEntrance - Vec3(0.0, 0.010, 0.0)).norm() < 6e-6);
        }
        QVERIFY(!session::keyboardMouseStation({.scale = 9.0, .origin_m = {}}, urethra, {}));
    }

    /// P2's flexible mounting: the base stands turned, and what the device reads there is where it was in W.
    void basesCanBeMountedOtherwise() {
        const auto mapping = session::mappingOf({.turn_rad = {0.3, -0.2, 0.1}});
        QVERIFY(mapping && mapping->turned());
        const devices::WorkspaceMap map(*mapping);
        QVERIFY(map.pointToW(Vec3::UnitX()).y() >
                0.2); // to the left: the right side goes away from the person
        const auto tilted = session::mappingOf({.turn_rad = {0.0, 0.2, 0.0}});
        QVERIFY(devices::WorkspaceMap(*tilted).pointToW(Vec3::UnitZ()).y() > 0.15); // away from the person
        const auto rolled = session::mappingOf({.turn_rad = {0.0, 0.0, 0.2}});
        QVERIFY(devices::WorkspaceMap(*rolled).pointToW(Vec3::UnitZ()).x() > 0.15); // to the right
        const auto far = session::mappingOf({.turn_rad = {0.0, 1.0, 0.0}});
        QVERIFY(!far);
        QVERIFY(far.error().message.find("45 degrees") != std::string::npos);
        QVERIFY(!session::mappingOf({.turn_rad = {std::nan(""), 0.0, 0.0}}));
        const session::WorkspaceChoice turned{.turn_rad = {0.3, 0.0, 0.0}};
        const auto refused =
            session::scriptedStation(AnyKind("gimbal_hprd"), {}, "stayer", 5, {.mounting = turned});
        QVERIFY(!refused); // a hand that takes D for W would grope beside its work
        QCOMPARE(refused.error().code, core::ErrorCode::wrongUse);
        const auto pointer = session::keyboardMouseStation(turned);
        QVERIFY(pointer && !pointer->tools.front().mapping.turned()); // a mouse has no base
    }

    /// What a workspace may be, to its ends.
    void aWorkspaceHasItsLimits() {
        using Choice = session::WorkspaceChoice;
        const auto said = [](const Choice& choice) {
            const auto mapping = session::mappingOf(choice);
            return mapping ? std::string() : mapping.error().message;
        };
        for (const double scale : {0.25, 4.0}) {
            QCOMPARE(said({.scale = scale}), std::string());
            QVERIFY(said({.scale = scale < 1.0 ? std::nextafter(scale, 0.0) : std::nextafter(scale, 9.0)})
                        .ends_with("expected 0.25 to 4"));
        }
        for (std::size_t i = 0; i < 3; ++i)
            for (const double side : {-1.0, 1.0}) {
                Choice shifted, turned;
                shifted.origin_m[i] = side * 0.03;
                turned.turn_rad[i] = side * 0.25 * core::kPi;
                QCOMPARE(said(shifted), std::string());
                QCOMPARE(said(turned), std::string());
                QCOMPARE(session::mappingOf(shifted)->origin_m, shifted.origin_m);
                shifted.origin_m[i] *= 1.0001;
                turned.turn_rad[i] *= 1.0001;
                QVERIFY(said(shifted).ends_with("expected at most 0.03 m either way"));
                QVERIFY(said(turned).ends_with("expected at most 45 degrees either way"));
            }
    }

    /// What a level says of its bases holds, each beside where the exercise puts it, until somebody says
    /// otherwise.
    void aLevelMountsItsBases() {
        const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        catalogue::ExerciseLevel level = *catalogue->find("elastic_tube", 4);
        const auto kind = session::exerciseKind("elastic_tube");
        level.mounting.clear();
        const auto station = [&](const session::WorkspaceChoice& chosen) {
            auto made = session::scriptedStation(**kind, level, "expert", 5, {.mounting = chosen});
            return made ? made->mappings() : std::vector<devices::WorkspaceMapping>{};
        };
        const auto usual = station({});
        QVERIFY(usual.size() == 2 && !usual[0].turned());
        level.mounting = {
            {},
            {.scale = 0.9, .origin_m = {0.01, 0.0, 0.002}, .leftHanded = false, .turn_rad = {0.2, 0.1, 0.0}}};
        const auto mounted = station({});
        QCOMPARE(mounted.size(), std::size_t{2});
        QVERIFY(mounted[0].q_WD == usual[0].q_WD && mounted[0].origin_m == usual[0].origin_m);
        QVERIFY(std::abs(mounted[1].origin_m[0] - usual[1].origin_m[0] - 0.01) < 1e-12 &&
                mounted[1].scale == 0.9);
        QVERIFY(mounted[1].q_WD == session::mappingOf(level.mounting[1])->q_WD);
        const auto otherwise =
            station({.scale = 1.0, .origin_m = {}, .leftHanded = false, .turn_rad = {-0.3, 0.0, 0.0}});
        QVERIFY(otherwise[0].q_WD == otherwise[1].q_WD &&
                otherwise[1].q_WD == session::mappingOf({.turn_rad = {-0.3, 0.0, 0.0}})->q_WD);
        QVERIFY(otherwise[1].scale == 0.9); // of that nothing was said
        const auto straight =
            station({.scale = 1.0, .origin_m = {}, .leftHanded = false, .turn_rad = {}, .turnGiven = true});
        QVERIFY(!straight[1].turned());
        const auto pointer = session::keyboardMouseStation({}, **kind, level);
        QVERIFY(pointer && !pointer->tools[1].mapping.turned() &&
                pointer->tools[1].mapping.scale == 1.0); // a mouse is mounted nowhere
        const catalogue::ExerciseLevel& fold =
            *catalogue->find("elastic_tube", 6); // two hands and a retractor
        const auto three = session::scriptedStation(**kind, fold, "novice", 5);
        QVERIFY(three && three->tools.size() == 3 && three->tools[2].mapping.turned() &&
                three->tools[2].mapping.origin_m[1] > 0.0);
        const auto mouse = session::keyboardMouseStation({}, **kind, fold);
        QVERIFY(mouse && mouse->pointers().size() == 3);
        level.mounting[1].turn_rad[0] = 1.0; // stored content that no schema saw
        QVERIFY(station({}).empty());
    }

    void theScriptedOperatorHoldsTheMechanismOfTheExercise() {
        auto endoscope = session::scriptedStation(AnyKind("five_bar_spherical"), {}, "stayer", 5);
        QVERIFY(endoscope.has_value());
        QCOMPARE(endoscope->tools[0].device->descriptor().kinematics, std::string("five_bar_spherical"));
        QVERIFY(endoscope->tools[0].device->open().has_value());
        const core::ToolState tool = poseOf(*endoscope);
        QVERIFY((tool.p_WT - kBeforeTheEntrance).norm() < 30e-6);
        QVERIFY((tool.q_WT * -Vec3::UnitZ() - Vec3::UnitY()).norm() < 3e-4);
        auto gimbal = session::scriptedStation(AnyKind("gimbal_hprd"), {}, "stayer", 5);
        QVERIFY(gimbal.has_value());
        QCOMPARE(gimbal->tools[0].device->descriptor().kinematics, std::string("gimbal_hprd"));
        const auto unknown = session::scriptedStation(AnyKind("hexapod"), {}, "stayer", 5);
        QVERIFY(!unknown && unknown.error().code == core::ErrorCode::wrongUse);
        QVERIFY(unknown.error().message.find("hexapod") != std::string::npos);
        QVERIFY(!session::scriptedStation(AnyKind("gimbal_hprd"), {}, "nobody", 5));
    }

    /// The same operator on another arm: a light hand gives way further than a firm one.
    void anotherHandMayHoldTheMechanism() {
        const auto pushed_m = [](const mechanisms::HandParameters* hand) {
            auto station = session::scriptedStation(AnyKind("gimbal_hprd"), {}, "stayer", 5, {.hand = hand});
            devices::IDevice& device = *station->tools.at(0).device;
            if (!device.open())
                return 0.0;
            realtime::TickSource source;
            Vec3 first = Vec3::Zero(), last = Vec3::Zero();
            for (int n = 0; n < 150; ++n) {
                const auto now = source.next(static_cast<std::int64_t>(n) * 1'000'000);
                last = device.kinematics().pose(device.read(now)).p_WT;
                first = n == 0 ? last : first;
                devices::ForceCommand command;
                command.wrench_D.force = Vec3(1.0, 0.0, 0.0);
                command.enabled = true;
                device.command(now, command);
            }
            return (last - first).norm();
        };
        const mechanisms::HandParameters light = mechanisms::HandParameters::light(),
                                         firm = mechanisms::HandParameters::firm();
        const double own_m = pushed_m(nullptr), light_m = pushed_m(&light), firm_m = pushed_m(&firm);
        QVERIFY(firm_m > 0.0 && own_m > 1.2 * firm_m && light_m > 1.2 * own_m);
    }

    /// Row by row the pose that was recorded, orientation included; without it an endoscope is refused, a
    /// point is not.
    void aTraceBringsItsOrientation() {
        std::string text = "t_s,x_mm,y_mm,z_mm,qw,qx,qy,qz\n";
        std::string bare = "t_s,x_mm,y_mm,z_mm\n";
        const auto poseAt = [](int row) {
            const double pitch = 0.02 * row;
            return core::Quat(Eigen::AngleAxisd(0.5 * core::kPi + pitch, Vec3::UnitX()));
        };
        for (int row = 0; row <= 50; ++row) {
            const core::Quat q = poseAt(row);
            const std::string place =
                QString::asprintf("%.3f,0,%.4f,%.4f", 0.01 * row, -69.0 + row, 0.1 * row).toStdString();
            text +=
                place + QString::asprintf(",%.9f,%.9f,%.9f,%.9f\n", q.w(), q.x(), q.y(), q.z()).toStdString();
            bare += place + "\n";
        }
        auto station =
            session::traceStation(*scoring::readTraceCsv(text, "with.csv"), PointerTool::endoscope);
        QVERIFY(station.has_value());
        QVERIFY(station->tools[0].device->open().has_value());
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

    /// One tool for each instrument, under its entry point, its jaw open; each mailbox moves its own tool and
    /// no other, and all reach the same box.
    void aMouseMovesOneOfSeveralGraspers() {
        for (const bool leftHanded : {false, true}) {
            auto station = session::keyboardMouseStation(
                {.origin_m = {0.010, 0.0, 0.0}, .leftHanded = leftHanded}, Graspers(2), {});
            QVERIFY(station && station->pointers().size() == 2 && station->tools.size() == 2);
            for (auto& tool : station->tools)
                QVERIFY(tool.device->open().has_value());
            const core::ToolState right = poseOf(*station, 1, 0);
            QVERIFY((right.p_WT - Vec3(0.070, 0.0, 0.060)).norm() < 3e-6);
            QVERIFY((poseOf(*station, 1, 1).p_WT - Vec3(-0.050, 0.0, 0.060)).norm() < 3e-6);
            QCOMPARE(right.jaw_rad, 1.6);
            station->pointers()[1]->move(0.0, 0.004, 0.0);
            station->pointers()[1]->setJawRate(-1.0);
            QVERIFY((poseOf(*station, 300, 0).p_WT - right.p_WT).norm() < 1e-9);
            const core::ToolState left = poseOf(*station, 300, 1);
            QVERIFY(std::abs(left.p_WT.y() - 0.004) < 3e-6 && std::abs(left.jaw_rad - 1.3) < 2e-3);
            for (std::size_t tool = 0; tool < 2; ++tool) { // to the same edge of W: 80 mm from the middle
                station->pointers()[tool]->move(leftHanded ? -1.0 : 1.0, 0.0, 0.0);
                QVERIFY(std::abs(poseOf(*station, 800, tool).p_WT.x() - 0.090) < 3e-6);
            }
        }
        QVERIFY(!session::keyboardMouseStation({}, Graspers(0), {}));
        QVERIFY(!session::keyboardMouseStation({}, Graspers(5), {}));
        const auto point = session::keyboardMouseStation({}, AnyKind("gimbal_hprd"), {});
        QVERIFY(point && point->pointers().size() == 1);
    }

    /// A finger that palpates begins just above the skin, on every level, wherever the workspace was shifted
    /// and however it is scaled.
    void aFingerBeginsJustAboveTheTissue() {
        const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        QVERIFY(catalogue.has_value());
        const auto kind = session::exerciseKind("palpation");
        QVERIFY(kind.has_value());
        int levels = 0;
        for (const catalogue::ExerciseLevel& level : catalogue->find("palpation")->levels) {
            const simulation::TissueSurface surface(
                level.parameters.as<simulation::PalpationParameters>().tissue.shape);
            for (const session::WorkspaceChoice& choice :
                 {session::WorkspaceChoice{},
                  session::WorkspaceChoice{.scale = 2.0, .origin_m = {0.01, -0.02, 0.005}},
                  session::WorkspaceChoice{.scale = 0.5, .leftHanded = true}}) {
                auto station = session::keyboardMouseStation(choice, **kind, level);
                QVERIFY(station.has_value());
                for (std::size_t tool = 0; tool < station->tools.size(); ++tool) {
                    QVERIFY(station->tools[tool].device->open().has_value());
                    const Vec3 p_WT = poseOf(*station, 1, tool).p_WT;
                    const double above_m = p_WT.z() - surface.pointAt(p_WT.head<2>()).z();
                    QVERIFY2(
                        std::abs(above_m - 0.005) < 1e-5,
                        qPrintable(
                            QStringLiteral("%1: %2 m").arg(QString::fromStdString(level.id)).arg(above_m)));
                }
            }
            ++levels;
        }
        QVERIFY(levels >= 5);
        auto ball = session::keyboardMouseStation({}, **session::exerciseKind("sphere_apex"),
                                                  catalogue->find("sphere_apex")->levels.front());
        QVERIFY(ball.has_value() && ball->tools.front().device->open().has_value());
        QVERIFY(std::abs(poseOf(*ball, 1, 0).p_WT.z() - 0.060) <
                1e-5); // a hidden ball has to be looked for from above
    }

    /// Each hand at its own gimbal, at its own place, with a tremor of its own; all with jaws.
    void everyInstrumentHasItsGimbal() {
        auto station = session::scriptedStation(Graspers(4), {}, "stayer", 5, {.forceMap = "as-published"});
        QVERIFY(station && station->tools.size() == 4);
        for (auto& tool : station->tools) {
            QVERIFY(tool.device->open().has_value());
            QVERIFY(tool.device->descriptor().jawResolution_rad > 0.0);
            QCOMPARE(tool.device->descriptor().kinematicsParameters.at(1), 1.0);
        }
        for (std::size_t tool = 0; tool < 4; ++tool)
            QVERIFY(
                (poseOf(*station, 1, tool).p_WT - Vec3(tool % 2 == 0 ? 0.060 : -0.060, 0.0, 0.050)).norm() <
                60e-6);
        QVERIFY((poseOf(*station, 500, 0).p_WT - poseOf(*station, 500, 2).p_WT).norm() > 1e-5);
        const auto unknown = session::scriptedStation(Graspers(4), {}, "stayer", 5, {.forceMap = "by-feel"});
        QVERIFY(!unknown && unknown.error().code == core::ErrorCode::wrongUse);
        QVERIFY(unknown.error().message.find("by-feel") != std::string::npos);
        const auto one = session::scriptedStation(Graspers(1, 2), {}, "stayer", 5);
        QVERIFY(!one && one.error().code == core::ErrorCode::wrongUse);
        QCOMPARE(one.error().message, std::string("exercise any: 2 hands for 1 instruments"));
    }

    /// Rows of both tools drive both, with their jaws, on one clock; a tool that comes later waits, one that
    /// ends earlier stays.
    void aTraceDrivesEveryTool() {
        const std::string text = "t_s,x_mm,y_mm,z_mm,jaw_deg,tool\n"
                                 "1.0,0,0,50,0,0\n1.1,10,0,50,57.29577951308232,0\n"
                                 "1.05,-20,0,40,0,1\n1.15,-20,0,30,0,1\n"
                                 "1.0,1,2,3,0,3\n"; // nobody needs a fourth
        const auto rows = scoring::readTraceCsv(text, "two.csv");
        QVERIFY(rows.has_value());
        auto station = session::traceStation(*rows, PointerTool::grasper, 2);
        QVERIFY(station && station->tools.size() == 2 && station->mappings().size() == 2);
        for (auto& tool : station->tools)
            QVERIFY(tool.device->open().has_value());
        QVERIFY((poseOf(*station, 51, 0).p_WT - Vec3(0.005, 0.0, 0.050)).norm() < 2e-6);
        QVERIFY(std::abs(poseOf(*station, 49, 0).jaw_rad - 0.99) < 1e-5);
        QVERIFY((poseOf(*station, 50, 1).p_WT - Vec3(-0.020, 0.0, 0.040)).norm() <
                2e-6); // not before its time
        QVERIFY((poseOf(*station, 51, 1).p_WT - Vec3(-0.020, 0.0, 0.035)).norm() < 2e-6);
        QVERIFY(!station->tools.front().device->finished());
        QVERIFY((poseOf(*station, 60, 0).p_WT - Vec3(0.010, 0.0, 0.050)).norm() < 2e-6);
        QVERIFY(station->tools.front().device->finished());
    }

    void aTraceThatLacksAToolIsRefused() {
        const auto refusal = [](const std::string& text, int tools) {
            const auto station =
                session::traceStation(*scoring::readTraceCsv(text, "t.csv"), PointerTool::grasper, tools);
            return station ? std::string() : station.error().message;
        };
        const std::string right = "t_s,x_mm,y_mm,z_mm,jaw_deg,tool\n0,0,0,50,0,0\n1,0,0,50,0,0\n";
        QCOMPARE(refusal(right, 1), std::string());
        QCOMPARE(refusal(right, 2),
                 std::string("t.csv: no row of tool 1; the level needs rows of tools 0 to 1 (column tool)"));
        QCOMPARE(refusal("t_s,x_mm,y_mm,z_mm,jaw_deg\n0,0,0,50,0\n1,0,0,50,0\n", 2),
                 std::string("t.csv: no row of tool 1; the level needs rows of tools 0 to 1 (column tool)"));
        QCOMPARE(refusal("t_s,x_mm,y_mm,z_mm\n0,0,0,50\n", 1),
                 std::string("t.csv: no jaw; a grasper needs the column jaw_deg"));
    }
};

QTEST_APPLESS_MAIN(TestStation)
#include "test_station.moc"
