// SPDX-License-Identifier: GPL-3.0-or-later
// Adding a driver touches its own folder and one line of the catalogue: no shared source may include one or
// name one by its id, its word in stored plans, or its kinematics. The words are those of the catalogue
// itself.
#include "devices/driver_catalogue.h"
#include "support/source_text.h"

#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QSet>
#include <QtTest>

using namespace chiron;
using test::SourceText;

namespace {

const QString kDrivers = QStringLiteral("modules/devices/drivers/");
const QString kCatalogue = QStringLiteral("modules/devices/driver_catalogue.cpp");

/// A shared source that names a driver's mechanism all the same, how often, and why.
struct Exception {
    const char* path;
    const char* word;
    int times;
    const char* why;
};
constexpr Exception kExceptions[]{
    {"modules/devices/driver.h", "gimbal_hprd", 1,
     "a request can give this mechanism's true parameters (DriverRequest::plant), so that it can be "
     "measured"},
    {"app/exercises/palpation/session/palpation_kind.h", "fingertip_arm", 1,
     "an exercise says in its own folder on which mechanisms its operators know how to work"},
    {"app/exercises/urethra_insertion/session/urethra_insertion_kind.h", "five_bar_spherical", 1,
     "an exercise says in its own folder on which mechanisms its operators know how to work"},
    {"app/cli/device_check.cpp", "fingertip_arm", 1,
     "the output of a verification names the mechanism that was verified"},
    {"app/cli/commands/device_commands.cpp", "fingertip_arm", 2,
     "a verification is the protocol of one published mechanism; the option chooses between the two there "
     "are"},
    {"app/cli/commands/device_commands.cpp", "gimbal_hprd", 4,
     "a verification is the protocol of one published mechanism; the option chooses between the two there "
     "are"},
};
/// The list may only become shorter: what is new asks the catalogue.
static_assert(std::size(kExceptions) <= 7);

QString text(std::string_view view) {
    return QString::fromUtf8(view.data(), static_cast<qsizetype>(view.size()));
}

/// The catalogue's words. One of several parts (gimbal_hprd) has no other meaning; an ordinary one (trace)
/// has many.
struct Words {
    QStringList ofParts, ordinary;

