// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/source_text.h"

#include <QDir>
#include <QDirIterator>
#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

#include <algorithm>

using namespace chiron::test;

namespace {

const QString kRoot = QStringLiteral(CHIRON_SOURCE_DIR);

/// Empty where it cannot be read; `path` is relative to the root, as everywhere here.
QString contentOf(const QString& path) {
    QFile file(kRoot + u'/' + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QStringList foldersIn(const QString& path) {
    return QDir(kRoot + u'/' + path).entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name);
}

/// Every exercise that has a folder on a floor.
QStringList exercises() {
    QStringList ids = foldersIn(QStringLiteral("app/exercises")) +
                      foldersIn(QStringLiteral("curriculum/exercises")) +
                      foldersIn(QStringLiteral("modules/exercises"));
    ids.removeDuplicates();
    ids.sort();
    return ids;
}

/// The same for a pattern.
QString anyExercise() {
    return u'(' + exercises().join(u'|') + u')';
}

/// Where an exercise may be named: its own folders, and the lists with a line an exercise.
bool mayNameExercises(const QString& path) {
    static const QRegularExpression own(
        QStringLiteral("^(app|curriculum|modules)/exercises/%1/").arg(anyExercise()));
    static const QRegularExpression catalogue(QStringLiteral(
        "^((app|modules)/exercises/[a-z0-9_]+_catalogue|curriculum/catalogue/"
        "exercise_contents|curriculum/scoring/(metric|critical_error|own_column)_catalogue)\\.cpp$|"
        "^app/exercises/exercise_catalogue\\.h$"));
    return own.match(path).hasMatch() || catalogue.match(path).hasMatch();
}

/// The id of the task that studies present side by side. It is no exercise (no folder, no levels), but its
/// sessions are stored under this id, which shared code must not ask for either.
const QString kStudyTask = QStringLiteral("comparison");

/// The task's own files.
bool isOfTheStudyTask(const QString& path) {
    static const QRegularExpression own(
        QStringLiteral("/comparison_(kind|face|content|facts|reporter)\\.(h|cpp)$"));
    return own.match(path).hasMatch();
}

bool includesAnExercise(const SourceText& source) {
    static const QRegularExpression include(
        QStringLiteral("^[ \\t]*#[ \\t]*include[ \\t]*\"([^\"]*/)?exercises/%1/").arg(anyExercise()),
        QRegularExpression::MultilineOption);
    return include.match(source.code).hasMatch();
}

bool namesAnExercise(const SourceText& source, bool ofTheStudyTask) {
    static const QStringList ids = exercises();
    return std::any_of(source.literals.begin(), source.literals.end(),
                       [ofTheStudyTask](const QString& literal) {
                           return ids.contains(literal) || (!ofTheStudyTask && literal == kStudyTask);
                       });
}

/// "includes", "names", "both", or empty.
QString whatItDoes(const QString& text, const QString& path = {}) {
    const SourceText source = readSource(text);
    const bool includes = includesAnExercise(source), names = namesAnExercise(source, isOfTheStudyTask(path));
    if (includes && names)
        return QStringLiteral("both");
    return includes ? QStringLiteral("includes") : names ? QStringLiteral("names") : QString();
}

QStringList sourcesIn(const QString& folder) {
    QStringList files;
    for (QDirIterator it(kRoot + u'/' + folder, {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                         QDirIterator::Subdirectories);
         it.hasNext();)
        files << QDir(kRoot).relativeFilePath(it.next());
    return files;
}

QStringList productSources() {
    QStringList files;
    for (const char* floor : {"app", "modules", "curriculum", "database"})
        files << sourcesIn(QLatin1String(floor));
    return files;
}

/// A module that exercises add to, and the list that must then have a line for them.
struct Listed {
    const char* floor;
    const char* module;
    const char* list;
};
constexpr Listed kLists[]{
    {"app", "session", "app/exercises/session_catalogue.cpp"},
    {"app", "session_report", "app/exercises/report_catalogue.cpp"},
    {"app", "desktop", "app/exercises/face_catalogue.cpp"},
    {"app", "scene3d", "app/exercises/flat_catalogue.cpp"},
    {"app", "scene3d_plugin", "app/exercises/scene_catalogue.cpp"},
    {"curriculum", "catalogue", "curriculum/catalogue/exercise_contents.cpp"},
};

/// A function of a shared interface that has a default, which a single exercise overrides, and the property
/// that it names: of the device, the tissue, the recording or the study. Any other exercise may have it.
struct OfOne {
    const char* function;
    const char* names;
};
constexpr OfOne kOfOne[]{
    {"ExerciseFace::depthOfField", "the instrument has a camera with a lens"},
    {"ExerciseFace::resultsPart", "recordings of several sessions are judged together"},
    {"ExerciseKind::caps", "the device is asked for torques"},
    {"ExerciseKind::depthAt_m", "the instrument is in the body, and the recording tells how deep"},
    {"ExerciseKind::markSessions", "a study's condition is answered by marks"},
    {"ExerciseKind::sceneEvents", "the recording has event bits of the scene"},
    {"ExerciseReporter::toolName", "the tools are fingers of one hand and no instruments"},
    {"IFlatContent::paintWhole", "the camera is in the body"},
    {"LivePart::commands", "the pointer is held by the tool, so reports of the task have keys"},
    {"LivePart::guide", "the device is moved in a way of its own"},
    {"LivePart::lean_rad", "the tissue's surface has a normal from which a force can lean"},
    {"OwnTrace::way", "the recording has a line that the tip has to follow"},
    {"PlaybackLayer::lost", "something cannot be read from the recording"},
    {"PlaybackLayer::setUp", "the camera's settings can be changed while it is watched"},
};

/// "Interface::function" of each virtual function with a default that the header declares.
QStringList functionsWithDefault(const QString& code) {
    static const QRegularExpression part(
        QStringLiteral("\\bclass\\s+(\\w+)[^;{]*\\{|\\bvirtual\\b[^;{}=]*?[\\s&*>](\\w+)\\s*\\((?:[^()]|\\([^"
                       "()]*\\))*\\)([^;{]*)[;{]"));
    QStringList found;
    QString interface;
    for (auto it = part.globalMatch(code); it.hasNext();) {
        const auto each = it.next();
        if (!each.captured(1).isEmpty())
            interface = each.captured(1);
        else if (!each.captured(3).contains(u'='))
            found << interface + QStringLiteral("::") + each.captured(2);
    }
    return found;
}

/// The names of the functions that a file overrides.
QSet<QString> overriddenIn(const QString& code) {
    static const QRegularExpression function(
        QStringLiteral("(\\w+)\\s*\\((?:[^()]|\\([^()]*\\))*+\\)[^;{}()]*\\boverride\\b"));
    QSet<QString> found;
    if (code.contains(QLatin1String("override")))
        for (auto it = function.globalMatch(code); it.hasNext();)
            found.insert(it.next().captured(1));
    return found;
}

} // namespace

/// What belongs to one exercise stands in its folders (docs/exercises-as-slices.md).
class TestExerciseSlices : public QObject {
    Q_OBJECT
private slots:
    void codeIsReadWithoutComments();
    void whatAFileDoesIsFound();
    void nothingElseNamesAnExercise();
    void theSweepNamesNoExercise();
    void nothingElseNamesAMetricOfOneExercise();
    void noSceneOrOperatorKnowsAnotherExercise();
    void nothingBelowTheScenesKnowsAnExercise();
    void everyExerciseIsOnEachFloor();
    void everyFolderIsBuilt();
    void everyExerciseIsInTheLists();
    void everyHeaderHasANameOfItsOwn();
    void cuesAreAskedForInOnePlace();
    void functionsWithADefaultAreFound();
    void whatOneExerciseOverridesNamesAProperty();
};

void TestExerciseSlices::codeIsReadWithoutComments() {
    const SourceText source =
        readSource(QStringLiteral("a(\"x//\\\"y\"); // \"no\"\n"
                                  "/* \"no\" */b('\"', 1'000, \"z\") R\"q(raw \"in\")q\" end"));
    QCOMPARE(source.literals, (QStringList{"x//\\\"y", "z", "raw \"in\""}));
    QCOMPARE(source.code, QStringLiteral("a(\"x//\\\"y\"); \n b('\"', 1'000, \"z\") R\"\" end"));
    QCOMPARE(readSource(QStringLiteral("/* open")).code, QStringLiteral(" "));
    QCOMPARE(readSource(QStringLiteral("\"open\\")).literals, QStringList{"open\\"});
}

void TestExerciseSlices::whatAFileDoesIsFound() {
    const QString include = QStringLiteral("#include \"app/exercises/palpation/session/palpation_kind.h\"\n");
    QCOMPARE(whatItDoes(include), QStringLiteral("includes"));
    QCOMPARE(whatItDoes(QStringLiteral("#include \"modules/exercises/elastic_tube/operators/a.h\"\n")),
             QStringLiteral("includes"));
    QCOMPARE(whatItDoes(QStringLiteral("#include \"operators/laparoscopy/a.h\"\n")), QString());
    QCOMPARE(whatItDoes(QStringLiteral("// ") + include), QString());
    QCOMPARE(whatItDoes(QStringLiteral("id == \"palpation\"")), QStringLiteral("names"));
    QCOMPARE(whatItDoes(QStringLiteral("// \"palpation\"\n\"palpation_hits\" \"comparisons\"")), QString());
    // No folder may know an exercise, and the studies' task has its id in its own files alone.
    const QString laboratory = QStringLiteral("app/session/study/a.cpp"),
                  task = QStringLiteral("id == \"comparison\"");
    QCOMPARE(whatItDoes(include, laboratory), QStringLiteral("includes"));
    QCOMPARE(whatItDoes(task, laboratory), QStringLiteral("names"));
    QCOMPARE(whatItDoes(task, QStringLiteral("app/desktop/sessions/session_words.cpp")),
             QStringLiteral("names"));
    QCOMPARE(whatItDoes(task, QStringLiteral("app/session/study/comparison_kind.h")), QString());
    QCOMPARE(whatItDoes(include + QStringLiteral("QStringLiteral(\"sphere_apex\")")), QStringLiteral("both"));
    QVERIFY(mayNameExercises("modules/exercises/palpation/operators/a.cpp") &&
            mayNameExercises("app/exercises/flat_catalogue.cpp") &&
            mayNameExercises("app/exercises/exercise_catalogue.h"));
    QVERIFY(!mayNameExercises("modules/operators/laparoscopy/a.cpp") &&
            !mayNameExercises("app/session/exercise_kind.h"));
}

void TestExerciseSlices::nothingElseNamesAnExercise() {
    QStringList wrong;
    int read = 0;
    for (const QString& path : productSources()) {
        if (mayNameExercises(path))
            continue;
        ++read;
        if (const QString does = whatItDoes(contentOf(path), path); !does.isEmpty())
            wrong << QStringLiteral("%1: %2: what belongs to one exercise stands in its folder "
                                    "(includes: a header from there; names: its id)")
                         .arg(path, does);
    }
    QVERIFY(read > 500);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

/// What the sweep must know of one exercise stands in tests/exercises/<id>/sweep_facts.cpp.
void TestExerciseSlices::theSweepNamesNoExercise() {
    QStringList wrong;
    const QStringList files = sourcesIn(QStringLiteral("tests/sweep"));
    for (const QString& path : files)
        if (const QString does = whatItDoes(contentOf(path), path); !does.isEmpty())
            wrong << QStringLiteral("%1: %2").arg(path, does);
    QVERIFY(files.contains(QStringLiteral("tests/sweep/level_sweep.cpp")));
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

/// What belongs to one metric of one exercise (a limit, a benchmark, where it was worst) stands in the
/// metric's row or in the exercise's folder. Ids of one word are also words for other things.
void TestExerciseSlices::nothingElseNamesAMetricOfOneExercise() {
    static const QRegularExpression row(QStringLiteral("\\.id = \"([a-z0-9]+_[a-z0-9_]+)\""));
    QStringList metrics, wrong;
    for (const QString& id : exercises())
        for (QDirIterator it(kRoot + QStringLiteral("/curriculum/exercises/%1/scoring").arg(id),
                             {QStringLiteral("*.cpp")}, QDir::Files);
             it.hasNext();)
            for (auto found = row.globalMatch(contentOf(QDir(kRoot).relativeFilePath(it.next())));
                 found.hasNext();)
                metrics << found.next().captured(1);
    QVERIFY(metrics.size() > 40 && metrics.contains(QStringLiteral("apex_error_mean")));
    for (const QString& path : productSources()) {
        if (!path.startsWith(QStringLiteral("app/")) || mayNameExercises(path))
            continue;
        for (const QString& literal : readSource(contentOf(path)).literals)
            if (metrics.contains(literal))
                wrong << QStringLiteral("%1: names the metric %2").arg(path, literal);
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

/// On the floor of the modules an exercise stands for itself: what it shares with another is in a folder
/// named after what it is.
void TestExerciseSlices::noSceneOrOperatorKnowsAnotherExercise() {
    static const QRegularExpression own(QStringLiteral("^modules/exercises/([a-z0-9_]+)/"));
    static const QRegularExpression include(
        QStringLiteral("#[ \\t]*include[ \\t]*\"modules/exercises/([a-z0-9_]+)/"));
    QStringList wrong;
    int read = 0;
    for (const QString& path : productSources()) {
        const auto of = own.match(path);
        if (!of.hasMatch())
            continue;
        ++read;
        for (auto found = include.globalMatch(readSource(contentOf(path)).code); found.hasNext();)
            if (const QString other = found.next().captured(1); other != of.captured(1))
                wrong << QStringLiteral("%1: includes a header of %2").arg(path, other);
    }
    QVERIFY(read > 100);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

/// What every session runs through knows neither an exercise nor a family of exercises, and says nothing of
/// one.
void TestExerciseSlices::nothingBelowTheScenesKnowsAnExercise() {
    static const QRegularExpression below(
        QStringLiteral("^modules/(core|realtime|devices|mechanisms|haptics|recording)/"));
    const QRegularExpression known(
        QStringLiteral("#[ \\t]*include[ \\t]*\"cues/|exercises/%1/").arg(anyExercise()));
    QStringList wrong;
    int read = 0;
    for (const QString& path : productSources()) {
        if (!path.contains(below))
            continue;
        ++read;
        if (const auto found = known.match(contentOf(path)); found.hasMatch())
            wrong << QStringLiteral("%1: %2").arg(path, found.captured());
    }
    QVERIFY(read > 100);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

void TestExerciseSlices::everyExerciseIsOnEachFloor() {
    QVERIFY(exercises().size() > 1);
    QCOMPARE(foldersIn(QStringLiteral("app/exercises")), exercises());
    QCOMPARE(foldersIn(QStringLiteral("curriculum/exercises")), exercises());
    QCOMPARE(foldersIn(QStringLiteral("modules/exercises")), exercises());
}

void TestExerciseSlices::everyFolderIsBuilt() {
    QStringList wrong;
    for (const char* floor : {"app", "curriculum", "modules"}) {
        const QString folder = QLatin1String(floor) + QStringLiteral("/exercises");
        const QString all = contentOf(folder + QStringLiteral("/CMakeLists.txt"));
        for (const QString& id : foldersIn(folder)) {
            if (!all.contains(QStringLiteral("add_subdirectory(%1)").arg(id)))
                wrong << QStringLiteral("%1/CMakeLists.txt: no add_subdirectory(%2)").arg(folder, id);
            const QString own = folder + u'/' + id;
            const QString parts = contentOf(own + QStringLiteral("/CMakeLists.txt"));
            for (const QString& part : foldersIn(own))
                if (!parts.contains(QStringLiteral(" IN %1\n").arg(part)) &&
                    !parts.contains(QStringLiteral(" IN %1)").arg(part)) &&
                    !parts.contains(QStringLiteral("add_subdirectory(%1)").arg(part)))
                    wrong << QStringLiteral("%1/CMakeLists.txt: no chiron_part(… IN %2").arg(own, part);
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

void TestExerciseSlices::everyExerciseIsInTheLists() {
    QStringList wrong;
    for (const Listed& each : kLists) {
        const QString folder = QLatin1String(each.floor) + QStringLiteral("/exercises");
        const QString code = readSource(contentOf(QLatin1String(each.list))).code;
        for (const QString& id : foldersIn(folder)) {
            const QString parts = contentOf(folder + u'/' + id + QStringLiteral("/CMakeLists.txt"));
            const bool adds =
                parts.contains(QStringLiteral("chiron_part(%1 IN ").arg(QLatin1String(each.module)));
            const bool listed = code.contains(QStringLiteral("#include \"%1/%2/").arg(folder, id));
            if (adds != listed)
                wrong << QStringLiteral("%1: %2: %3")
                             .arg(QLatin1String(each.list), id,
                                  adds ? QStringLiteral("not listed")
                                       : QStringLiteral("listed, but adds nothing to the module"));
        }
    }
    for (const QString& id : exercises()) {
        if (!contentOf(QStringLiteral("app/exercises/%1/CMakeLists.txt").arg(id))
                 .contains(QLatin1String("(session IN ")))
            wrong << QStringLiteral("app/exercises/%1: cannot be run").arg(id);
        if (!contentOf(QStringLiteral("curriculum/exercises/%1/CMakeLists.txt").arg(id))
                 .contains(QLatin1String("(catalogue IN ")))
            wrong << QStringLiteral("curriculum/exercises/%1: its levels cannot be read").arg(id);
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

/// Whoever reads the name of a header knows which one it is, whatever folder it was found in.
void TestExerciseSlices::everyHeaderHasANameOfItsOwn() {
    QHash<QString, QString> found;
    QStringList wrong;
    for (const QString& path : productSources()) {
        if (!path.endsWith(QLatin1String(".h")))
            continue;
        QString& first = found[path.section(u'/', -1)];
        if (first.isEmpty())
            first = path;
        else
            wrong << QStringLiteral("%1 and %2").arg(first, path);
    }
    QVERIFY(found.size() > 500);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

/// Whether a level has a cue is asked by simulation::hasCue, and not by a search of one's own.
void TestExerciseSlices::cuesAreAskedForInOnePlace() {
    static const QRegularExpression search(
        QStringLiteral("std::(find|count|any_of)\\([^;]*\\bcues(\\.|->)begin\\(\\)[^;]*(cue|word|\")"));
    const QString own =
        QStringLiteral("bool f() { return std::find(l.cues.begin(), l.cues.end(), \"object\") != e; }");
    QVERIFY(readSource(own).code.contains(search));
    QStringList wrong;
    for (const QString& path : productSources())
        if (path != QLatin1String("modules/simulation/scene_parameters.h") &&
            readSource(contentOf(path)).code.contains(search))
            wrong << path;
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

void TestExerciseSlices::functionsWithADefaultAreFound() {
    const QString code = QStringLiteral("class A {\n virtual ~A() = default;\n virtual int a() const = 0;\n"
                                        " virtual std::vector<int> b(const P& p = {}) const { return {}; }\n"
                                        " virtual F* c(int (*f)(int));\n int d();\n};\n"
                                        "class B final : public A {\n virtual void e() {}\n"
                                        " std::vector<int> b(const P&) const override;\n};\n");
    QCOMPARE(functionsWithDefault(code),
             (QStringList{QStringLiteral("A::b"), QStringLiteral("A::c"), QStringLiteral("B::e")}));
    QCOMPARE(overriddenIn(code), QSet<QString>{QStringLiteral("b")});
}

/// A default that only one exercise replaces is that exercise's special case, unless it names something that
/// any exercise may have.
void TestExerciseSlices::whatOneExerciseOverridesNamesAProperty() {
    static const QRegularExpression own(QStringLiteral("/exercises/([a-z0-9_]+)/"));
    QHash<QString, QString> shared;                    // path → code
    QHash<QString, QStringList> overridesShared;       // function → paths
    QHash<QString, QSet<QString>> overridesOfExercise; // function → exercises
    for (const QString& path : productSources()) {
        const QString code = readSource(contentOf(path)).code;
        const auto exercise = own.match(path);
        if (!exercise.hasMatch())
            shared[path] = code;
        for (const QString& function : overriddenIn(code))
            if (exercise.hasMatch())
                overridesOfExercise[function].insert(exercise.captured(1));
            else
                overridesShared[function] << path;
    }
    QStringList found;
    for (auto header = shared.cbegin(); header != shared.cend(); ++header) {
        if (!header.key().endsWith(QLatin1String(".h")))
            continue;
        for (const QString& each : functionsWithDefault(header.value())) {
            const QString interface = each.section(QStringLiteral("::"), 0, 0),
                          function = each.section(QStringLiteral("::"), 1);
            if (overridesOfExercise.value(function).size() != 1)
                continue;
            // Another interface may have a function of the same name.
            const QRegularExpression derived(QStringLiteral("\\bpublic\\s+(\\w+::)*%1\\b").arg(interface));
            const QStringList paths = overridesShared.value(function);
            if (std::none_of(paths.begin(), paths.end(),
                             [&](const QString& path) { return shared[path].contains(derived); }))
                found << each;
        }
    }
    found.sort();
    QStringList known;
    for (const OfOne& each : kOfOne)
        known << QLatin1String(each.function);
    QCOMPARE(found.join(u'\n'), known.join(u'\n'));
}

QTEST_GUILESS_MAIN(TestExerciseSlices)
#include "test_exercise_slices.moc"
