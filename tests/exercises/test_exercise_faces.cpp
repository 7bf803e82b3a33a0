// SPDX-License-Identifier: GPL-3.0-or-later
// What screens and reports ask of every exercise, asked of each.
#include "desktop/exercise_face.h"
#include "session_report/exercise_section.h"

#include <QDir>
#include <QSet>
#include <QtTest>

using namespace chiron;

namespace {

catalogue::ExerciseLevel levelOf(const char* exercise, catalogue::ExerciseParameters parameters) {
    catalogue::ExerciseLevel level;
    level.exercise = exercise;
    level.parameters = std::move(parameters);
    return level;
}

/// One of each, with the values that parameters begin with.
std::vector<catalogue::ExerciseLevel> everyLevel() {
    return {levelOf("sphere_apex", simulation::SphereApexParameters{}),
            levelOf("urethra_insertion", simulation::UrethraInsertionParameters{}),
            levelOf("elastic_tube", simulation::ElasticTubeParameters{}),
            levelOf("object_handling", simulation::ObjectHandlingParameters{}),
            levelOf("palpation", simulation::PalpationParameters{}),
            levelOf("comparison", simulation::ComparisonParameters{})};
}

const desktop::ExerciseFace& faceOf(const catalogue::ExerciseLevel& level) { return **desktop::exerciseFace(level.exercise); }

} // namespace

class TestExerciseFaces : public QObject {
    Q_OBJECT
private slots:
    void everyFolderIsAsked();
    void theyAreKnownByTheirIds();
    void theirWordsAreTheirOwn();
    void aSessionWithoutTrialsIsShownAsOne();
    void aReportHasOneSectionAtMost();
};

/// So that no exercise is left out below.
void TestExerciseFaces::everyFolderIsAsked() {
    QStringList asked;
    for (const catalogue::ExerciseLevel& level : everyLevel())
        asked << QString::fromStdString(level.exercise);
    asked.sort();
    QCOMPARE(asked, QDir(QStringLiteral(CHIRON_SOURCE_DIR "/app/exercises")).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name));
}

void TestExerciseFaces::theyAreKnownByTheirIds() {
    const auto none = desktop::exerciseFace("knitting");
    QVERIFY(!none && none.error().code == core::ErrorCode::notFound);
    for (const catalogue::ExerciseLevel& level : everyLevel()) {
        const auto face = desktop::exerciseFace(level.exercise);
        QVERIFY2(face && (*face)->id() == level.exercise, level.exercise.c_str());
        QVERIFY2(none.error().message.find(level.exercise) != std::string::npos, none.error().message.c_str());
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
    QStringList with;
    for (const catalogue::ExerciseLevel& level : everyLevel())
        if (session_report::exerciseSectionOf({}, level))
            with << QString::fromStdString(level.exercise);
    // The others say nothing of a session without trials; studies have reports of their own.
    QCOMPARE(with, (QStringList{"sphere_apex", "elastic_tube", "object_handling"}));
    catalogue::ExerciseLevel unknown = everyLevel().front();
    unknown.exercise = "knitting";
    QVERIFY(!session_report::exerciseSectionOf({}, unknown));
}

QTEST_MAIN(TestExerciseFaces)
#include "test_exercise_faces.moc"
