// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/session_report.h"

#include "catalogue/catalogue.h"
#include "core/languages.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/site_repository.h"
#include "recording/digest.h"
#include "scoring/force_facts.h"
#include "scoring/metric_catalogue.h"
#include "session/level_limits.h"
#include "session_report/exercise_reporter.h"
#include "session_report/metric_words.h"
#include "session_report/track_series.h"

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

namespace chiron::session_report {

using namespace report;

namespace {

/// True if a session in this state is judged; one that did not reach its end has values but no verdict.
bool isJudged(const database::SessionRecord& record) {
    return record.summary.state == database::SessionState::completed ||
           record.stateBeforeVoid == database::SessionState::completed;
}

std::vector<MetricRow> rowsOf(const scoring::ScoreCard& card, const catalogue::ExerciseLevel& level,
                              bool felt, bool judged, int trials) {
    std::vector<MetricRow> rows;
    for (const scoring::MetricValue& metric : card.metrics) {
        MetricRow row;
        row.id = QString::fromStdString(metric.id);
        row.trials = trials;
        row.name = metricTitle(row.id, trials);
        row.unit = QString::fromStdString(metric.unit);
        row.value = metric.value;
        row.reason = QString::fromStdString(metric.reason);
        row.chance = chanceOf(metric.id, card);
        if (judged)
            row.passed = metric.passed;
        for (const scoring::Gate& gate : level.gates) {
            if (gate.metric != metric.id)
                continue;
            row.gateMinimum = gate.minimum;
            row.gateMaximum = gate.maximum;
            row.limit = session::limitBehind(level, gate);
            row.headline = judged;
        }
        // A band applies to one device class: these people felt the force.
        if (felt)
            addPublishedBand(row, metric.version);
        rows.push_back(std::move(row));
    }
    return rows;
}

LoopFacts loopFactsOf(const std::string& text) {
    const QJsonObject json = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    LoopFacts facts;
    facts.ticks = static_cast<std::uint64_t>(json.value("ticks").toDouble());
    facts.late = static_cast<std::uint64_t>(json.value("late").toDouble());
    facts.skipped = static_cast<std::uint64_t>(json.value("skipped").toDouble());
    facts.realtime = json.value("realtime").toBool();
    facts.p50_us = json.value("p50_us").toDouble();
    facts.p99_us = json.value("p99_us").toDouble();
    facts.max_us = json.value("max_us").toDouble();
    return facts;
}

void addFacts(ReportData& data, const database::SessionRecord& record, const session::SessionSetup& setup,
              const std::string& language) {
    const catalogue::ExerciseLevel& level = setup.level;
    data.simulated = !record.setup.operatorName.empty();
    data.person = QString::fromStdString(record.summary.personName);
    if (data.simulated)
        data.person = QStringLiteral("%1 (scripted), seed %2")
                          .arg(QString::fromStdString(record.setup.operatorName))
                          .arg(record.setup.seed);
    data.demonstration = record.summary.demonstration;
    data.exerciseId = QString::fromStdString(level.exercise);
    data.exerciseTitle = QString::fromStdString(level.exercise).replace(QLatin1Char('_'), QLatin1Char(' '));
    data.levelTitle = QString::fromStdString(catalogue::textIn(level.title, language));
    data.level = level.number;
    data.startedUtc =
        QDateTime::fromString(QString::fromStdString(record.summary.startedUtc), Qt::ISODateWithMs);
    data.offsetMinutes = record.summary.utcOffset_min;
    data.device = QString::fromStdString(setup.devices.front().model);
    data.felt = record.setup.felt;
    data.state = QString::fromUtf8(database::token(record.summary.state).data());
    data.forceLimit_N = std::min(record.setup.forceLimit_N, session::levelLimits(level).force_N);
    data.loop = loopFactsOf(record.loopJson);
    data.integrity.sessionId = QString::number(record.summary.id);
    data.integrity.frames = record.summary.frames;
    data.integrity.dropped = record.summary.dropped;
    data.integrity.bytes = record.summary.recordingBytes;
    data.integrity.buildId = QString::fromStdString(record.setup.buildId);
    data.integrity.contentSha256 = QString::fromStdString(record.contentSha256);
    data.integrity.taskSha256 = QString::fromStdString(catalogue::taskSha256(record.setup.contentJson));
}

/// BLAKE2b-256 over the chunks' force digests, hex. It identifies the recording in the footer of every page.
core::Result<QString> recordingDigestOf(session::SessionView& session) {
    QCryptographicHash hash(QCryptographicHash::Blake2b_256);
    for (std::size_t i = 0; i < session.reader().chunkCount(); ++i) {
        auto digest = session.reader().forceHash(i);
        CHIRON_TRY(digest);
        hash.addData(
            QByteArrayView(reinterpret_cast<const char*>(digest->data()), qsizetype(digest->size())));
    }
    return QString::fromLatin1(hash.result().toHex());
}

} // namespace

int trialsDoneOf(const std::vector<database::TrialRecord>& trials) {
    return static_cast<int>(
        std::count_if(trials.begin(), trials.end(), [](const database::TrialRecord& trial) {
            return trial.state == database::SessionState::completed;
        }));
}

report::ForceFacts feltFactsOf(const scoring::SessionTrace& trace) {
    const scoring::ForceFacts facts = scoring::forceFactsOf(trace);
    return {facts.tissue_N, facts.commanded_N, facts.limited_s, facts.firstLimited_s,
            facts.beyondCheckedShare()};
}

void addPublishedBand(MetricRow& row, int version) {
    const scoring::MetricDefinition* metric = scoring::findMetric(row.id.toStdString(), version);
    if (metric == nullptr || !metric->published)
        return;
    row.bandLow = metric->published->low;
    row.bandHigh = metric->published->high;
    const std::string_view source = metric->published->source;
    row.bandSource = QString::fromUtf8(source.data(), static_cast<qsizetype>(source.size()));
}

core::Result<ReportData> reportHeadOf(const database::SessionRecord& record,
                                      const session::SessionSetup& setup, database::Connection& connection,
                                      const database::Actor& actor, const std::string& language) {
    ReportData data;
    addFacts(data, record, setup, language);
    const auto site = database::SiteRepository(connection, actor).siteName();
    auto trials = database::SessionReader(connection, actor).trials(record.summary.id);
    CHIRON_TRY(site);
    CHIRON_TRY(trials);
    data.site = QString::fromStdString(*site);
    data.trialsDone = trialsDoneOf(*trials);
    database::ScoreRepository repository(connection, actor);
    auto card = repository.scores(record.summary.id);
    if (card) {
        const bool judged = isJudged(record);
        // If all trials were broken off, no metrics are shown.
        if (judged || data.trialsDone > 0) {
            data.metrics = rowsOf(*card, setup.level, record.setup.felt, judged, data.trialsDone);
            const auto seal = repository.scoreSeal(record.summary.id);
            CHIRON_TRY(seal);
            data.integrity.scoreSeal = QString::fromStdString(recording::toHex(*seal));
        }
        if (judged && !setup.level.gates.empty())
            data.passed = card->passed;
    } else if (!core::failedAs(card, core::ErrorCode::notFound)) {
        CHIRON_TRY(card);
    }
    return data;
}

core::Result<ReportData> reportDataOf(session::SessionView& session, database::Connection& connection,
                                      const database::Actor& actor, const std::string& language) {
    auto head = reportHeadOf(session.record(), session.setup(), connection, actor, language);
    CHIRON_TRY(head);
    ReportData data = std::move(*head);
    CHIRON_TRY(session.decode());
    const scoring::SessionTrace& trace = **session.trace();
    if (auto section = exerciseSectionOf(trace, session.setup().level))
        data.sections.push_back(std::move(section));
    data.force = feltFactsOf(trace);
    // Curves and critical errors are the same as in playback.
    const session::PlaybackTrack& track = **session.track();
    data.series = seriesOf(track, session.setup().level,
                           QLocale(QString::fromStdString(std::string(core::languageOf(language).locale))));
    data.duration_s = track.duration_s;
    auto digest = recordingDigestOf(session);
    CHIRON_TRY(digest);
    data.integrity.recordingDigest = std::move(*digest);
    return data;
}

} // namespace chiron::session_report
