// SPDX-License-Identifier: GPL-3.0-or-later
// Sites with a session of every exercise, as this and earlier versions recorded and scored them: their
// sessions list, play and score as they did. Where the laws are the same, a replay gives the same forces;
// where they are others now, it says so, and does not say that somebody tampered.
#include "stored_site.h"
#include "support/looked_back.h"

#include "catalogue/canonical_json.h"
#include "catalogue/catalogue.h"
#include "core/fp_environment.h"
#include "database/accounts/account_service.h"
#include "database/integrity/verifier.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "session/replayer.h"
#include "session/session_view.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>

using namespace chiron;
using namespace chiron::database;
using namespace chiron::test;

namespace {

constexpr const char* kOldPassword = "an old password"; // guards nothing but this fixture

QByteArray unpacked(const QByteArray& packed) {
    QByteArray plain(static_cast<qsizetype>(ZSTD_getFrameContentSize(
                         packed.constData(), static_cast<std::size_t>(packed.size()))),
                     '\0');
    const std::size_t got = ZSTD_decompress(plain.data(), static_cast<std::size_t>(plain.size()),
                                            packed.constData(), static_cast<std::size_t>(packed.size()));
    return ZSTD_isError(got) || got != static_cast<std::size_t>(plain.size()) ? QByteArray() : plain;
}

/// A stored site: the name of its files, and the schema version and models id of the program that made it.
struct SiteBefore {
    const char* name;
    int schema;
    const char* models;
};
constexpr SiteBefore kSitesBefore[] = {
    {"v3_sessions", 3, "1"}, {"v3_sessions_models2", 3, "2"}, {"v7_sessions_models3", 7, "3"}};
/// In each of them, in this order.
constexpr const char* kExercisesBefore[] = {"sphere_apex", "urethra_insertion", "elastic_tube",
                                            "object_handling", "palpation"};

/// Of a force, N: with the same laws, libraries of mathematics on another class of processor move a force by
/// less than the resolution at which it is stored (0.001 N in each direction), so that at most its last digit
/// is another.
constexpr double kLastDigit_N = 0.002;

core::Result<void> makeSiteBefore(const std::string& file, const SiteBefore& site) {
    auto connection = Connection::create(file);
    CHIRON_TRY(connection);
    const std::string stored = std::string(kStoredSite) + site.name;
    auto built =
        (*connection)
            ->execute(unpacked(contentOf(stored + ".sql.zst")).toStdString() +
                      "PRAGMA application_id=" + std::to_string(kApplicationId) +
                      "; PRAGMA user_version=" + std::to_string(site.schema) + "; PRAGMA journal_mode=WAL;");
    QDir().mkpath(QString::fromStdString(file + ".site"));
    copyTo(file + ".site/site.key", contentOf(stored + ".key"));
    copyTo(file + ".site/audit_head.json", contentOf(stored + "_audit_head.json"));
    QFile::setPermissions(QString::fromStdString(file + ".site/site.key"),
                          QFile::ReadOwner | QFile::WriteOwner);
    return built;
}

} // namespace

class TestSessionsBefore : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void verifies_data() { sites(); }
    void verifies();
    void everySessionListsPlaysAndScores_data();
    void everySessionListsPlaysAndScores();
    void everySessionReplaysOrSaysWhichModelsItNeeds();

private:
    struct Opened {
        std::unique_ptr<DatabaseFixture> site;
        std::optional<Actor> ada;
    };
    static void sites();
    std::array<Opened, std::size(kSitesBefore)> m_sites;
};

void TestSessionsBefore::initTestCase() {
    for (std::size_t i = 0; i < m_sites.size(); ++i) {
        auto& opened = m_sites[i];
        opened.site = std::make_unique<DatabaseFixture>();
        REQUIRE(makeSiteBefore(opened.site->path(), kSitesBefore[i]));
        REQUIRE(opened.site->reopen());
        const auto ada = AccountService(*opened.site->database).login("ada", kOldPassword);
        REQUIRE(ada);
        opened.ada = *ada;
    }
}

void TestSessionsBefore::sites() {
    QTest::addColumn<int>("site");
    for (int i = 0; i < static_cast<int>(std::size(kSitesBefore)); ++i)
        QTest::newRow(kSitesBefore[i].name) << i;
}

void TestSessionsBefore::verifies() {
    QFETCH(int, site);
    const auto& opened = m_sites[static_cast<std::size_t>(site)];
    auto reader = opened.site->database->openReader();
    QCOMPARE(SessionReader(**reader, *opened.ada).listSessions()->size(), std::size(kExercisesBefore));
    QVERIFY(verifyDatabase(opened.site->path(), opened.site->options).ok());
}

void TestSessionsBefore::everySessionListsPlaysAndScores_data() {
    QTest::addColumn<int>("site");
    QTest::addColumn<int>("id");
    QTest::addColumn<QString>("exercise");
    for (int site = 0; site < static_cast<int>(std::size(kSitesBefore)); ++site) {
        int id = 0;
        for (const char* exercise : kExercisesBefore)
            QTest::addRow("%s, %s", kSitesBefore[site].name, exercise) << site << ++id << exercise;
    }
}

