// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/procedure_reader.h"

#include "catalogue/json_file.h"
#include "catalogue/procedure_refusal.h"
#include "psychophysics/procedures/procedure_catalogue.h"

#include <QJsonDocument>
#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

namespace chiron::catalogue {

using namespace psychophysics;

namespace {

constexpr double kMostGridValues = 1e6;
constexpr std::string_view kStop = "stop";

QString text(std::string_view key) {
    return QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size()));
}

std::vector<double> numbersAt(const QJsonValue& value, const QString& path, Problems& problems) {
    std::vector<double> numbers;
    if (!value.isArray())
        problems.push_back({path, QStringLiteral("another type"), QStringLiteral("an array of numbers")});
    const QJsonArray array = value.toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        if (!array[i].isDouble() || !std::isfinite(array[i].toDouble()))
            problems.push_back(
                {elementPath(path, i), QStringLiteral("another type"), QStringLiteral("a number")});
        numbers.push_back(array[i].toDouble());
    }
    return numbers;
}

/// Reads a grid from "values", or from "from", "to" and "step".
std::vector<double> gridOf(const ObjectReader& json) {
    for (const char* key : {"from", "to", "step"})
        if (json.has("values") && json.has(key))
            json.problems().push_back({memberPath(json.path(), key), QStringLiteral("beside values"),
                                       QStringLiteral("either values, or from, to and step")});
    if (json.has("values") || !json.has("from"))
        return numbersAt(json.json().value("values"), memberPath(json.path(), "values"), json.problems());
    const double from = json.number("from");
    const double to = json.number("to");
    const double step = json.number("step");
    std::vector<double> values;
    if (!(step > 0.0) || !(to >= from) || !((to - from) / step < kMostGridValues)) {
        json.problems().push_back({memberPath(json.path(), "step"), QString::number(step),
                                   QStringLiteral("a step above 0, and to at least from")});
        return values;
    }
    const double count = std::floor((to - from) / step + 1e-6);
    for (double i = 0.0; i <= count; i += 1.0)
        values.push_back(from + step * i);
    return values;
}

/// Reads the value of one key with the type that its row has.
class ValueReader {
public:
    ValueReader(const ObjectReader& json, std::string_view key) : m_json(json), m_key(text(key)) {}

    ParameterValue operator()(double) const { return m_json.number(m_key); }
    ParameterValue operator()(int) const { return m_json.integer(m_key); }
    ParameterValue operator()(bool) const { return m_json.boolean(m_key); }
    ParameterValue operator()(const std::string&) const { return m_json.text(m_key); }
    ParameterValue operator()(const std::optional<double>&) const {
        return std::optional<double>(m_json.number(m_key));
    }
    ParameterValue operator()(const std::vector<double>&) const {
        return numbersAt(m_json.json().value(m_key), path(), m_json.problems());
    }

    ParameterValue operator()(std::uint64_t before) const {
        const double value = m_json.number(m_key);
        // A JSON number holds every integer up to 2^53 exactly.
        if (value >= 0.0 && value <= 9007199254740992.0 && value == std::floor(value))
            return static_cast<std::uint64_t>(value);
        m_json.problems().push_back(
            {path(), QString::number(value), QStringLiteral("a whole number from 0 to 2^53")});
        return before;
    }

    ParameterValue operator()(const StimulusGrids&) const {
        StimulusGrids grids;
        m_json.eachObject(m_key, [&grids](const ObjectReader& json) {
            grids.emplace_back(json.text("name"), gridOf(json));
            refuseUnknownKeys(json, {"name", "values", "from", "to", "step"},
                              QStringLiteral("a key of a stimulus dimension"));
        });
        return grids;
    }

    ParameterValue operator()(const std::vector<ParameterGrid>&) const {
        std::vector<ParameterGrid> grids;
        m_json.eachObject(m_key, [&grids](const ObjectReader& json) {
            ParameterGrid grid;
            grid.name = json.text("name");
            grid.values = gridOf(json);
            if (json.has("prior"))
                grid.prior =
                    numbersAt(json.json().value("prior"), memberPath(json.path(), "prior"), json.problems());
            if (json.has("nuisance"))
                grid.nuisance = json.boolean("nuisance");
            grids.push_back(std::move(grid));
            refuseUnknownKeys(json, {"name", "values", "from", "to", "step", "prior", "nuisance"},
                              QStringLiteral("a key of a parameter's grid"));
        });
        return grids;
    }

