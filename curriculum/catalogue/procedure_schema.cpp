// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/procedure_schema.h"

#include "psychophysics/procedures/procedure_catalogue.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
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

/// A JSON value whose keys keep the order in which they were added, which is the order in which people read
/// them.
struct Node {
    QString scalar{}; ///< as written; empty for an object or a list
    std::vector<std::pair<QString, Node>> members{};
    std::vector<Node> items{};

    static Node of(const QString& text) {
        const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
        return {QString::fromUtf8(list.mid(1, list.size() - 2))};
    }
    static Node of(double number) { return {QString::number(number, 'g', 16)}; }
    void add(const char* key, Node value) {
        members.emplace_back(QString::fromLatin1(key), std::move(value));
    }
};

QString written(const Node& node, int depth = 0) {
    if (!node.scalar.isEmpty())
        return node.scalar;
    constexpr int kIndent = 4;
    const QString inside(kIndent * (depth + 1), QLatin1Char(' '));
    QStringList lines;
    for (const auto& [key, value] : node.members)
        lines << inside + Node::of(key).scalar + ": " + written(value, depth + 1);
    for (const Node& item : node.items)
        lines << inside + written(item, depth + 1);
    const QString brackets = node.items.empty() ? QStringLiteral("{}") : QStringLiteral("[]");
    return brackets.left(1) + '\n' + lines.join(QStringLiteral(",\n")) + '\n' +
           QString(kIndent * depth, QLatin1Char(' ')) + brackets.right(1);
}

Node numberNode(const char* type, const QString& unit, double minimum, double maximum,
                const QString& description) {
    Node node;
    node.add("type", Node::of(QString::fromLatin1(type)));
    node.add("unit", Node::of(unit));
    node.add("minimum", Node::of(minimum));
    node.add("maximum", Node::of(maximum));
    node.add("description", Node::of(description));
    return node;
}

Node arrayNode(int fewest, int most, const QString& description, Node items) {
    Node node;
    node.add("type", Node::of(QStringLiteral("array")));
    node.add("minItems", Node::of(fewest));
    node.add("maxItems", Node::of(most));
    node.add("description", Node::of(description));
    node.add("items", std::move(items));
    return node;
}

Node textNode(const QString& description) {
    Node node;
    node.add("type", Node::of(QStringLiteral("string")));
    node.add("description", Node::of(description));
    return node;
}

Node yesNoNode(const QString& description) {
    Node node;
    node.add("type", Node::of(QStringLiteral("boolean")));
    node.add("description", Node::of(description));
    return node;
}

Node objectNode(const QString& description, Node properties, const char* required = nullptr) {
    Node node;
    node.add("type", Node::of(QStringLiteral("object")));
    node.add("description", Node::of(description));
    node.add("properties", std::move(properties));
    if (required)
        node.add("required", Node{{}, {}, {Node::of(QString::fromLatin1(required))}});
    return node;
}

constexpr int kMostValues = 65536;

/// Describes a named grid of a dimension of the stimulus or of a parameter.
Node gridNode(const QString& description, const QString& unit, bool withPrior) {
    constexpr double kSmallestStep = 1e-9;
    Node name = textNode(QStringLiteral("Of the dimension or parameter, as the function calls it."));
    name.add("minLength", Node::of(1));
    name.add("maxLength", Node::of(64));
    const auto number = [&unit](double minimum, const char* says) {
        return numberNode("number", unit, minimum, kUnbounded, QString::fromLatin1(says));
    };
    Node grid;
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
    return objectNode(description, std::move(grid), "name");
}

/// Describes the values of this type with the range of the row.
struct NodeOf {
    Parameter row;
    QString description;

    Node operator()(double) const {
        return numberNode("number", words(row.unit), row.minimum, row.maximum, description);
    }
    Node operator()(const std::optional<double>&) const { return (*this)(0.0); }
    Node operator()(int) const {
        return numberNode("integer", words(row.unit), row.minimum, row.maximum, description);
    }
    Node operator()(std::uint64_t) const { return (*this)(0); }
    Node operator()(bool) const { return yesNoNode(description); }
    Node operator()(const std::string&) const {
        Node node = textNode(description);
        Node allowed;
        for (const ParameterWord& word : row.words)
            allowed.items.push_back(Node::of(words(word.word)));
        node.add("enum", std::move(allowed));
        return node;
    }
    Node operator()(const std::vector<double>&) const {
        return listOf(numberNode("number", words(row.unit), row.minimum, row.maximum, words(row.item)));
    }
    Node operator()(const StimulusGrids&) const {
        return listOf(gridNode(words(row.item), words(row.unit), false));
    }
    Node operator()(const std::vector<ParameterGrid>&) const {
        return listOf(gridNode(words(row.item), words(row.unit), true));
    }
    Node operator()(const OutcomeProbabilities&) const {
        constexpr int kMostCells = 1000000;
        const Node number = numberNode("number", words(row.unit), row.minimum, row.maximum, words(row.item));
        return listOf(
            arrayNode(1, kMostValues, QStringLiteral("Of one outcome."),
                      arrayNode(1, kMostCells, QStringLiteral("Of one stimulus, a number a cell."), number)));
    }

private:
    Node listOf(Node items) const { return arrayNode(row.fewest, row.most, description, std::move(items)); }
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

Node nodeOf(const std::vector<Known>& key, const QString& description) {
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

Node stopNode() {
    const Keys keys = keysIn("stop");
    Node properties;
    for (const auto& key : keys)
        properties.members.emplace_back(words(key.front().row->key), nodeOf(key, ruleOf(key)));
    return objectNode("When the run ends: whichever of trials, reversals, sd comes first; 0 does not end it. "
                      "At least one that the kind knows is needed; rules that are "
                      "given replace the default ones whole. Default: " +
                          defaultRules(keys) + ".",
                      std::move(properties));
}

Node kindNode() {
    QStringList kinds;
    Node allowed;
    for (const ProcedureKind* kind : procedureKinds()) {
        kinds << words(kind->id()) + " (" + words(kind->words().title) + ")";
        allowed.items.push_back(Node::of(words(kind->id())));
    }
    Node node = textNode("Which procedure: " + kinds.join(QStringLiteral(", ")) +
                         ". The keys below say which kinds know them.");
    node.add("enum", std::move(allowed));
    return node;
}

} // namespace

QByteArray procedureSchema() {
    Node properties;
    properties.add("kind", kindNode());
    for (const auto& key : keysIn({}))
        properties.members.emplace_back(words(key.front().row->key), nodeOf(key, descriptionOf(key)));
    properties.add("stop", stopNode());
    Node schema;
    schema.add("$schema", Node::of(QStringLiteral("https://json-schema.org/draft/2020-12/schema")));
    schema.add("title", Node::of(QStringLiteral("Procedure")));
    schema.add("description", Node::of(QStringLiteral(
                                  "How the stimuli of a run are chosen. x stands for the unit of the "
                                  "procedure's stimuli: in a study, D (log10 of a ratio) "
                                  "or log10 D. Outcome 1 is right (yes), 0 wrong (no); of rank3_quest_plus "
                                  "the six orders, 0 all correct. This file is made "
                                  "of the rows of the procedures (curriculum/psychophysics/procedures).")));
    schema.add("type", Node::of(QStringLiteral("object")));
    schema.add("properties", std::move(properties));
    schema.add("required", Node{{}, {}, {Node::of(QStringLiteral("kind"))}});
    return written(schema).toUtf8() + '\n';
}

} // namespace chiron::catalogue
