// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_site.h"

#include "core/random.h"
#include "database/integrity/digested_row.h"
#include "database/query.h"
#include "database/schema/migration_runner.h"

#include <QFile>
#include <QRegularExpression>
#include <algorithm>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

/// verify: what it finds.
class TestVerify : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void soundDatabaseHasNoFindings();
    void digestsCoverEveryColumn();
    void tablesAreAskedSinceTheVersionThatBroughtThem();
    void everyTableIsGuarded_data();
    void everyTableIsGuarded();
    void payloadAndTextsAreGuarded();
    void rowRemovedWithItsIndexIsFound();
    void rowChangedWithItsDigestIsFound();
    void rowAddedWithItsDigestIsFound();
    void auditEditGapReorderSpliceTruncation_data();
    void auditEditGapReorderSpliceTruncation();
    void forgedHeadIsFound();
    void missingKeyIsTold();
    void scoreCheckIsAskedForEachSession();
    void scoreCheckIsAskedWhereThereIsSomethingToCheck();
    void watchHearsAllOfIt();
    void watchEndsIt();
    void noiseIsAFinding();
    void rowsBehindABrokenPageAreChecked();

private:
    std::string damagedCopy(const std::string& sql);

    DatabaseFixture m;
};

void TestVerify::initTestCase() {
    REQUIRE(makeSite(m));
}

std::string TestVerify::damagedCopy(const std::string& sql) {
    return test::damagedCopy(m, sql);
}

void TestVerify::soundDatabaseHasNoFindings() {
    const VerifyReport report = verifyDatabase(m.path(), m.options);
    QVERIFY2(report.ok(),
             report.ok()
                 ? ""
                 : (report.findings[0].kind + report.findings[0].table + report.findings[0].detail).c_str());
    QVERIFY(report.rowsChecked > 60);
}

void TestVerify::digestsCoverEveryColumn() {
    auto connection = Connection::open(m.path(), Connection::Mode::readOnly);
    REQUIRE(connection);
    auto query = Query::run(**connection,
                            "SELECT m.name, c.name FROM sqlite_schema m, pragma_table_info(m.name) c WHERE "
                            "m.type = 'table' AND m.name NOT IN ('meta', 'audit', 'sqlite_stat1')");
    REQUIRE(query);
    std::size_t stored = 0;
    while (query->next().value_or(false)) {
        const DigestedTable& table = digestedTable(query->text(0));
        const std::string column = query->text(1);
        const bool covered =
            std::find(table.columns.begin(), table.columns.end(), column) != table.columns.end();
        QVERIFY2(covered || column == "digest" || column == table.hashedColumn,
                 (query->text(0) + "." + column).c_str());
        stored += covered ? 1 : 0;
    }
    std::size_t listed = 0;
    for (const DigestedTable& table : digestedTables()) {
        listed += table.columns.size();
    }
    QCOMPARE(stored, listed);
}

/// Else a database of an earlier version, opened to be read, would be asked for a table that it cannot have.
void TestVerify::tablesAreAskedSinceTheVersionThatBroughtThem() {
    for (const DigestedTable& table : digestedTables()) {
        const QRegularExpression made(
            QStringLiteral("CREATE TABLE %1\\b").arg(QString::fromStdString(std::string(table.name))));
        int brought = 0;
        for (const Migration& migration : builtInMigrations())
            if (brought == 0 && QString::fromStdString(migration.sql).contains(made))
                brought = migration.version;
        QVERIFY2(brought > 0, std::string(table.name).c_str());
        QVERIFY2(table.since == brought, std::string(table.name).c_str());
    }
}

void TestVerify::everyTableIsGuarded_data() {
    QTest::addColumn<QString>("table");
    QTest::addColumn<QString>("column");
    for (const DigestedTable& table : digestedTables()) {
        for (const std::string_view column : table.columns) {
            QTest::addRow("%s.%s", std::string(table.name).c_str(), std::string(column).c_str())
                << QString::fromStdString(std::string(table.name))
                << QString::fromStdString(std::string(column));
        }
    }
}

