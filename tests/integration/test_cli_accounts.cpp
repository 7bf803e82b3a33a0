// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli_process.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLockFile>
#include <QtTest>
#include <algorithm>

// A site's people from the first administrator to the last, as a technician scripts it.
class TestCliAccounts : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void peopleComeAndChange();
    void theSiteHasAName();
    void rolesDecide();
    void passwordsChange();
    void aForgottenPasswordIsRecovered();
    void aSecondAdministratorMakesARecoveryCode();
    void rosterIsAllOrNothing();
    void rosterOfASpreadsheet();
    void renaming();
    void anOldRosterKnowsWhoWasRenamed();
    void aWrongPasswordIsRefused();
    void theWritersLockIsNamed();

private:
    CliRun as(const QString& name, const QString& password, const QStringList& arguments,
              const QString& newPassword = {});
    QJsonObject object(const CliRun& run);
    QString file(const QString& name, const QByteArray& content);

    QTemporaryDir m_folder;
    QString m_database;
    QString m_recoveryCode; ///< of alice
};

namespace {
const QString kAlice = QStringLiteral("correct horse battery");
const QString kBob = QStringLiteral("staple and stable 9");
} // namespace

CliRun TestCliAccounts::as(const QString& name, const QString& password, const QStringList& arguments,
                           const QString& newPassword) {
    QMap<QString, QString> variables{{"CHIRON_PASSWORD", password}};
    if (!newPassword.isEmpty())
        variables["CHIRON_NEW_PASSWORD"] = newPassword;
    return runCli(arguments + QStringList{"--as", name, "--database", m_database, "--json"}, {}, variables);
}

QJsonObject TestCliAccounts::object(const CliRun& run) {
    if (run.exitCode != 0)
        qWarning("%s", run.err.constData());
    return QJsonDocument::fromJson(run.out).object();
}

QString TestCliAccounts::file(const QString& name, const QByteArray& content) {
    QFile out(m_folder.filePath(name));
    if (!out.open(QIODevice::WriteOnly) || out.write(content) != content.size())
        qFatal("the test's own file could not be written");
    return out.fileName();
}

void TestCliAccounts::initTestCase() {
    m_database = m_folder.filePath("folder/to/make/site.db");
    const CliRun run =
        runCli({"init", "--admin", "alice", "--database", m_database, "--json", "--password-stdin"},
               kAlice.toUtf8() + "\n");
    QCOMPARE(run.exitCode, 0);
    const QJsonObject json = object(run);
    QCOMPARE(json["database"].toString(), m_database);
    QVERIFY(json["schema_version"].toInt() >= 1);
    m_recoveryCode = json["recovery_code"].toString();
    QVERIFY(m_recoveryCode.size() >= 16);
    QVERIFY(!run.out.contains(kAlice.toUtf8()));
    const CliRun again = runCli({"init", "--admin", "mallory", "--database", m_database}, {},
                                {{"CHIRON_PASSWORD", "another long one"}});
    QCOMPARE(again.exitCode, 2); // it has an administrator
}

