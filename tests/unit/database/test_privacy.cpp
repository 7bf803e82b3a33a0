// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "database/accounts/account_rules.h"
#include "database/accounts/password_hasher.h"
#include "database/accounts/throttle.h"
#include "database/integrity/verifier.h"
#include "database/privacy/erasure.h"
#include "database/query.h"
#include "database/repositories/audit_repository.h"
#include "database/repositories/privacy_repository.h"

#include <QDir>
#include <QFile>
#include <algorithm>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {
// Whether the bytes occur in any file of the database (main file, log).
bool onDisk(const std::string& database, const QByteArray& bytes) {
    for (const char* suffix : {"", "-wal", "-shm", "-journal"}) {
        QFile file(QString::fromStdString(database + suffix));
        if (file.open(QIODevice::ReadOnly) && file.readAll().contains(bytes)) {
            return true;
        }
    }
    return false;
}
} // namespace

/// Importing, exporting and erasing people.
class TestPrivacy : public QObject {
    Q_OBJECT
private slots:
    void csvImportIsAllOrNothing();
    void csvPreviewChangesNothing();
    void csvSyntax_data();
    void csvSyntax();
    void exportHoldsEverything();
    void exportHoldsNobodyElsesAudit();
    void erasureLeavesNoTraceButTheTombstone();
    void erasureKeepsWhatIsOthers();
    void erasureNeedsThePassword();
    void erasureTellsWhenAReaderKeepsOldPages();
    void erasureGoesOnWhereItStopped();
    void filesAreTheirOwnersAlone();
};

void TestPrivacy::csvImportIsAllOrNothing() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    REQUIRE(ada);
    AccountService accounts(*f.database);
    const std::string bad = "name,display_name,roles,password\r\n"
                            "tim,Tim,trainee,a good long word\r\n"
                            "uma,Uma,wizard,a good long word\r\n"
                            "tim,Twice,trainee,a good long word\r\n"
                            "vic,Vic,trainee,short\r\n";
    const auto refused = accounts.importCsv(*ada, bad);
    QCOMPARE(refused.error().code, core::ErrorCode::badInput);
    for (const char* place :
         {"line 3, roles \"wizard\"", "line 4, name \"tim\": given already in line 2", "line 5, password"}) {
        QVERIFY2(refused.error().message.find(place) != std::string::npos, refused.error().message.c_str());
    }
    QVERIFY(refused.error().message.find("line 2,") == std::string::npos);
    QVERIFY(refused.error().message.find("short") == std::string::npos); // passwords are not repeated
    QCOMPARE(accounts.listPeople(*ada)->size(), std::size_t{1});
    // Who has an account already is left alone.
    const auto taken = accounts.importCsv(
        *ada, "name,roles,password\nwes,trainee,a good long word\nAda,trainer,a good long word\n");
    REQUIRE(taken);
    QVERIFY(taken->added.size() == 1 && taken->skipped == 1 && taken->updated == 0);
    REQUIRE(accounts.login("ada", kPassword));
    QVERIFY(accounts.personByName(*ada, "ada")->roles == RoleSet{Role::admin});
    const auto done =
        accounts.importCsv(*ada, "roles,name,password\n\"trainer,researcher\",\"Quote \"\"Q\"\" Person\",a "
                                 "good long word\ntrainee;admin,yan,a good long word");
    REQUIRE(done);
    QCOMPARE(done->added.size(), std::size_t{2});
    const auto yan = accounts.login("yan", "a good long word");
    REQUIRE(yan);
    QVERIFY(yan->mustChangePassword());
    QVERIFY((yan->roles() == RoleSet{Role::trainee, Role::admin}));
    REQUIRE(accounts.personByName(*ada, "quote \"q\" person"));
}

void TestPrivacy::csvPreviewChangesNothing() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainer});
    AccountService accounts(*f.database);
    const std::string text = "name,display_name,roles,password\n"
                             "uma,Uma,trainee,a good long word\n"
                             "TIM,Tim,trainee,a good long word\n"
                             "vic,Vic,wizard,short\n"
                             "uma,Uma,trainee,a good long word\n"
                             "wes,Wes,trainee\n";
    const auto preview = accounts.previewCsv(*ada, text);
    REQUIRE(preview);
    const Roster& roster = preview->roster;
    QCOMPARE(roster.rows.size(), std::size_t{5});
    QCOMPARE(roster.rows[0].displayName, std::string("Uma"));
    QVERIFY(roster.rows[0].password.empty());
    QVERIFY(preview->steps[1].kind == RosterStep::Kind::skip && preview->steps[1].person == tim->personId());
    QVERIFY(preview->steps[4].makesPassword &&
            !preview->steps[0].makesPassword); // a spreadsheet leaves out what is empty at the end
    const auto has = [&](int line, RosterFault fault, int other = 0) {
        return std::any_of(roster.problems.begin(), roster.problems.end(), [&](const RosterProblem& p) {
            return p.line == line && p.fault == fault && p.other == other;
        });
    };
    QVERIFY(has(4, RosterFault::roles) && has(4, RosterFault::password) && has(5, RosterFault::nameTwice, 2));
    QCOMPARE(roster.problems.size(), std::size_t{3});
    QCOMPARE(accounts.listPeople(*ada)->size(), std::size_t{2});
    QCOMPARE(accounts.previewCsv(*tim, text).error().code, core::ErrorCode::notAllowed);
}

