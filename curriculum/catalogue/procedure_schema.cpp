// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/procedure_schema.h"

#include "catalogue/schema_nodes.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <QString>
#include <QStringList>
#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace chiron::catalogue {

using namespace psychophysics;

namespace {

QString words(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

JsonNode described(JsonNode node, const QString& description) {
    node.add("description", JsonNode::text(description));
    return node;
}

JsonNode numberNode(const char* type, const QString& unit, double minimum, double maximum,
                    const QString& description) {
    return described(numberType(type, unit, minimum, maximum), description);
}

JsonNode arrayNode(int fewest, int most, const QString& description, JsonNode items) {
    JsonNode node = described(arrayType(fewest, most), description);
    node.add("items", std::move(items));
    return node;
}

JsonNode textNode(const QString& description) {
    JsonNode node;
    node.add("type", JsonNode::text(QStringLiteral("string")));
    return described(std::move(node), description);
}

JsonNode yesNoNode(const QString& description) {
    JsonNode node;
    node.add("type", JsonNode::text(QStringLiteral("boolean")));
    return described(std::move(node), description);
}

constexpr int kMostValues = 65536;

/// Describes a named grid of a dimension of the stimulus or of a parameter.
JsonNode gridNode(const QString& description, const QString& unit, bool withPrior) {
    constexpr double kSmallestStep = 1e-9;
    JsonNode name = textNode(QStringLiteral("Of the dimension or parameter, as the function calls it."));
    name.add("minLength", JsonNode::number(1));
    name.add("maxLength", JsonNode::number(64));
    const auto number = [&unit](double minimum, const char* says) {
        return numberNode("number", unit, minimum, kUnbounded, QString::fromLatin1(says));
    };
    JsonNode grid;
    grid.add("name", std::move(name));
    grid.add("values",
             arrayNode(1, kMostValues, QStringLiteral("The values themselves; or from, to and step."),
                       number(-kUnbounded, "One number, in the procedure's unit.")));
    grid.add("from", number(-kUnbounded, "First value of an even grid."));
    grid.add("to", number(-kUnbounded, "Last value of it."));
    grid.add("step", number(kSmallestStep, "Between neighbours."));
    if (withPrior) {
        grid.add(
            "prior",
            arrayNode(
                1, kMostValues,
                QStringLiteral("Prior weight of each value; any positive scale. Default: all alike."),
                numberNode("number", QStringLiteral("1"), 0.0, kUnbounded, QStringLiteral("A weight."))));
        grid.add("nuisance",
                 yesNoNode(QStringLiteral(
                     "Left out of the entropy that trials are chosen by (Prins 2013). Default false.")));
    }
    return objectNode(description, std::move(grid), {QStringLiteral("name")});
}

/// Describes the values of this type with the range of the row.
struct NodeOf {
    Parameter row;
    QString description;

    JsonNode operator()(double) const {
        return numberNode("number", words(row.unit), row.minimum, row.maximum, description);
    }
    JsonNode operator()(const std::optional<double>&) const { return (*this)(0.0); }
    JsonNode operator()(int) const {
        return numberNode("integer", words(row.unit), row.minimum, row.maximum, description);
    }
    JsonNode operator()(std::uint64_t) const { return (*this)(0); }
    JsonNode operator()(bool) const { return yesNoNode(description); }
    JsonNode operator()(const std::string&) const {
        JsonNode node = textNode(description);
        QStringList allowed;
        for (const ParameterWord& word : row.words)
            allowed << words(word.word);
        node.add("enum", JsonNode::texts(allowed));
        return node;
    }
    JsonNode operator()(const std::vector<double>&) const {
        return listOf(numberNode("number", words(row.unit), row.minimum, row.maximum, words(row.item)));
    }
    JsonNode operator()(const StimulusGrids&) const {
        return listOf(gridNode(words(row.item), words(row.unit), false));
    }
    JsonNode operator()(const std::vector<ParameterGrid>&) const {
        return listOf(gridNode(words(row.item), words(row.unit), true));
    }
    JsonNode operator()(const OutcomeProbabilities&) const {
        constexpr int kMostCells = 1000000;
        const JsonNode number =
            numberNode("number", words(row.unit), row.minimum, row.maximum, words(row.item));
        return listOf(
            arrayNode(1, kMostValues, QStringLiteral("Of one outcome."),
                      arrayNode(1, kMostCells, QStringLiteral("Of one stimulus, a number a cell."), number)));
    }

private:
    JsonNode listOf(JsonNode items) const {
        return arrayNode(row.fewest, row.most, description, std::move(items));
    }
};

/// Writes a default as the schema shows it; empty means that the schema does not mention it.
struct DefaultOf {
    QString operator()(double value) const { return QString::number(value); }
    QString operator()(int value) const { return QString::number(value); }
    QString operator()(std::uint64_t value) const { return QString::number(value); }
    QString operator()(bool value) const { return value ? QStringLiteral("true") : QStringLiteral("false"); }
    QString operator()(const std::string& value) const { return QString::fromStdString(value); }
    QString operator()(const std::vector<double>& values) const {
        QStringList numbers;
        for (const double value : values)
            numbers << QString::number(value);
        return numbers.isEmpty() ? QString() : "[" + numbers.join(QStringLiteral(", ")) + "]";
    }
    template <class Other> QString operator()(const Other&) const { return {}; }
};

/// One key as one kind of procedure defines it.
struct Known {
    const ProcedureKind* kind;
    const Parameter* row;

    QString byDefault() const {
        return row->byDefault.empty() ? std::visit(DefaultOf(), row->get(kind->defaults()))
                                      : words(row->byDefault);
    }
};

/// Returns "pest (default 0.75), quest (default 0.82): proportion right ..." for the kinds that describe a
/// key in the same words.
QString sentenceOf(const std::vector<Known>& alike) {
    const auto first = alike.front().byDefault();
    const bool oneDefault =
        std::all_of(alike.begin(), alike.end(), [&](const Known& each) { return each.byDefault() == first; });
    QStringList kinds;
    for (const Known& each : alike)
        kinds << words(each.kind->id()) + (oneDefault ? QString() : " (default " + each.byDefault() + ")");
    QString sentence = kinds.join(QStringLiteral(", ")) + ": " + words(alike.front().row->description);
    if (oneDefault && !first.isEmpty())
        sentence += " Default " + first + ".";
    return sentence;
}

QString descriptionOf(const std::vector<Known>& key) {
    std::vector<std::vector<Known>> groups;
    for (const Known& each : key) {
        const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
            return group.front().row->description == each.row->description;
        });
        if (same == groups.end())
            groups.push_back({each});
        else
            same->push_back(each);
    }
    QStringList sentences;
    for (const auto& group : groups)
        sentences << sentenceOf(group);
    return sentences.join(QLatin1Char(' '));
}