void TestVerify::everyTableIsGuarded() {
    QFETCH(QString, table);
    QFETCH(QString, column);
    // One column of the first row, changed to another value of its kind; checks are off, as a hex editor
    // knows none.
    const std::string name = table.toStdString();
    const std::string c = column.toStdString();
    const std::string copy = damagedCopy(
        "PRAGMA ignore_check_constraints=ON; UPDATE " + name + " SET " + c + " = CASE typeof(" + c +
        ") WHEN 'integer' THEN " + c + " + 1000 WHEN 'real' THEN " + c + " + 1e-9 WHEN 'text' THEN " + c +
        " || 'x' WHEN 'blob' THEN zeroblob(32) ELSE (SELECT CASE type WHEN 'INTEGER' THEN 1 WHEN 'REAL' THEN "
        "1.5 "
        "WHEN 'BLOB' THEN zeroblob(32) ELSE 'x' END FROM pragma_table_info('" +
        name + "') WHERE name = '" + c + "') END WHERE rowid = (SELECT min(rowid) FROM " + name + ");");
    QVERIFY(!copy.empty());
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    QVERIFY(has(verifyDatabase(copy, options), "digest", name));
}

void TestVerify::payloadAndTextsAreGuarded() {
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    QVERIFY(
        has(verifyDatabase(damagedCopy("UPDATE chunk SET payload = zeroblob(length(payload)) WHERE id = 3;"),
                           options),
            "payload", "chunk", "session_id=1 sequence=2"));
    QVERIFY(has(verifyDatabase(damagedCopy("UPDATE chunk SET payload = x'' WHERE id = 3;"), options),
                "payload", "chunk")); // emptied, but no erasure
    QVERIFY(has(verifyDatabase(damagedCopy("UPDATE session_comment SET text = 'shaky hand';"), options),
                "payload", "session_comment"));
    QVERIFY(has(verifyDatabase(damagedCopy("UPDATE session SET void_reason = '' WHERE id = 2;"), options),
                "payload", "session"));
}

void TestVerify::rowRemovedWithItsIndexIsFound() {
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    VerifyReport report = verifyDatabase(damagedCopy("DELETE FROM chunk WHERE id = 8;"), options);
    QVERIFY(has(report, "missing", "chunk", "session_id=2 sequence=1"));
    QVERIFY(has(report, "seal", "session", "id=2"));
    report = verifyDatabase(damagedCopy("DELETE FROM score WHERE rowid = 2;"), options);
    QVERIFY(has(report, "missing", "score", "session_id=1"));
    QVERIFY(has(verifyDatabase(damagedCopy("DELETE FROM trial WHERE session_id = 1;"), options), "seal",
                "session", "id=1"));
    QVERIFY(has(verifyDatabase(damagedCopy("DELETE FROM event WHERE session_id = 1;"), options), "seal",
                "session", "id=1"));
    report = verifyDatabase(
        damagedCopy("DELETE FROM score WHERE score_set_id = 2; DELETE FROM score_set WHERE id = 2;"),
        options);
    QVERIFY(
        has(report, "missing", "score_set", "id=2")); // a whole result, with everything that referred to it
    report = verifyDatabase(damagedCopy("DELETE FROM session WHERE id = 3;"), options);
    QVERIFY(has(report, "missing", "session", "id=3"));
    QVERIFY(has(report, "foreign_key", "chunk"));
}