void TestCliAccounts::peopleComeAndChange() {
    const QJsonObject bob =
        object(as("alice", kAlice,
                  {"user", "add", "bob", "--role", "trainee", "--display-name", "Βασίλης Größe"}, kBob));
    QCOMPARE(bob["name"].toString(), QStringLiteral("bob"));
    QCOMPARE(bob["display_name"].toString(), QStringLiteral("Βασίλης Größe"));
    QVERIFY(!bob.contains("initial_password"));
    const QJsonObject carol =
        object(as("alice", kAlice, {"user", "add", "carol", "--role", "trainer,researcher"}));
    QVERIFY(carol["initial_password"].toString().size() >= 16);
    QVERIFY(carol["must_change_password"].toBool());
    QCOMPARE(carol["roles"].toArray(), QJsonArray({"trainer", "researcher"}));
    QCOMPARE(object(as("alice", kAlice, {"user", "role", "carol", "--role", "trainer"}))["roles"].toArray(),
             QJsonArray({"trainer"}));
    QCOMPARE(refusalFault(as("alice", kAlice, {"user", "role", "carol", "--role", "trainer,boss"}), 2,
                          {"user role", "--role", "boss"}),
             QString());
    QCOMPARE(object(as("alice", kAlice, {"user", "disable", "bob"}))["enabled"].toBool(true), false);
    QCOMPARE(as("bob", kBob, {"user", "list"}).exitCode, 2); // a closed account opens nothing
    QCOMPARE(object(as("alice", kAlice, {"user", "enable", "bob"}))["enabled"].toBool(false), true);
    const QJsonArray people = QJsonDocument::fromJson(as("alice", kAlice, {"user", "list"}).out).array();
    QCOMPARE(people.size(), 3);
    for (const QJsonValue& person : people) {
        QVERIFY(person["name"].toString() != QLatin1String("simulated"));
        if (person["name"].toString() == QLatin1String("carol"))
            QCOMPARE(person["roles"].toArray(), QJsonArray({"trainer"})); // refused roles changed nothing
    }
    QCOMPARE(as("alice", kAlice, {"user", "add", "BOB", "--role", "trainee"}, kBob).exitCode,
             3); // taken but for case
    QCOMPARE(as("alice", kAlice, {"user", "disable", "nobody"}).exitCode, 3);
    QVERIFY(as("alice", kAlice, {"user", "disable", "alice"}).exitCode != 0); // the last administrator
}

void TestCliAccounts::theSiteHasAName() {
    const auto told = [this] {
        return object(runCli({"site", "name", "--database", m_database, "--json"}))["name"].toString();
    };
    QCOMPARE(told(), QString());
    QCOMPARE(object(as("alice", kAlice, {"site", "name", "  Klinik Größe  "}))["name"].toString(),
             QStringLiteral("Klinik Größe"));
    QCOMPARE(told(), QStringLiteral("Klinik Größe")); // anybody may read it
    QCOMPARE(as("bob", kBob, {"site", "name", "Bob's"}).exitCode, 2);
    QCOMPARE(runCli({"site", "name", "Nobody's", "--database", m_database}).exitCode, 2);
    QCOMPARE(as("alice", kAlice, {"site", "name", QString(81, 'x')}).exitCode, 3);
    QCOMPARE(as("alice", kAlice, {"site", "name", "One", "--remove"}).exitCode, 2);
    for (const char* blank : {"", "  "}) // a script's empty variable neither shows nor removes
        QCOMPARE(as("alice", kAlice, {"site", "name", QString::fromLatin1(blank)}).exitCode, 2);
    QCOMPARE(told(), QStringLiteral("Klinik Größe"));
    QCOMPARE(as("alice", kAlice, {"site", "name", "--remove"}).exitCode, 0);
    QCOMPARE(told(), QString());
}

void TestCliAccounts::rolesDecide() {
    for (const QStringList& arguments :
         {QStringList{"user", "add", "eve", "--role", "admin"}, QStringList{"user", "disable", "carol"},
          QStringList{"user", "role", "bob", "--role", "admin"}, QStringList{"user", "passwd", "alice"},
          QStringList{"person", "erase", "alice", "--reason", "because"}}) {
        const CliRun run = as("bob", kBob, arguments, "a password of eve");
        QVERIFY2(run.exitCode == 2, run.err.constData());
        QVERIFY(run.out.isEmpty());
    }
}

