// SPDX-License-Identifier: GPL-3.0-or-later
// One session's score is the same live, from the stored file, from a restored backup and from the exported
// trace; and nothing that is edited afterwards changes it.
#include "database/accounts/account_service.h"
#include "database/repositories/score_repository.h"
#include "database/upkeep/upkeep.h"
#include "scoring/score_calculator.h"
#include "scoring/trace_builder.h"
#include "scoring/trace_csv.h"
#include "session/replayer.h"
#include "session/session_export.h"
#include "session/site.h"
#include "support/content_copy.h"
#include "support/made_session.h"
#include "support/session_fixture.h"

#include <QtTest>

using namespace chiron;
using tests::OpenStored;
using tests::SessionFixture;
using tests::shortLevel;

namespace {

scoring::ScoreCard storedCard(database::Database& database, database::SessionId id) {
    auto connection = database.openReader();
    auto card = database::ScoreRepository(**connection, database::Actor::simulated()).scores(id);
    return card ? *card : scoring::ScoreCard{};
}

scoring::ScoreCard recomputed(database::Database& database, database::SessionId id) {
    OpenStored stored(database, id);
    auto card = stored.session->computeScores();
    return card ? *card : scoring::ScoreCard{};
}

} // namespace

class TestScoreIsKept : public QObject {
    Q_OBJECT
private slots:
    void initTestCase();
    void liveStoredAndRecomputedAgree();
    void restoredBackupAgrees();
    void exportedTraceAgrees();
    void exportedTraceOfAStoppedSetCanBeRead();
    void exportHasNoColumnsOfOtherExercises();
    void refusedPacketsAreNotExported();
    void editedContentChangesNothing();
    void cleanupTestCase() { m_site.reset(); }

private:
    /// Exports and reads back.
    scoring::TraceRows exported(database::SessionId id) {
        OpenStored stored(*m_site->database, id);
        const QString path = QString::fromStdString(m_site->folder() + "/exported.csv");
        if (auto done = session::exportCsv(*stored.session, path); !done)
            qFatal("%s", done.error().message.c_str());
        auto rows = scoring::readTraceCsvFile(path.toStdString());
        if (!rows)
            qFatal("%s", rows.error().message.c_str());
        return std::move(*rows);
    }

    std::unique_ptr<SessionFixture> m_site;
    session::TrainingResult m_result;
};

void TestScoreIsKept::initTestCase() {
    m_site = std::make_unique<SessionFixture>();
    auto result = m_site->run(m_site->request(shortLevel(2, 2, 25.0), "intermediate", 21));
    QVERIFY2(result, result ? "" : result.error().message.c_str());
    m_result = std::move(*result);
    QVERIFY(!m_result.scores.metrics.empty());
}

void TestScoreIsKept::liveStoredAndRecomputedAgree() {
    QVERIFY(session::sameScores(m_result.scores, storedCard(*m_site->database, m_result.session)));
    QVERIFY(session::sameScores(m_result.scores, recomputed(*m_site->database, m_result.session)));
}

void TestScoreIsKept::restoredBackupAgrees() {
    database::AccountService accounts(*m_site->database);
    QVERIFY(accounts.createFirstAdministrator("alice", "a long password"));
    auto alice = accounts.login("alice", "a long password");
    QVERIFY(alice);
    const std::string folder = m_site->folder() + "/backup";
    auto made = database::Upkeep::backup(*m_site->database, *alice, folder);
    QVERIFY2(made, made ? "" : made.error().message.c_str());
    database::RestoreRequest request;
    request.backupFolder = folder;
    request.targetFile = m_site->folder() + "/restored.db";
    request.name = "alice";
    request.password = "a long password";
    request.siteKeyFile = m_site->database->siteFolder() + "/site.key";
    auto restored = database::Upkeep::restore(request, m_site->database->options());
    QVERIFY2(restored, restored ? "" : restored.error().message.c_str());
    auto again = database::Database::openReadOnly(request.targetFile, m_site->database->options());
    QVERIFY2(again, again ? "" : again.error().message.c_str());
    QVERIFY(session::sameScores(m_result.scores, storedCard(**again, m_result.session)));
    QVERIFY(session::sameScores(m_result.scores, recomputed(**again, m_result.session)));
    OpenStored stored(**again, m_result.session);
    auto replay = session::replaySession(*stored.session);
    QVERIFY(replay && replay->identical);
}