void TestVerify::rowChangedWithItsDigestIsFound() {
    // Somebody who knows how digests are made, but not the site's key, makes a trainee an administrator and a
    // score better.
    const std::string copy = damagedCopy("");
    QVERIFY(!copy.empty());
    {
        auto connection = Connection::create(copy);
        REQUIRE(connection);
        REQUIRE(updateRow(**connection, "person", {{"id", std::int64_t{2}}},
                          {{"roles", std::string("trainee,admin")}}));
        REQUIRE(updateRow(**connection, "session", {{"id", std::int64_t{1}}}, {{"level", std::int64_t{3}}}));
        REQUIRE(
            updateRow(**connection, "score_set", {{"id", std::int64_t{1}}}, {{"passed", std::int64_t{0}}}));
        REQUIRE(updateRow(**connection, "score",
                          {{"score_set_id", std::int64_t{1}}, {"trial", std::int64_t{0}}},
                          {{"value", 0.001}}));
        REQUIRE((*connection)->execute("UPDATE meta SET value = '1' WHERE key = 'demonstration'"));
    }
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    const VerifyReport report = verifyDatabase(copy, options);
    QVERIFY(has(report, "audit", "person", "id=2"));
    QVERIFY(has(report, "audit", "session", "id=1"));
    QVERIFY(has(report, "audit", "score_set", "id=1"));
    QVERIFY(has(report, "seal", "score_set", "id=1"));
    QVERIFY(has(report, "audit", "audit", "sequence=1")); // the chain grew out of another identity
    QVERIFY(!has(report, "digest", "person"));
}

void TestVerify::rowAddedWithItsDigestIsFound() {
    // The same somebody adds an administrator of his own, a decision on a session, and better scores to it.
    const std::string copy = damagedCopy("");
    QVERIFY(!copy.empty());
    {
        auto connection = Connection::create(copy);
        REQUIRE(connection);
        REQUIRE(insertRow(**connection, "person",
                          {{"id", std::int64_t{77}},
                           {"kind", std::string("person")},
                           {"name", std::string("mallory")},
                           {"name_key", std::string("mallory")},
                           {"display_name", std::string()},
                           {"roles", std::string("admin")},
                           {"enabled", std::int64_t{1}},
                           {"created_utc", std::string("2026-01-01T00:00:00.000Z")}}));
        REQUIRE(insertRow(**connection, "session_decision",
                          {{"id", std::int64_t{79}},
                           {"session_id", std::int64_t{1}},
                           {"decision", std::string("void")},
                           {"person_id", std::int64_t{2}},
                           {"utc", std::string("2026-01-01T00:00:00.000Z")},
                           {"reason", std::string("no reason")},
                           {"reason_hash", toBlob(textDigest("no reason"))}}));
        const std::vector<std::uint8_t> empty(8, 0); // a seal over no scores: their number
        REQUIRE(insertRow(**connection, "score_set",
                          {{"id", std::int64_t{78}},
                           {"session_id", std::int64_t{1}},
                           {"ordinal", std::int64_t{9}},
                           {"utc", std::string("2026-01-01T00:00:00.000Z")},
                           {"passed", std::int64_t{1}},
                           {"trials", std::int64_t{0}},
                           {"scores", std::int64_t{0}},
                           {"seal", toBlob(bytesDigest(empty))}}));
    }
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    const VerifyReport report = verifyDatabase(copy, options);
    QVERIFY(has(report, "audit", "person", "id=77"));
    QVERIFY(has(report, "audit", "score_set", "id=78"));
    QVERIFY(has(report, "audit", "session_decision", "id=79")); // the newest of the tables, too
    QVERIFY(!has(report, "audit", "person", "id=1"));
    QCOMPARE(report.findings.size(), std::size_t{3}); // nothing else tells
}

