// SPDX-License-Identifier: GPL-3.0-or-later
#include "database_fixture.h"

#include "core/random.h"
#include "database/audit/audit_trail.h"
#include "database/integrity/digested_row.h"
#include "database/integrity/verifier.h"
#include "database/query.h"
#include "database/repositories/audit_repository.h"

#include <QFile>
#include <algorithm>
#include <map>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

bool has(const VerifyReport& report, const std::string& kind, const std::string& table, const std::string& row = {}) {
    return std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) {
        return f.kind == kind && f.table == table && f.row.find(row) != std::string::npos;
    });
}

/// A row with what identifies it for people and by number.
struct KnownRow {
    std::string key;
    std::int64_t rowid = 0;
    std::string content; ///< everything in it, as hex
    std::string owner;   ///< "session_id=3" or "id=7 " of its score set
};

// Chunks and scores of a file, each read on its own, so that one damaged row hides no other.
std::map<std::int64_t, KnownRow> rowsOf(Connection& connection, const std::string& table) {
    const bool chunk = table == "chunk";
    const std::string sql =
        chunk ? "SELECT 'session_id=' || session_id || ' sequence=' || sequence, hex(payload) || '|' || quote(first_tick) || quote(frames) || "
                "hex(payload_hash) || hex(payload_digest) || hex(force_hash) || hex(digest) || quote(id), 'session_id=' || session_id FROM chunk "
                "NOT INDEXED WHERE rowid = ?"
              : "SELECT 'score_set_id=' || score_set_id || ' trial=' || trial || ' metric=' || metric, quote(score_set_id) || quote(trial) || "
                "quote(ordinal) || hex(CAST(metric AS BLOB)) || quote(version) || hex(CAST(unit AS BLOB)) || typeof(value) || quote(value) || "
                "hex(CAST(reason AS BLOB)) || quote(passed) || hex(digest), 'id=' || score_set_id || ' ' FROM score NOT INDEXED WHERE rowid = ?";
    std::map<std::int64_t, KnownRow> rows;
    for (std::int64_t rowid = 1; rowid <= 200; ++rowid) {
        auto query = Query::run(connection, sql, {rowid});
        const auto row = query ? query->next() : core::Result<bool>(false);
        if (row && *row) {
            rows[rowid] = {query->text(0), rowid, query->text(1), query->text(2)};
        }
    }
    return rows;
}

bool inUnreadableRange(const Finding& finding, std::int64_t rowid) {
    long long first = 0;
    long long last = 0;
    const int read = std::sscanf(finding.row.c_str(), "rowid %lld..%lld", &first, &last);
    return finding.kind == "unreadable" && (read == 2 ? first <= rowid && rowid <= last : read == 1 && first <= rowid);
}

// Whether verify told of this damaged row: by its key, its number, as missing, or because nothing can be read at all.
bool reported(const VerifyReport& report, const std::string& table, const KnownRow& row) {
    return std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) {
        if (f.kind == "file") {
            return true;
        }
        if (table == "score" && (f.kind == "missing" || f.kind == "seal") && (f.table == "score" || f.table == "score_set")) {
            return (f.row + " ").find(row.owner) != std::string::npos;
        }
        return f.table == table && (f.row == row.key || inUnreadableRange(f, row.rowid) ||
                                    f.detail.find("(rowid " + std::to_string(row.rowid) + ")") != std::string::npos);
    });
}

} // namespace

/// verify: what it finds, and that nothing makes it stumble.
class TestVerify : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void soundDatabaseHasNoFindings();
    void everyTableIsGuarded_data();
    void everyTableIsGuarded();
    void payloadAndTextsAreGuarded();
    void rowRemovedWithItsIndexIsFound();
    void rowChangedWithItsDigestIsFound();
    void auditEditGapReorderSpliceTruncation_data();
    void auditEditGapReorderSpliceTruncation();
    void forgedHeadIsFound();
    void missingKeyIsTold();
    void scoreCheckIsAskedForEachSession();
    void noiseIsAFinding();
    void singleBitFlips_data();
    void singleBitFlips();
    void manyFlipsAtOnce();

private:
    std::string damagedCopy(const std::string& sql);
    void flipAndCheck(const QByteArray& sound, const std::vector<std::size_t>& bits);

    DatabaseFixture m;
    Actor m_ada = Actor::anonymous();
    std::map<std::int64_t, KnownRow> m_chunks;
    std::map<std::int64_t, KnownRow> m_scores;
    int m_damaged = 0; ///< chunks and scores that the flips of a test have damaged
};