void TestSessionsBefore::everySessionListsPlaysAndScores() {
    QFETCH(int, site);
    QFETCH(int, id);
    QFETCH(QString, exercise);
    const auto& opened = m_sites[static_cast<std::size_t>(site)];
    auto connection = opened.site->database->openReader();
    REQUIRE(connection);
    auto stored = session::SessionView::open(**connection, *opened.ada, SessionId{id});
    REQUIRE(stored);
    QCOMPARE((*stored)->record().summary.exercise, exercise.toStdString());

    // Its content has the texts of its time in it: the digest is what it was, and the task is known without
    // them.
    const auto& record = (*stored)->record();
    QCOMPARE(record.contentSha256, catalogue::sha256Hex(record.setup.contentJson));
    QCOMPARE(catalogue::taskSha256(record.setup.contentJson).size(), std::size_t{64});
    QVERIFY(catalogue::taskSha256(record.setup.contentJson) != record.contentSha256);
    QByteArray reworded = QByteArray::fromStdString(record.setup.contentJson);
    QVERIFY(reworded.contains("\"title\":{"));
    reworded.replace("\"title\":{", "\"title\":{\"fr\":\"Un titre\",");
    QCOMPARE(catalogue::taskSha256(reworded.toStdString()), catalogue::taskSha256(record.setup.contentJson));

    const auto track = tests::trackOf(**stored);
    REQUIRE(track);
    QVERIFY(track->duration_s > 1.0);

    // Scored then, and scored again from the stored channels now: the same to the bit.
    const auto then = ScoreRepository(**connection, *opened.ada).scores(SessionId{id});
    const auto now = (*stored)->computeScores();
    REQUIRE(then);
    REQUIRE(now);
    QCOMPARE(now->passed, then->passed);
    QCOMPARE(now->metrics.size(), then->metrics.size());
    QVERIFY(now->metrics.size() > 10);
    for (std::size_t i = 0; i < now->metrics.size(); ++i) {
        const auto &a = now->metrics[i], &b = then->metrics[i];
        const QByteArray where = QByteArray::fromStdString(b.id);
        QCOMPARE(a.id, b.id);
        QVERIFY2(a.version == b.version && a.value == b.value && a.passed == b.passed, where.constData());
    }
}

void TestSessionsBefore::everySessionReplaysOrSaysWhichModelsItNeeds() {
    const std::string had = core::modelsOfBuild(core::buildId());
    int sessions = 0, ofTheseModels = 0, comparable = 0, identical = 0;
    double largest_N = 0.0; // of those that are comparable
    std::map<std::string, int> needing;
    QStringList elsewhere, wrong;
    for (std::size_t site = 0; site < m_sites.size(); ++site) {
        auto connection = m_sites[site].site->database->openReader();
        REQUIRE(connection);
        for (int id = 1; id <= static_cast<int>(std::size(kExercisesBefore)); ++id) {
            const QString where =
                QStringLiteral("%1, %2: ").arg(kSitesBefore[site].name, kExercisesBefore[id - 1]);
            auto stored = session::SessionView::open(**connection, *m_sites[site].ada, SessionId{id});
            REQUIRE(stored);
            const auto& record = (*stored)->record();
            const std::string needed = core::modelsOfBuild(record.setup.buildId);
            QCOMPARE(needed, std::string(kSitesBefore[site].models));
            const auto replay = session::replaySession(**stored);
            REQUIRE(replay);
            QVERIFY2(replay->frames == record.summary.frames && replay->frames > 1'000, qPrintable(where));
            ++sessions;
            const QString note = QString::fromStdString(replay->note);
            if (needed != had) {
                ++needing[needed];
                if (replay->comparable ||
                    note != QStringLiteral("needs models %1, this program has %2")
                                .arg(QString::fromStdString(needed), QString::fromStdString(had)))
                    wrong << where + QStringLiteral("does not say which models id it needs: ") + note;
                continue;
            }
            ++ofTheseModels;
            if (replay->comparable) {
                ++comparable;
                identical += replay->identical ? 1 : 0;
                largest_N = std::max(largest_N, replay->maximumDifference_N);
                if (!replay->identical || replay->firstDifferentTick || replay->maximumDifference_N != 0.0)
                    wrong << where + QStringLiteral("differs from tick %1 on, by %2 N at most")
                                         .arg(replay->firstDifferentTick.value_or(0))
                                         .arg(replay->maximumDifference_N);
                continue;
            }
            elsewhere << where + note;
            if (record.setup.cpuClass == core::cpuClass() &&
                core::forcesOfBuild(record.setup.buildId) == core::forcesOfBuild(core::buildId()))
                wrong << where + QStringLiteral("is called incomparable: ") + note;
            if (!(replay->maximumDifference_N <= kLastDigit_N))
                wrong << where + QStringLiteral("the same laws differ by %1 N: %2")
                                     .arg(replay->maximumDifference_N)
                                     .arg(note);
        }
    }
    std::printf("%d stored sessions: %d comparable, %d of them identical (largest difference %g N)", sessions,
                comparable, identical, largest_N);
    for (const auto& [models, count] : needing)
        std::printf("; %d need models %s", count, models.c_str());
    std::printf("; %d from another compiler or class of processor\n", static_cast<int>(elsewhere.size()));
    std::fflush(stdout);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    QVERIFY2(ofTheseModels > 0,
             qPrintable(QStringLiteral("no stored session is of models %1, so nothing was compared: make one "
                                       "with tests/migration/store_site and name it in kSitesBefore")
                            .arg(QString::fromStdString(had))));
    if (comparable == 0)
        QSKIP(qPrintable(QStringLiteral("the bits cannot be compared here:\n") +
                         elsewhere.join(QLatin1Char('\n'))));
}

QTEST_GUILESS_MAIN(TestSessionsBefore)
#include "test_sessions_before.moc"