void TestCliAccounts::passwordsChange() {
    const QString next = QStringLiteral("a new one for bob 7");
    QCOMPARE(as("bob", kBob, {"user", "passwd"}).exitCode, 2); // no new password given
    QCOMPARE(object(as("bob", kBob, {"user", "passwd"}, next))["changed"].toBool(), true);
    QCOMPARE(as("bob", kBob, {"user", "passwd"}, kBob).exitCode, 2);
    const CliRun back =
        runCli({"user", "passwd", "--as", "bob", "--database", m_database, "--password-stdin"},
               next.toUtf8() + "\r\n" + kBob.toUtf8() + "\n");
    QVERIFY2(back.exitCode == 0, back.err.constData());
    const QString reset =
        object(as("alice", kAlice, {"user", "passwd", "bob"}))["initial_password"].toString();
    QVERIFY(!reset.isEmpty());
    QCOMPARE(as("bob", reset, {"person", "export", "bob"}).exitCode, 2); // to be changed first
    QCOMPARE(object(as("bob", reset, {"user", "passwd"}, kBob))["changed"].toBool(), true);
}

/// The recovery code from `init` sets a new password for the administrator and works once; the next recovery
/// needs the new code.
void TestCliAccounts::aForgottenPasswordIsRecovered() {
    const QStringList recover{"user", "recover", "alice", "--database", m_database, "--json"};
    const QString other = QStringLiteral("another horse battery");
    const CliRun wrong =
        runCli(recover, {}, {{"CHIRON_RECOVERY_CODE", other}, {"CHIRON_NEW_PASSWORD", other}});
    QCOMPARE(wrong.exitCode, 2);
    QVERIFY(wrong.out.isEmpty());
    QCOMPARE(as("alice", kAlice, {"user", "list"}).exitCode, 0); // the old password still works

    const QJsonObject first = object(
        runCli(recover, {}, {{"CHIRON_RECOVERY_CODE", m_recoveryCode}, {"CHIRON_NEW_PASSWORD", other}}));
    QCOMPARE(first["name"].toString(), QStringLiteral("alice"));
    const QString next = first["recovery_code"].toString();
    QVERIFY(next.size() >= 16 && next != m_recoveryCode);
    QCOMPARE(as("alice", other, {"user", "list"}).exitCode, 0);
    QCOMPARE(as("alice", kAlice, {"user", "list"}).exitCode, 2);

    QCOMPARE(runCli(recover, {}, {{"CHIRON_RECOVERY_CODE", m_recoveryCode}, {"CHIRON_NEW_PASSWORD", kAlice}})
                 .exitCode,
             2); // this code has been used
    const CliRun piped =
        runCli(recover + QStringList{"--password-stdin"}, next.toUtf8() + "\n" + kAlice.toUtf8() + "\n");
    QVERIFY2(piped.exitCode == 0, piped.err.constData());
    QCOMPARE(as("alice", kAlice, {"user", "list"}).exitCode, 0);
    m_recoveryCode = object(piped)["recovery_code"].toString();
}

/// Somebody else than the first administrator: a code of their own, which replaces the one before.
void TestCliAccounts::aSecondAdministratorMakesARecoveryCode() {
    const QString maria = QStringLiteral("maria's long word");
    QCOMPARE(as("alice", kAlice, {"user", "add", "maria", "--role", "admin"}, maria).exitCode, 0);
    QCOMPARE(as("maria", QStringLiteral("wrong wrong wrong"), {"user", "recovery-code"}).exitCode, 2);
    const QJsonObject first = object(as("maria", maria, {"user", "recovery-code"}));
    QCOMPARE(first["name"].toString(), QStringLiteral("maria"));
    const QString code = object(as("maria", maria, {"user", "recovery-code"}))["recovery_code"].toString();
    QVERIFY(code.size() >= 16 && code != first["recovery_code"].toString());
    const QStringList recover{"user", "recover", "maria", "--database", m_database, "--json"};
    const QString other = QStringLiteral("another long word");
    QCOMPARE(
        runCli(recover, {},
               {{"CHIRON_RECOVERY_CODE", first["recovery_code"].toString()}, {"CHIRON_NEW_PASSWORD", other}})
            .exitCode,
        2);
    QCOMPARE(runCli(recover, {}, {{"CHIRON_RECOVERY_CODE", code}, {"CHIRON_NEW_PASSWORD", other}}).exitCode,
             0);
    QCOMPARE(as("maria", other, {"user", "list"}).exitCode, 0);
    QCOMPARE(as("bob", kBob, {"user", "recovery-code"}).exitCode,
             2); // administrators only: others are helped by one
    QCOMPARE(as("alice", kAlice, {"user", "disable", "maria"}).exitCode, 0);
}

