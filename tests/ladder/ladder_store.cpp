// SPDX-License-Identifier: GPL-3.0-or-later
#include "ladder/ladder_store.h"

#include "core/fp_environment.h"
#include "session/score_json.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QUuid>
#include <algorithm>
#include <utility>

namespace chiron::tests {

namespace {

QString text(const std::string& value) {
    return QString::fromStdString(value);
}

/// What git answers in the source tree; nothing if it fails.
QByteArray git(const QStringList& arguments) {
    QProcess process;
    process.setWorkingDirectory(QStringLiteral(CHIRON_SOURCE_DIR));
    process.start(QStringLiteral("git"), arguments);
    if (!process.waitForFinished() || process.exitStatus() != QProcess::NormalExit || process.exitCode() != 0)
        return {};
    return process.readAllStandardOutput().trimmed();
}

std::string commitOfSources() {
    const QByteArray commit =
        git({QStringLiteral("rev-parse"), QStringLiteral("--short=12"), QStringLiteral("HEAD")});
    // A key of its own each time where it is not known which sources were built, so that no result of other
    // sources is taken for theirs.
    const std::string once = "+" + QUuid::createUuid().toString(QUuid::Id128).toStdString();
    if (commit.isEmpty())
        return "unknown" + once;
    const QByteArray diff = git({QStringLiteral("diff"), QStringLiteral("--binary"), QStringLiteral("HEAD")});
    if (diff.isEmpty())
        return commit.toStdString();
    const QByteArray digest = QCryptographicHash::hash(diff, QCryptographicHash::Sha256).toHex().left(12);
    return commit.toStdString() + "+" + digest.toStdString();
}

std::string fileOf(const std::string& folder, const catalogue::ExerciseLevel& level) {
    return folder + "/" + level.exercise + "_" + std::to_string(level.number) + ".jsonl";
}

/// Every stored session of a level; a line that was cut off is none.
std::vector<QJsonObject> linesOf(const std::string& file) {
    std::vector<QJsonObject> lines;
    QFile stored(text(file));
    if (!stored.open(QIODevice::ReadOnly))
        return lines; // nothing was run yet
    for (const QByteArray& line : stored.readAll().split('\n'))
        if (const QJsonDocument json = QJsonDocument::fromJson(line); json.isObject())
            lines.push_back(json.object());
    return lines;
}

/// What has to agree for a stored session to count as one of this run.
QJsonObject keyOf(const catalogue::ExerciseLevel& level, const std::string& operatorName,
                  const LadderSettings& settings, const LadderStore::Sources& sources) {
    return {{"level", text(nameOf(level))},
            {"operator", text(operatorName)},
            {"mechanism", text(settings.mechanism)},
            {"hand", text(settings.hand)},
            {"budget_Ns_per_m", settings.budget_Ns_per_m},
            {"commit", text(sources.commit)},
            {"models", text(sources.models)}};
}

QJsonObject jsonOf(const LadderSession& session) {
    return {{"seed", QString::number(session.seed)},
            {"completed", session.completed},
            {"passed", session.card.passed},
            {"metrics", session::metricsJson(session.card.metrics)},
            {"ticks", static_cast<qint64>(session.ticks)},
            {"acted", static_cast<qint64>(session.acted)},
            {"kept_J", session.kept_J},
            {"withheld_J", session.withheld_J},
            {"held_beyond_J", session.heldBeyond_J},
            {"tissue_N", session.tissue_N},
            {"commanded_N", session.commanded_N},
            {"fast_N", session.fast_N},
            {"fast_ends_s", session.fastEnds_s},
            {"windows", static_cast<qint64>(session.windows)},
            {"checked", session.checked},
            {"replays_identically", session.replaysIdentically},
            {"scores_identically", session.scoresIdentically}};
}

scoring::MetricValue metricOf(const QJsonObject& json) {
    scoring::MetricValue metric;
    metric.id = json["id"].toString().toStdString();
    metric.version = json["version"].toInt();
    metric.unit = json["unit"].toString().toStdString();
    if (json["value"].isDouble())
        metric.value = json["value"].toDouble();
    if (json["passed"].isBool())
        metric.passed = json["passed"].toBool();
    return metric;
}

LadderSession sessionOf(const QJsonObject& json) {
    LadderSession session;
    session.seed = json["seed"].toString().toULongLong();
    session.completed = json["completed"].toBool();
    session.card.passed = json["passed"].toBool();
    for (const QJsonValue& metric : json["metrics"].toArray())
        session.card.metrics.push_back(metricOf(metric.toObject()));
    session.ticks = static_cast<std::uint64_t>(json["ticks"].toInteger());
    session.acted = static_cast<std::uint64_t>(json["acted"].toInteger());
    session.kept_J = json["kept_J"].toDouble();
    session.withheld_J = json["withheld_J"].toDouble();
    session.heldBeyond_J = json["held_beyond_J"].toDouble();
    session.tissue_N = json["tissue_N"].toDouble();
    session.commanded_N = json["commanded_N"].toDouble();
    session.fast_N = json["fast_N"].toDouble();
    session.fastEnds_s = json["fast_ends_s"].toDouble();
    session.windows = static_cast<std::uint64_t>(json["windows"].toInteger());
    session.checked = json["checked"].toBool();
    session.replaysIdentically = json["replays_identically"].toBool();
    session.scoresIdentically = json["scores_identically"].toBool();
    return session;
}

} // namespace

LadderStore::Sources LadderStore::present() {
    return {commitOfSources(), core::modelsOfBuild(core::buildId())};
}

std::optional<LadderStore::Sources> LadderStore::last(const std::string& folder,
                                                      const catalogue::ExerciseLevel& level) {
    const std::vector<QJsonObject> lines = linesOf(fileOf(folder, level));
    if (lines.empty())
        return std::nullopt;
    const QJsonObject run = lines.back()["run"].toObject();
    return Sources{run["commit"].toString().toStdString(), run["models"].toString().toStdString()};
}

LadderStore::LadderStore(std::string folder, Sources sources)
    : m_folder(std::move(folder)), m_sources(std::move(sources)) {
    if (!QDir().mkpath(text(m_folder)))
        qFatal("%s: the folder cannot be made", m_folder.c_str());
}

std::vector<LadderSession> LadderStore::sessions(const catalogue::ExerciseLevel& level,
                                                 const std::string& operatorName,
                                                 const LadderSettings& settings) const {
    std::vector<LadderSession> found;
    const QJsonObject key = keyOf(level, operatorName, settings, m_sources);
    for (const QJsonObject& line : linesOf(fileOf(m_folder, level))) {
        if (line["run"].toObject() != key)
            continue;
        const LadderSession session = sessionOf(line["session"].toObject());
        const auto same = std::find_if(found.begin(), found.end(), [&session](const LadderSession& other) {
            return other.seed == session.seed;
        });
        if (same == found.end())
            found.push_back(session);
        else
            *same = session;
    }
    return found;
}

void LadderStore::add(const catalogue::ExerciseLevel& level, const std::string& operatorName,
                      const LadderSettings& settings, const LadderSession& session) {
    const std::string path = fileOf(m_folder, level);
    QFile file(text(path));
    if (!file.open(QIODevice::Append))
        qFatal("%s: %s", path.c_str(), qPrintable(file.errorString()));
    const QJsonObject line{{"run", keyOf(level, operatorName, settings, m_sources)},
                           {"session", jsonOf(session)}};
    // The newline comes first, so that a line that was cut off spoils no other
    file.write("\n" + QJsonDocument(line).toJson(QJsonDocument::Compact) + "\n");
}

} // namespace chiron::tests