void TestScoreIsKept::exportedTraceAgrees() {
    OpenStored stored(*m_site->database, m_result.session);
    const QString path = QString::fromStdString(m_site->folder() + "/trace.csv");
    auto exported = session::exportCsv(*stored.session, path);
    QVERIFY2(exported, exported ? "" : exported.error().message.c_str());
    auto rows = scoring::readTraceCsvFile(path.toStdString());
    QVERIFY2(rows, rows ? "" : rows.error().message.c_str());
    auto trace = scoring::buildSessionTrace(*rows, "sphere_apex");
    QVERIFY2(trace, trace ? "" : trace.error().message.c_str());
    std::vector<scoring::MetricRequest> wanted;
    for (const auto& metric : stored.session->setup().level.metrics)
        wanted.push_back({metric.id, metric.version});
    auto card = scoring::calculateScore(*trace, wanted, stored.session->setup().level.gates, true);
    QVERIFY2(card, card ? "" : card.error().message.c_str());
    for (std::size_t i = 0; i < card->metrics.size(); ++i) {
        QVERIFY2(card->metrics[i].value == m_result.scores.metrics[i].value, card->metrics[i].id.c_str());
    }
    QVERIFY(session::sameScores(*card, m_result.scores));
}

void TestScoreIsKept::exportedTraceOfAStoppedSetCanBeRead() {
    tests::MadeSession made = tests::copyOf(*m_site->database, m_result.session);
    const auto second = std::find_if(made.frames.begin(), made.frames.end(),
                                     [](const core::HapticFrame& frame) { return frame.header.trial == 1; });
    QVERIFY(second != made.frames.end());
    QVERIFY(!(second->header.events &
              core::event_bits::kTrialStarted)); // the second trial is there, but has not begun
    tests::cutFrames(made.frames, static_cast<std::size_t>(second - made.frames.begin()) + 1,
                     core::CommandKind::end);
    const auto rows = exported(tests::store(*m_site->database, database::Actor::simulated(), made));
    const auto trace = scoring::buildSessionTrace(rows, "sphere_apex");
    QVERIFY2(trace, trace ? "" : trace.error().message.c_str());
    QCOMPARE(trace->trials.size(), std::size_t{1});
}

void TestScoreIsKept::exportHasNoColumnsOfOtherExercises() {
    const auto rows = exported(m_result.session);
    QVERIFY(rows.columns.target && rows.columns.orientation);
    QVERIFY(rows.columns.own == nullptr && !rows.columns.torque);
}

void TestScoreIsKept::refusedPacketsAreNotExported() {
    tests::MadeSession made = tests::copyOf(*m_site->database, m_result.session);
    for (std::size_t i = 0; i < made.frames.size(); i += i == 0 ? 500 : 97) { // the first packet too
        core::ToolFrame& tool = made.frames[i].tool[0];
        tool.status |= core::sample_status::kRefused;
        tool.counts[0] += 5000;
        tool.deviceTime_us += 900'000'000; // a clock that jumped
    }
    QVERIFY(made.frames.front().tool[0].status & core::sample_status::kRefused);
    const database::SessionId id = tests::store(*m_site->database, database::Actor::simulated(), made);
    const auto rows = exported(id);
    QVERIFY(rows.rows.size() < made.frames.size() && rows.rows.size() > made.frames.size() * 9 / 10);
    QCOMPARE(rows.rows.front().t_s, 0.0);
    const auto trace = scoring::buildSessionTrace(rows, "sphere_apex");
    QVERIFY(trace);
    OpenStored stored(*m_site->database, id);
    std::vector<scoring::MetricRequest> wanted;
    for (const auto& metric : stored.session->setup().level.metrics)
        wanted.push_back({metric.id, metric.version});
    const auto card = scoring::calculateScore(*trace, wanted, stored.session->setup().level.gates, true);
    QVERIFY(card && session::sameScores(*card, storedCard(*m_site->database, id)));
}

void TestScoreIsKept::editedContentChangesNothing() {
    ContentCopy content;
    auto before = catalogue::Catalogue::load(content.directory());
    QVERIFY(before);
    auto run = session::runScripted(*m_site->database, database::Actor::simulated(), *before,
                                    {"sphere_apex", 1, "expert", 4});
    QVERIFY2(run, run ? "" : run.error().message.c_str());
    const QString level = QStringLiteral("exercises/sphere_apex/levels/visible.json");
    QByteArray text = content.read(level);
    QVERIFY(text.contains("\"radius_mm\": 20"));
    content.write(level, text.replace("\"radius_mm\": 20", "\"radius_mm\": 15"));
    auto after = catalogue::Catalogue::load(content.directory());
    QVERIFY2(after, after ? "" : after.error().message.c_str());
    QVERIFY(after->find("sphere_apex", 1)->resolvedSha256 != before->find("sphere_apex", 1)->resolvedSha256);
    QVERIFY(session::sameScores(run->scores, recomputed(*m_site->database, run->session)));
    OpenStored stored(*m_site->database, run->session);
    auto replay = session::replaySession(*stored.session);
    QVERIFY(replay && replay->identical);
}

QTEST_GUILESS_MAIN(TestScoreIsKept)
#include "test_score_is_kept.moc"
