// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/results/results_data.h"

#include "database/repositories/privacy_repository.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "session/person_json.h"
#include "session/session_export.h"
#include "session/session_view.h"

#include <QDateTime>
#include <QDir>
#include <QJsonDocument>
#include <QSaveFile>

namespace chiron::desktop {

namespace {

tl::unexpected<core::Error> stopped() {
    return core::fail(core::ErrorCode::cancelled, "stopped by the person");
}

core::Result<void> writeJson(const QString& path, const QJsonObject& json) {
    QSaveFile file(path);
    const QByteArray text = QJsonDocument(json).toJson();
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return core::fail(core::ErrorCode::storage,
                          (path + QStringLiteral(": ") + file.errorString()).toStdString());
    return {};
}

core::Result<void> writeSamples(database::Connection& connection, const database::Actor& actor,
                                database::SessionId session, const QDir& folder) {
    auto stored = session::SessionView::open(connection, actor, session);
    CHIRON_TRY(stored);
    return session::exportCsv(**stored, folder.filePath(QStringLiteral("session_%1.csv").arg(session)));
}

core::Result<QDir> newFolder(const QString& parent, const database::Person& person) {
    const QString name =
        QStringLiteral("chiron-%1-%2")
            .arg(QString::fromStdString(person.name),
                 QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMdd-HHmmss")));
    QDir folder(parent);
    if (!folder.mkdir(name) || !folder.cd(name))
        return core::fail(core::ErrorCode::storage,
                          folder.filePath(name).toStdString() + ": the folder could not be made");
    return folder;
}

} // namespace

const scoring::MetricValue* Attempt::metric(const std::string& id) const {
    for (const scoring::MetricValue& value : metrics)
        if (value.id == id)
            return &value;
    return nullptr;
}

bool Attempt::onCurve() const {
    return summary.state == database::SessionState::completed && summary.attempt > 0;
}

core::Result<std::vector<Attempt>> loadAttempts(database::Connection& connection,
                                                const database::Actor& actor, database::PersonId person,
                                                const std::function<bool(double)>& progress) {
    database::SessionFilter filter;
    filter.person = person;
    auto sessions = database::SessionReader(connection, actor).listSessions(filter);
    CHIRON_TRY(sessions);
    database::ScoreRepository scores(connection, actor);
    std::vector<Attempt> attempts;
    for (database::SessionSummary& summary : *sessions) {
        if (!progress(static_cast<double>(attempts.size()) / static_cast<double>(sessions->size())))
            return stopped();
        auto card = scores.scores(summary.id);
        if (!core::failedAs(card, core::ErrorCode::notFound))
            CHIRON_TRY(card);
        attempts.push_back(
            {std::move(summary), card ? std::move(card->metrics) : std::vector<scoring::MetricValue>{}});
    }
    return attempts;
}

core::Result<std::string> exportOwnData(database::Connection& connection, const database::Actor& actor,
                                        const std::string& parent,
                                        const std::function<bool(double)>& progress) {
    auto everything = database::PrivacyRepository(connection, actor).exportPerson(actor.personId());
    CHIRON_TRY(everything);
    auto folder = newFolder(QString::fromStdString(parent), everything->person);
    CHIRON_TRY(folder);
    CHIRON_TRY(
        writeJson(folder->filePath(QStringLiteral("person.json")), session::personExportJson(*everything)));
    std::size_t done = 0;
    for (const database::PersonSession& session : everything->sessions) {
        if (!progress(static_cast<double>(done++) / static_cast<double>(everything->sessions.size())))
            return stopped();
        const database::SessionSummary& summary = session.record.summary;
        if (summary.recordingErased || summary.chunks == 0 || session.sealed)
            continue;
        CHIRON_TRY(writeSamples(connection, actor, summary.id, *folder));
    }
    return folder->path().toStdString();
}

} // namespace chiron::desktop