void TestCliAccounts::rosterIsAllOrNothing() {
    const QString bad = file(
        "bad.csv",
        "name,display_name,roles,password\nfred,Fred,trainee,long enough 1\ngina,Gina,boss,long enough 2\n");
    const CliRun refused = as("alice", kAlice, {"user", "import-csv", bad});
    QCOMPARE(refused.exitCode, 3);
    QVERIFY2(refused.err.contains("bad.csv") && refused.err.contains("line 3") &&
                 refused.err.contains("boss"),
             refused.err.constData());
    const QString good = file("good.csv", "name,display_name,roles,password\nfred,Fred,trainee,long enough "
                                          "1\ngina,Gina,trainee;trainer,long enough 2\n");
    QCOMPARE(object(as("alice", kAlice, {"user", "import-csv", good}))["imported"].toInt(),
             2); // fred was not there yet
}

void TestCliAccounts::rosterOfASpreadsheet() {
    const QString german =
        file("Kurs.csv", "Nachname;Vorname;Anmeldename;Rolle;Gruppe\r\nM\xfcller;J\xf6rg;mueller;Lernende "
                         "Person;A\r\nFred;Fritz;FRED;Ausbilder/in;A\r\n");
    const QJsonObject done = object(as("alice", kAlice, {"user", "import-csv", german}));
    QCOMPARE(done["imported"].toInt(), 1);
    QCOMPARE(done["skipped"].toInt(), 1); // fred is there
    QCOMPARE(done["ignored_columns"].toArray(), QJsonArray{"Gruppe"});
    const QJsonObject made = done["passwords"].toArray().at(0).toObject();
    QCOMPARE(made["name"].toString(), QStringLiteral("mueller"));
    QCOMPARE(object(as("mueller", made["initial_password"].toString(), {"user", "passwd"}, kBob))["changed"]
                 .toBool(),
             true);
    const QJsonObject updated =
        object(as("alice", kAlice, {"user", "import-csv", german, "--existing", "update"}));
    QCOMPARE(updated["updated"].toInt(), 1);
    QCOMPARE(updated["imported"].toInt(), 0);
    const QJsonArray people = QJsonDocument::fromJson(as("alice", kAlice, {"user", "list"}).out).array();
    const auto fred = std::find_if(people.begin(), people.end(), [](const QJsonValue& person) {
        return person["name"] == QStringLiteral("fred");
    });
    QVERIFY(fred != people.end());
    QCOMPARE((*fred)[QStringLiteral("display_name")].toString(), QStringLiteral("Fritz Fred"));
    QCOMPARE((*fred)[QStringLiteral("roles")].toArray(), QJsonArray{"trainer"});
    QCOMPARE(as("alice", kAlice, {"user", "import-csv", german, "--existing", "replace"}).exitCode, 2);
    const CliRun excel =
        as("alice", kAlice,
           {"user", "import-csv", file("Kurs.xlsx", QByteArray("PK\x03\x04", 4) + "[Content_Types].xml")});
    QCOMPARE(excel.exitCode, 3);
    QVERIFY2(excel.err.contains("Kurs.xlsx") && excel.err.contains("save it as CSV"), excel.err.constData());
}

