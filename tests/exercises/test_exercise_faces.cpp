// SPDX-License-Identifier: GPL-3.0-or-later
// What screens and reports ask of every exercise, asked of each.
#include "catalogue/catalogue.h"
#include "desktop/exercise_face.h"
#include "session/exercise_kind.h"
#include "session/moment_rule.h"
#include "session_report/exercise_section.h"
#include "session_report/exercise_words.h"
#include "session_report/tool_words.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QDir>
#include <QSet>
#include <QtTest>
#include <algorithm>

using namespace chiron;

namespace {

/// Level 1 of each exercise as it is shipped, and one of those that studies alone use, with the values that
/// parameters begin with.
const std::vector<catalogue::ExerciseLevel>& everyLevel() {
    static const std::vector<catalogue::ExerciseLevel> kLevels = [] {
        const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
        if (!catalogue)
            qFatal("%s", catalogue.error().message.c_str());
        std::vector<catalogue::ExerciseLevel> levels;
        for (const catalogue::Exercise& exercise : catalogue->exercises())
            levels.push_back(exercise.levels.front());
        levels.push_back({});
        levels.back().exercise = "comparison";
        levels.back().parameters = simulation::ComparisonParameters{};
        return levels;
    }();
    return kLevels;
}

const desktop::ExerciseFace& faceOf(const catalogue::ExerciseLevel& level) {
    return **desktop::exerciseFace(level.exercise);
}

} // namespace

class TestExerciseFaces : public QObject {
    Q_OBJECT
private slots:
    void whatOnlyStudiesPresentIsInNoCatalogue();
    void everyFolderIsAsked();
    void theyAreKnownByTheirIds();
    void theirWordsAreTheirOwn();
    void aSessionWithoutTrialsIsShownAsOne();
    void aReportHasOneSectionAtMost();
    void everyEndHasWords();
    void rulesOfMomentsAreOfWhatThereIs();
};

/// A rule that says where a metric was worst is of a metric that a level asks for, and of marks or a quantity
/// that there are.
void TestExerciseFaces::rulesOfMomentsAreOfWhatThereIs() {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QVERIFY(catalogue);
    int rules = 0;
    for (const catalogue::Exercise& exercise : catalogue->exercises()) {
        const auto kind = session::exerciseKind(exercise.id);
        QVERIFY(kind);
        for (const session::MomentRule& rule : (*kind)->momentRules()) {
            ++rules;
            const std::string which = exercise.id + ": " + std::string(rule.metric);
            const auto anyLevel = [&](auto holds) {
                return std::any_of(exercise.levels.begin(), exercise.levels.end(), holds);
            };
            QVERIFY2(anyLevel([&](const catalogue::ExerciseLevel& level) {
                         return std::any_of(level.metrics.begin(), level.metrics.end(),
                                            [&](const auto& metric) { return rule.isOf(metric.id); });
                     }),
                     which.c_str());
            const bool ofMarks = rule.by == session::MomentRule::By::largestMark ||
                                 rule.by == session::MomentRule::By::firstMark;
            QVERIFY2(ofMarks == !rule.marks.empty(), which.c_str());
            if (rule.by != session::MomentRule::By::largestQuantity)
                continue;
            QVERIFY2(anyLevel([&](const catalogue::ExerciseLevel& level) {
                         const auto quantities = (*kind)->quantities(level);
                         return std::any_of(quantities.begin(), quantities.end(), [&](const auto& quantity) {
                             return quantity.id == rule.quantity;
                         });
                     }),
                     which.c_str());
        }
    }
    QVERIFY(rules >= 9);
}

