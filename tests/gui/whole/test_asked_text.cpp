// SPDX-License-Identifier: GPL-3.0-or-later
// What the desktop tells of itself it tells wherever it is called: in a terminal without a display, too.
#include "support/patience.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>
#include <QtTest>

using chiron::tests::kPatience_ms;

namespace {

struct Told {
    bool ended = false; ///< by itself, and not by a signal
    int status = -1;
    QString out, errors;
};

/// The program where no window can be opened, with a home of its own.
Told runWithoutDisplay(const QStringList& arguments, const QString& home) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "XDG_DATA_HOME", "XDG_CONFIG_HOME",
                             "XDG_CACHE_HOME", "XDG_RUNTIME_DIR"})
        environment.remove(QString::fromLatin1(name));
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("xcb"));
    environment.insert(QStringLiteral("HOME"), home);
    QProcess process;
    process.setProcessEnvironment(environment);
    process.start(QStringLiteral(CHIRON_BINARY_DIR "/app/desktop/chiron"), arguments);
    Told told;
    const bool finished = process.waitForFinished(kPatience_ms);
    if (!finished) {
        process.kill();
        process.waitForFinished();
    }
    told.ended = finished && process.exitStatus() == QProcess::NormalExit;
    told.status = process.exitCode();
    told.out = QString::fromUtf8(process.readAllStandardOutput());
    told.errors = QString::fromUtf8(process.readAllStandardError());
    return told;
}

} // namespace

class TestAskedText : public QObject {
    Q_OBJECT
private slots:
    void textNeedsNoDisplay_data();
    void textNeedsNoDisplay();
    void aWindowNeedsADisplay();
};

void TestAskedText::textNeedsNoDisplay_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QStringList>("words");
    const QStringList options{QStringLiteral("--database"), QStringLiteral("--settings"),
                              QStringLiteral("--study"), QStringLiteral("--person")};
    const QStringList version{QStringLiteral("chiron ")};
    QTest::newRow("--help") << QStringList{QStringLiteral("--help")} << options;
    QTest::newRow("-h") << QStringList{QStringLiteral("-h")} << options;
    QTest::newRow("--help-all") << QStringList{QStringLiteral("--help-all")} << options;
    QTest::newRow("--version") << QStringList{QStringLiteral("--version")} << version;
    QTest::newRow("-v") << QStringList{QStringLiteral("-v")} << version;
    QTest::newRow("after another option")
        << QStringList{QStringLiteral("--database"), QStringLiteral("nowhere.db"),
                       QStringLiteral("--version")}
        << version;
}

void TestAskedText::textNeedsNoDisplay() {
    QFETCH(QStringList, arguments);
    QFETCH(QStringList, words);
    const QTemporaryDir home;
    const Told told = runWithoutDisplay(arguments, home.path());
    QVERIFY2(told.ended, qPrintable(told.errors));
    QCOMPARE(told.status, 0);
    for (const QString& word : words)
        QVERIFY2(told.out.contains(word), qPrintable(word + QStringLiteral(" in:\n") + told.out));
    QCOMPARE(QDir(home.path()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot),
             QStringList()); // nothing is begun
}

/// Else the test above would show nothing: without one of those options there is no way to start here.
void TestAskedText::aWindowNeedsADisplay() {
    const QTemporaryDir home;
    const Told told = runWithoutDisplay(
        {QStringLiteral("--database"), home.filePath(QStringLiteral("site.db"))}, home.path());
    QVERIFY(!told.ended || told.status != 0);
    QVERIFY2(told.errors.contains(QStringLiteral("display")), qPrintable(told.errors));
}

QTEST_GUILESS_MAIN(TestAskedText)
#include "test_asked_text.moc"