    ParameterValue operator()(const OutcomeProbabilities&) const {
        OutcomeProbabilities table;
        const QJsonArray outcomes = m_json.json().value(m_key).toArray();
        if (outcomes.isEmpty())
            m_json.problems().push_back({path(), QStringLiteral("no outcomes"),
                                         QStringLiteral("an array [outcome][stimulus][parameter cell]")});
        for (qsizetype r = 0; r < outcomes.size(); ++r) {
            const QJsonArray stimuli = outcomes[r].toArray();
            table.emplace_back();
            for (qsizetype x = 0; x < stimuli.size(); ++x)
                table.back().push_back(
                    numbersAt(stimuli[x], elementPath(elementPath(path(), r), x), m_json.problems()));
        }
        return table;
    }

private:
    QString path() const { return memberPath(m_json.path(), m_key); }

    const ObjectReader& m_json;
    QString m_key;
};

/// Writes a value to JSON.
struct ValueWriter {
    QJsonValue operator()(double value) const { return value; }
    QJsonValue operator()(int value) const { return value; }
    QJsonValue operator()(bool value) const { return value; }
    QJsonValue operator()(std::uint64_t value) const { return static_cast<double>(value); }
    QJsonValue operator()(const std::string& value) const { return QString::fromStdString(value); }
    QJsonValue operator()(const std::optional<double>& value) const {
        return value ? QJsonValue(*value) : QJsonValue(QJsonValue::Undefined);
    }
    QJsonValue operator()(const OutcomeProbabilities& value) const {
        return value.empty() ? QJsonValue(QJsonValue::Undefined) : QJsonValue(array(value));
    }
    QJsonValue operator()(const std::pair<std::string, std::vector<double>>& value) const {
        return QJsonObject{{"name", QString::fromStdString(value.first)}, {"values", array(value.second)}};
    }
    QJsonValue operator()(const ParameterGrid& value) const {
        QJsonObject grid{{"name", QString::fromStdString(value.name)},
                         {"values", array(value.values)},
                         {"nuisance", value.nuisance}};
        if (!value.prior.empty())
            grid.insert("prior", array(value.prior));
        return grid;
    }
    template <class Item> QJsonValue operator()(const std::vector<Item>& value) const { return array(value); }

private:
    template <class Item> QJsonArray array(const std::vector<Item>& items) const {
        QJsonArray array;
        for (const Item& item : items)
            array.append((*this)(item));
        return array;
    }
};

/// Returns the neutral value of the same type: 0, false, an empty list.
ParameterValue nothingOf(const ParameterValue& value) {
    return std::visit([](const auto& of) -> ParameterValue { return std::decay_t<decltype(of)>{}; }, value);
}

void readRow(const Parameter& row, const ObjectReader& json, ProcedureSpec& spec) {
    if (!json.has(text(row.key)))
        return;
    const ParameterValue value = std::visit(ValueReader(json, row.key), row.get(spec));
    row.set(spec, value);
    // Not a word of this key.
    if (const auto* word = std::get_if<std::string>(&value);
        word && std::get<std::string>(row.get(spec)) != *word) {
        QStringList words;
        for (const ParameterWord& each : row.words)
            words << text(each.word);
        json.problems().push_back({memberPath(json.path(), text(row.key)),
                                   quoted(QString::fromStdString(*word)), "one of " + words.join(", ")});
    }
}

double numberOf(const ParameterValue& value) {
    if (const auto* whole = std::get_if<int>(&value))
        return *whole;
    const auto* number = std::get_if<double>(&value);
    return number ? *number : 0.0;
}

