// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_groups.h"
#include "cli/session_output.h"
#include "cli/site_access.h"
#include "database/repositories/score_repository.h"
#include "scoring/force_facts.h"
#include "session/replayer.h"

#include <QJsonValue>
#include <limits>

namespace chiron::cli {

namespace {

/// A session opened for review: database, connection and session in the order of their lifetimes.
struct Opened {
    Site site;
    std::unique_ptr<database::Connection> connection;
    std::unique_ptr<session::SessionView> session;
};

core::Result<Opened> openStored(const Arguments& arguments) {
    auto id = arguments.integerOperand(0, 1, std::numeric_limits<qint64>::max());
    CHIRON_TRY(id);
    auto site = openAsAnybody(arguments, Opening::forReading);
    CHIRON_TRY(site);
    auto connection = site->database->openReader();
    CHIRON_TRY(connection);
    auto session = session::SessionView::open(**connection, site->actor, *id);
    CHIRON_TRY(session);
    return Opened{std::move(*site), std::move(*connection), std::move(*session)};
}

/// The force of the tissue and the force felt (commanded). States if more than 1 % of the samples behind a
/// score lie outside the range for which the law was checked (data.md, Range of a law).
QJsonObject forceJson(const scoring::ForceFacts& force, bool felt) {
    return {
        {"tissue_max_N", force.tissue_N},
        {"felt_max_N", felt ? QJsonValue(force.commanded_N) : QJsonValue()},
        {"limited_s", felt ? QJsonValue(force.limited_s) : QJsonValue()},
        {"first_limited_s", felt && force.firstLimited_s ? QJsonValue(*force.firstLimited_s) : QJsonValue()},
        {"beyond_checked_share", force.beyondCheckedShare()}};
}

QString forceText(const scoring::ForceFacts& force, bool felt) {
    QString text = QStringLiteral("\ntissue answered with up to %1 N; ").arg(force.tissue_N, 0, 'f', 2);
    text += !felt ? QStringLiteral("shown, not felt\n")
                  : QStringLiteral("felt (commanded) up to %1 N, limited for %2 s\n")
                        .arg(force.commanded_N, 0, 'f', 2)
                        .arg(force.limited_s, 0, 'f', 2);
    constexpr double kSaid = 0.01;
    if (force.beyondCheckedShare() > kSaid)
        text +=
            QStringLiteral("%1 % of the samples lie outside the range for which the force law was checked\n")
                .arg(100.0 * force.beyondCheckedShare(), 0, 'f', 1);
    return text;
}

core::Result<CommandOutput> score(const Arguments& arguments) {
    auto version = arguments.integer(QStringLiteral("metric-version"), 1, 1000, 0);
    CHIRON_TRY(version);
    auto opened = openStored(arguments);
    CHIRON_TRY(opened);
    auto card = opened->session->computeScores(static_cast<int>(*version));
    CHIRON_TRY(card);
    auto view = viewOf(*opened->connection, opened->site.actor, opened->session->record().summary.id);
    CHIRON_TRY(view);
    const bool same = session::sameScores(view->card, *card);
    const QJsonArray stored = metricsJson(view->card.metrics);
    view->card = std::move(*card);
    auto trace = opened->session->trace();
    CHIRON_TRY(trace);
    const scoring::ForceFacts force = scoring::forceFactsOf(**trace);
    const bool felt = opened->session->record().setup.felt;
    QJsonObject json = scoreJson(*view);
    json.insert("force", forceJson(force, felt));
    json.insert("stored", stored);
    json.insert("same", same);
    const QString verdict =
        same ? QStringLiteral("\nsame as stored\n") : QStringLiteral("\nDIFFERS from what is stored\n");
    // Another version of a metric may give other values: that is a result, not a failure.
    return CommandOutput{QJsonDocument(json), scoreText(*view) + forceText(force, felt) + verdict,
                         same || *version > 0 ? 0 : 1};
}

core::Result<CommandOutput> replay(const Arguments& arguments) {
    auto opened = openStored(arguments);
    CHIRON_TRY(opened);
    auto report = session::replaySession(*opened->session);
    CHIRON_TRY(report);
    QJsonObject json{{"session_id", static_cast<double>(opened->session->record().summary.id)},
                     {"frames", static_cast<double>(report->frames)},
                     {"identical", report->identical},
                     {"comparable", report->comparable},
                     {"max_difference_N", report->maximumDifference_N},
                     {"first_different_tick", report->firstDifferentTick ? QJsonValue(static_cast<double>(
                                                                               *report->firstDifferentTick))
                                                                         : QJsonValue()}};
    if (!report->note.empty())
        json.insert("note", QString::fromStdString(report->note));
    const QString text =
        QStringLiteral("%1 frames re-simulated: %2 (largest difference %3 N)%4\n")
            .arg(report->frames)
            .arg(report->identical ? QStringLiteral("identical") : QStringLiteral("NOT identical"))
            .arg(report->maximumDifference_N)
            .arg(report->note.empty() ? QString()
                                      : QStringLiteral("; not comparable bit for bit: ") +
                                            QString::fromStdString(report->note));
    return CommandOutput{QJsonDocument(json), text, report->identical || !report->comparable ? 0 : 1};
}

} // namespace

std::vector<CommandSpec> reviewCommands() {
    CommandSpec scoring;
    scoring.group = QStringLiteral("score");
    scoring.summary = QStringLiteral("compute a session's scores again from its recording");
    scoring.operands = {{QStringLiteral("ID"), QStringLiteral("number of the session")}};
    scoring.options = {
        {QStringLiteral("metric-version"), QStringLiteral("V"),
         QStringLiteral(
             "of every metric that has it, the newest below of the others; default: the session's own")}};
    scoring.example = QStringLiteral("chiron-cli score 12 --json");
    scoring.run = score;
    CommandSpec replaying;
    replaying.group = QStringLiteral("replay");
    replaying.summary =
        QStringLiteral("simulate a session again from its recorded inputs and compare the forces");
    replaying.operands = scoring.operands;
    replaying.example = QStringLiteral("chiron-cli replay 12 --json");
    replaying.run = replay;
    return {scoring, replaying};
}

} // namespace chiron::cli