void TestVerify::initTestCase() {
    REQUIRE(m.create());
    const auto ada = m.administrator();
    REQUIRE(ada);
    m_ada = *ada;
    REQUIRE(storeSession(*m.database, Actor::simulated(), 6, 9000));
    const auto id = storeSession(*m.database, *ada, 5, 5000);
    REQUIRE(id);
    REQUIRE(storeSession(*m.database, Actor::simulated(), 3));
    REQUIRE(m.database->write([&](WriteContext& w) -> core::Result<void> {
        SessionRepository sessions(w.connection(), *ada);
        auto comment = sessions.addComment(*id, "steady hand");
        return comment ? sessions.voidSession(*id, "the chair fell over") : tl::unexpected(comment.error());
    }));
    const auto tim = m.person(*ada, "tim", {Role::trainee});
    REQUIRE(AccountService(*m.database).erasePerson(*ada, kPassword, tim->personId(), "wish", true));
    m.database.reset(); // into one file
    auto connection = Connection::open(m.path(), Connection::Mode::readOnly);
    REQUIRE(connection);
    m_chunks = rowsOf(**connection, "chunk");
    m_scores = rowsOf(**connection, "score");
    QCOMPARE(m_chunks.size(), std::size_t{14});
    QCOMPARE(m_scores.size(), std::size_t{12});
}

std::string TestVerify::damagedCopy(const std::string& sql) {
    const std::string copy = m.path("copy.db");
    QFile::remove(QString::fromStdString(copy));
    if (!QFile::copy(QString::fromStdString(m.path()), QString::fromStdString(copy))) {
        return {};
    }
    auto connection = Connection::create(copy);
    const std::string open = "PRAGMA foreign_keys=OFF; PRAGMA synchronous=OFF; PRAGMA journal_mode=DELETE; DROP TRIGGER person_stays; DROP TRIGGER session_stays;"
                             "DROP TRIGGER trial_stays; DROP TRIGGER chunk_stays; DROP TRIGGER score_stays; DROP TRIGGER score_fixed;"
                             "DROP TRIGGER audit_stays; DROP TRIGGER audit_fixed;";
    return connection && (*connection)->execute(open + sql) ? copy : std::string();
}

void TestVerify::soundDatabaseHasNoFindings() {
    const VerifyReport report = verifyDatabase(m.path(), m.options);
    QVERIFY2(report.ok(), report.ok() ? "" : (report.findings[0].kind + report.findings[0].table + report.findings[0].detail).c_str());
    QVERIFY(report.rowsChecked > 60);
}

void TestVerify::everyTableIsGuarded_data() {
    QTest::addColumn<QString>("table");
    QTest::addColumn<QString>("column");
    for (const DigestedTable& table : digestedTables()) {
        for (const std::string_view column : table.columns) {
            QTest::addRow("%s.%s", std::string(table.name).c_str(), std::string(column).c_str())
                << QString::fromStdString(std::string(table.name)) << QString::fromStdString(std::string(column));
        }
    }
}

void TestVerify::everyTableIsGuarded() {
    QFETCH(QString, table);
    QFETCH(QString, column);
    // One column of the first row, changed to another value of its kind; checks are off, as a hex editor knows none.
    const std::string name = table.toStdString();
    const std::string c = column.toStdString();
    const std::string copy = damagedCopy("PRAGMA ignore_check_constraints=ON; UPDATE " + name + " SET " + c + " = CASE typeof(" + c +
                                         ") WHEN 'integer' THEN " + c + " + 1000 WHEN 'real' THEN " + c + " + 1e-9 WHEN 'text' THEN " + c +
                                         " || 'x' WHEN 'blob' THEN zeroblob(32) ELSE (SELECT CASE type WHEN 'INTEGER' THEN 1 WHEN 'REAL' THEN 1.5 "
                                         "WHEN 'BLOB' THEN zeroblob(32) ELSE 'x' END FROM pragma_table_info('" + name + "') WHERE name = '" + c +
                                         "') END WHERE rowid = (SELECT min(rowid) FROM " + name + ");");
    QVERIFY(!copy.empty());
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    QVERIFY(has(verifyDatabase(copy, options), "digest", name));
}

void TestVerify::payloadAndTextsAreGuarded() {
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    QVERIFY(has(verifyDatabase(damagedCopy("UPDATE chunk SET payload = zeroblob(length(payload)) WHERE id = 3;"), options), "payload", "chunk", "session_id=1 sequence=2"));
    QVERIFY(has(verifyDatabase(damagedCopy("UPDATE chunk SET payload = x'' WHERE id = 3;"), options), "payload", "chunk")); // emptied, but no erasure
    QVERIFY(has(verifyDatabase(damagedCopy("UPDATE session_comment SET text = 'shaky hand';"), options), "payload", "session_comment"));
    QVERIFY(has(verifyDatabase(damagedCopy("UPDATE session SET void_reason = '' WHERE id = 2;"), options), "payload", "session"));
}

