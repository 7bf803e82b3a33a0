// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/integrity/verifier.h"
#include "database/privacy/erasure.h"
#include "database/query.h"
#include "database/repositories/account_repository.h"
#include "database/repositories/audit_repository.h"
#include "database/repositories/privacy_repository.h"

#include <algorithm>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// Changes of names: who may, what is kept of the old ones, and what an erasure leaves of them.
class TestNames : public QObject {
    Q_OBJECT
private slots:
    void init();
    void theOldNamesStayInTheHistory();
    void aPastSessionIsStillTheSamePersons();
    void refusedNames_data();
    void refusedNames();
    void everybodyChangesTheirOwnDisplayName();
    void whoWasRenamedConfirmsWithTheirPassword();
    void theChainVouchesForEarlierNames();
    void anErasureOverwritesThem();
    void earlierLoginsAreListedLatestFirst();

private:
    AccountService accounts() { return AccountService(*m->database); }
    std::vector<EarlierName> earlier(PersonId person) {
        return accounts().earlierNames(m_admin, person).value_or(std::vector<EarlierName>{});
    }

    std::unique_ptr<DatabaseFixture> m;
    Actor m_admin = Actor::anonymous(), m_bob = Actor::anonymous();
};

void TestNames::init() {
    m = std::make_unique<DatabaseFixture>();
    REQUIRE(m->create());
    m_admin = m->administrator().value();
    m_bob = m->person(m_admin, "bob", {Role::trainee}).value();
}

void TestNames::theOldNamesStayInTheHistory() {
    const auto before = AuditRepository(**m->database->openReader(), m_admin).listAudit()->size();
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "robert", "Robert B."));
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "ROBERT", "Robert B.")); // only the case
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "ROBERT", "Robert B.")); // nothing
    const auto names = earlier(m_bob.personId());
    QCOMPARE(names.size(), std::size_t{2});
    QVERIFY(names[0].name == "robert" && names[0].displayName == "Robert B.");
    QVERIFY(names[1].name == "bob" && names[1].displayName == "bob display");
    QVERIFY(names[1].changedBy == m_admin.personId() && !names[1].untilUtc.empty());
    const auto audit = AuditRepository(**m->database->openReader(), m_admin).listAudit();
    QCOMPARE(audit->size(), before + 4);
    QCOMPARE(audit->at(0).action, std::string("changeNames"));
    QCOMPARE(audit->at(1).action, std::string("keepNames"));
    for (const AuditEntry& entry :
         *audit) // ids and digests only: an erasure must not have to touch the chain
        QVERIFY(entry.detailJson.find("obert") == std::string::npos);
    REQUIRE(accounts().login("robert", kPassword)); // case does not matter
    QVERIFY(!accounts().login("bob", kPassword));
    REQUIRE(m->person(m_admin, "bob", {Role::trainee})); // the name is free again
    const auto held = PrivacyRepository(**m->database->openReader(), m_admin).exportPerson(m_bob.personId());
    REQUIRE(held);
    QCOMPARE(held->earlierNames.size(), std::size_t{2});
}

void TestNames::aPastSessionIsStillTheSamePersons() {
    const auto session = storeSession(*m->database, m_bob);
    REQUIRE(session);
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "robert", "Robert B."));
    const auto listed = SessionReader(**m->database->openReader(), m_admin).session(*session);
    REQUIRE(listed);
    QCOMPARE(listed->summary.person, m_bob.personId());
    QCOMPARE(listed->summary.personName, std::string("robert"));
    const auto seal =
        selectText(**m->database->openReader(), "SELECT hex(seal) FROM session WHERE id = ?", {*session});
    QVERIFY(seal && !(*seal)->empty());
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
}

void TestNames::refusedNames_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("displayName");
    QTest::newRow("taken") << "ada"
                           << "B";
    QTest::newRow("taken in another case") << "ADA"
                                           << "B";
    QTest::newRow("empty") << ""
                           << "B";
    QTest::newRow("comma") << "bob,b"
                           << "B";
    QTest::newRow("space at the end") << "bob "
                                      << "B";
    QTest::newRow("too long") << QString(65, 'b') << "B";
    QTest::newRow("invisible") << QString::fromUtf8("bo\xe2\x80\x8b"
                                                    "b")
                               << "B";
    QTest::newRow("reserved") << "erased-7"
                              << "B";
    QTest::newRow("the machine's") << "Simulated"
                                   << "B";
    QTest::newRow("display name too long") << "bob" << QString(201, 'b');
}

void TestNames::refusedNames() {
    QFETCH(QString, name);
    QFETCH(QString, displayName);
    const auto changed =
        accounts().changeNames(m_admin, m_bob.personId(), name.toStdString(), displayName.toStdString());
    QCOMPARE(changed.error().code, core::ErrorCode::badInput);
    QCOMPARE(accounts().self(m_bob)->name, std::string("bob"));
    QCOMPARE(accounts().self(m_bob)->displayName, std::string("bob display"));
    QVERIFY(earlier(m_bob.personId()).empty());
}

void TestNames::everybodyChangesTheirOwnDisplayName() {
    for (const Role role : {Role::trainee, Role::trainer, Role::researcher, Role::admin}) {
        const auto who = m->person(m_admin, std::string(token(role)) + "-1", {role});
        REQUIRE(who);
        REQUIRE(accounts().changeDisplayName(*who, "Quite Another"));
        QCOMPARE(accounts().self(*who)->displayName, std::string("Quite Another"));
        QCOMPARE(earlier(who->personId()).front().changedBy, who->personId());
        const auto others = m->database->write([&](WriteContext& w) {
            return AccountRepository(w.connection(), *who).changeDisplayName(m_bob.personId(), "Mallory");
        });
        QCOMPARE(others.error().code, core::ErrorCode::notAllowed);
        const auto login =
            accounts().changeNames(*who, who->personId(), "other-" + std::string(token(role)), "X");
        QCOMPARE(login.has_value(), role == Role::admin);
    }
    QCOMPARE(accounts().self(m_bob)->displayName, std::string("bob display"));
    QCOMPARE(accounts().changeDisplayName(Actor::anonymous(), "X").error().code, core::ErrorCode::notAllowed);
    QCOMPARE(accounts().changeNames(m_admin, 4711, "nobody", "X").error().code, core::ErrorCode::notFound);
    QCOMPARE(accounts().changeNames(m_admin, Actor::kSimulatedPerson, "machine", "X").error().code,
             core::ErrorCode::notFound);
}