void TestVerify::auditEditGapReorderSpliceTruncation_data() {
    QTest::addColumn<QString>("sql");
    QTest::newRow("edit") << "UPDATE audit SET actor_id = 77 WHERE sequence = 3;";
    QTest::newRow("edit time") << "UPDATE audit SET utc = '2020-01-01T00:00:00.000Z' WHERE sequence = 3;";
    QTest::newRow("edit detail")
        << "UPDATE audit SET detail_json = '{}' WHERE sequence = (SELECT max(sequence) FROM audit);";
    QTest::newRow("gap") << "DELETE FROM audit WHERE sequence = 4;";
    QTest::newRow("gap closed") << "DELETE FROM audit WHERE sequence = 4; UPDATE audit SET sequence = "
                                   "sequence - 1 WHERE sequence > 4;";
    QTest::newRow("reorder") << "UPDATE audit SET sequence = 9999 WHERE sequence = 3; UPDATE audit SET "
                                "sequence = 3 WHERE sequence = 4;"
                                "UPDATE audit SET sequence = 4 WHERE sequence = 9999;";
    QTest::newRow("splice")
        << "INSERT INTO audit SELECT max(sequence) + 1, '2026-01-01T00:00:00.000Z', 'person', 2, 'setRoles', "
           "'person', 3, '{}', "
           "(SELECT mac FROM audit ORDER BY sequence DESC LIMIT 1), randomblob(32) FROM audit;";
    QTest::newRow("first") << "DELETE FROM audit WHERE sequence = 1;";
    QTest::newRow("truncation by one")
        << "DELETE FROM audit WHERE sequence = (SELECT max(sequence) FROM audit);";
    QTest::newRow("truncation") << "DELETE FROM audit WHERE sequence > 2;";
    QTest::newRow("all") << "DELETE FROM audit;";
}

void TestVerify::auditEditGapReorderSpliceTruncation() {
    QFETCH(QString, sql);
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    const std::string copy = damagedCopy(sql.toStdString());
    QVERIFY(!copy.empty());
    const VerifyReport report = verifyDatabase(copy, options);
    QVERIFY(has(report, "audit", "audit"));
    if (QLatin1String(QTest::currentDataTag()) == QLatin1String("gap")) {
        QVERIFY(std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& f) {
            return f.row == "sequence=5" && f.detail.ends_with("expected sequence 4");
        }));
    }
}

void TestVerify::forgedHeadIsFound() {
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(storeSession(*f.database, Actor::simulated(), 1));
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());
    QFile head(QString::fromStdString(f.path() + ".site/audit_head.json"));
    QVERIFY(head.open(QIODevice::ReadOnly));
    QByteArray text = head.readAll();
    head.close();
    const qsizetype digit = text.indexOf("\"count\": ") + 9;
    text[digit] = '2';
    QVERIFY(head.open(QIODevice::WriteOnly | QIODevice::Truncate));
    head.write(text);
    head.close();
    QVERIFY(has(verifyDatabase(f.path(), f.options), "audit", "audit"));
    QVERIFY(head.remove());
    QVERIFY(has(verifyDatabase(f.path(), f.options), "audit", "audit"));
}