void TestVerify::rowRemovedWithItsIndexIsFound() {
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    VerifyReport report = verifyDatabase(damagedCopy("DELETE FROM chunk WHERE id = 8;"), options);
    QVERIFY(has(report, "missing", "chunk", "session_id=2 sequence=1"));
    QVERIFY(has(report, "seal", "session", "id=2"));
    report = verifyDatabase(damagedCopy("DELETE FROM score WHERE rowid = 2;"), options);
    QVERIFY(has(report, "missing", "score", "session_id=1"));
    QVERIFY(has(verifyDatabase(damagedCopy("DELETE FROM trial WHERE session_id = 1;"), options), "seal", "session", "id=1"));
    QVERIFY(has(verifyDatabase(damagedCopy("DELETE FROM event WHERE session_id = 1;"), options), "seal", "session", "id=1"));
    report = verifyDatabase(damagedCopy("DELETE FROM score WHERE score_set_id = 2; DELETE FROM score_set WHERE id = 2;"), options);
    QVERIFY(has(report, "missing", "score_set", "id=2")); // a whole result, with everything that referred to it
    report = verifyDatabase(damagedCopy("DELETE FROM session WHERE id = 3;"), options);
    QVERIFY(has(report, "missing", "session", "id=3"));
    QVERIFY(has(report, "foreign_key", "chunk"));
}

