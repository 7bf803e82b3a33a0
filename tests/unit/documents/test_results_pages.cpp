// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of measured results say what made them, and scripts/results makes a page anew.
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QtTest>

namespace {

struct Ran {
    int status = -1;
    QString out, error;
};

Ran results(const QStringList& arguments) {
    constexpr int kLimit_ms = 120'000;
    QProcess script;
    script.setWorkingDirectory(QStringLiteral(CHIRON_SOURCE_DIR));
    script.start(QStringLiteral(CHIRON_SOURCE_DIR "/scripts/results"), arguments);
    Ran ran;
    if (script.waitForFinished(kLimit_ms) && script.exitStatus() == QProcess::NormalExit)
        ran.status = script.exitCode();
    ran.out = QString::fromUtf8(script.readAllStandardOutput());
    ran.error = QString::fromUtf8(script.readAllStandardError());
    return ran;
}

/// A folder with one page, "x".
class Pages {
public:
    explicit Pages(const QString& text) {
        QFile file(page());
        if (!m_folder.isValid() || !file.open(QIODevice::WriteOnly))
            qFatal("no page could be written");
        file.write(text.toUtf8());
    }
    QString text() const {
        QFile file(page());
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }
    Ran run(const QStringList& arguments) const {
        return results(QStringList{QStringLiteral("--pages"), m_folder.path()} + arguments);
    }

private:
    QString page() const { return m_folder.filePath(QStringLiteral("x.md")); }
    QTemporaryDir m_folder;
};

const QString kMeasures = QStringLiteral("<!-- measures: scripts -->\n");

QString block(const QString& command, const QString& inside) {
    return QStringLiteral("<!-- made by: %1 -->\n%2\n<!-- end -->\n").arg(command, inside);
}

QString goodBlock(const QString& command) {
    return block(
        command,
        QStringLiteral("Printed by `%1` on 2026-11-20 (commit 1015e761; a machine).\n\nold").arg(command));
}

} // namespace

class TestResultsPages : public QObject {
    Q_OBJECT
private slots:
    void everyPageSaysWhatMadeIt();
    void whatAPageLeavesOutIsNamed_data();
    void whatAPageLeavesOutIsNamed();
    void aPageIsMadeAnew();
    void oneBlockIsMadeAnew();
    void aRunThatFailsLeavesThePage_data();
    void aRunThatFailsLeavesThePage();
};

void TestResultsPages::everyPageSaysWhatMadeIt() {
    const Ran ran = results({QStringLiteral("--check")});
    QVERIFY2(ran.status == 0, qPrintable(ran.error));
    static const QRegularExpression pages(QStringLiteral("^results: ([0-9]+) pages"));
    QVERIFY2(pages.match(ran.out).captured(1).toInt() > 20, qPrintable(ran.out));
}

void TestResultsPages::whatAPageLeavesOutIsNamed_data() {
    QTest::addColumn<QString>("page");
    QTest::addColumn<QString>("said");
    const QString command = QStringLiteral("scripts/results --help");
    const QString good = goodBlock(command);
    const auto row = [](const char* name, const QString& page, const char* said) {
        QTest::newRow(name) << page << QString::fromLatin1(said);
    };
    row("nothing", kMeasures + good, "");
    row("by hand",
        kMeasures +
            QString(good).replace(QLatin1String("Printed by"), QLatin1String("Condensed by hand from what")),
        "");
    row("no block", kMeasures + QStringLiteral("| a |\n|---|\n| 1 |\n"), "at least one block");
    row("no end", kMeasures + good + QString(good).remove(QLatin1String("<!-- end -->\n")),
        "each with both of its lines");
    row("no date", kMeasures + block(command, QStringLiteral("old")), "expected the block to begin");
    row("no commit", kMeasures + QString(good).remove(QLatin1String("commit 1015e761; ")),
        "expected the block to begin");
    row("another command",
        kMeasures + QString(good).replace(QLatin1String("by `scripts/results --help`"),
                                          QLatin1String("by `scripts/results --list`")),
        "expected the block to begin");
    row("no such program", kMeasures + goodBlock(QStringLiteral("apex_table 20 2")),
        "no word names a program of the tree");
    row("one of two", kMeasures + goodBlock(QStringLiteral("test_{results,nothings}")), "`test_nothings`");
    row("nothing measured", good, "<!-- measures: FOLDERS -->");
    row("measures what is gone", QStringLiteral("<!-- measures: modules/gone -->\n") + good,
        "modules/gone: there is no such folder");
}

