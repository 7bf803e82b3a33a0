// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/study_catalogue.h"
#include "catalogue/study_json.h"
#include "cli/cli_errors.h"
#include "cli/study/apex_output.h"
#include "cli/study/study_access.h"
#include "cli/study/study_file.h"
#include "cli/text_table.h"
#include "psychophysics/planning/study_plan.h"
#include "session/new_folder.h"
#include "session/study/study_run_check.h"
#include "session/study_export.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace chiron::cli {

namespace {

using namespace psychophysics;

QString text(std::string_view words) {
    return QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

QString english(const StudyText& words) {
    const auto found = words.find("en");
    return found == words.end() ? QString() : QString::fromStdString(found->second);
}

/// Reads the design from a file, from the database, or else from the content that comes with the program.
core::Result<StudyDesign> designOf(const Arguments& arguments) {
    if (isStudyFile(arguments.operand(0)))
        return readStudyFile(arguments.operand(0));
    if (QFileInfo::exists(databasePath(arguments))) {
        auto study = openStudy(arguments, Opening::forReading);
        // Its conditions are sealed, and with them the values to plan with.
        if (study && study->record.masked)
            return core::fail(core::ErrorCode::notAllowed,
                              QStringLiteral("study %1 is blinded; expected --as its author or an "
                                             "administrator, or the study to be unblinded first")
                                  .arg(quoted(QString::fromStdString(study->record.summary.key)))
                                  .toStdString());
        if (study)
            return catalogue::readStudy(QByteArray::fromStdString(study->record.designJson),
                                        study->record.summary.key);
        if (!core::failedAs(study, core::ErrorCode::notFound))
            CHIRON_TRY(study);
    }
    const auto content = catalogue::StudyCatalogue::load();
    CHIRON_TRY(content);
    const StudyDesign* design = content->find(arguments.operand(0).toStdString());
    if (design)
        return *design;
    QStringList known;
    for (const StudyDesign& each : content->studies())
        known << QString::fromStdString(each.id);
    return core::fail(
        core::ErrorCode::notFound,
        QStringLiteral("STUDY %1: no such study; expected one of %2, one of the database, or a JSON file")
            .arg(quoted(arguments.operand(0)), known.join(QStringLiteral(", ")))
            .toStdString());
}

core::Result<QJsonArray> codesOf(database::StudyReader reader, database::StudyNumber study) {
    const auto codes = reader.conditionCodes(study);
    CHIRON_TRY(codes);
    QJsonArray array;
    for (const database::SealedCondition& each : *codes)
        array.append(text(each.sealedCode));
    return array;
}

QJsonValue numberOrNull(double value) {
    return std::isfinite(value) ? QJsonValue(value) : QJsonValue(QJsonValue::Null);
}

/// The reason why there is no best difference to present; empty if there is one.
QString withoutSpacing(Task task) {
    if (task == Task::adjustment)
        return QStringLiteral("adjustment: the participant sets the level, no difference is presented");
    return task == Task::magnitude
               ? QStringLiteral("magnitude estimation: single values are presented, no difference")
               : QString();
}

/// The assumptions of the power calculation of a comparison.
struct PowerInputs {
    PowerQuestion question;
    double wanted = 0.8;
    std::optional<double> ratio;
};

core::Result<std::optional<PowerInputs>> readPower(const Arguments& arguments, const StudyDesign& design) {
    for (const char* option :
         {"ratio", "participants", "wanted", "alpha", "paired", "unpaired", "between-sd"})
        if (arguments.has(QLatin1String(option)) && !arguments.has(QStringLiteral("power")))
            return wrongUse(QStringLiteral("--%1 without --power: expected both").arg(QLatin1String(option)));
    if (!arguments.has(QStringLiteral("power")))
        return std::nullopt;
    if (arguments.has(QStringLiteral("paired")) && arguments.has(QStringLiteral("unpaired")))
        return wrongUse(QStringLiteral("--paired and --unpaired were given: expected one of them"));
    PowerInputs inputs;
    PowerQuestion& question = inputs.question;
    question.paired = !arguments.has(QStringLiteral("unpaired"));
    constexpr int kMost = 100'000;
    const auto participants =
        arguments.integer(QStringLiteral("participants"), 2, kMost, std::max(2, design.participantsPlanned));
    const auto wanted = arguments.number(QStringLiteral("wanted"), 0.01, 0.9999, 0.8);
    const auto alpha = arguments.number(QStringLiteral("alpha"), 1e-6, 0.5, question.alpha);
    const auto between = arguments.number(QStringLiteral("between-sd"), 0.0, 3.0,
                                          question.paired ? question.effectSdLog10 : question.personSdLog10);
    const auto ratio = arguments.number(QStringLiteral("ratio"), 0.01, 100.0, 1.0);
    CHIRON_TRY(participants);
    for (const auto* each : {&wanted, &alpha, &between, &ratio})
        CHIRON_TRY(*each);
    question.participants = static_cast<int>(*participants);
    question.alpha = *alpha;
    (question.paired ? question.effectSdLog10 : question.personSdLog10) = *between;
    inputs.wanted = *wanted;
    if (arguments.has(QStringLiteral("ratio"))) {
        if (*ratio == 1.0)
            return wrongUse(QStringLiteral(
                "--ratio 1: expected a ratio other than 1, which is no difference that could be found"));
        inputs.ratio = *ratio;
        question.differenceLog10 = std::log10(*ratio);
    }
    return inputs;
}

/// The power of a comparison of two conditions like this one. The `_error` values are one standard error,
/// propagated from that of the runs' standard deviation.
QJsonObject powerJson(const PowerInputs& inputs, const ConditionPlan& plan) {
    PowerQuestion question = inputs.question;
    QJsonObject json{{"participants", question.participants},
                     {"alpha", question.alpha},
                     {"paired", question.paired},
                     {"wanted_power", inputs.wanted},
                     {"between_sd_log10", question.paired ? question.effectSdLog10 : question.personSdLog10},
                     {"run_sd_log10", numberOrNull(plan.sdLog10)}};
    question.runSdLog10 = plan.sdLog10;
    const auto insert = [&](const char* key, const std::function<double(const PowerQuestion&)>& figure) {
        const double value = std::isfinite(plan.sdLog10) ? figure(question) : std::nan("");
        json.insert(QLatin1String(key), numberOrNull(value));
        json.insert(QLatin1String(key) + QStringLiteral("_error"),
                    numberOrNull(figureError(question, plan.sdError, figure)));
    };
    insert("detectable_ratio", [&](const PowerQuestion& q) { return detectableRatio(q, inputs.wanted); });
    if (inputs.ratio) {
        json.insert("ratio", *inputs.ratio);
        insert("power", [](const PowerQuestion& q) { return power(q); });
        insert("participants_needed", [&](const PowerQuestion& q) {
            const int needed = participantsFor(q, inputs.wanted);
            return needed > 0 ? static_cast<double>(needed) : std::nan("");
        });
    }
    return json;
}

QString powerText(const QString& condition, const QJsonObject& json) {
    const auto shown = [&](const char* key) {
        const double value = json[QLatin1String(key)].toDouble(std::nan("")),
                     error = json[QLatin1String(key) + QStringLiteral("_error")].toDouble(std::nan(""));
        return std::isfinite(value) ? QStringLiteral("%1 ± %2").arg(shortNumber(value), shortNumber(error))
                                    : QStringLiteral("none");
    };
    QString words =
        QStringLiteral(
            "%1: %2 participants%3, sd %4 log10 %5, alpha %6: a ratio of %7 is found with %8 % power\n")
            .arg(condition)
            .arg(json["participants"].toInt())
            .arg(json["paired"].toBool() ? QStringLiteral(" who do both") : QStringLiteral(" in each group"))
            .arg(shortNumber(json["between_sd_log10"].toDouble()),
                 json["paired"].toBool() ? QStringLiteral("of the difference")
                                         : QStringLiteral("between people"),
                 shortNumber(json["alpha"].toDouble()), shown("detectable_ratio"),
                 shortNumber(100.0 * json["wanted_power"].toDouble()));
    if (json.contains("ratio"))
        words += QStringLiteral("%1: a ratio of %2 is found with a chance of %3; needed: %4 participants\n")
                     .arg(condition, shortNumber(json["ratio"].toDouble()), shown("power"),
                          shown("participants_needed"));
    return words;
}

QString withoutValueText(const QString& condition, const ConditionPlan& plan) {
    const QString said = QStringLiteral("%1: %2 of %3 simulated runs give no usable value")
                             .arg(condition)
                             .arg(plan.withoutValue.value_or(0))
                             .arg(plan.runs);
    return plan.trialsForValues > 0
               ? said + QStringLiteral("; with about %1 trials or more, fewer than 1 in 20 do\n")
                            .arg(plan.trialsForValues)
               : said + QLatin1Char('\n');
}

/// Without simulated runs, the number of trials of a run and its duration are not known.
QJsonObject planJson(const Condition& condition, const ConditionPlan& plan) {
    const QString why = withoutSpacing(condition.task);
    const bool simulated = plan.runs > 0;
    QJsonObject json{
        {"condition", text(condition.id)},
        {"title", english(condition.title)},
        {"runs", plan.runs},
        {"bias_log10", numberOrNull(plan.biasLog10)},
        {"sd_log10", numberOrNull(plan.sdLog10)},
        {"coverage", numberOrNull(plan.coverage)},
        {"trials", numberOrNull(simulated ? plan.meanTrials : std::nan(""))},
        {"minutes", numberOrNull(simulated ? plan.minutes : std::nan(""))},
        {"information_per_trial",
         numberOrNull(condition.task == Task::magnitude ? std::nan("") : plan.fisherPerTrial)},
        {"best_spacing_sigma", numberOrNull(why.isEmpty() ? plan.bestSpacing : std::nan(""))},
        {"best_difference", numberOrNull(why.isEmpty() ? plan.bestDifference : std::nan(""))},
        {"without_estimate", plan.withoutEstimate},
        {"without_value", plan.withoutValue ? QJsonValue(*plan.withoutValue) : QJsonValue()},
        {"trials_for_values", numberOrNull(plan.trialsForValues > 0 ? plan.trialsForValues : std::nan(""))},
        {"bias_log10_error", numberOrNull(plan.biasError)},
        {"sd_log10_error", numberOrNull(plan.sdError)},
        {"coverage_error", numberOrNull(plan.coverageError)},
        {"trials_error", numberOrNull(plan.trialsError)},
        {"minutes_error", numberOrNull(plan.minutesError)},
        {"weber_quantiles", QJsonObject{{"0.1", numberOrNull(plan.weber10)},
                                        {"0.5", numberOrNull(plan.weber50)},
                                        {"0.9", numberOrNull(plan.weber90)}}},
        {"weber_quantiles_error", QJsonObject{{"0.1", numberOrNull(plan.weber10Error)},
                                              {"0.5", numberOrNull(plan.weber50Error)},
                                              {"0.9", numberOrNull(plan.weber90Error)}}},
        {"warnings", warningsJson(plan.warnings, false)}};
    if (!why.isEmpty())
        json.insert("best_spacing_why", why);
    return json;
}

} // namespace

core::Result<CommandOutput> listStudies(const Arguments& arguments) {
    auto site = openAsAnybody(arguments, Opening::forReading);
    CHIRON_TRY(site);
    auto connection = site->database->openReader();
    CHIRON_TRY(connection);
    auto studies = database::StudyReader(**connection, site->actor)
                       .listStudies(arguments.has(QStringLiteral("archived")));
    CHIRON_TRY(studies);
    QJsonArray array;
    TextTable table({">id", "key", "title", "state", ">participants", ">completed", ">trials", "sha256"});
    for (const database::StudySummary& study : *studies) {
        array.append(studyJson(study));
        table.add({QString::number(study.id), text(study.key), text(study.title), stateWord(study.state),
                   QString::number(study.participants), QString::number(study.completed),
                   QString::number(study.trials), text(study.sha256).left(12)});
    }
    return CommandOutput{QJsonDocument(QJsonObject{{"studies", array}}), table.toText(), 0};
}

core::Result<CommandOutput> showStudy(const Arguments& arguments) {
    auto study = openStudy(arguments, Opening::forReading);
    CHIRON_TRY(study);
    auto participants = study->reader().participants(study->number());
    CHIRON_TRY(participants);
    QJsonObject json = studyJson(study->record.summary);
    QJsonArray list;
    TextTable table({"code", ">order", "state", "observer"});
    for (const database::Participant& each : *participants) {
        const QJsonObject participant = participantJson(each);
        list.append(participant);
        table.add({participant["code"].toString(), QString::number(each.order),
                   participant["state"].toString(), participant["observer"].toString()});
    }
    json.insert("participant_list", list);
    json.insert("blinded", study->record.blinding.on);
    if (!study->record.masked) {
        json.insert("design",
                    QJsonDocument::fromJson(QByteArray::fromStdString(study->record.designJson)).object());
    } else {
        auto codes = codesOf(study->reader(), study->number());
        CHIRON_TRY(codes);
        json.insert("conditions", std::move(*codes));
    }
    const QString head = alignedPairs({{"study", json["key"].toString()},
                                       {"title", json["title"].toString()},
                                       {"state", json["state"].toString()},
                                       {"sha256", json["sha256"].toString()}});
    return CommandOutput{QJsonDocument(json), head + table.toText(), 0};
}

core::Result<CommandOutput> exportStudy(const Arguments& arguments) {
    auto formats = arguments.list(QStringLiteral("format"));
    CHIRON_TRY(formats);
    if (formats->isEmpty())
        *formats << QStringLiteral("csv");
    for (const QString& format : *formats)
        if (format != u"csv" && format != u"bids")
            return wrongUse(QStringLiteral("--format: %1: unknown; expected csv, bids").arg(quoted(format)));
    auto study = openStudy(arguments, Opening::forReading);
    CHIRON_TRY(study);
    const QString out = QFileInfo(arguments.value(QStringLiteral("out"))).absoluteFilePath();
    QJsonArray folders;
    QString words;
    const auto folderOf = [&](const QString& format) {
        return formats->size() == 1 ? out : out + u'/' + format;
    };
    for (const QString& format : *formats) // check all of them before any is written
        CHIRON_TRY(session::NewFolder::isFree(folderOf(format).toStdString()));
    for (const QString& format : *formats) {
        const QString folder = folderOf(format);
        database::StudyReader reader = study->reader();
        const std::filesystem::path path(folder.toStdString());
        const auto written = format == u"csv"
                                 ? session::exportStudyCsv(reader, study->number(), path)
                                 : session::exportStudyBids(reader, *study->connection, study->site.actor,
                                                            study->number(), path);
        CHIRON_TRY(written);
        folders.append(folder);
        words += folder + u'\n';
    }
    return CommandOutput{QJsonDocument(QJsonObject{{"study", text(study->record.summary.key)},
                                                   {"sha256", text(study->record.summary.sha256)},
                                                   {"folders", folders}}),
                         words, 0};
}

core::Result<CommandOutput> planStudy(const Arguments& arguments) {
    const auto runs = arguments.integer(QStringLiteral("runs"), 0, 100'000, 100);
    const auto seed = arguments.seed(QStringLiteral("seed"), 1);
    CHIRON_TRY(runs);
    CHIRON_TRY(seed);
    const auto observer = parseObserver(arguments.value(QStringLiteral("observer")).toStdString());
    if (!observer)
        return badInput(QStringLiteral("--observer: %1").arg(text(observer.error().message)));
    const auto design = designOf(arguments);
    CHIRON_TRY(design);
    CHIRON_TRY(session::checkObserver(*design, *observer));
    const auto powerInputs = readPower(arguments, *design);
    CHIRON_TRY(powerInputs);
    if (*powerInputs && *runs < 2)
        return wrongUse(QStringLiteral(
            "--power: expected --runs of at least 2: the spread of a run's estimate is simulated"));
    QJsonArray conditions;
    TextTable table(
        {"condition", ">bias (log10)", ">sd (log10)", ">coverage", ">trials", ">minutes", ">information"});
    double minutes = 0.0, minutesError = 0.0;
    QString words;
    for (const Condition& condition : design->conditions) {
        ConditionPlan plan =
            planCondition(condition, design->trial, *observer, static_cast<int>(*runs), *seed);
        examineLength(plan, condition, *observer, *seed);
        QJsonObject json = planJson(condition, plan);
        if (condition.stimulus.attribute == Attribute::apex && *runs > 0) {
            const QJsonObject apex =
                apexPlanJson(design->participantsPlanned, static_cast<int>(std::lround(plan.meanTrials)),
                             static_cast<int>(*runs), *seed);
            json.insert("apex", apex);
            words += QStringLiteral("%1: mean error of %2 participants %3 ± %4 % of the radius; other than "
                                    "%5 % in %6 % of such studies\n")
                         .arg(text(condition.id))
                         .arg(design->participantsPlanned)
                         .arg(shortNumber(apex["mean_absolute_percent"].toDouble()),
                              shortNumber(apex["half_width_percent"].toDouble()),
                              shortNumber(apex["against_percent"].toDouble()),
                              shortNumber(100.0 * apex["power"].toDouble()));
        }
        if (oftenWithoutValue(plan))
            words += withoutValueText(text(condition.id), plan);
        if (*powerInputs && condition.stimulus.attribute != Attribute::apex) {
            json.insert("power", powerJson(**powerInputs, plan));
            words += powerText(text(condition.id), json["power"].toObject());
        }
        conditions.append(json);
        const auto shown = [&](const char* key) {
            return shortNumber(json[QLatin1String(key)].toDouble(std::nan("")));
        };
        const auto withError = [&](const char* key) {
            const double error = json[QLatin1String(key) + QStringLiteral("_error")].toDouble(std::nan(""));
            return std::isfinite(error) ? QStringLiteral("%1 ± %2").arg(shown(key), shortNumber(error))
                                        : shown(key);
        };
        table.add({text(condition.id), withError("bias_log10"), withError("sd_log10"), withError("coverage"),
                   withError("trials"), withError("minutes"), shown("information_per_trial")});
        minutes += plan.runs > 0 ? plan.minutes : std::nan("");
        minutesError = std::hypot(minutesError, plan.minutesError); // each has its own random numbers
    }
    return CommandOutput{
        QJsonDocument(QJsonObject{{"study", text(design->id)},
                                  {"observer", text(observerText(*observer))},
                                  {"conditions", conditions},
                                  {"minutes", numberOrNull(minutes)},
                                  {"minutes_error", numberOrNull(minutesError)}}),
        table.toText() +
            (*runs > 0 ? QStringLiteral("±: one standard error of so few simulated runs (Monte Carlo)\n")
                       : QString()) +
            words,
        0};
}

} // namespace chiron::cli
