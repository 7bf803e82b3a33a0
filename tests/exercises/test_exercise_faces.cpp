// SPDX-License-Identifier: GPL-3.0-or-later
// What screens and reports ask of every exercise, asked of each.
#include "app/exercises/exercise_catalogue.h"
#include "catalogue/catalogue.h"
#include "desktop/exercise_face.h"
#include "desktop/playback/playback_scene.h"
#include "desktop/scene2d/flat_content.h"
#include "desktop/training/info_view.h"
#include "devices/kinematics_catalogue.h"
#include "session/exercise_kind.h"
#include "session/level_cues.h"
#include "session/moment_rule.h"
#include "session/playback_track.h"
#include "session_report/exercise_reporter.h"
#include "session_report/mark_words.h"
#include "session_report/tool_words.h"
#include "simulation/comparison/comparison_parameters.h"

#include <QDir>
#include <QSet>
#include <QtTest>
#include <algorithm>
#include <array>
#include <set>

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

template <class... Exercises> std::vector<std::string> idsOf(exercises::List<Exercises...>) {
    return {Exercises::kId...};
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
    void everyListHasEveryLine();
    void everyMarkHasWords();
    void anObjectThatCameOffIsNoTissue();
    void rulesOfMomentsAreOfWhatThereIs();
    void everyLevelHasAMechanismAndItsTools();
    void everyKeyOfALevelDoesOneThing();
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
            QVERIFY2((rule.by == session::MomentRule::By::own) == (rule.own != nullptr), which.c_str());
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

/// Each library's list is made from the lines of the catalogue, and each part knows whose it is.
void TestExerciseFaces::everyListHasEveryLine() {
    const std::vector<std::string> lines = idsOf(exercises::All{});
    QCOMPARE(lines.size(), everyLevel().size());
    QCOMPARE(session::exerciseKinds().size(), lines.size());
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        QCOMPARE(std::string(session::exerciseKinds()[i]->id()), lines[i]);
        const auto face = desktop::exerciseFace(lines[i]);
        QVERIFY2(face && (*face)->id() == lines[i], lines[i].c_str());
        const session_report::ExerciseReporter* reporter = session_report::exerciseReporter(lines[i]);
        QVERIFY2(reporter != nullptr && reporter->id() == lines[i], lines[i].c_str());
        const auto level = std::find_if(everyLevel().begin(), everyLevel().end(),
                                        [&](const auto& each) { return each.exercise == lines[i]; });
        QVERIFY2(level != everyLevel().end(), lines[i].c_str());
        session::SessionSetup setup;
        setup.level = *level;
        QVERIFY2(scene3d::makeFlatContent(desktop::sceneSetupOf(setup, 4.0, theme)), lines[i].c_str());
    }
    QVERIFY(session_report::exerciseReporter("knitting") == nullptr);
}

/// Every exercise has words for the marks that all recordings can have, the marks that an exercise adds are
/// called by its own words, and no two kinds share an id.
void TestExerciseFaces::everyMarkHasWords() {
    using namespace session::mark_kinds;
    const std::array shared{kTrialStarted, kMarked,  kTimedOut,     kTraceEnded, kContact, kOverLimit,
                            kPaused,       kRearmed, kForceStopped, kGuard,      kFault,   kEnded,
                            kCompleted,    kGrasped, kStageChanged, kReleased,   kSlipped, kDamaged,
                            kYielded,      kFailed,  kLimited};
    std::set<std::string_view> ids;
    for (const session::PlaybackMarkKind& kind : shared)
        QVERIFY2(ids.insert(kind.id).second, std::string(kind.id).c_str());
    const auto said = [](const session::PlaybackMarkKind& kind, std::string_view exercise) {
        session::PlaybackMark mark;
        mark.kind = kind;
        mark.value = 1.0;
        return session_report::whatHappened(mark, exercise, QLocale::c());
    };
    int own = 0;
    for (const session::ExerciseKind* kind : session::exerciseKinds()) {
        const session_report::ExerciseReporter& reporter = *session_report::exerciseReporter(kind->id());
        for (const session::PlaybackMarkKind& each : shared)
            QVERIFY2(!said(each, kind->id()).isEmpty(), std::string(each.id).c_str());
        for (const session_report::MarkWords& words : reporter.marks()) {
            ++own;
            const std::string which(words.kind.id);
            QVERIFY2(ids.insert(words.kind.id).second, which.c_str());
            QVERIFY2(!words.kind.icon.empty() && !said(words.kind, kind->id()).isEmpty(), which.c_str());
            QVERIFY2(said(words.kind, "knitting").isEmpty(), which.c_str());
        }
        for (const session::SceneEvent& event : kind->sceneEvents())
            QVERIFY2(!said(event.mark, kind->id()).isEmpty(), event.word);
        for (const session::MomentRule& rule : kind->momentRules())
            for (const session::PlaybackMarkKind& mark : rule.marks)
                QVERIFY2(!said(mark, kind->id()).isEmpty(), std::string(rule.metric).c_str());
        session::PlaybackMark stage;
        stage.kind = kStageChanged;
        const QString unknown = session_report::whatHappened(stage, kind->id(), QLocale::c());
        for (const session_report::StageWords& words : reporter.stages()) {
            stage.detail = std::string(words.stage);
            QVERIFY2(session_report::whatHappened(stage, kind->id(), QLocale::c()) != unknown,
                     stage.detail.c_str());
        }
    }
    QVERIFY(own >= 10);
}