/// Describes a stop rule, with the kinds that apply it unless all of them do.
QString ruleOf(const std::vector<Known>& key) {
    QStringList heeding;
    for (const Known& each : key)
        if (!each.row->ignored)
            heeding << words(each.kind->id());
    QString rule = words(key.front().row->description);
    if (heeding.size() < static_cast<qsizetype>(key.size()))
        return heeding.join(QStringLiteral(", ")) + ": " + rule;
    rule.front() = rule.front().toUpper();
    return rule;
}

/// Returns a row that accepts the union of what the kinds accept.
Parameter widest(const std::vector<Known>& key) {
    Parameter row = *key.front().row;
    for (const Known& each : key) {
        row.minimum = std::min(row.minimum, each.row->minimum);
        row.maximum = std::max(row.maximum, each.row->maximum);
        row.fewest = std::min(row.fewest, each.row->fewest);
        row.most = std::max(row.most, each.row->most);
    }
    return row;
}

using Keys = std::vector<std::vector<Known>>;

/// Returns every key of an object (empty: of the procedure) with the kinds that know it, in the order of
/// first occurrence.
Keys keysIn(std::string_view object) {
    Keys keys;
    for (const ProcedureKind* kind : procedureKinds())
        for (const Parameter& row : kind->rows()) {
            if (row.object != object)
                continue;
            const auto known = std::find_if(keys.begin(), keys.end(),
                                            [&](const auto& key) { return key.front().row->key == row.key; });
            if (known == keys.end())
                keys.push_back({{kind, &row}});
            else
                known->push_back({kind, &row});
        }
    return keys;
}

JsonNode nodeOf(const std::vector<Known>& key, const QString& description) {
    return std::visit(NodeOf{widest(key), description}, key.front().row->get(key.front().kind->defaults()));
}

/// Returns "staircase trials 60; rank3_quest_plus trials 80, minimum_trials 20, sd 0.06".
QString defaultRules(const Keys& keys) {
    QStringList kinds;
    for (const ProcedureKind* kind : procedureKinds()) {
        QStringList rules;
        for (const auto& key : keys)
            for (const Known& each : key)
                if (const QString value = each.byDefault();
                    each.kind == kind && value != QStringLiteral("0") && value != QStringLiteral("false"))
                    rules << words(each.row->key) + " " + value;
        if (!rules.isEmpty())
            kinds << words(kind->id()) + " " + rules.join(QStringLiteral(", "));
    }
    return kinds.join(QStringLiteral("; "));
}

JsonNode stopNode() {
    const Keys keys = keysIn("stop");
    JsonNode properties;
    for (const auto& key : keys)
        properties.add(words(key.front().row->key), nodeOf(key, ruleOf(key)));
    return objectNode("When the run ends: whichever of trials, reversals, sd comes first; 0 does not end it. "
                      "At least one that the kind knows is needed; rules that are "
                      "given replace the default ones whole. Default: " +
                          defaultRules(keys) + ".",
                      std::move(properties));
}

JsonNode kindNode() {
    QStringList kinds, allowed;
    for (const ProcedureKind* kind : procedureKinds()) {
        kinds << words(kind->id()) + " (" + words(kind->words().title) + ")";
        allowed << words(kind->id());
    }
    JsonNode node = textNode("Which procedure: " + kinds.join(QStringLiteral(", ")) +
                             ". The keys below say which kinds know them.");
    node.add("enum", JsonNode::texts(allowed));
    return node;
}

} // namespace

QByteArray procedureSchema() {
    JsonNode properties;
    properties.add("kind", kindNode());
    for (const auto& key : keysIn({}))
        properties.add(words(key.front().row->key), nodeOf(key, descriptionOf(key)));
    properties.add("stop", stopNode());
    return schemaFile(
        QStringLiteral("Procedure"),
        QStringLiteral("How the stimuli of a run are chosen. x stands for the unit of the "
                       "procedure's stimuli: in a study, D (log10 of a ratio) "
                       "or log10 D. Outcome 1 is right (yes), 0 wrong (no); of rank3_quest_plus "
                       "the six orders, 0 all correct. This file is made "
                       "of the rows of the procedures (curriculum/psychophysics/procedures)."),
        std::move(properties), {QStringLiteral("kind")}, JsonLayout::itemPerLine);
}

} // namespace chiron::catalogue