/// Reads the stop rules. If any are given, they replace all the default ones.
void readStopRules(const std::vector<Parameter>& rows, const ObjectReader& json, ProcedureSpec& spec) {
    std::vector<QString> known;
    for (const Parameter& row : rows) {
        if (row.object != kStop)
            continue;
        known.push_back(text(row.key));
        row.set(spec, nothingOf(row.get(spec)));
        readRow(row, json, spec);
    }
    refuseUnknownKeys(json, known, QStringLiteral("a rule of when to stop"));
    for (const Parameter& row : rows) {
        if (row.object != kStop)
            continue;
        const double value = numberOf(row.get(spec));
        const QString path = memberPath(json.path(), text(row.key));
        if (!(value >= row.minimum))
            json.problems().push_back(
                {path, QString::number(value), QStringLiteral("at least %1").arg(row.minimum)});
        for (const Parameter& other : rows)
            if (const double most =
                    other.object == kStop && other.key == row.noMoreThan ? numberOf(other.get(spec)) : 0.0;
                most > 0.0 && value > most)
                json.problems().push_back(
                    {path, QString::number(static_cast<qint64>(value)),
                     QStringLiteral("at most %1, %2").arg(text(other.key)).arg(static_cast<qint64>(most))});
    }
}

void readRows(const ProcedureKind& kind, const ObjectReader& json, ProcedureSpec& spec) {
    std::vector<QString> known{QStringLiteral("kind")};
    for (const Parameter& row : kind.rows()) {
        const QString key = text(row.object.empty() ? row.key : row.object);
        if (std::find(known.begin(), known.end(), key) != known.end())
            continue; // belongs to an object that has been read
        known.push_back(key);
        if (row.object.empty())
            readRow(row, json, spec);
        else if (json.has(key))
            readStopRules(kind.rows(), json.object(key), spec);
    }
    refuseUnknownKeys(json, known, "a key of the procedure " + text(kind.id()));
}

} // namespace

ProcedureSpec readProcedure(const ObjectReader& json) {
    const QString word = QString::fromStdString(json.text("kind"));
    const std::size_t before = json.problems().size();
    std::vector<QString> known;
    for (const ProcedureKind* kind : procedureKinds()) {
        known.push_back(text(kind->id()));
        if (word != known.back())
            continue;
        ProcedureSpec spec = kind->defaults();
        readRows(*kind, json, spec);
        if (json.problems().size() == before)
            if (const auto good = kind->check(spec); !good)
                addRefusal(good.error(), json, writeProcedure(spec));
        return spec;
    }
    if (json.json().value("kind").isString())
        json.problems().push_back(
            {memberPath(json.path(), "kind"), quoted(word),
             "one of " + QString::fromStdString(procedureKindIds()) + didYouMean(word, known)});
    return procedureKinds().front()->defaults();
}

core::Result<ProcedureSpec> readProcedure(const QByteArray& json, const std::string& file,
                                          const Schema& schema) {
    constexpr qsizetype kMostMebibytes = 16; // a table of many outcomes has a million numbers
    const auto parsed = JsonFile::parse(json, QString::fromStdString(file), kMostMebibytes);
    CHIRON_TRY(parsed);
    Problems problems;
    ProcedureSpec spec = readProcedure(ObjectReader(parsed->root(), QStringLiteral("$"), problems));
    if (problems.empty()) // a fault found while reading says more than a range does
        validated(parsed->root(), schema, QStringLiteral("$"), problems);
    if (!problems.empty())
        return tl::unexpected(parsed->error(problems));
    return spec;
}

QJsonObject writeProcedure(const ProcedureSpec& spec) {
    const ProcedureKind& kind = kindFor(spec);
    QJsonObject json{{"kind", text(kind.id())}};
    for (const Parameter& row : kind.rows()) {
        const QJsonValue value = std::visit(ValueWriter(), row.get(spec));
        if (value.isUndefined())
            continue;
        if (row.object.empty()) {
            json.insert(text(row.key), value);
            continue;
        }
        QJsonObject object = json.value(text(row.object)).toObject();
        object.insert(text(row.key), value);
        json.insert(text(row.object), object);
    }
    return json;
}

} // namespace chiron::catalogue