/// What only studies present is told by that, and is in no catalogue; an exercise is.
void TestExerciseFaces::whatOnlyStudiesPresentIsInNoCatalogue() {
    const auto catalogue = catalogue::Catalogue::load(CHIRON_SOURCE_DIR "/curriculum/content");
    QVERIFY(catalogue);
    int onlyInStudies = 0;
    for (const session::ExerciseKind* kind : session::exerciseKinds()) {
        const bool listed = std::any_of(catalogue->exercises().begin(), catalogue->exercises().end(),
                                        [&](const auto& exercise) { return exercise.id == kind->id(); });
        QVERIFY2(listed != kind->onlyInStudies(), std::string(kind->id()).c_str());
        QCOMPARE(session::isOnlyInStudies(kind->id()), kind->onlyInStudies());
        onlyInStudies += kind->onlyInStudies() ? 1 : 0;
    }
    QVERIFY(onlyInStudies > 0);
    QVERIFY(!session::isOnlyInStudies("knitting") && !session::isOnlyInStudies(""));
}

/// So that no exercise is left out below.
void TestExerciseFaces::everyFolderIsAsked() {
    QStringList asked;
    for (const catalogue::ExerciseLevel& level : everyLevel())
        if (!session::isOnlyInStudies(level.exercise)) // what studies present is no exercise
            asked << QString::fromStdString(level.exercise);
    asked.sort();
    QCOMPARE(asked, QDir(QStringLiteral(CHIRON_SOURCE_DIR "/app/exercises"))
                        .entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name));
}

void TestExerciseFaces::theyAreKnownByTheirIds() {
    const auto none = desktop::exerciseFace("knitting");
    QVERIFY(!none && none.error().code == core::ErrorCode::notFound);
    for (const catalogue::ExerciseLevel& level : everyLevel()) {
        const auto face = desktop::exerciseFace(level.exercise);
        QVERIFY2(face && (*face)->id() == level.exercise, level.exercise.c_str());
        QVERIFY2(none.error().message.find(level.exercise) != std::string::npos,
                 none.error().message.c_str());
    }
}

/// No exercise speaks with another one's words.
void TestExerciseFaces::theirWordsAreTheirOwn() {
    QSet<QString> said;
    for (const catalogue::ExerciseLevel& level : everyLevel())
        for (const QString& words : {faceOf(level).debriefTitle(), faceOf(level).debriefEmpty()}) {
            QVERIFY2(!words.isEmpty() && !said.contains(words), qPrintable(words));
            said.insert(words);
        }
}

void TestExerciseFaces::aSessionWithoutTrialsIsShownAsOne() {
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    for (const catalogue::ExerciseLevel& level : everyLevel()) {
        const desktop::DebriefReading part = faceOf(level).readDebrief(level, {});
        QVERIFY2(part, level.exercise.c_str());
        QVERIFY2(!*part || !(*part)->widget(theme, QLocale::c()), level.exercise.c_str());
        session::SessionSetup setup;
        setup.level = level;
        const auto layer = faceOf(level).playbackLayer(setup, {});
        QVERIFY2(layer && layer->lost().isEmpty(), level.exercise.c_str());
    }
}

void TestExerciseFaces::aReportHasOneSectionAtMost() {
    for (const catalogue::ExerciseLevel& level : everyLevel())
        QVERIFY2(level.exercise != "comparison" || !session_report::exerciseSectionOf({}, level),
                 "studies have reports of their own");
    catalogue::ExerciseLevel unknown = everyLevel().front();
    unknown.exercise = "knitting";
    QVERIFY(!session_report::exerciseSectionOf({}, unknown));
}

void TestExerciseFaces::everyEndHasWords() {
    for (const catalogue::ExerciseLevel& level : everyLevel()) {
        const session_report::EndWords ends = session_report::endWords(level.exercise);
        for (const QString& words : {ends.marked, ends.completed, ends.timedOut, ends.failed, ends.damaged})
            QVERIFY2(!words.isEmpty(), level.exercise.c_str());
        QVERIFY2(!session_report::toolName(level, 0, 1).isEmpty(), level.exercise.c_str());
    }
    QVERIFY(session_report::endWords("knitting").completed.isEmpty());
    catalogue::ExerciseLevel unknown;
    unknown.exercise = "knitting";
    QCOMPARE(session_report::toolName(unknown, 1, 2), session_report::instrumentName(1, 2));
}

QTEST_MAIN(TestExerciseFaces)
#include "test_exercise_faces.moc"