void TestNames::whoWasRenamedConfirmsWithTheirPassword() {
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "robert", ""));
    QVERIFY(accounts()
                .tryConfirm(m_bob, kPassword)
                .has_value()); // logged in under the old name: unlocking goes on
    REQUIRE(m->person(m_admin, "bob", {Role::trainee}));
    QVERIFY(accounts()
                .tryConfirm(m_bob, kPassword)
                .has_value()); // and whoever has that name now is somebody else
    QCOMPARE(accounts().changePassword(m_bob, kPassword, "robert").error().code, core::ErrorCode::badInput);
    REQUIRE(accounts().changePassword(m_bob, kPassword, "another horse 8"));
    REQUIRE(accounts().login("robert", "another horse 8"));
}

void TestNames::theChainVouchesForEarlierNames() {
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "robert", ""));
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
    for (const char* change :
         {"UPDATE person_name SET names_json = replace(names_json, 'bob', 'eve')",
          "UPDATE person_name SET names_json = ''", "UPDATE person_name SET person_id = 2",
          "DROP TRIGGER person_name_stays; DELETE FROM person_name"}) {
        QFile::remove(QString::fromStdString(m->path("copy.db")));
        QVERIFY(QFile::copy(QString::fromStdString(m->path()), QString::fromStdString(m->path("copy.db"))));
        auto connection = Connection::open(m->path(), Connection::Mode::readWrite);
        REQUIRE((*connection)->execute(change));
        REQUIRE((*connection)->execute("PRAGMA user_version=2")); // does not keep verify from looking
        connection->reset();
        const VerifyReport report = verifyDatabase(m->path(), m->options);
        QVERIFY2(std::any_of(report.findings.begin(), report.findings.end(),
                             [](const Finding& f) { return f.table == "person_name"; }),
                 change);
        QVERIFY(QFile::remove(QString::fromStdString(m->path())));
        QVERIFY(QFile::rename(QString::fromStdString(m->path("copy.db")), QString::fromStdString(m->path())));
    }
}

void TestNames::anErasureOverwritesThem() {
    const auto eve = m->person(m_admin, "eve", {Role::trainee});
    REQUIRE(eve);
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "krummstab", "Wanderfalke"));
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "sperling", "Sperling"));
    REQUIRE(accounts().changeNames(m_admin, eve->personId(), "eva", "Eva"));
    REQUIRE(Upkeep::backup(*m->database, m_admin, m->path("before")));
    REQUIRE(accounts().erasePerson(m_admin, kPassword, m_bob.personId(), "wish", false));
    QVERIFY(earlier(m_bob.personId()).empty());
    QCOMPARE(earlier(eve->personId()).size(), std::size_t{1});
    m->database.reset();
    QVERIFY(verifyDatabase(m->path(), m->options).ok());
    for (const QString& name : QDir(m->folder.path()).entryList({QStringLiteral("site.db*")}, QDir::Files)) {
        QFile file(m->folder.filePath(name));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        QVERIFY2(!bytes.contains("krummstab") && !bytes.contains("Wanderfalke") &&
                     !bytes.contains("sperling"),
                 qPrintable(name));
    }
    // A backup from before knows the names still; restoring it erases them again.
    database::RestoreRequest request = requestFor(*m, m->path("before"));
    const auto restored = Upkeep::restore(request, m->options);
    REQUIRE(restored);
    QCOMPARE(restored->erasuresApplied, 1);
    REQUIRE(m->reopen());
    QVERIFY(earlier(m_bob.personId()).empty());
    QCOMPARE(earlier(eve->personId()).size(), std::size_t{1});
}

/// Each earlier login is listed once, with its person; those of an erased person are not listed.
void TestNames::earlierLoginsAreListedLatestFirst() {
    const auto eve = m->person(m_admin, "eve", {Role::trainee}),
               gil = m->person(m_admin, "gil", {Role::trainee});
    REQUIRE(eve);
    REQUIRE(gil);
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "robert", "Robert"));
    REQUIRE(accounts().changeNames(m_admin, eve->personId(), "eva", "Eva"));
    REQUIRE(accounts().changeNames(m_admin, gil->personId(), "gilbert", "Gilbert"));
    REQUIRE(accounts().changeNames(m_admin, m_bob.personId(), "rob", "Rob"));
    REQUIRE(accounts().erasePerson(m_admin, kPassword, gil->personId(), "wish", false));
    const auto logins = AccountRepository(**m->database->openReader(), m_admin).listEarlierLogins();
    REQUIRE(logins);
    const std::vector<EarlierLogin> expected{{m_bob.personId(), "robert", "Robert"},
                                             {eve->personId(), "eve", "eve display"},
                                             {m_bob.personId(), "bob", "bob display"}};
    QCOMPARE(logins->size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        QVERIFY2(logins->at(i).person == expected[i].person && logins->at(i).name == expected[i].name &&
                     logins->at(i).displayName == expected[i].displayName,
                 logins->at(i).name.c_str());
}

QTEST_GUILESS_MAIN(TestNames)
#include "test_names.moc"
