// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QtTest>
#include <utility>
#include <vector>

// Commands that touch people's data or files, before anybody is let in: refused with the right exit status,
// one line on stderr that names the place, nothing on stdout, and nothing left behind.
class TestCliRefusesPeople : public QObject {
    Q_OBJECT
private slots:
    void peopleAndFiles_data();
    void peopleAndFiles();

private:
    void row(const char* name, const QStringList& arguments, int exitCode, const QStringList& mentions,
             const QByteArray& input = {}) {
        QTest::newRow(name) << arguments << exitCode << mentions << input;
    }
    QString file(const QString& name, const QByteArray& content);
    void protectedCommands();
    void administrators();
    QTemporaryDir m_folder;
};

namespace {
QStringList words(const char* line) {
    return QString::fromUtf8(line).split(QLatin1Char(' '), Qt::SkipEmptyParts);
}
} // namespace

QString TestCliRefusesPeople::file(const QString& name, const QByteArray& content) {
    const QString path = m_folder.filePath(name);
    QFile out(path);
    if (!out.open(QIODevice::WriteOnly) || out.write(content) != content.size())
        qFatal("the test's own file could not be written");
    return path;
}

// Every command that needs a person, before and behind the door.
void TestCliRefusesPeople::protectedCommands() {
    const QString folder = m_folder.path();
    const QString garbage = file(
        "garbage.db",
        "this is no database, but it is longer than a header of one hundred bytes, so that it is read as "
        "one and found to be something else entirely");
    const QString empty = file("empty.db", "");
    const QString roster = file("roster.csv", "name,display_name,roles,password\n");
    const std::vector<std::pair<const char*, QStringList>> commands{
        {"user list", {"user", "list"}},
        {"user add", {"user", "add", "bob", "--role", "trainee"}},
        {"user disable", {"user", "disable", "bob"}},
        {"user enable", {"user", "enable", "bob"}},
        {"user role", {"user", "role", "bob", "--role", "trainee"}},
        {"user passwd", {"user", "passwd"}},
        {"user recovery-code", {"user", "recovery-code"}},
        {"user import-csv", {"user", "import-csv", roster}},
        {"user rename", {"user", "rename", "bob", "--name", "robert"}},
        {"person export", {"person", "export", "bob"}},
        {"person erase", {"person", "erase", "bob", "--reason", "x"}},
        {"migrate", {"migrate"}},
        {"backup", {"backup", folder + "/backup"}},
        {"export-site", {"export-site", folder + "/export"}}};
    for (const auto& [name, arguments] : commands) {
        row(qPrintable(QStringLiteral("%1 as nobody").arg(name)), arguments, 2, {name, "--as"});
        row(qPrintable(QStringLiteral("%1 without password").arg(name)), arguments + words("--as alice"), 2,
            {name, "CHIRON_PASSWORD"});
        row(qPrintable(QStringLiteral("%1 empty stdin").arg(name)),
            arguments + words("--as alice --password-stdin"), 2, {name, "first line"});
        row(qPrintable(QStringLiteral("%1 no database").arg(name)),
            arguments + QStringList{"--as", "alice", "--password-stdin", "--database", folder + "/none.db"},
            3, {name, "none.db", "no such file"}, "secret secret\n");
        row(qPrintable(QStringLiteral("%1 folder").arg(name)),
            arguments + QStringList{"--as", "alice", "--password-stdin", "--database", folder}, 3,
            {name, folder, "not a file"}, "secret secret\n");
        row(qPrintable(QStringLiteral("%1 garbage").arg(name)),
            arguments + QStringList{"--as", "alice", "--password-stdin", "--database", garbage}, 4,
            {name, "garbage.db"}, "secret secret\n");
        row(qPrintable(QStringLiteral("%1 empty file").arg(name)),
            arguments + QStringList{"--as", "alice", "--password-stdin", "--database", empty}, 4,
            {name, "empty.db"}, "secret secret\n");
    }
}

void TestCliRefusesPeople::administrators() {
    const QString folder = m_folder.path();
    const QString garbage = file("text.db", "a few words");
    row("init without a name", {"init"}, 2, {"--admin"});
    row("init without a password", {"init", "--admin", "alice"}, 2, {"CHIRON_PASSWORD"});
    const auto init = [&](const char* what, const QString& name, const QByteArray& password) {
        row(what, {"init", "--admin", name, "--password-stdin", "--database", folder + "/new.db"}, 3,
            {"init"}, password + "\n");
    };
    init("init short password", "alice", "short");
    init("init name as password", "alicealice", "alicealice");
    init("init monotonous password", "alice", "aaaaaaaaaaaaaaaa");
    init("init password not UTF-8", "alice", "\xff\xfe\xfd long enough");
    init("init name simulated", "simulated", "a good long password");
    init("init name with a comma", "a,b", "a good long password");
    init("init name with a space behind", "alice ", "a good long password");
    init("init name too long", QString(65, QLatin1Char('n')), "a good long password");
    init("init name with a bell", "alice\u0007", "a good long password");
    row("init into a file's folder",
        {"init", "--admin", "alice", "--password-stdin", "--database", garbage + "/site.db"}, 4, {"text.db"},
        "a good long password\n");
}

void TestCliRefusesPeople::peopleAndFiles_data() {
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QStringList>("mentions");
    QTest::addColumn<QByteArray>("input");
    protectedCommands();
    administrators();
    const QString folder = m_folder.path();
    row("user add without role", {"user", "add", "bob"}, 2, {"--role", "missing"});
    for (const char* role : {"boss", "trainee,", ",trainee", "trainee;admin", "Trainee", "trainee,boss", " "})
        row(qPrintable(QStringLiteral("role \"%1\"").arg(role)), {"user", "add", "bob", "--role", role}, 2,
            {"--role", QStringLiteral("\"%1\"").arg(role)});
    row("roster missing", {"user", "import-csv", folder + "/none.csv", "--as", "alice"}, 3,
        {"none.csv", "no such file"});
    row("roster is a folder", {"user", "import-csv", folder, "--as", "alice"}, 3, {folder, "folder"});
    row("erase without reason", {"person", "erase", "bob"}, 2, {"--reason"});
    row("recover without code", {"user", "recover", "alice"}, 2, {"CHIRON_RECOVERY_CODE"});
    row("recover without password", {"user", "recover", "alice", "--password-stdin"}, 2, {"second line"},
        "CODE\n");
    row("unknown exercise", {"exercise", "show", "juggling"}, 3, {"\"juggling\"", "sphere_apex"});
    row("no exercise", {"exercise", "show"}, 2, {"ID"});
    row("unknown language", {"exercise", "list", "--language", "xx"}, 2,
        {"--language", "\"xx\"", "en, de, el"});
    row("content missing", {"exercise", "list", "--content", folder + "/none"}, 3, {"none"});
    row("content of something else", {"exercise", "list", "--content", folder}, 3, {folder});
}

void TestCliRefusesPeople::peopleAndFiles() {
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QStringList, mentions);
    QFETCH(QByteArray, input);
    const QString fault = refusalFault(runCli(arguments, input), exitCode, mentions);
    QVERIFY2(fault.isEmpty(), qPrintable(fault));
    QVERIFY(!QFile::exists(m_folder.filePath("new.db")));
}

QTEST_GUILESS_MAIN(TestCliRefusesPeople)
#include "test_cli_refuses_people.moc"
