// SPDX-License-Identifier: GPL-3.0-or-later
// Single flipped bits in copies of a database: verify finds every damaged chunk and score, and nothing
// crashes. CHIRON_FLIPS sets how many of each kind (default 30; the long test: 500).
#include "core/random.h"
#include "raw_database.h"
#include "session/integrity_check.h"
#include "support/patience.h"
#include "support/session_fixture.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QtTest>
#include <cstdio>

using chiron::tests::kPatience_ms;

using namespace chiron;

namespace {

constexpr std::uint64_t kSeed = 20261120;
constexpr int kFewFlips = 30;

int flips() {
    const int asked = qEnvironmentVariableIntValue("CHIRON_FLIPS");
    return asked > 0 ? asked : kFewFlips;
}

database::VerifyReport verify(const QString& file, const QString& siteFolder) {
    database::DatabaseOptions options;
    options.siteFolder = siteFolder.toStdString();
    return session::verifyEverything(file.toStdString(), options);
}

/// A program of its own, so that a crash is seen: prints what verify and SQLite say of the file.
int examine(const QString& file, const QString& siteFolder, const QStringList& tables) {
    const database::VerifyReport report = verify(file, siteFolder);
    QJsonObject content;
    bool sound = false;
    if (const auto raw = RawDatabase::open(file, RawDatabase::Mode::read)) {
        sound = raw->isSound();
        for (const QString& table : tables) {
            const auto hash = raw->contentOf(table);
            content[table] = hash ? QString::fromLatin1(hash->toHex()) : QStringLiteral("unreadable");
        }
    }
    const QJsonObject said{
        {"findings", qint64(report.findings.size())}, {"sound", sound}, {"content", content}};
    std::fputs(QJsonDocument(said).toJson(QJsonDocument::Compact).constData(), stdout);
    return 0;
}

/// What the finding must name; the key itself may be what was flipped.
QStringList namesOf(RawDatabase& raw, const QString& table, std::int64_t rowid) {
    const QStringList keys = table == "chunk" ? QStringList{"session_id", "sequence"}
                                              : QStringList{"score_set_id", "trial", "metric"};
    QStringList names;
    for (const QString& key : keys)
        names << key + '=' +
                     raw.text(QString("SELECT %1 FROM %2 WHERE rowid = %3").arg(key, table).arg(rowid));
    return names;
}

bool isNamed(const database::VerifyReport& report, const QString& table, const QStringList& names) {
    for (const database::Finding& finding : report.findings) {
        const QStringList words = QString::fromStdString(finding.row).split(' ');
        const bool all =
            std::all_of(names.begin(), names.end(), [&](const QString& n) { return words.contains(n); });
        if (QString::fromStdString(finding.table) == table && all)
            return true;
    }
    return false;
}

} // namespace

class TestFlippedBits : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void anyBitOfTheFile();
    void chunksAndScores_data();
    void chunksAndScores();
    void cleanupTestCase() { m_site.reset(); }

private:
    QJsonObject examined(const QString& file);
    QString freshCopy(const QString& name);

    std::unique_ptr<tests::SessionFixture> m_site;
    QTemporaryDir m_folder;
    QString m_original;
    QString m_siteFolder;
    QStringList m_tables;
};

void TestFlippedBits::initTestCase() {
    m_site = std::make_unique<tests::SessionFixture>();
    for (int level = 1; level <= 3; ++level) {
        auto result =
            m_site->run(m_site->request(tests::shortLevel(level, 3, 15.0), "intermediate", 30 + level));
        QVERIFY2(result, result ? "" : result.error().message.c_str());
    }
    m_siteFolder = QString::fromStdString(m_site->database->siteFolder());
    m_site->database.reset();
    m_original = QString::fromStdString(m_site->file());
    QVERIFY(!QFile::exists(m_original + "-wal")); // everything is in the file
    QVERIFY(verify(m_original, m_siteFolder).ok());
    m_tables = RawDatabase::open(m_original, RawDatabase::Mode::read)->tables();
    QVERIFY(m_tables.contains("chunk") && m_tables.contains("score"));
}

QString TestFlippedBits::freshCopy(const QString& name) {
    const QString file = m_folder.filePath(name);
    for (const char* suffix : {"", "-wal", "-shm", "-journal"})
        QFile::remove(file + suffix);
    return QFile::copy(m_original, file) ? file : QString();
}