void TestResultsPages::whatAPageLeavesOutIsNamed() {
    QFETCH(QString, page);
    QFETCH(QString, said);
    const Ran ran = Pages(page).run({QStringLiteral("--check")});
    QCOMPARE(ran.status, said.isEmpty() ? 0 : 1);
    QVERIFY2(ran.error.contains(said), qPrintable(ran.error));
    QVERIFY2(said.isEmpty() || ran.error.contains(QLatin1String("x.md: ")), qPrintable(ran.error));
}

/// Tables as they are printed, other words in a fence; what people wrote stays.
void TestResultsPages::aPageIsMadeAnew() {
    const QString two = QStringLiteral("scripts/results --{help,check}");
    const Pages pages(QStringLiteral("# x\n") + kMeasures + QStringLiteral("before\n") +
                      goodBlock(QStringLiteral("scripts/results --list")) + QStringLiteral("between\n") +
                      goodBlock(two) + QStringLiteral("after\n"));
    const Ran ran = pages.run({QStringLiteral("x")});
    if (ran.error.contains(QLatin1String("git does not know the commit")))
        QSKIP("not a checkout of the repository");
    QVERIFY2(ran.status == 0, qPrintable(ran.error));
    const QString text = pages.text();
    QVERIFY2(
        text.startsWith(QStringLiteral("# x\n") + kMeasures + QStringLiteral("before\n<!-- made by: ")) &&
            text.contains(QLatin1String("<!-- end -->\nbetween\n<!-- made by: ")) &&
            text.endsWith(QLatin1String("<!-- end -->\nafter\n")) && !text.contains(QLatin1String("\nold\n")),
        qPrintable(text));
    static const QRegularExpression table(
        QStringLiteral(
            "^Printed by `scripts/results --list` on [0-9-]{10} \\(commit [0-9a-f]{8,}[^\n]*\\)\\.\n\n"
            "\\| page \\|"),
        QRegularExpression::MultilineOption);
    QVERIFY2(table.match(text).hasMatch(), qPrintable(text));
    static const QRegularExpression fences(
        QStringLiteral("`scripts/results --help`:\n\n```\nusage: .*```\n\n`scripts/results --check`:\n\n```\n"
                       "results: [0-9]+ pages, [^\n]*\n```\n<!-- end -->"),
        QRegularExpression::DotMatchesEverythingOption);
    QVERIFY2(fences.match(text).hasMatch(), qPrintable(text));
    QCOMPARE(pages.run({QStringLiteral("--check")}).status, 0);
}

void TestResultsPages::oneBlockIsMadeAnew() {
    const QString first = goodBlock(QStringLiteral("scripts/results --list"));
    const Pages pages(kMeasures + first + goodBlock(QStringLiteral("scripts/results --check")));
    const Ran ran = pages.run({QStringLiteral("x:2")});
    if (ran.error.contains(QLatin1String("git does not know the commit")))
        QSKIP("not a checkout of the repository");
    QVERIFY2(ran.status == 0, qPrintable(ran.error));
    QVERIFY2(pages.text().startsWith(kMeasures + first) && pages.text().count(QLatin1String("\nold\n")) == 1,
             qPrintable(pages.text()));
}

void TestResultsPages::aRunThatFailsLeavesThePage_data() {
    QTest::addColumn<QString>("command");
    QTest::addColumn<QString>("asked");
    QTest::newRow("a wrong option") << QStringLiteral("scripts/results --nothing") << QStringLiteral("x");
    QTest::newRow("the second fails")
        << QStringLiteral("scripts/results --{help,nothing}") << QStringLiteral("x");
    QTest::newRow("no program") << QStringLiteral("ls -l") << QStringLiteral("x");
    QTest::newRow("no such page") << QStringLiteral("scripts/results --help") << QStringLiteral("y");
    QTest::newRow("no such block") << QStringLiteral("scripts/results --help") << QStringLiteral("x:2");
}

void TestResultsPages::aRunThatFailsLeavesThePage() {
    QFETCH(QString, command);
    QFETCH(QString, asked);
    const QString before = kMeasures + goodBlock(command);
    const Pages pages(before);
    const Ran ran = pages.run({asked});
    QVERIFY2(ran.status > 0 && ran.error.contains(QLatin1String("results: ")), qPrintable(ran.error));
    QCOMPARE(pages.text(), before);
}

QTEST_GUILESS_MAIN(TestResultsPages)
#include "test_results_pages.moc"