void TestVerify::missingKeyIsTold() {
    DatabaseFixture f;
    REQUIRE(f.create());
    f.database.reset();
    QFile key(QString::fromStdString(f.path() + ".site/site.key"));
    QCOMPARE(key.permissions() &
                 (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther),
             QFile::Permissions());
    QVERIFY(key.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
    QCOMPARE(Database::openForWriting(f.path(), f.options).error().code, core::ErrorCode::storage);
    QVERIFY(key.remove());
    const VerifyReport report = verifyDatabase(f.path(), f.options);
    QVERIFY(has(report, "audit", "audit") &&
            report.findings[0].detail.find("key is missing") != std::string::npos);
    QCOMPARE(Database::openForWriting(f.path(), f.options).error().code, core::ErrorCode::notFound);
    REQUIRE(Database::openReadOnly(f.path(), f.options)); // reading needs no key
}

void TestVerify::scoreCheckIsAskedForEachSession() {
    std::vector<SessionId> asked;
    const VerifyReport report = verifyDatabase(
        m.path(), m.options, [&](Connection& connection, SessionId id) -> std::vector<Finding> {
            asked.push_back(id);
            const auto card = ScoreRepository(connection, Actor::maintenance()).scores(id);
            return card && id == 2 ? std::vector<Finding>{{"score", "score", "session_id=2", "differs"}}
                                   : std::vector<Finding>{};
        });
    QCOMPARE(asked, (std::vector<SessionId>{1, 2, 3}));
    QCOMPARE(report.findings.size(), std::size_t{1});
    QCOMPARE(report.findings[0].kind, std::string("score"));
}

// Scores are not checked of a session that has none, still runs, or has lost its recording to an erasure.
void TestVerify::scoreCheckIsAskedWhereThereIsSomethingToCheck() {
    DatabaseFixture f;
    REQUIRE(f.create());
    const auto ada = f.administrator();
    const auto tim = f.person(*ada, "tim", {Role::trainee});
    REQUIRE(tim);
    const auto begin = [&] {
        return f.database->write([&](WriteContext& w) {
            return SessionRepository(w.connection(), *ada).beginSession(someSession());
        });
    };
    const auto unscored = begin();
    REQUIRE(unscored);
    REQUIRE(f.database->write([&](WriteContext& w) {
        return SessionRepository(w.connection(), *ada)
            .finishSession(*unscored, {SessionState::stopped, 5, 5, 0, "{}"});
    }));
    const auto scored = storeSession(*f.database, *ada, 1);
    const auto erased = storeSession(*f.database, *tim, 1);
    REQUIRE(scored);
    REQUIRE(erased);
    REQUIRE(AccountService(*f.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true));
    REQUIRE(begin());
    f.database.reset();
    std::vector<SessionId> asked;
    const VerifyReport report =
        verifyDatabase(f.path(), f.options, [&](Connection&, SessionId id) -> std::vector<Finding> {
            asked.push_back(id);
            return {};
        });
    QVERIFY2(report.ok(), report.ok() ? "" : report.findings.front().detail.c_str());
    QCOMPARE(asked, std::vector<SessionId>{*scored});
}

// From nothing to all of it, in steps of which a session's scores are 500 and a row is one; asked every 64
// steps, no oftener.
void TestVerify::watchHearsAllOfIt() {
    using Told = std::vector<std::pair<std::uint64_t, std::uint64_t>>;
    const auto heard = [&](const ScoreCheck& check) {
        Told told;
        const VerifyReport report =
            verifyDatabase(m.path(), m.options, check, [&](std::uint64_t done, std::uint64_t of) {
                told.emplace_back(done, of);
                return true;
            });
        return report.ok() ? told : Told{};
    };
    auto connection = Connection::open(m.path(), Connection::Mode::readOnly);
    REQUIRE(connection);
    std::uint64_t rows = 0;
    for (const DigestedTable& table : digestedTables()) {
        rows += static_cast<std::uint64_t>(
            selectInteger(**connection, "SELECT count(*) FROM " + std::string(table.name))->value_or(0));
    }
    QVERIFY(rows > 64);
    Told expected;
    for (std::uint64_t done = 0; done <= rows; done += 64) {
        expected.emplace_back(done, rows);
    }
    QCOMPARE(heard({}), expected);
    const auto sound = [](Connection&, SessionId) { return std::vector<Finding>{}; };
    for (auto& [done, of] : expected) {
        of = rows + 1500; // three sessions
    }
    for (std::uint64_t session = 1; session <= 3; ++session) {
        expected.emplace_back(rows + 500 * session, rows + 1500);
    }
    QCOMPARE(heard(sound), expected);
}

void TestVerify::watchEndsIt() {
    for (const int after : {0, 1}) {
        int asked = 0;
        std::vector<SessionId> checked;
        const VerifyReport report = verifyDatabase(
            m.path(), m.options,
            [&](Connection&, SessionId id) {
                checked.push_back(id);
                return std::vector<Finding>{};
            },
            [&](std::uint64_t, std::uint64_t) { return asked++ < after; });
        QVERIFY(report.cancelled && !report.ok());
        QCOMPARE(asked, after + 1); // not asked again
        QCOMPARE(report.rowsChecked, static_cast<std::uint64_t>(64 * after));
        QVERIFY(report.findings.empty() && checked.empty()); // what was not looked at is not called missing
    }
    std::vector<SessionId> checked;
    const VerifyReport report = verifyDatabase(
        m.path(), m.options,
        [&](Connection&, SessionId id) {
            checked.push_back(id);
            return std::vector<Finding>{};
        },
        [&](std::uint64_t, std::uint64_t) { return checked.size() < 2; });
    QVERIFY(report.cancelled && report.findings.empty());
    QCOMPARE(checked, (std::vector<SessionId>{1, 2}));
}

void TestVerify::noiseIsAFinding() {
    const std::string noise = m.path("noise.db");
    core::Random random(7);
    for (const int size : {0, 1, 99, 100, 4096, 20000}) {
        QFile file(QString::fromStdString(noise));
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        QByteArray bytes("SQLite format 3\0", 16);
        while (bytes.size() < size) {
            bytes.append(static_cast<char>(random.next()));
        }
        file.write(bytes.left(size));
        file.close();
        QVERIFY(has(verifyDatabase(noise, m.options), "file", ""));
    }
    QVERIFY(has(verifyDatabase(m.path("nothing.db"), m.options), "file", ""));
}

// If one page of a table cannot be read, its rows are reported as one range, and the rows behind it are
// checked.
void TestVerify::rowsBehindABrokenPageAreChecked() {
    constexpr int kEvents = 400, kMiddle = 200, kChanged = 390;
    const auto word = [](int i) {
        return QStringLiteral("row-%1.").arg(i, 4, 10, QLatin1Char('0')).toLatin1();
    };
    DatabaseFixture f;
    REQUIRE(f.create());
    REQUIRE(f.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), Actor::simulated());
        const auto id = sessions.beginSession(someSession());
        CHIRON_TRY(id);
        std::vector<EventRecord> events;
        for (int i = 0; i < kEvents; ++i)
            events.push_back({static_cast<std::uint64_t>(i), 0.001 * i, 0, word(i).toStdString(), "{}"});
        CHIRON_TRY(sessions.storeEvents(*id, events));
        return sessions.finishSession(*id, {SessionState::completed, 1000, 1000, 0, "{}"});
    }));
    f.database.reset();
    QVERIFY(verifyDatabase(f.path(), f.options).ok());

    QByteArray bytes = contentOf(f.path());
    const qsizetype page =
        256 * static_cast<unsigned char>(bytes[16]) + static_cast<unsigned char>(bytes[17]);
    QVERIFY(page >= 512);
    const qsizetype start = bytes.indexOf(word(kMiddle)) / page * page;
    const auto inside = [&](int i) {
        const qsizetype at = bytes.indexOf(word(i));
        return at >= start && at < start + page;
    };
    int first = kMiddle, last = kMiddle;
    while (inside(first - 1))
        --first;
    while (inside(last + 1))
        ++last;
    QVERIFY(start > 0 && first > 1 && last < kChanged - 1);
    bytes[bytes.indexOf(word(kChanged)) + 4] = '9';
    bytes[start] = '\x7f'; // no kind of page
    QFile file(QString::fromStdString(f.path()));
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    QCOMPARE(file.write(bytes), bytes.size());
    file.close();

    const VerifyReport report = verifyDatabase(f.path(), f.options);
    QVERIFY(has(report, "digest", "event", "ordinal=" + std::to_string(kChanged)));
    QStringList ranges;
    for (const Finding& finding : report.findings)
        if (finding.kind == "unreadable" && finding.table == "event")
            ranges << QString::fromStdString(finding.row);
    QCOMPARE(ranges.size(), 1);
    const auto range = QRegularExpression(QStringLiteral("^rowid (\\d+)\\.\\.(\\d+)$")).match(ranges.front());
    QVERIFY2(range.hasMatch(), qPrintable(ranges.front()));
    // Rows count from 1, and the first one behind the page may be given up with it.
    QCOMPARE(range.captured(1).toInt(), first + 1);
    QVERIFY2(range.captured(2).toInt() >= last + 1 && range.captured(2).toInt() <= last + 2,
             qPrintable(ranges.front()));
}

QTEST_GUILESS_MAIN(TestVerify)
#include "test_verify.moc"