QJsonObject TestFlippedBits::examined(const QString& file) {
    QProcess child;
    child.start(QCoreApplication::applicationFilePath(),
                QStringList{"--examine", file, m_siteFolder} + m_tables);
    if (!child.waitForFinished(kPatience_ms) || child.exitStatus() != QProcess::NormalExit ||
        child.exitCode() != 0)
        return {};
    return QJsonDocument::fromJson(child.readAllStandardOutput()).object();
}

void TestFlippedBits::anyBitOfTheFile() {
    core::Random random = core::Random::stream(kSeed, "bits of the file");
    const QJsonObject whole = examined(m_original)["content"].toObject();
    QCOMPARE(whole.size(), m_tables.size());
    int harmless = 0;
    for (int i = 0; i < flips(); ++i) {
        const QString file = freshCopy("flipped.db");
        QFile bytes(file);
        QVERIFY(bytes.open(QIODevice::ReadWrite));
        const auto bit = static_cast<qint64>(random.below(static_cast<std::uint64_t>(bytes.size()) * 8));
        QVERIFY(bytes.seek(bit / 8));
        char byte = 0;
        QVERIFY(bytes.getChar(&byte) && bytes.seek(bit / 8) &&
                bytes.putChar(static_cast<char>(byte ^ (1 << (bit % 8)))));
        bytes.close();
        const QJsonObject said = examined(file);
        QVERIFY2(!said.isEmpty(), qPrintable(QString("bit %1: the program died").arg(bit)));
        const bool damaged = !said["sound"].toBool() || said["content"].toObject() != whole;
        if (damaged)
            QVERIFY2(said["findings"].toInteger() > 0, qPrintable(QString("bit %1: not found").arg(bit)));
        else
            ++harmless; // free space, or a byte that SQLite does not read
    }
    qInfo("%d flips, %d of them in bytes that hold nothing", flips(), harmless);
    QVERIFY(harmless < flips());
}

void TestFlippedBits::chunksAndScores_data() {
    QTest::addColumn<QString>("table");
    QTest::addColumn<QString>("column");
    for (const char* column : {"payload", "payload_hash", "payload_digest", "force_hash", "digest",
                               "first_tick", "frames", "session_id", "sequence"})
        QTest::addRow("chunk.%s", column) << "chunk" << column;
    for (const char* column : {"value", "metric", "version", "unit", "trial", "ordinal", "passed", "reason",
                               "digest", "score_set_id"})
        QTest::addRow("score.%s", column) << "score" << column;
}

void TestFlippedBits::chunksAndScores() {
    QFETCH(QString, table);
    QFETCH(QString, column);
    core::Random random = core::Random::stream(kSeed, (table + column).toStdString());
    // Payloads and values are what the long test is about; the other columns get a share.
    const bool main = column == "payload" || column == "value";
    const int wanted = main ? flips() / 2 : std::max(1, flips() / 20);
    int done = 0;
    for (int attempt = 0; done < wanted && attempt < 200 * wanted; ++attempt) {
        const QString file = freshCopy("row.db");
        auto raw = RawDatabase::open(file, RawDatabase::Mode::write);
        QVERIFY(raw && raw->execute("PRAGMA ignore_check_constraints=ON; DROP TRIGGER score_fixed;"));
        const auto rows =
            raw->integer(QString("SELECT count(*) FROM %1 WHERE %2 IS NOT NULL").arg(table, column));
        QVERIFY2(rows && *rows > 0, "nothing there to damage");
        const auto rowid = *raw->integer(
            QString("SELECT rowid FROM %1 WHERE %2 IS NOT NULL ORDER BY rowid LIMIT 1 OFFSET %3")
                .arg(table, column)
                .arg(random.below(static_cast<std::uint64_t>(*rows))));
        const QStringList names = namesOf(*raw, table, rowid);
        if (!raw->flip(table, rowid, column, random.next()))
            continue; // NULL, or SQLite refused it
        raw.reset();
        ++done;
        const database::VerifyReport report = verify(file, m_siteFolder);
        const bool isKey = names.filter(column + '=').size() == 1;
        QVERIFY2(isKey ? !report.ok() : isNamed(report, table, names), qPrintable(names.join(' ')));
    }
    QCOMPARE(done, wanted);
}

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == QLatin1String("--examine"))
        return examine(arguments.value(2), arguments.value(3), arguments.mid(4));
    TestFlippedBits test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_flipped_bits.moc"
