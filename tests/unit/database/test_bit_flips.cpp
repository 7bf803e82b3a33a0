// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_site.h"

#include "core/random.h"
#include "database/query.h"

#include <algorithm>
#include <map>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

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
    const std::string sql = chunk ? "SELECT 'session_id=' || session_id || ' sequence=' || sequence, "
                                    "hex(payload) || '|' || quote(first_tick) || quote(frames) || "
                                    "hex(payload_hash) || hex(payload_digest) || hex(force_hash) || "
                                    "hex(digest) || quote(id), 'session_id=' || session_id FROM chunk "
                                    "NOT INDEXED WHERE rowid = ?"
                                  : "SELECT 'score_set_id=' || score_set_id || ' trial=' || trial || ' "
                                    "metric=' || metric, quote(score_set_id) || quote(trial) || "
                                    "quote(ordinal) || hex(CAST(metric AS BLOB)) || quote(version) || "
                                    "hex(CAST(unit AS BLOB)) || typeof(value) || quote(value) || "
                                    "hex(CAST(reason AS BLOB)) || quote(passed) || hex(digest), 'id=' || "
                                    "score_set_id || ' ' FROM score NOT INDEXED WHERE rowid = ?";
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
    return finding.kind == "unreadable" &&
           (read == 2 ? first <= rowid && rowid <= last : read == 1 && first <= rowid);
}

// Whether verify told of this damaged row: by its key, its number, as missing, or because nothing can be read
// at all.
bool reported(const VerifyReport& report, const std::string& table, const KnownRow& row) {
    return std::any_of(report.findings.begin(), report.findings.end(), [&](const Finding& f) {
        if (f.kind == "file") {
            return true;
        }
        if (table == "score" && (f.kind == "missing" || f.kind == "seal") &&
            (f.table == "score" || f.table == "score_set")) {
            return (f.row + " ").find(row.owner) != std::string::npos;
        }
        return f.table == table &&
               (f.row == row.key || inUnreadableRange(f, row.rowid) ||
                f.detail.find("(rowid " + std::to_string(row.rowid) + ")") != std::string::npos);
    });
}

} // namespace

/// Random damage to the file: verify tells of every damaged chunk and score, and never stumbles.
class TestBitFlips : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void singleBitFlips_data();
    void singleBitFlips();
    void manyFlipsAtOnce();

private:
    void flipAndCheck(const QByteArray& sound, const std::vector<std::size_t>& bits);

    DatabaseFixture m;
    std::map<std::int64_t, KnownRow> m_chunks;
    std::map<std::int64_t, KnownRow> m_scores;
    int m_damaged = 0; ///< chunks and scores that the flips of a test have damaged
};

void TestBitFlips::initTestCase() {
    REQUIRE(makeSite(m));
    auto connection = Connection::open(m.path(), Connection::Mode::readOnly);
    REQUIRE(connection);
    m_chunks = rowsOf(**connection, "chunk");
    m_scores = rowsOf(**connection, "score");
    QCOMPARE(m_chunks.size(), std::size_t{14});
    QCOMPARE(m_scores.size(), std::size_t{12});
}

void TestBitFlips::flipAndCheck(const QByteArray& sound, const std::vector<std::size_t>& bits) {
    const std::string copy = m.path("flipped.db");
    QByteArray bytes = sound;
    for (const std::size_t bit : bits) {
        bytes[static_cast<qsizetype>(bit / 8)] =
            static_cast<char>(bytes[static_cast<qsizetype>(bit / 8)] ^ (1 << (bit % 8)));
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
    for (const auto& [table, known] :
         {std::pair{std::string("chunk"), &m_chunks}, {std::string("score"), &m_scores}}) {
        const auto now = rowsOf(**connection, table);
        for (const auto& [rowid, row] : *known) {
            const auto found = now.find(rowid);
            const bool damaged = found == now.end() || found->second.content != row.content;
            m_damaged += damaged ? 1 : 0;
            QVERIFY2(!damaged || reported(report, table, row),
                     (table + " " + row.key + ", bit " + std::to_string(bits.front())).c_str());
        }
    }
}

void TestBitFlips::singleBitFlips_data() {
    QTest::addColumn<int>("flips");
    QTest::newRow("flips") << qEnvironmentVariableIntValue("CHIRON_BIT_FLIPS");
}

void TestBitFlips::singleBitFlips() {
    QFETCH(int, flips);
    QFile file(QString::fromStdString(m.path()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray sound = file.readAll();
    core::Random random(20261120);
    m_damaged = 0;
    for (int i = 0; i < std::max(flips, 40); ++i) {
        flipAndCheck(sound, {random.below(static_cast<std::uint64_t>(sound.size()) * 8)});
    }
    QVERIFY2(m_damaged >= std::max(flips, 40) / 10,
             qPrintable(QString::number(m_damaged))); // else this showed nothing
}

void TestBitFlips::manyFlipsAtOnce() {
    const int rounds = std::max(qEnvironmentVariableIntValue("CHIRON_BIT_FLIPS") / 25, 2);
    QFile file(QString::fromStdString(m.path()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray sound = file.readAll();
    core::Random random(42);
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::size_t> bits;
        for (int i = 0; i < 25 * (round + 1); ++i) {
            bits.push_back(800 + random.below(static_cast<std::uint64_t>(sound.size()) * 8 -
                                              800)); // behind the header: it opens
        }
        flipAndCheck(sound, bits);
    }
}

QTEST_GUILESS_MAIN(TestBitFlips)
#include "test_bit_flips.moc"
