// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cli_errors.h"
#include "cli/session_output.h"
#include "cli/study/apex_output.h"
#include "cli/study/study_access.h"
#include "cli/study/study_to_run.h"
#include "cli/text_table.h"
#include "database/accounts/account_service.h"
#include "session/site.h"
#include "session/study/study_runner.h"
#include "session/study/trial_fidelity.h"
#include "session/study_export_data.h"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <atomic>
#include <cmath>
#include <csignal>

namespace chiron::cli {

namespace {

using namespace psychophysics;

std::atomic<bool> g_cancel{false}; // the only object that the signal handler may touch

void onSignal(int) {
    g_cancel.store(true, std::memory_order_relaxed);
}

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

QJsonValue number(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

/// While the study is blinded, omits values and everything else by which conditions could be told apart.
QJsonObject trialJson(const database::StudyTrial& t, const Condition& condition,
                      const session::StudyExportData& data) {
    QJsonObject json{{"ordinal", t.ordinal},       {"practice", t.practice},
                     {"spoiled", text(t.spoiled)}, {"exploration_s", t.exploration_s},
                     {"answer_s", t.answer_s},     {"paused_s", number(session::pausedOf(t.fidelityJson))},
                     {"device", text(t.device)},   {"force_class", forceClassJson(t.felt)}};
    if (!data.blinded || data.oneTable)
        json.insert("difference", t.difference);
    for (const auto& [key, value] :
         {std::pair{"arrangement", t.arrangement}, {"answer", t.answer}, {"outcome", t.outcome}})
        if (!data.blinded || data.oneTask)
            json.insert(QLatin1String(key), value);
    if (data.blinded)
        return json;
    QJsonArray values;
    for (const int multiple : arrangements(condition.task)[static_cast<std::size_t>(t.arrangement)])
        values.append(condition.stimulus.reference * std::pow(10.0, multiple * t.difference));
    json.insert("procedure", t.procedure);
    json.insert("candidate", t.candidate);
    json.insert("values", values);
    json.insert("value", t.value ? number(*t.value) : QJsonValue(QJsonValue::Null));
    json.insert("entropy_margin", number(t.entropyMargin));
    json.insert("session_id", static_cast<qint64>(t.session));
    if (const QJsonObject mark = apexMarkJson(t); !mark.isEmpty())
        json.insert("mark", mark);
    json.insert("fidelity", QJsonDocument::fromJson(QByteArray::fromStdString(t.fidelityJson)).object());
    return json;
}

QJsonArray runsJson(const session::StudyExportData& data, const std::string& code) {
    QJsonArray all;
    for (const session::ExportedParticipant& each : data.participants) {
        if (each.participant.code != code)
            continue;
        for (const session::ExportedRun& run : each.runs) {
            QJsonArray list;
            for (const database::StudyTrial& trial : run.trials)
                list.append(trialJson(trial, *run.condition, data));
            QJsonObject json{{"condition", run.label},
                             {"run", run.index},
                             {"completed", run.run.state == database::StudyRunState::completed},
                             {"trials", list},
                             {"estimate", estimateJson(run.estimate, data.blinded)}};
            if (!data.blinded)
                json.insert("seed", QString::number(run.run.seed));
            all.append(json);
        }
    }
    return all;
}

/// A table with the position of each mark of an apex; empty in other studies.
QString marksText(const QJsonArray& runs) {
    TextTable table({"condition", ">trial", ">x (%R)", ">y (%R)", ">distance (mm)", "not counted"});
    bool any = false;
    for (const QJsonValue& run : runs)
        for (const QJsonValue& trial : run["trials"].toArray()) {
            if (!trial["mark"].isObject())
                continue;
            any = true;
            const QString why =
                trial["practice"].toBool() ? QStringLiteral("practice") : trial["spoiled"].toString();
            table.add({run["condition"].toString(), QString::number(trial["ordinal"].toInt()),
                       shortNumber(trial["mark"]["error_x_percent"].toDouble()),
                       shortNumber(trial["mark"]["error_y_percent"].toDouble()),
                       shortNumber(1000.0 * trial["value"].toDouble()), why});
        }
    return any ? table.toText() : QString();
}

/// The limits of what the device could render, at the delay measured on it; null for a quick run, which has
/// no device.
QJsonValue deviceJson(const std::optional<session::RenderingLimits>& limits) {
    if (!limits)
        return QJsonValue::Null;
    return QJsonObject{{"delay_us", 1e6 * limits->delay_s},
                       {"delay_measured", limits->measured},
                       {"stiffness_cap_N_per_m", number(limits->largestStiffness_N_per_m)},
                       {"force_limit_N", number(limits->largestForce_N)},
                       {"viscosity_cap_Ns_per_m", number(limits->largestViscosity_Ns_per_m)}};
}

core::Result<CommandOutput> told(database::Database& database, const database::Actor& actor,
                                 const database::StudyRecord& study, const database::Participant& participant,
                                 const session::StudyRunReport& report) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    database::StudyReader reader(**connection, actor);
    const auto data = session::gatherStudy(reader, study.summary.id);
    CHIRON_TRY(data);
    const QJsonArray runs = runsJson(*data, participant.code);
    QJsonObject json{{"study", text(study.summary.key)},
                     {"sha256", text(study.summary.sha256)},
                     {"participant", text(participant.code)},
                     {"observer", text(participant.observer)},
                     {"blinded", data->blinded},
                     {"device", deviceJson(report.limits)},
                     {"runs", runs}};
    // The keys that cli.md specifies describe the first condition.
    if (!runs.isEmpty()) {
        json.insert("trials", runs.first()["trials"]);
        json.insert("estimate", runs.first()["estimate"]);
    }
    TextTable table({"condition", "completed", ">trials", ">Weber", ">low", ">high", ">exponent"});
    for (const QJsonValue& run : runs) {
        const QJsonObject e = run["estimate"].toObject();
        const auto shown = [&](const char* key) {
            return shortNumber(e[QLatin1String(key)].toDouble(std::nan("")));
        };
        table.add({run["condition"].toString(), run["completed"].toBool() ? "yes" : "no",
                   e["trials"].isNull() ? QStringLiteral("sealed") : QString::number(e["trials"].toInt()),
                   shown("weber"), shown("ci_low"), shown("ci_high"), shown("exponent")});
    }
    return CommandOutput{QJsonDocument(json), table.toText() + marksText(runs), 0};
}

core::Result<session::StudyRunRequest> requestOf(const Arguments& arguments) {
    session::StudyRunRequest request;
    const auto observer = parseObserver(arguments.value(QStringLiteral("observer")).toStdString());
    if (!observer)
        return badInput(QStringLiteral("--observer: %1").arg(text(observer.error().message)));
    const auto seed = arguments.seed(QStringLiteral("seed"), 1);
    const auto most = arguments.integer(QStringLiteral("trials"), 1, 100'000, 0);
    CHIRON_TRY(seed);
    CHIRON_TRY(most);
    request.observer = *observer;
    request.seed = *seed;
    request.seedGiven = arguments.has(QStringLiteral("seed"));
    request.trialsAtMost = static_cast<int>(*most);
    request.quick = arguments.has(QStringLiteral("quick"));
    request.condition = arguments.value(QStringLiteral("condition")).toStdString();
    request.participantCode = arguments.value(QStringLiteral("participant")).toStdString();
    request.cancel = &g_cancel;
    return request;
}

} // namespace

core::Result<CommandOutput> runStudy(const Arguments& arguments) {
    if (arguments.has(QStringLiteral("person"))) {
        if (arguments.has(QStringLiteral("participant")) || arguments.has(QStringLiteral("observer")))
            return wrongUse(QStringLiteral("--person: a person answers in the window; expected neither "
                                           "--participant nor --observer with it"));
        return openSitting(databasePath(arguments), arguments.operand(0),
                           arguments.value(QStringLiteral("person")));
    }
    for (const char* name : {"participant", "observer"})
        if (!arguments.has(QLatin1String(name)))
            return wrongUse(QStringLiteral("study run: --%1 is missing; expected --participant CODE and "
                                           "--observer SPEC for a simulated participant, or --person CODE")
                                .arg(QLatin1String(name)));
    auto request = requestOf(arguments);
    CHIRON_TRY(request);
    std::vector<std::string> secrets;
    if (arguments.has(QStringLiteral("as"))) {
        auto read = readSecrets(arguments, {QStringLiteral("CHIRON_PASSWORD")});
        CHIRON_TRY(read);
        secrets = std::move(*read);
    }
    const QString file = databasePath(arguments);
    const QString name = arguments.operand(0);
    // A database is created only for a run that can be done.
    if (!QFileInfo::exists(file)) {
        if (!secrets.empty())
            return core::fail(
                core::ErrorCode::notFound,
                QStringLiteral("--database %1: no such file; expected a database with the account of --as")
                    .arg(quoted(file))
                    .toStdString());
        const auto wanted = findStudyToRun(nullptr, database::Actor::simulated(), name);
        CHIRON_TRY(wanted);
        CHIRON_TRY(mayBeRun(*wanted, *request));
    }
    auto site = session::openSite(file.toStdString(), databaseOptions());
    CHIRON_TRY(site);
    const auto actor = secrets.empty()
                           ? core::Result<database::Actor>(database::Actor::simulated())
                           : database::AccountService(*site->database)
                                 .login(arguments.value(QStringLiteral("as")).toStdString(), secrets[0]);
    CHIRON_TRY(actor);
    const auto wanted = findStudyToRun(site->database.get(), *actor, name);
    CHIRON_TRY(wanted);
    CHIRON_TRY(mayBeRun(*wanted, *request));
    const auto ready = makeReady(*site->database, *actor, *wanted, *request);
    CHIRON_TRY(ready);
    request->study = ready->study.summary.id;
    request->participantCode = ready->participant.code;
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    auto report = session::runStudyHeadless(*site->database, *actor, *request);
    CHIRON_TRY(report);
    return told(*site->database, *actor, ready->study, ready->participant, *report);
}

core::Result<CommandOutput> rerunStudy(const Arguments& arguments) {
    auto study = openStudy(arguments, Opening::forReading);
    CHIRON_TRY(study);
    database::StudyReader reader = study->reader();
    const auto data = session::gatherStudy(reader, study->number());
    CHIRON_TRY(data);
    if (data->blinded && !data->blinding.analysable())
        return core::fail(core::ErrorCode::wrongUse,
                          "study \"" + study->record.summary.key +
                              "\" is blinded and its conditions differ: expected it to be unblinded first");
    QJsonArray runs;
    bool identical = true;
    TextTable table({"participant", "condition", ">trials", ">same", ">ties", "first difference"});
    for (const session::ExportedParticipant& each : data->participants) {
        for (const session::ExportedRun& run : each.runs) {
            // The condition was sealed with the device's limit, so there is nothing to repeat.
            if (run.run.procedures.empty())
                continue;
            database::StudyRun byStandIn = run.run;
            byStandIn.condition = run.condition->id;
            const auto again = session::rerunChoices(*data->design, byStandIn, run.trials);
            CHIRON_TRY(again);
            identical = identical && again->identical();
            runs.append(QJsonObject{{"participant", text(each.participant.code)},
                                    {"condition", run.label},
                                    {"trials", again->trials},
                                    {"same", again->same},
                                    {"ties", again->ties},
                                    {"first_difference", again->firstDifference},
                                    {"same_procedures", again->sameProcedures},
                                    {"identical", again->identical()}});
            table.add({text(each.participant.code), run.label, QString::number(again->trials),
                       QString::number(again->same), QString::number(again->ties),
                       again->firstDifference < 0 ? QString() : QString::number(again->firstDifference)});
        }
    }
    return CommandOutput{QJsonDocument(QJsonObject{{"study", text(study->record.summary.key)},
                                                   {"identical", identical},
                                                   {"runs", runs}}),
                         table.toText(), identical ? 0 : 1};
}

} // namespace chiron::cli