void TestCliAccounts::renaming() {
    const QJsonObject renamed = object(
        as("alice", kAlice, {"user", "rename", "fred", "--name", "frederic", "--display-name", "Frédéric"}));
    QCOMPARE(renamed["name"].toString(), QStringLiteral("frederic"));
    QCOMPARE(renamed["display_name"].toString(), QStringLiteral("Frédéric"));
    const QJsonObject held = object(as("alice", kAlice, {"person", "export", "frederic"}));
    QVERIFY2(held["earlier_names"].toArray().size() >= 1,
             qPrintable(QString::fromUtf8(QJsonDocument(held).toJson().left(400))));
    QCOMPARE(held["earlier_names"].toArray().at(0)["name"].toString(), QStringLiteral("fred"));
    QCOMPARE(as("alice", kAlice, {"user", "rename", "fred", "--name", "fritz"}).exitCode,
             3); // nobody has that name now
    QCOMPARE(as("alice", kAlice, {"user", "rename", "frederic", "--name", "ALICE"}).exitCode, 3); // taken
    QCOMPARE(as("alice", kAlice, {"user", "rename", "frederic"}).exitCode, 2);                    // to what?
    QCOMPARE(as("bob", kBob, {"user", "rename", "bob", "--name", "robert"}).exitCode, 2); // not one's own
}

void TestCliAccounts::anOldRosterKnowsWhoWasRenamed() {
    const QString old =
        file("old.csv", "login name;full name;role\nFred;Fritz Fred;trainee\n"); // frederic by now
    const QJsonObject skipped = object(as("alice", kAlice, {"user", "import-csv", old}));
    QCOMPARE(skipped["imported"].toInt(), 0);
    QCOMPARE(skipped["skipped"].toInt(), 1);
    const QJsonObject told = skipped["names"].toArray().at(0).toObject();
    QCOMPARE(told["line"].toInt(), 2);
    QCOMPARE(told["name"].toString(), QStringLiteral("Fred"));
    QCOMPARE(told["name_today"].toString(), QStringLiteral("frederic"));
    const QJsonObject updated =
        object(as("alice", kAlice, {"user", "import-csv", old, "--existing", "update"}));
    QCOMPARE(updated["updated"].toInt(), 1);
    QCOMPARE(updated["imported"].toInt(), 0);
    QCOMPARE(updated["names"].toArray().at(0)["earlier_full_name"].toString(),
             QStringLiteral("Fritz Fred")); // which is not given back
    const QJsonArray people = QJsonDocument::fromJson(as("alice", kAlice, {"user", "list"}).out).array();
    QStringList names;
    for (const QJsonValue& person : people)
        names << person["name"].toString() << person["display_name"].toString();
    QVERIFY(names.contains(QStringLiteral("Frédéric")));
    QVERIFY2(names.contains(QStringLiteral("frederic")) &&
                 !names.contains(QStringLiteral("Fred"), Qt::CaseInsensitive),
             qPrintable(names.join(QLatin1Char(' '))));
}

void TestCliAccounts::aWrongPasswordIsRefused() {
    const CliRun wrong = as("alice", "wrong wrong wrong", {"user", "list"});
    const CliRun unknown = as("nobody", "wrong wrong wrong", {"user", "list"});
    QCOMPARE(wrong.exitCode, 2);
    QCOMPARE(unknown.exitCode, 2);
    QCOMPARE(wrong.err, unknown.err); // who has an account is not told
    QVERIFY(!wrong.err.contains("wrong wrong"));
}

void TestCliAccounts::theWritersLockIsNamed() {
    QLockFile lock(m_database + ".lock");
    lock.setStaleLockTime(0);
    QVERIFY(lock.tryLock(0));
    const CliRun run = as("alice", kAlice, {"user", "disable", "bob"});
    QCOMPARE(run.exitCode, 4);
    QVERIFY2(run.err.contains(QByteArray::number(QCoreApplication::applicationPid())), run.err.constData());
    QCOMPARE(as("alice", kAlice, {"user", "list"}).exitCode, 0); // readers go on
}

QTEST_GUILESS_MAIN(TestCliAccounts)
#include "test_cli_accounts.moc"