void TestPrivacy::csvSyntax_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("empty") << "";
    QTest::newRow("header only") << "name,roles,password\n";
    QTest::newRow("value without heading") << "name,roles,password\na,trainee,a good long word,3\n";
    QTest::newRow("column twice") << "name,name,roles,password\na,a,trainee,a good long word\n";
    QTest::newRow("column missing") << "name,password\na,a good long word\n";
    QTest::newRow("open quote") << "name,roles,password\n\"a,trainee,a good long word\n";
    QTest::newRow("too few fields") << "name,password,roles\na,a good long word\n";
    QTest::newRow("no role") << "name,roles,password\na,,a good long word\n";
    QTest::newRow("binary") << QString(QChar(0)) + "\n" + QString(QChar(1));
}

void TestPrivacy::csvSyntax() {
    QFETCH(QString, text);
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto refused = AccountService(*f.database).importCsv(*ada, text.toStdString());
    QCOMPARE(refused.error().code, core::ErrorCode::badInput);
    QVERIFY(!refused.error().message.empty());
}

void TestPrivacy::exportHoldsEverything() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    REQUIRE(tim);
    const auto id = storeSession(*f.database, *tim);
    REQUIRE(id);
    REQUIRE(f.database->write([&](WriteContext& w) {
        return SessionRepository(w.connection(), *tim).addComment(*id, "my hand shook", 42);
    }));
    auto reader = f.database->openReader();
    const auto held = PrivacyRepository(**reader, *tim).exportPerson(tim->personId());
    REQUIRE(held);
    QCOMPARE(held->person.name, std::string("tim"));
    QCOMPARE(held->person.displayName, std::string("tim display"));
    QCOMPARE(held->sessions.size(), std::size_t{1});
    QCOMPARE(held->sessions[0].trials.size(), std::size_t{1});
    QCOMPARE(held->sessions[0].events.size(), std::size_t{1});
    QVERIFY(held->sessions[0].scores.has_value());
    QCOMPARE(held->commentsWritten.size(), std::size_t{1});
    QVERIFY(held->commentsWritten[0].tick == 42U && held->sessions[0].comments[0].tick == 42U);
    QVERIFY(held->hasPassword);
    QVERIFY(held->audit.size() >= 5); // created, logged in, began, finished, scored, commented
}

/// A person's export contains the audit entries of what they did and of what was done to their account, and
/// no others.
void TestPrivacy::exportHoldsNobodyElsesAudit() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee}), uma = f.person(*ada, "uma", {Role::trainee});
    REQUIRE(tim);
    REQUIRE(uma);
    REQUIRE(storeSession(*f.database, *tim));
    REQUIRE(storeSession(*f.database, *uma));
    auto reader = f.database->openReader();
    const auto whole = AuditRepository(**reader, *ada).listAudit();
    REQUIRE(whole);
    std::vector<std::int64_t> expected;
    for (const AuditEntry& entry : *whole) {
        const bool did = entry.actorKind == "person" && entry.actor == tim->personId();
        const bool about =
            (entry.target == "person" || entry.target == "credential") && entry.targetId == tim->personId();
        if (did || about) {
            expected.push_back(entry.sequence);
        }
    }
    std::sort(expected.begin(), expected.end()); // the list has the newest first, the export the oldest
    QVERIFY(expected.size() < whole->size());
    const auto held = PrivacyRepository(**reader, *tim).exportPerson(tim->personId());
    REQUIRE(held);
    std::vector<std::int64_t> found;
    for (const AuditEntry& entry : held->audit) {
        found.push_back(entry.sequence);
    }
    QCOMPARE(found, expected);
}

