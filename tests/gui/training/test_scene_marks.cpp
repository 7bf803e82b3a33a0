// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a scene draws to guide somebody is explained in a sentence, and nothing is explained that no scene
// draws.
#include "catalogue/catalogue.h"
#include "desktop/scene3d/scene_marks.h"
#include "desktop/training/scene_feed.h"
#include "gui/training/training_bench.h"
#include "modules/exercises/elastic_tube/simulation/elastic_tube_parameters.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"
#include "session/level_cues.h"

#include <QtTest>
#include <set>

using namespace chiron;

namespace {

std::set<std::string> drawnOn(const catalogue::ExerciseLevel& level, const desktop::Theme& theme, bool felt) {
    const session::LevelCues cues = session::cuesOf(level, felt);
    const scene3d::SceneSetup setup = desktop::sceneSetupOf(level, cues, theme, false, {});
    const std::vector<std::string> marks = scene3d::marksOf({setup, cues.coverage, level.feedback});
    return {marks.begin(), marks.end()};
}

} // namespace

class TestSceneMarks : public QObject {
    Q_OBJECT
private slots:
    void everyMarkHasItsSentence() {
        tests::DesktopFixture site;
        for (const catalogue::Exercise& exercise : site.site.catalogue().exercises()) {
            std::set<std::string> explained, drawn;
            for (const catalogue::LegendLine& line : exercise.legend)
                explained.insert(line.mark);
            for (const catalogue::ExerciseLevel& level : exercise.levels)
                for (const bool felt : {false, true})
                    drawn.merge(drawnOn(level, site.context.theme(), felt));
            for (const std::string& mark : drawn)
                QVERIFY2(explained.contains(mark),
                         (exercise.id + " draws, and does not explain: " + mark).c_str());
            for (const std::string& mark : explained)
                QVERIFY2(drawn.contains(mark),
                         (exercise.id + " explains, and draws nowhere: " + mark).c_str());
        }
    }

    /// In the flat picture there are two rings: each has its name.
    void theRingsOfAnObjectAndItsTargetAreTold() {
        tests::DesktopFixture site;
        int told = 0;
        for (const catalogue::LegendLine& line : site.site.catalogue().find("object_handling")->legend) {
            if (line.mark != "target_ring")
                continue;
            ++told;
            for (const char* language : {"en", "de", "el"}) {
                const QString text = QString::fromStdString(catalogue::textIn(line.text, language));
                for (const char* word : {language[0] == 'd'   ? "gestrichelt"
                                         : language[1] == 'l' ? "διακεκομμένος"
                                                              : "dashed",
                                         language[0] == 'd' ? "Rand des Objekts"
                                         : language[1] == 'l' ? "περίγραμμα του αντικειμένου"
                                                              : "edge of the object"})
                    QVERIFY2(text.contains(QString::fromUtf8(word)), qPrintable(text));
            }
        }
        QCOMPARE(told, 1);
    }

    /// By the cues of each level, and by what is known of its task.
    void aLevelHasItsOwnMarks() {
        tests::DesktopFixture site;
        const catalogue::Catalogue& all = site.site.catalogue();
        const auto on = [&](const char* exercise, int level) {
            return drawnOn(*all.find(exercise, level), site.context.theme(), false);
        };
        QVERIFY(on("sphere_apex", 1).contains("force_limit")); // the ring that stays while somebody touches
        QVERIFY(on("sphere_apex", 1).contains("apex_answer"));
        for (const catalogue::ExerciseLevel& level : all.find("sphere_apex")->levels)
            QCOMPARE(on("sphere_apex", level.number).contains("apex_answer"), level.feedback);
        for (const catalogue::ExerciseLevel& level : all.find("palpation")->levels) {
            QCOMPARE(on("palpation", level.number).contains("lump_answer"), level.feedback);
            QCOMPARE(on("palpation", level.number).contains("lump"), level.number == 1);
            QCOMPARE(on("palpation", level.number).contains("tool_rings"),
                     level.parameters.as<simulation::PalpationParameters>().tools() > 1);
        }
        for (const catalogue::ExerciseLevel& level : all.find("elastic_tube")->levels)
            QCOMPARE(on("elastic_tube", level.number).contains("tool_rings"),
                     level.parameters.as<simulation::ElasticTubeParameters>().tools() > 1);
        for (const catalogue::ExerciseLevel& level : all.find("urethra_insertion")->levels)
            QCOMPARE(on("urethra_insertion", level.number).contains("lumen_ring"),
                     session::cuesOf(level, false).guidance);
    }
};

QTEST_MAIN(TestSceneMarks)
#include "test_scene_marks.moc"
