// SPDX-License-Identifier: GPL-3.0-or-later
// A session's report states exactly what is stored: every fact and every score.
#include "database/repositories/score_repository.h"
#include "desktop/debrief/debrief_data.h"
#include "desktop/playback/playback_data.h"
#include "recording/digest.h"
#include "review_sessions.h"
#include "session_report/metric_words.h"
#include "session_report/session_report.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <tuple>

using namespace chiron;

class TestStoredReport : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        m_site = std::make_unique<tests::DesktopFixture>();
        m_made = std::make_unique<tests::ReviewSessions>(m_site->database());
        m_tina = m_site->actor("tina");
        m_good = tests::store(m_site->database(), *m_tina, m_made->good);
        m_shown = tests::store(m_site->database(), *m_tina, tests::ReviewSessions::shown(m_made->bad));
        auto reader = m_site->database().openReader();
        QVERIFY(reader);
        m_reader = std::move(*reader);
    }
    void cleanupTestCase() {
        m_reader.reset();
        m_site.reset();
    }
    void factsAreTheRecords();
    void aScriptedHandIsNoPerson();
    void scoresAreTheCards();
    void onlyWhatCameToItsEndIsJudged();
    void thePublishedBandIsOfThoseWhoFelt();
    void theWholeReportNamesItsRecording();
    void eachLooksAtTheRecordingOnce();

private:
    database::SessionRecord recordOf(database::SessionId id) {
        auto record = database::SessionReader(*m_reader, *m_tina).session(id);
        if (!record)
            qFatal("%s", record.error().message.c_str());
        return *record;
    }
    report::ReportData headOf(const database::SessionRecord& record, const char* language = "en") {
        auto head = session_report::reportHeadOf(record, *session::setupFromStored(record.setup), *m_reader,
                                                 *m_tina, language);
        if (!head)
            qFatal("%s", head.error().message.c_str());
        return *head;
    }
    static const report::MetricRow* rowOf(const report::ReportData& data, const char* id) {
        const auto row =
            std::find_if(data.metrics.begin(), data.metrics.end(),
                         [&](const report::MetricRow& each) { return each.id == QLatin1String(id); });
        return row == data.metrics.end() ? nullptr : &*row;
    }

    std::unique_ptr<tests::DesktopFixture> m_site;
    std::unique_ptr<tests::ReviewSessions> m_made;
    std::optional<database::Actor> m_tina;
    std::unique_ptr<database::Connection> m_reader;
    database::SessionId m_good = 0, m_shown = 0;
};

void TestStoredReport::factsAreTheRecords() {
    database::SessionRecord record = recordOf(m_good);
    record.summary.personName = "Τίνα Groß";
    record.summary.startedUtc = "2026-03-01T23:59:58.250Z";
    record.summary.utcOffset_min = -150;
    record.summary.demonstration = true;
    record.summary.frames = 1234;
    record.summary.dropped = 5;
    record.summary.recordingBytes = 6789;
    record.setup.felt = false;
    record.setup.forceLimit_N = 3.25;
    record.setup.buildId = "1.2.3 gcc";
    record.contentSha256 = std::string(64, 'a');
    record.loopJson =
        R"({"ticks": 5000, "late": 4, "skipped": 3, "realtime": false, "p50_us": 1.5, "p99_us": 20.25, "max_us": 300})";
    const report::ReportData data = headOf(record, "de");
    const auto setup = session::setupFromStored(record.setup);
    QCOMPARE(data.person, QStringLiteral("Τίνα Groß"));
    QVERIFY(!data.simulated && data.demonstration && !data.felt);
    QCOMPARE(data.exerciseId, QStringLiteral("sphere_apex"));
    QCOMPARE(data.exerciseTitle, QStringLiteral("sphere apex"));
    QCOMPARE(data.levelTitle, QString::fromStdString(setup->level.title.at("de")));
    QVERIFY(data.levelTitle != headOf(record, "en").levelTitle);
    QCOMPARE(data.level, record.summary.level);
    QCOMPARE(data.startedUtc, QDateTime(QDate(2026, 3, 1), QTime(23, 59, 58, 250), Qt::UTC));
    QCOMPARE(data.offsetMinutes, -150);
    QCOMPARE(data.device, QString::fromStdString(setup->devices.front().model));
    QCOMPARE(data.state, QStringLiteral("completed"));
    QCOMPARE(data.forceLimit_N, 3.25);
    QVERIFY(data.loop.ticks == 5000 && data.loop.late == 4 && data.loop.skipped == 3 && !data.loop.realtime);
    QVERIFY(data.loop.p50_us == 1.5 && data.loop.p99_us == 20.25 && data.loop.max_us == 300.0);
    QCOMPARE(data.integrity.sessionId, QString::number(m_good));
    QVERIFY(data.integrity.frames == 1234 && data.integrity.dropped == 5 && data.integrity.bytes == 6789);
    QCOMPARE(data.integrity.buildId, QStringLiteral("1.2.3 gcc"));
    QCOMPARE(data.integrity.contentSha256, QString(64, QLatin1Char('a')));
    QCOMPARE(data.trialsDone, 3);
}

