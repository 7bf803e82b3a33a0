// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "core/fp_environment.h"
#include "realtime/guarded_run.h"
#include "session/exercise_kind.h"
#include "session/session_setup.h"
#include "session/station.h"
#include "session/training_run.h"

#include <QtTest>
#include <algorithm>

using namespace chiron;
using namespace chiron::tests;

/// Every level of the catalogue as a session runs it, on each mechanism on which it can be done, with a
/// scripted operator: nothing is allocated, locked or thrown in a tick. A new exercise is asked as soon as it
/// is listed. What a scene does only later or seldom is looked at by the guards of single exercises.
class TestEveryExerciseGuard : public QObject {
    Q_OBJECT

    static constexpr std::size_t kSessionTicks =
        20'000; ///< arming takes 2 s; all touch something within 11 s

private slots:
    void initTestCase() { core::setModelFloatingPointEnvironment(); }

    void everyLevel_data() {
        QTest::addColumn<QString>("exercise");
        QTest::addColumn<int>("number");
        QTest::addColumn<QString>("mechanism");
        for (const catalogue::Exercise& exercise : m_catalogue.exercises()) {
            const auto kind = session::exerciseKind(exercise.id);
            QVERIFY2(kind.has_value(), exercise.id.c_str());
            for (const catalogue::ExerciseLevel& level : exercise.levels)
                for (const std::string_view mechanism : (*kind)->mechanisms())
                    QTest::addRow("%s %d, %s", exercise.id.c_str(), level.number,
                                  std::string(mechanism).c_str())
                        << QString::fromStdString(exercise.id) << level.number
                        << QString::fromStdString(std::string(mechanism));
        }
    }
    void everyLevel() {
        QFETCH(QString, exercise);
        QFETCH(int, number);
        QFETCH(QString, mechanism);
        const session::ExerciseKind& kind = **session::exerciseKind(exercise.toStdString());
        session::SessionSetup setup;
        setup.level = *m_catalogue.find(exercise.toStdString(), number);
        setup.seed = 1;
        setup.safety = session::headlessSafety(setup.level);
        const std::string held = mechanism.toStdString();
        auto station = session::scriptedStation(kind, setup.level, kind.operatorNames().front(), setup.seed,
                                                {.mechanism = held});
        QVERIFY2(station.has_value(), station ? "" : station.error().message.c_str());
        setup.mappings = station->mappings();
        std::vector<haptics::LoopTool> tools;
        for (const session::StationTool& tool : station->tools) {
            QVERIFY(tool.device->open().has_value());
            setup.devices.push_back(tool.device->descriptor());
            tools.push_back({*tool.device, tool.mapping});
        }
        haptics::LiveInputs inputs;
        FrameStore store(kSessionTicks);
        LoopBench bench(tools, inputs, store, kind.makeScene(setup), setup.safety);
        realtime::TickSource ticks;
        inputs.post({core::CommandKind::start});
        resetForbiddenCounts();
        bool on = true;
        for (std::size_t n = 0; on && n < kSessionTicks; ++n) {
            const realtime::HapticTick now = ticks.next(static_cast<std::int64_t>(n) * 1'000'000);
            const TickGuard guard;
            on = bench.loop->tick(now);
        }
        QVERIFY2(forbiddenCounts().total() == 0, words(forbiddenCounts()));
        const bool touched =
            std::any_of(store.frames.begin(), store.frames.end(), [](const core::HapticFrame& frame) {
                return std::any_of(frame.tool.begin(), frame.tool.begin() + frame.tools,
                                   [](const core::ToolFrame& tool) {
                                       return core::toWrench(tool.tissue).force.norm() > 0.02;
                                   });
            });
        QVERIFY(touched);
    }

private:
    catalogue::Catalogue m_catalogue = *catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
};

QTEST_APPLESS_MAIN(TestEveryExerciseGuard)
#include "test_every_exercise_guard.moc"