/// A lifted object of a study that comes off the tool is no tissue and no penalty, wherever it is said; every
/// exercise that is trained acts on tissue.
void TestExerciseFaces::anObjectThatCameOffIsNoTissue() {
    session::PlaybackTrack yielded;
    yielded.marks.emplace_back().kind = session::mark_kinds::kYielded;
    yielded.marks.back().value = 12.0;
    for (const catalogue::ExerciseLevel& level : everyLevel()) {
        session::PlaybackTrack track = yielded;
        if (session::isOnlyInStudies(level.exercise))
            QVERIFY((**session::exerciseKind(level.exercise)).addMarks({}, nullptr, track));
        const session::PlaybackMark& mark = track.marks.front();
        const bool tissue = !session::isOnlyInStudies(level.exercise);
        QCOMPARE(session::isPenalty(mark.kind), tissue);
        const auto words = session::yieldWords(level.exercise);
        for (const QString& said : {session_report::markText(mark, level.exercise, QLocale::c()),
                                    faceOf(level).yieldedWords(level, false),
                                    QString::fromUtf8(words.data(), qsizetype(words.size()))})
            QVERIFY2(said.contains(tissue ? QStringLiteral("tissue gave way")
                                          : QStringLiteral("object came off the tool")),
                     qPrintable(said));
        if (!tissue)
            QCOMPARE(session_report::markText(mark, level.exercise, QLocale::c())
                         .replace(QChar(QChar::Nbsp), QLatin1Char(' ')),
                     QStringLiteral("The object came off the tool at 12.0 N"));
    }
    QVERIFY(session::yieldWords("knitting") == session::kTissueGaveWay);
}

/// The mechanisms on which it is done exist, and its tools fill whole hands.
void TestExerciseFaces::everyLevelHasAMechanismAndItsTools() {
    for (const catalogue::ExerciseLevel& level : everyLevel()) {
        const session::ExerciseKind& kind = **session::exerciseKind(level.exercise);
        QVERIFY2(!kind.mechanisms().empty(), level.exercise.c_str());
        for (const std::string_view mechanism : kind.mechanisms())
            QVERIFY2(devices::findKinematics(mechanism) != nullptr, std::string(mechanism).c_str());
        const session::LevelTools tools = kind.tools(level);
        QVERIFY2(tools.count >= 1 && tools.count <= core::kMaxTools, level.exercise.c_str());
        QVERIFY2(tools.perHand >= 1 && tools.count % tools.perHand == 0, level.exercise.c_str());
    }
}

/// No two commands of a level share a key, and each can be given at any time.
void TestExerciseFaces::everyKeyOfALevelDoesOneThing() {
    const desktop::Theme theme = desktop::Theme::load(desktop::ThemeName::light, 1.0).value();
    int freed = 0, commands = 0;
    for (const catalogue::ExerciseLevel& level : everyLevel()) {
        desktop::LiveSurroundings around{.theme = theme,
                                         .locale = QLocale::c(),
                                         .cues = session::cuesOf(level, true),
                                         .ownHand = true,
                                         .report = [](std::uint16_t) {},
                                         .freePointer = [&freed] { ++freed; }};
        const auto part = faceOf(level).livePart(level, std::move(around));
        const std::unique_ptr<desktop::InfoView> panel(part->makePanel());
        std::set<int> keys;
        for (const desktop::LiveCommand& command : part->commands()) {
            QVERIFY2(keys.insert(command.key).second, level.exercise.c_str());
            QVERIFY2(command.run, level.exercise.c_str());
            command.run();
            ++commands;
        }
    }
    QVERIFY(freed > 0 && commands > freed); // some level has both kinds
}

QTEST_MAIN(TestExerciseFaces)
#include "test_exercise_faces.moc"