void TestStoredReport::aScriptedHandIsNoPerson() {
    database::SessionRecord record = recordOf(m_good);
    record.setup.operatorName = "expert";
    record.setup.seed = 7;
    const report::ReportData data = headOf(record);
    QVERIFY(data.simulated);
    QCOMPARE(data.person, QStringLiteral("expert (scripted), seed 7"));
}

void TestStoredReport::scoresAreTheCards() {
    const database::SessionRecord record = recordOf(m_good);
    const catalogue::ExerciseLevel level = session::setupFromStored(record.setup)->level;
    const auto card = database::ScoreRepository(*m_reader, *m_tina).scores(m_good);
    QVERIFY(card);
    const report::ReportData data = headOf(record);
    QCOMPARE(data.passed, std::optional<bool>(card->passed));
    QCOMPARE(data.metrics.size(), card->metrics.size());
    int gated = 0;
    for (std::size_t i = 0; i < card->metrics.size(); ++i) {
        const scoring::MetricValue& metric = card->metrics[i];
        const report::MetricRow& row = data.metrics[i];
        QCOMPARE(row.id, QString::fromStdString(metric.id));
        QCOMPARE(row.name, session_report::metricTitle(row.id));
        QCOMPARE(row.unit, QString::fromStdString(metric.unit));
        QCOMPARE(row.value, metric.value);
        QCOMPARE(row.reason, QString::fromStdString(metric.reason));
        QCOMPARE(row.passed, metric.passed);
        const auto gate = std::find_if(level.gates.begin(), level.gates.end(),
                                       [&](const scoring::Gate& each) { return each.metric == metric.id; });
        QCOMPARE(row.headline, gate != level.gates.end());
        if (gate == level.gates.end())
            QVERIFY(!row.gateMinimum && !row.gateMaximum);
        else {
            ++gated;
            QCOMPARE(row.gateMinimum, gate->minimum);
            QCOMPARE(row.gateMaximum, gate->maximum);
        }
    }
    QVERIFY(gated > 0);
    const auto seal = database::ScoreRepository(*m_reader, *m_tina).scoreSeal(m_good);
    QVERIFY(seal);
    QCOMPARE(data.integrity.scoreSeal, QString::fromStdString(recording::toHex(*seal)));
    QVERIFY(std::any_of(data.metrics.begin(), data.metrics.end(),
                        [](const report::MetricRow& row) { return !row.unit.isEmpty(); }));
}