    void add(std::string_view word) {
        QStringList& list = word.find('_') != std::string_view::npos ? ofParts : ordinary;
        if (!list.contains(text(word)))
            list << text(word);
    }
};

Words catalogueWords() {
    Words words;
    for (const devices::Driver* driver : devices::driverCatalogue()) {
        words.add(driver->id);
        words.add(driver->planWord);
        for (const devices::KinematicsEntry& kinematics : driver->kinematics)
            words.add(kinematics.id);
    }
    return words;
}

QStringList headersOfDrivers() {
    QStringList names;
    for (QDirIterator it(QStringLiteral(CHIRON_SOURCE_DIR "/") + kDrivers, {QStringLiteral("*.h")},
                         QDir::Files, QDirIterator::Subdirectories);
         it.hasNext();)
        names << QFileInfo(it.next()).fileName();
    return names;
}

/// Headers of drivers that a source includes, however their path is written.
QStringList includesOf(const SourceText& source, const QStringList& headers) {
    static const QRegularExpression include(
        QStringLiteral("^[ \\t]*#[ \\t]*include[ \\t]*[\"<]([^\">\\n]+)[\">]"),
        QRegularExpression::MultilineOption);
    QStringList found;
    for (auto it = include.globalMatch(source.code); it.hasNext();) {
        const QString path = it.next().captured(1);
        if (path.startsWith(QStringLiteral("drivers/")) || path.contains(QStringLiteral("/drivers/")) ||
            headers.contains(path.section(u'/', -1)))
            found << path;
    }
    return found;
}

/// The words of drivers in a source's string literals, as often as they are there. A word of several parts
/// counts wherever it stands; an ordinary one where a literal is nothing else, in a statement that speaks of
/// drivers, kinematics or stored plans.
QStringList wordsOf(const SourceText& source, const Words& words) {
    QStringList found;
    const QRegularExpression parts(
        QStringLiteral("(?<![A-Za-z0-9_])(%1)(?![A-Za-z0-9_])").arg(words.ofParts.join(u'|')));
    for (const QString& literal : source.literals)
        for (auto it = parts.globalMatch(literal); it.hasNext();)
            found << it.next().captured(1);
    static const QRegularExpression ends(QStringLiteral("[;{}]"));
    static const QRegularExpression speaksOfThem(QStringLiteral("driver|kinematics|plan_?word"),
                                                 QRegularExpression::CaseInsensitiveOption);
    const QRegularExpression word(QStringLiteral("\"(%1)\"").arg(words.ordinary.join(u'|')));
    for (const QString& statement : source.code.split(ends))
        if (speaksOfThem.match(statement).hasMatch())
            for (auto it = word.globalMatch(statement); it.hasNext();)
                found << it.next().captured(1);
    return found;
}

QStringList sharedSources() {
    QStringList files;
    const QDir root(QStringLiteral(CHIRON_SOURCE_DIR));
    for (const char* floor : {"app", "curriculum", "database", "modules"})
        for (QDirIterator it(root.filePath(QLatin1String(floor)),
                             {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                             QDirIterator::Subdirectories);
             it.hasNext();)
            if (const QString path = root.relativeFilePath(it.next());
                !path.startsWith(kDrivers) && path != kCatalogue)
                files << path;
    files.sort();
    return files;
}

SourceText sourceAt(const QString& path) {
    QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/") + path);
    return test::readSource(file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString());
}

} // namespace

class TestDriverTree : public QObject {
    Q_OBJECT

private slots:
    void theCatalogueIsRead();
    void everySpellingIsFound();
    void noSharedSourceIncludesADriver();
    void noSharedSourceNamesADriver();

private:
    const Words m_words = catalogueWords();
    const QStringList m_headers = headersOfDrivers();
};

void TestDriverTree::theCatalogueIsRead() {
    for (const char* word : {"keyboard_mouse", "gimbal_hprd"})
        QVERIFY2(m_words.ofParts.contains(QLatin1String(word)), word);
    for (const char* word : {"simulated", "replay", "trace", "cartesian"})
        QVERIFY2(m_words.ordinary.contains(QLatin1String(word)), word);
    QVERIFY(m_headers.contains(QStringLiteral("replay_driver.h")));
    QVERIFY(!sourceAt(kCatalogue).code.isEmpty());
    QVERIFY(includesOf(sourceAt(kCatalogue), m_headers).size() >=
            static_cast<qsizetype>(devices::driverCatalogue().size()));
}

void TestDriverTree::everySpellingIsFound() {
    const auto includes = [this](const char* code) {
        return includesOf(test::readSource(QString::fromUtf8(code)), m_headers).size();
    };
    QCOMPARE(includes("#include \"devices/drivers/replay/replay_driver.h\"\n"), 1);
    QCOMPARE(includes("#include \"modules/devices/drivers/new_one/any.h\"\n"), 1);
    QCOMPARE(includes("  # include <drivers/replay/replay_device.h>\n"), 1);
    QCOMPARE(includes("#include \"replay_driver.h\"\n#include \"../keyboard_mouse/motion_intake.h\"\n"), 2);
    QCOMPARE(includes("#include \"devices/driver.h\"\n// #include \"replay_driver.h\"\n"), 0);

    const auto words = [this](const char* code) {
        return wordsOf(test::readSource(QString::fromUtf8(code)), m_words).join(u' ');
    };
    QCOMPARE(words("if (id == \"keyboard_mouse\") open(u\"gimbal_hprd\");"),
             QStringLiteral("keyboard_mouse gimbal_hprd"));
    QCOMPARE(words("help(\"fingertip_arm or\\n\" R\"(five_bar_spherical)\");"),
             QStringLiteral("fingertip_arm five_bar_spherical"));
    QCOMPARE(
        words("switch (tag) {} auto d = findDriver(\"replay\"); d.planWord !=\n QLatin1String(\"mouse\");"),
        QStringLiteral("replay mouse"));
    QCOMPARE(words("return descriptor.kinematics == QStringLiteral(\"cartesian\");"),
             QStringLiteral("cartesian"));
    QCOMPARE(words("// \"gimbal_hprd\"\nopen(\"my_gimbal_hprd\"); json[\"trace\"] = 1; driver(\"a trace\");"),
             QString());
}

void TestDriverTree::noSharedSourceIncludesADriver() {
    QStringList wrong;
    int read = 0;
    for (const QString& path : sharedSources()) {
        ++read;
        for (const QString& included : includesOf(sourceAt(path), m_headers))
            wrong << QStringLiteral("%1 includes %2").arg(path, included);
    }
    QVERIFY(read > 500);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

void TestDriverTree::noSharedSourceNamesADriver() {
    QMap<QString, int> found;
    for (const QString& path : sharedSources())
        for (const QString& word : wordsOf(sourceAt(path), m_words))
            ++found[path + QStringLiteral(": \"%1\"").arg(word)];
    QStringList wrong;
    for (const Exception& each : kExceptions) {
        const QString what =
            QStringLiteral("%1: \"%2\"").arg(QLatin1String(each.path), QLatin1String(each.word));
        if (const int times = found.take(what); times != each.times)
            wrong << QStringLiteral(
                         "%1 %2 times, not %3 as excepted because %4; an exception may only shrink")
                         .arg(what)
                         .arg(times)
                         .arg(each.times)
                         .arg(QLatin1String(each.why));
    }
    for (auto it = found.cbegin(); it != found.cend(); ++it)
        wrong << it.key() + QStringLiteral(": names a driver or its kinematics; ask the catalogue");
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

QTEST_GUILESS_MAIN(TestDriverTree)
#include "test_driver_tree.moc"