void TestPrivacy::erasureLeavesNoTraceButTheTombstone() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "timotheus-unverwechselbar", {Role::trainee});
    REQUIRE(tim);
    const auto id = storeSession(*f.database, *tim, 6);
    REQUIRE(id);
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        auto comment = SessionRepository(w.connection(), *tim).addComment(*id, "geheimes-wort-eins");
        return comment ? SessionRepository(w.connection(), *ada).voidSession(*id, "geheimes-wort-zwei")
                       : tl::unexpected(comment.error());
    }));
    const QByteArray payload(reinterpret_cast<const char*>(someChunk(3).payload.data()), 300);
    for (const QByteArray& trace : {QByteArray("timotheus-unverwechselbar"), QByteArray("geheimes-wort-eins"),
                                    QByteArray("geheimes-wort-zwei"), payload}) {
        QVERIFY(onDisk(f.path(), trace));
    }
    AccountService accounts(*f.database);
    REQUIRE(accounts.erasePerson(*ada, kPassword, tim->personId(), "withdrew consent", true));
    for (const QByteArray& trace : {QByteArray("timotheus-unverwechselbar"), QByteArray("geheimes-wort-eins"),
                                    QByteArray("geheimes-wort-zwei"), payload}) {
        QVERIFY2(!onDisk(f.path(), trace), trace.constData());
    }
    auto reader = f.database->openReader();
    const auto erasures = PrivacyRepository(**reader, *ada).listErasures();
    REQUIRE(erasures);
    QCOMPARE(erasures->size(), std::size_t{1});
    QCOMPARE(erasures->front().reason, std::string("withdrew consent"));
    QVERIFY(erasures->front().recordingsWithdrawn);
    QVERIFY(!accounts.login("timotheus-unverwechselbar", kPassword));
    QCOMPARE(
        selectInteger(**reader, "SELECT enabled FROM person WHERE id = ?", {tim->personId()})->value_or(-1),
        std::int64_t{0});
    QCOMPARE(storeSession(*f.database, *tim).error().code, core::ErrorCode::notAllowed);
    QCOMPARE(SessionReader(**reader, *ada).openChunks(*id).error().code, core::ErrorCode::notFound);
    const auto record = SessionReader(**reader, *ada).session(*id);
    REQUIRE(record);
    QVERIFY(record->summary.recordingErased);
    QCOMPARE(record->voidReason, std::string());
    REQUIRE(ScoreRepository(**reader, *ada).scores(*id)); // the numbers stay, under nobody's name
    const auto everybody = accounts.listPeople(*ada);
    REQUIRE(everybody);
    for (const Person& person : *everybody) {
        QVERIFY(person.id != tim->personId());
    }
    // The name is free again, the number is not.
    const auto other = f.person(*ada, "timotheus-unverwechselbar", {Role::trainee});
    REQUIRE(other);
    QVERIFY(other->personId() != tim->personId());
}

// Of each pair one is the erased person's as the writer, one as whom it is about; the third is nothing of
// theirs, and stays.
void TestPrivacy::erasureKeepsWhatIsOthers() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee, Role::trainer});
    const auto uma = f.person(*ada, "uma", {Role::trainee});
    REQUIRE(uma);
    const auto ofTim = storeSession(*f.database, *tim, 6);
    const auto ofUma = storeSession(*f.database, *uma, 6);
    const auto second = storeSession(*f.database, *uma, 2);
    REQUIRE(second);
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository byTim(w.connection(), *tim), byUma(w.connection(), *uma),
            byAda(w.connection(), *ada);
        for (const auto& done :
             {drop(byTim.addComment(*ofUma, "by tim on uma")),
              drop(byAda.addComment(*ofTim, "by ada on tim")),
              drop(byUma.addComment(*ofUma, "by uma on uma")),
              drop(byTim.voidSession(*ofUma, "first by tim")),
              drop(byTim.reinstateSession(*ofUma, "counted by tim")),
              drop(byTim.voidSession(*ofUma, "void by tim")), drop(byAda.voidSession(*ofTim, "first of tim")),
              drop(byAda.reinstateSession(*ofTim, "counted of tim")),
              drop(byAda.voidSession(*ofTim, "void of tim")),
              drop(byAda.voidSession(*second, "first by ada")),
              drop(byAda.reinstateSession(*second, "counted by ada")),
              drop(byAda.voidSession(*second, "void by ada"))})
            if (!done)
                return done;
        return {};
    }));
    const auto chunksOf = [&](SessionId id) {
        auto reader = f.database->openReader();
        const auto source = SessionReader(**reader, *ada).openChunks(id);
        return source ? (*source)->chunkCount() : std::size_t{0};
    };
    QVERIFY(chunksOf(*ofUma) == 6 && chunksOf(*second) == 2); // of each session its own
    const auto list = [&](const char* sql) {
        auto reader = f.database->openReader();
        std::vector<std::string> texts;
        auto query = Query::run(**reader, sql, {});
        while (query && query->next().value_or(false))
            texts.push_back(query->text(0));
        std::sort(texts.begin(), texts.end());
        return texts;
    };
    using Texts = std::vector<std::string>;
    REQUIRE(AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "asked for it", true));
    QCOMPARE(list("SELECT text FROM session_comment"), (Texts{"", "", "by uma on uma"}));
    QCOMPARE(list("SELECT void_reason FROM session"), (Texts{"", "", "void by ada"}));
    QCOMPARE(list("SELECT reason FROM session_decision"),
             (Texts{"", "", "", "", "counted by ada", "first by ada"}));
    QCOMPARE(list("SELECT operator_name FROM session"), (Texts{"", "novice", "novice"}));
    QVERIFY(onDisk(f.path(), "by uma on uma") && !onDisk(f.path(), "by tim on uma") &&
            !onDisk(f.path(), "by ada on tim"));
}