void TestStoredReport::onlyWhatCameToItsEndIsJudged() {
    database::SessionRecord record = recordOf(m_good);
    for (const auto& [state, before, judged] :
         {std::tuple{database::SessionState::stopped, std::optional<database::SessionState>(), false},
          {database::SessionState::voided, std::optional(database::SessionState::stopped), false},
          {database::SessionState::voided, std::optional(database::SessionState::completed), true}}) {
        record.summary.state = state;
        record.stateBeforeVoid = before;
        const report::ReportData data = headOf(record);
        QCOMPARE(data.passed.has_value(), judged);
        QVERIFY(!data.metrics.empty());
        for (const report::MetricRow& row : data.metrics)
            QVERIFY(judged || (!row.passed && !row.headline));
    }
}

void TestStoredReport::thePublishedBandIsOfThoseWhoFelt() {
    database::SessionRecord record = recordOf(m_good);
    for (const bool felt : {true, false}) {
        record.setup.felt = felt;
        const report::ReportData data = headOf(record);
        const report::MetricRow* error = rowOf(data, "apex_error_mean");
        QVERIFY(error);
        QCOMPARE(error->bandLow.has_value(), felt);
        if (felt) { // P2: 14.2 %, SD 11.3
            QVERIFY(std::abs(*error->bandLow - 2.9) < 1e-9 && std::abs(*error->bandHigh - 25.5) < 1e-9);
            QVERIFY(error->bandSource.contains(QStringLiteral("5 subjects")));
        }
        for (const report::MetricRow& row : data.metrics)
            QVERIFY(&row == error || (!row.bandLow && row.bandSource.isEmpty()));
    }
    QVERIFY(!recordOf(m_shown).setup.felt);
}

void TestStoredReport::theWholeReportNamesItsRecording() {
    QStringList digests;
    for (const database::SessionId id : {m_good, m_shown}) {
        auto stored = session::SessionView::open(*m_reader, *m_tina, id);
        QVERIFY(stored);
        const auto whole = session_report::reportDataOf(**stored, *m_reader, *m_tina, "en");
        QVERIFY2(whole, whole ? "" : whole.error().message.c_str());
        const report::ReportData head = headOf(recordOf(id));
        QCOMPARE(whole->person, head.person);
        QCOMPARE(whole->integrity.sessionId, head.integrity.sessionId);
        QCOMPARE(whole->integrity.recordingDigest.size(), 64);
        digests << whole->integrity.recordingDigest;
        QVERIFY(whole->duration_s > 1.0 && !whole->series.t_s.empty() && whole->force);
        QVERIFY(whole->series.t_s.back() <= whole->duration_s + 1e-6);
    }
    QVERIFY(digests[0] != digests[1]);
}

/// Debrief, report and playback decode the recording once each, and together not more often.
void TestStoredReport::eachLooksAtTheRecordingOnce() {
    const auto opened = [this] {
        auto view = session::SessionView::open(*m_reader, *m_tina, m_good);
        if (!view)
            qFatal("%s", view.error().message.c_str());
        return std::move(*view);
    };
    const std::atomic<bool> goesOn = false;
    const auto debriefed = [&](session::SessionView& view) {
        const auto details = desktop::debriefDetailsOf(view, *m_reader, *m_tina, goesOn);
        return details && details->duration_s > 0.0 && !details->trials.empty();
    };
    const auto printed = [&](session::SessionView& view) {
        const auto data = session_report::reportDataOf(view, *m_reader, *m_tina, "en");
        return data && data->duration_s > 0.0 && !data->series.t_s.empty();
    };
    const auto played = [&](session::SessionView& view) {
        desktop::PlaybackData data;
        data.setup = view.setup();
        return desktop::addRecording(data, view, {}) && !data.track.empty() && data.layer;
    };
    const auto all = opened();
    using Look = std::function<bool(session::SessionView&)>;
    for (const Look& look : {Look(debriefed), Look(printed), Look(played)}) {
        const auto own = opened();
        QCOMPARE(own->decodings(), 0); // opening reads rows only
        QVERIFY(look(*own));
        QCOMPARE(own->decodings(), 1);
        QVERIFY(look(*all));
    }
    QCOMPARE(all->decodings(), 1);
}

QTEST_MAIN(TestStoredReport)
#include "test_stored_report.moc"