void TestVerify::rowChangedWithItsDigestIsFound() {
    // Somebody who knows how digests are made, but not the site's key, makes a trainee an administrator and a score better.
    const std::string copy = damagedCopy("");
    QVERIFY(!copy.empty());
    {
        auto connection = Connection::create(copy);
        REQUIRE(connection);
        REQUIRE(updateRow(**connection, "person", {{"id", std::int64_t{2}}}, {{"roles", std::string("trainee,admin")}}));
        REQUIRE(updateRow(**connection, "session", {{"id", std::int64_t{1}}}, {{"level", std::int64_t{3}}}));
        REQUIRE(updateRow(**connection, "score_set", {{"id", std::int64_t{1}}}, {{"passed", std::int64_t{0}}}));
        REQUIRE(updateRow(**connection, "score", {{"score_set_id", std::int64_t{1}}, {"trial", std::int64_t{0}}}, {{"value", 0.001}}));
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

void TestVerify::auditEditGapReorderSpliceTruncation_data() {
    QTest::addColumn<QString>("sql");
    QTest::newRow("edit") << "UPDATE audit SET actor_id = 77 WHERE sequence = 3;";
    QTest::newRow("edit time") << "UPDATE audit SET utc = '2020-01-01T00:00:00.000Z' WHERE sequence = 3;";
    QTest::newRow("edit detail") << "UPDATE audit SET detail_json = '{}' WHERE sequence = (SELECT max(sequence) FROM audit);";
    QTest::newRow("gap") << "DELETE FROM audit WHERE sequence = 4;";
    QTest::newRow("gap closed") << "DELETE FROM audit WHERE sequence = 4; UPDATE audit SET sequence = sequence - 1 WHERE sequence > 4;";
    QTest::newRow("reorder") << "UPDATE audit SET sequence = 9999 WHERE sequence = 3; UPDATE audit SET sequence = 3 WHERE sequence = 4;"
                                "UPDATE audit SET sequence = 4 WHERE sequence = 9999;";
    QTest::newRow("splice") << "INSERT INTO audit SELECT max(sequence) + 1, '2026-01-01T00:00:00.000Z', 'person', 2, 'setRoles', 'person', 3, '{}', "
                               "(SELECT mac FROM audit ORDER BY sequence DESC LIMIT 1), randomblob(32) FROM audit;";
    QTest::newRow("first") << "DELETE FROM audit WHERE sequence = 1;";
    QTest::newRow("truncation by one") << "DELETE FROM audit WHERE sequence = (SELECT max(sequence) FROM audit);";
    QTest::newRow("truncation") << "DELETE FROM audit WHERE sequence > 2;";
    QTest::newRow("all") << "DELETE FROM audit;";
}

void TestVerify::auditEditGapReorderSpliceTruncation() {
    QFETCH(QString, sql);
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    const std::string copy = damagedCopy(sql.toStdString());
    QVERIFY(!copy.empty());
    QVERIFY(has(verifyDatabase(copy, options), "audit", "audit"));
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
    QCOMPARE(key.permissions() & (QFile::ReadGroup | QFile::ReadOther | QFile::WriteGroup | QFile::WriteOther), QFile::Permissions());
    QVERIFY(key.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadOther));
    QCOMPARE(Database::openForWriting(f.path(), f.options).error().code, core::ErrorCode::storage);
    QVERIFY(key.remove());
    const VerifyReport report = verifyDatabase(f.path(), f.options);
    QVERIFY(has(report, "audit", "audit") && report.findings[0].detail.find("key is missing") != std::string::npos);
    QCOMPARE(Database::openForWriting(f.path(), f.options).error().code, core::ErrorCode::notFound);
    REQUIRE(Database::openReadOnly(f.path(), f.options)); // reading needs no key
}

void TestVerify::scoreCheckIsAskedForEachSession() {
    std::vector<SessionId> asked;
    const VerifyReport report = verifyDatabase(m.path(), m.options, [&](Connection& connection, SessionId id) -> std::vector<Finding> {
        asked.push_back(id);
        const auto card = ScoreRepository(connection, Actor::maintenance()).scores(id);
        return card && id == 2 ? std::vector<Finding>{{"score", "score", "session_id=2", "differs"}} : std::vector<Finding>{};
    });
    QCOMPARE(asked, (std::vector<SessionId>{1, 2, 3}));
    QCOMPARE(report.findings.size(), std::size_t{1});
    QCOMPARE(report.findings[0].kind, std::string("score"));
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

void TestVerify::flipAndCheck(const QByteArray& sound, const std::vector<std::size_t>& bits) {
    const std::string copy = m.path("flipped.db");
    QByteArray bytes = sound;
    for (const std::size_t bit : bits) {
        bytes[static_cast<qsizetype>(bit / 8)] = static_cast<char>(bytes[static_cast<qsizetype>(bit / 8)] ^ (1 << (bit % 8)));
    }
    for (const char* suffix : {"", "-wal", "-shm"}) {
        QFile::remove(QString::fromStdString(copy + suffix));
    }
    QFile file(QString::fromStdString(copy));
    QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
    file.write(bytes);
    file.close();
    DatabaseOptions options = m.options;
    options.siteFolder = m.path() + ".site";
    const VerifyReport report = verifyDatabase(copy, options);
    auto connection = Connection::open(copy, Connection::Mode::readOnly);
    if (!connection) {
        QVERIFY(has(report, "file", ""));
        return;
    }
    for (const auto& [table, known] : {std::pair{std::string("chunk"), &m_chunks}, {std::string("score"), &m_scores}}) {
        const auto now = rowsOf(**connection, table);
        for (const auto& [rowid, row] : *known) {
            const auto found = now.find(rowid);
            const bool damaged = found == now.end() || found->second.content != row.content;
            m_damaged += damaged ? 1 : 0;
            QVERIFY2(!damaged || reported(report, table, row), (table + " " + row.key + ", bit " + std::to_string(bits.front())).c_str());
        }
    }
}

void TestVerify::singleBitFlips_data() {
    QTest::addColumn<int>("flips");
    QTest::newRow("flips") << qEnvironmentVariableIntValue("CHIRON_BIT_FLIPS");
}

void TestVerify::singleBitFlips() {
    QFETCH(int, flips);
    QFile file(QString::fromStdString(m.path()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray sound = file.readAll();
    core::Random random(20261120);
    m_damaged = 0;
    for (int i = 0; i < std::max(flips, 40); ++i) {
        flipAndCheck(sound, {random.below(static_cast<std::uint64_t>(sound.size()) * 8)});
    }
    QVERIFY2(m_damaged >= std::max(flips, 40) / 10, qPrintable(QString::number(m_damaged))); // else this showed nothing
}

void TestVerify::manyFlipsAtOnce() {
    const int rounds = std::max(qEnvironmentVariableIntValue("CHIRON_BIT_FLIPS") / 25, 2);
    QFile file(QString::fromStdString(m.path()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray sound = file.readAll();
    core::Random random(42);
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::size_t> bits;
        for (int i = 0; i < 25 * (round + 1); ++i) {
            bits.push_back(800 + random.below(static_cast<std::uint64_t>(sound.size()) * 8 - 800)); // behind the header: it opens
        }
        flipAndCheck(sound, bits);
    }
}

QTEST_GUILESS_MAIN(TestVerify)
#include "test_verify.moc"
