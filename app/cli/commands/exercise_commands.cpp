// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/catalogue.h"
#include "cli/arguments.h"
#include "cli/cli_errors.h"
#include "cli/command_groups.h"
#include "cli/text_table.h"
#include "core/languages.h"
#include "core/units.h"
#include "scoring/metric_catalogue.h"
#include "session/exercise_kind.h"

#include <QJsonArray>
#include <QJsonObject>

namespace chiron::cli {

namespace {

QString text(const std::string& words) {
    return QString::fromStdString(words);
}

core::Result<catalogue::Catalogue> load(const Arguments& arguments) {
    const auto folder =
        catalogue::findContentDirectory(arguments.value(QStringLiteral("content")).toStdString());
    CHIRON_TRY(folder);
    return catalogue::Catalogue::load(*folder);
}

QJsonArray metricsOf(const catalogue::ExerciseLevel& level) {
    QJsonArray array;
    for (const catalogue::MetricChoice& choice : level.metrics) {
        QJsonObject metric{{QStringLiteral("id"), text(choice.id)},
                           {QStringLiteral("version"), choice.version}};
        if (const auto* known = scoring::findMetric(choice.id, choice.version)) {
            metric[QStringLiteral("unit")] = text(std::string(known->unit));
            metric[QStringLiteral("direction")] = text(std::string(scoring::toString(known->direction)));
            metric[QStringLiteral("wrench")] = text(std::string(scoring::toString(known->wrench)));
            metric[QStringLiteral("tools")] = text(std::string(scoring::toString(known->tools)));
            metric[QStringLiteral("definition")] = text(std::string(known->definition));
        }
        array.append(metric);
    }
    return array;
}

QJsonValue limit(const std::optional<double>& value) {
    return value ? QJsonValue(*value) : QJsonValue(QJsonValue::Null);
}

QJsonArray gatesOf(const catalogue::ExerciseLevel& level) {
    QJsonArray array;
    for (const scoring::Gate& gate : level.gates)
        array.append(QJsonObject{{QStringLiteral("metric"), text(gate.metric)},
                                 {QStringLiteral("minimum"), limit(gate.minimum)},
                                 {QStringLiteral("maximum"), limit(gate.maximum)}});
    return array;
}

/// What the ExerciseKind states about a level; empty for content whose kind this program does not have.
struct KindFacts {
    int tools = 1;
    bool energy = false;
    std::vector<core::QuantityDescription> quantities;
};

KindFacts factsOf(const catalogue::ExerciseLevel& level) {
    const auto kind = session::exerciseKind(level.exercise);
    if (!kind)
        return {};
    return {(*kind)->toolCount(level), (*kind)->recordsEnergy(level), (*kind)->quantities(level)};
}

QJsonArray quantitiesOf(const KindFacts& facts) {
    QJsonArray array;
    for (const core::QuantityDescription& quantity : facts.quantities)
        array.append(QJsonObject{{QStringLiteral("id"), text(quantity.id)},
                                 {QStringLiteral("unit"), text(quantity.unit)},
                                 {QStringLiteral("resolution"), quantity.resolution}});
    return array;
}

/// How the level mounts the bases of its devices; empty if the level does not specify it.
QJsonArray mountingOf(const catalogue::ExerciseLevel& level) {
    QJsonArray array;
    for (const core::BaseMounting& base : level.mounting)
        array.append(QJsonObject{{QStringLiteral("shift_mm"),
                                  QJsonArray{core::mmFromM(base.origin_m[0]), core::mmFromM(base.origin_m[1]),
                                             core::mmFromM(base.origin_m[2])}},
                                 {QStringLiteral("scale"), base.scale},
                                 {QStringLiteral("mirrored"), base.leftHanded},
                                 {QStringLiteral("turn_deg"), core::degFromRad(base.turn_rad[0])},
                                 {QStringLiteral("tilt_deg"), core::degFromRad(base.turn_rad[1])},
                                 {QStringLiteral("roll_deg"), core::degFromRad(base.turn_rad[2])}});
    return array;
}

QJsonObject levelJson(const catalogue::ExerciseLevel& level, const std::string& language) {
    QJsonArray cues;
    for (const std::string& cue : level.cues)
        cues.append(text(cue));
    const KindFacts facts = factsOf(level);
    return {{QStringLiteral("level"), level.number},
            {QStringLiteral("tools"), facts.tools},
            {QStringLiteral("mounting"), mountingOf(level)},
            {QStringLiteral("quantities"), quantitiesOf(facts)},
            {QStringLiteral("records_energy"), facts.energy},
            {QStringLiteral("id"), text(level.id)},
            {QStringLiteral("title"), text(catalogue::textIn(level.title, language))},
            {QStringLiteral("objective"), text(catalogue::textIn(level.objective, language))},
            {QStringLiteral("measured"), text(catalogue::textIn(level.measured, language))},
            {QStringLiteral("cues"), cues},
            {QStringLiteral("needs_force"), level.needsForce},
            {QStringLiteral("metrics"), metricsOf(level)},
            {QStringLiteral("gates"), gatesOf(level)},
            {QStringLiteral("content_sha256"), text(level.resolvedSha256)},
            {QStringLiteral("task_sha256"), text(catalogue::taskSha256(level.resolvedJson))}};
}

QJsonObject exerciseJson(const catalogue::Exercise& exercise, const std::string& language) {
    QJsonArray levels;
    QJsonArray metrics;
    QJsonArray gates;
    for (const catalogue::ExerciseLevel& level : exercise.levels) {
        levels.append(levelJson(level, language));
        for (const catalogue::MetricChoice& choice : level.metrics) {
            if (!metrics.contains(text(choice.id)))
                metrics.append(text(choice.id));
        }
        for (QJsonValue gate : gatesOf(level)) {
            QJsonObject withLevel = gate.toObject();
            withLevel[QStringLiteral("level")] = level.number;
            gates.append(withLevel);
        }
    }
    QJsonObject texts;
    for (const auto& [id, sha256] : exercise.textsSha256)
        texts[text(id)] = text(sha256);
    return {{QStringLiteral("id"), text(exercise.id)},
            {QStringLiteral("version"), exercise.version},
            {QStringLiteral("texts_sha256"), texts},
            {QStringLiteral("title"), text(catalogue::textIn(exercise.title, language))},
            {QStringLiteral("objective"), text(catalogue::textIn(exercise.objective, language))},
            {QStringLiteral("levels"), levels},
            {QStringLiteral("metrics"), metrics},
            {QStringLiteral("gates"), gates}};
}

QStringList languageIds() {
    QStringList ids;
    for (const std::string& id : core::languageIds())
        ids << text(id);
    return ids;
}

core::Result<QString> chosenLanguage(const Arguments& arguments) {
    return arguments.choice(QStringLiteral("language"), languageIds(), languageIds().first());
}

/// Lists the texts of the content that a language lacks, and the number of those beyond the list.
QString missingText(const std::vector<catalogue::MissingText>& missing) {
    constexpr std::size_t kMost = 20;
    QString lines;
    for (std::size_t i = 0; i < std::min(kMost, missing.size()); ++i)
        lines += QStringLiteral("%1: %2: no text in %3; English is shown\n")
                     .arg(text(missing[i].file), text(missing[i].path), text(missing[i].language));
    return missing.size() > kMost ? lines + QStringLiteral("and %1 more\n").arg(missing.size() - kMost)
                                  : lines;
}

core::Result<CommandOutput> list(const Arguments& arguments) {
    const auto content = load(arguments);
    const auto language = chosenLanguage(arguments);
    CHIRON_TRY(language);
    CHIRON_TRY(content);
    QJsonArray json;
    TextTable table({QStringLiteral("exercise"), QStringLiteral(">level"), QStringLiteral("title"),
                     QStringLiteral(">tools"), QStringLiteral("needs force"), QStringLiteral("pass marks")});
    for (const catalogue::Exercise& exercise : content->exercises()) {
        json.append(exerciseJson(exercise, language->toStdString()));
        for (const catalogue::ExerciseLevel& level : exercise.levels)
            table.add({text(exercise.id), QString::number(level.number),
                       text(catalogue::textIn(level.title, language->toStdString())),
                       QString::number(factsOf(level).tools),
                       level.needsForce ? QStringLiteral("yes") : QStringLiteral("no"),
                       QString::number(level.gates.size())});
    }
    return CommandOutput{QJsonDocument(json), table.toText() + missingText(content->missingTexts()), 0};
}

/// Lists the instruments and what else is recorded; one line followed by an empty one.
QString recordedText(const KindFacts& facts) {
    QStringList recorded;
    for (const core::QuantityDescription& quantity : facts.quantities)
        recorded << text(quantity.id);
    if (facts.energy)
        recorded << QStringLiteral("energy_supplied_J") << QStringLiteral("energy_stored_J");
    if (facts.tools == 1 && recorded.isEmpty())
        return {};
    return QStringLiteral("instruments: %1; recorded beside them: %2\n")
        .arg(facts.tools)
        .arg(recorded.isEmpty() ? QStringLiteral("nothing") : recorded.join(QStringLiteral(", ")));
}

QString levelText(const catalogue::ExerciseLevel& level, const std::string& language) {
    TextTable table({QStringLiteral("metric"), QStringLiteral(">version"), QStringLiteral("unit"),
                     QStringLiteral("pass mark")});
    for (const catalogue::MetricChoice& choice : level.metrics) {
        QString mark;
        for (const scoring::Gate& gate : level.gates) {
            if (gate.metric == choice.id)
                mark = (gate.minimum ? QStringLiteral(">= %1 ").arg(*gate.minimum) : QString()) +
                       (gate.maximum ? QStringLiteral("<= %1").arg(*gate.maximum) : QString());
        }
        const auto* known = scoring::findMetric(choice.id, choice.version);
        table.add({text(choice.id), QString::number(choice.version),
                   known ? text(std::string(known->unit)) : QString(), mark});
    }
    return QStringLiteral("level %1, %2: %3\n%4\n%5\n%6\n")
        .arg(level.number)
        .arg(text(level.id), text(catalogue::textIn(level.title, language)),
             text(catalogue::textIn(level.objective, language)), recordedText(factsOf(level)),
             table.toText());
}

core::Result<CommandOutput> show(const Arguments& arguments) {
    const auto language = chosenLanguage(arguments);
    CHIRON_TRY(language);
    const auto content = load(arguments);
    CHIRON_TRY(content);
    const catalogue::Exercise* exercise = content->find(arguments.operand(0).toStdString());
    if (!exercise) {
        QStringList ids;
        for (const catalogue::Exercise& known : content->exercises())
            ids << text(known.id);
        return core::fail(core::ErrorCode::notFound,
                          QStringLiteral("ID %1: no such exercise; expected one of %2")
                              .arg(quoted(arguments.operand(0)), ids.join(QStringLiteral(", ")))
                              .toStdString());
    }
    QString words =
        QStringLiteral("%1: %2\n%3\n\n")
            .arg(text(exercise->id), text(catalogue::textIn(exercise->title, language->toStdString())),
                 text(catalogue::textIn(exercise->objective, language->toStdString())));
    for (const catalogue::ExerciseLevel& level : exercise->levels)
        words += levelText(level, language->toStdString());
    return CommandOutput{QJsonDocument(exerciseJson(*exercise, language->toStdString())), words, 0};
}

} // namespace

std::vector<CommandSpec> exerciseCommands() {
    const std::vector<OptionSpec> options{
        {QStringLiteral("content"), QStringLiteral("FOLDER"),
         QStringLiteral("where the content lies; default: CHIRON_CONTENT, the installed folder")},
        {QStringLiteral("language"), QStringLiteral("WORD"),
         languageIds().join(QStringLiteral(", ")) + QStringLiteral("; default: en")}};
    CommandSpec listing;
    listing.group = QStringLiteral("exercise");
    listing.verb = QStringLiteral("list");
    listing.summary = QStringLiteral("the exercises and their levels");
    listing.options = options;
    listing.example = QStringLiteral("chiron-cli exercise list --json");
    listing.run = list;
    CommandSpec showing = listing;
    showing.verb = QStringLiteral("show");
    showing.summary = QStringLiteral("one exercise: levels, metrics and pass marks");
    showing.operands = {
        {QStringLiteral("ID"), QStringLiteral("the exercise's id, for instance sphere_apex")}};
    showing.example = QStringLiteral("chiron-cli exercise show sphere_apex --language de");
    showing.run = show;
    return {listing, showing};
}

} // namespace chiron::cli