void TestPrivacy::erasureNeedsThePassword() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    AccountService accounts(*f.database);
    QCOMPARE(accounts.erasePerson(*ada, "wrong word 12", tim->personId(), "wish", false).error().code,
             core::ErrorCode::notAllowed);
    QCOMPARE(accounts.erasePerson(*ada, kPassword, tim->personId(), "", false).error().code,
             core::ErrorCode::badInput);
    QCOMPARE(accounts.erasePerson(*ada, kPassword, ada->personId(), "wish", false).error().code,
             core::ErrorCode::wrongUse);
    QCOMPARE(accounts.erasePerson(*ada, kPassword, Actor::kSimulatedPerson, "wish", false).error().code,
             core::ErrorCode::wrongUse);
    QCOMPARE(accounts.erasePerson(*ada, kPassword, 4711, "wish", false).error().code,
             core::ErrorCode::notFound);
    QCOMPARE(accounts.erasePerson(*tim, kPassword, ada->personId(), "wish", false).error().code,
             core::ErrorCode::notAllowed);
    REQUIRE(accounts.login("tim", kPassword));
}

void TestPrivacy::erasureTellsWhenAReaderKeepsOldPages() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    auto reader = f.database->openReader();
    REQUIRE(reader);
    REQUIRE((*reader)->execute("BEGIN"));
    QVERIFY(selectInteger(**reader, "SELECT count(*) FROM person").has_value()); // a snapshot from before
    const auto told = AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true);
    QVERIFY(!told);
    QVERIFY2(told.error().message.find("reading the database") != std::string::npos,
             told.error().message.c_str());
    (*reader)->rollback();
    QVERIFY(!AccountService(*f.database).login("tim", kPassword)); // erased all the same
    REQUIRE(AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true));
}

void TestPrivacy::erasureGoesOnWhereItStopped() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "timotheus-unverwechselbar", {Role::trainee});
    const auto id = storeSession(*f.database, *tim);
    REQUIRE(id);
    AccountService accounts(*f.database);
    const QString list = QString::fromStdString(erasureListFile(f.database->siteFolder()));
    QVERIFY(QDir().mkpath(list)); // a folder in the list's place: it cannot be written
    QVERIFY(!accounts.erasePerson(*ada, kPassword, tim->personId(), "first wish", false));
    QVERIFY(onDisk(f.path(), "timotheus-unverwechselbar")); // it stopped before the old pages were forgotten
    QVERIFY(QDir().rmdir(list));
    REQUIRE(accounts.erasePerson(*ada, kPassword, tim->personId(), "second wish", false));
    QVERIFY(!onDisk(f.path(), "timotheus-unverwechselbar"));
    auto listed = readErasureList(list.toStdString());
    REQUIRE(listed);
    QCOMPARE(listed->size(), std::size_t{1});
    QCOMPARE(listed->front().reason, std::string("first wish")); // the tombstone is what it was
    // Recordings can be withdrawn afterwards.
    auto reader = f.database->openReader();
    QVERIFY(SessionReader(**reader, *ada).openChunks(*id).has_value());
    reader->reset();
    REQUIRE(accounts.erasePerson(*ada, kPassword, tim->personId(), "withdrew", true));
    reader = f.database->openReader();
    QVERIFY(!SessionReader(**reader, *ada).openChunks(*id));
    reader->reset();
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
}

void TestPrivacy::filesAreTheirOwnersAlone() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(storeSession(*f.database, Actor::simulated()));
    const auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ReadOther | QFile::WriteOther;
    for (const char* suffix : {"", "-wal", "-shm", ".site/site.key"}) {
        const QString name = QString::fromStdString(f.path() + suffix);
        QVERIFY2(QFile::exists(name) && (QFile::permissions(name) & others) == QFile::Permissions(),
                 qPrintable(name));
    }
}

QTEST_GUILESS_MAIN(TestPrivacy)
#include "test_privacy.moc"
