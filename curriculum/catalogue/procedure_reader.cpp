// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/procedure_reader.h"

#include "catalogue/json_file.h"
#include "catalogue/procedure_keys.h"
#include "catalogue/procedure_refusal.h"

#include <QJsonDocument>
#include <cmath>
#include <optional>

namespace chiron::catalogue {

using namespace psychophysics;

namespace {

using Stimuli = std::vector<std::pair<std::string, std::vector<double>>>;
using Table = std::vector<std::vector<std::vector<double>>>;
constexpr double kMostGridValues = 1e6;

QString name(const char* key) { return QString::fromLatin1(key); }

std::vector<double> numbersAt(const QJsonValue& value, const QString& path, Problems& problems) {
    std::vector<double> numbers;
    if (!value.isArray())
        problems.push_back({path, QStringLiteral("another type"), QStringLiteral("an array of numbers")});
    const QJsonArray array = value.toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        if (!array[i].isDouble() || !std::isfinite(array[i].toDouble()))
            problems.push_back({elementPath(path, i), QStringLiteral("another type"), QStringLiteral("a number")});
        numbers.push_back(array[i].toDouble());
    }
    return numbers;
}

/// "values", or "from", "to" and "step".
std::vector<double> gridOf(const ObjectReader& json) {
    for (const char* key : {"from", "to", "step"})
        if (json.has("values") && json.has(name(key)))
            json.problems().push_back({memberPath(json.path(), name(key)), QStringLiteral("beside values"), QStringLiteral("either values, or from, to and step")});
    if (json.has("values") || !json.has("from"))
        return numbersAt(json.json().value("values"), memberPath(json.path(), "values"), json.problems());
    const double from = json.number("from");
    const double to = json.number("to");
    const double step = json.number("step");
    std::vector<double> values;
    if (!(step > 0.0) || !(to >= from) || !((to - from) / step < kMostGridValues)) {
        json.problems().push_back({memberPath(json.path(), "step"), QString::number(step), QStringLiteral("a step above 0, and to at least from")});
        return values;
    }
    const double count = std::floor((to - from) / step + 1e-6);
    for (double i = 0.0; i <= count; i += 1.0)
        values.push_back(from + step * i);
    return values;
}

const std::vector<QString>& stepTypes() {
    static const std::vector<QString> words{"linear", "log", "db"};
    return words;
}

/// Reads one key into a member of any of the types that procedures have.
class KeyReader {
public:
    explicit KeyReader(const ObjectReader& json) : m_json(json) {}

    template <class Member> void operator()(const char* key, Member& member) {
        m_known.push_back(name(key));
        if (m_json.has(name(key)))
            read(name(key), member);
    }

    void refuseOthers(const QString& what) const { refuseUnknownKeys(m_json, m_known, what); }
    void know(const char* key) { m_known.push_back(name(key)); }

private:
    void read(const QString& key, double& to) { to = m_json.number(key); }
    void read(const QString& key, int& to) { to = m_json.integer(key); }
    void read(const QString& key, bool& to) { to = m_json.boolean(key); }
    void read(const QString& key, std::string& to) { to = m_json.text(key); }
    void read(const QString& key, std::optional<double>& to) { to = m_json.number(key); }
    void read(const QString& key, std::vector<double>& to) {
        to = numbersAt(m_json.json().value(key), memberPath(m_json.path(), key), m_json.problems());
    }

    void read(const QString& key, std::uint64_t& to) {
        const double value = m_json.number(key);
        if (!(value >= 0.0 && value <= 9007199254740992.0) || value != std::floor(value)) // what a JSON number holds exactly
            m_json.problems().push_back({memberPath(m_json.path(), key), QString::number(value), QStringLiteral("a whole number from 0 to 2^53")});
        else
            to = static_cast<std::uint64_t>(value);
    }

    void read(const QString& key, StaircaseSpec::StepType& to) {
        const QString word = QString::fromStdString(m_json.text(key));
        const auto found = std::find(stepTypes().begin(), stepTypes().end(), word);
        if (found == stepTypes().end())
            m_json.problems().push_back({memberPath(m_json.path(), key), quoted(word), QStringLiteral("one of linear, log, db")});
        else
            to = static_cast<StaircaseSpec::StepType>(found - stepTypes().begin());
    }

    void read(const QString& key, StopRule& to) {
        const ObjectReader object = m_json.object(key);
        KeyReader reader(object);
        to = {}; // the rules given are the rules: nothing of the default stays beside them
        stopKeys(to, reader);
        reader.refuseOthers(QStringLiteral("a rule of when to stop"));
        const auto refuse = [&](const char* rule, double value, const QString& expected) {
            m_json.problems().push_back({memberPath(object.path(), name(rule)), QString::number(value), expected});
        };
        for (const auto& [rule, value] : {std::pair{"trials", double(to.trials)}, {"minimum_trials", double(to.minimumTrials)}, {"reversals", double(to.reversals)}, {"sd", to.sd}})
            if (!(value >= 0.0))
                refuse(rule, value, QStringLiteral("at least 0"));
        if (to.trials > 0 && to.minimumTrials > to.trials)
            refuse("minimum_trials", to.minimumTrials, QStringLiteral("at most trials, %1").arg(to.trials));
    }

    void read(const QString& key, Stimuli& to) {
        m_json.eachObject(key, [&to](const ObjectReader& json) {
            to.emplace_back(json.text("name"), gridOf(json));
            refuseUnknownKeys(json, {"name", "values", "from", "to", "step"}, QStringLiteral("a key of a stimulus dimension"));
        });
    }

    void read(const QString& key, std::vector<ParameterGrid>& to) {
        m_json.eachObject(key, [&to](const ObjectReader& json) {
            ParameterGrid grid;
            KeyReader reader(json);
            grid.name = json.text("name");
            grid.values = gridOf(json);
            reader("prior", grid.prior);
            reader("nuisance", grid.nuisance);
            to.push_back(std::move(grid));
            refuseUnknownKeys(json, {"name", "values", "from", "to", "step", "prior", "nuisance"}, QStringLiteral("a key of a parameter's grid"));
        });
    }

    void read(const QString& key, Table& to) {
        const QString path = memberPath(m_json.path(), key);
        const QJsonArray outcomes = m_json.json().value(key).toArray();
        if (outcomes.isEmpty())
            m_json.problems().push_back({path, QStringLiteral("no outcomes"), QStringLiteral("an array [outcome][stimulus][parameter cell]")});
        for (qsizetype r = 0; r < outcomes.size(); ++r) {
            const QJsonArray stimuli = outcomes[r].toArray();
            to.emplace_back();
            for (qsizetype x = 0; x < stimuli.size(); ++x)
                to.back().push_back(numbersAt(stimuli[x], elementPath(elementPath(path, r), x), m_json.problems()));
        }
    }

    const ObjectReader& m_json;
    std::vector<QString> m_known;
};

/// Writes one key.
class KeyWriter {
public:
    template <class Member> void operator()(const char* key, const Member& member) { m_json.insert(name(key), json(member)); }
    void operator()(const char* key, const std::optional<double>& member) {
        if (member)
            m_json.insert(name(key), *member);
    }
    void operator()(const char* key, const Table& member) {
        if (!member.empty())
            m_json.insert(name(key), array(member));
    }
    const QJsonObject& json() const { return m_json; }

private:
    static QJsonValue json(double value) { return value; }
    static QJsonValue json(int value) { return value; }
    static QJsonValue json(bool value) { return value; }
    static QJsonValue json(std::uint64_t value) { return static_cast<double>(value); }
    static QJsonValue json(const std::string& value) { return QString::fromStdString(value); }
    static QJsonValue json(StaircaseSpec::StepType value) { return stepTypes()[static_cast<std::size_t>(value)]; }
    static QJsonValue json(const std::vector<double>& value) { return array(value); }
    static QJsonValue json(const Stimuli& value) { return array(value); }
    static QJsonValue json(const std::vector<ParameterGrid>& value) { return array(value); }
    static QJsonValue json(const std::vector<std::vector<double>>& value) { return array(value); }
    static QJsonValue json(const std::pair<std::string, std::vector<double>>& value) {
        return QJsonObject{{"name", QString::fromStdString(value.first)}, {"values", array(value.second)}};
    }
    static QJsonValue json(const ParameterGrid& value) {
        QJsonObject grid{{"name", QString::fromStdString(value.name)}, {"values", array(value.values)}, {"nuisance", value.nuisance}};
        if (!value.prior.empty())
            grid.insert("prior", array(value.prior));
        return grid;
    }
    static QJsonValue json(const StopRule& value) {
        KeyWriter writer;
        stopKeys(value, writer);
        return writer.m_json;
    }
    template <class Item> static QJsonArray array(const std::vector<Item>& items) {
        QJsonArray array;
        for (const Item& item : items)
            array.append(json(item));
        return array;
    }

    QJsonObject m_json;
};

/// One procedure of each kind, with its defaults.
std::vector<ProcedureSpec> kinds() {
    return {StaircaseSpec{}, PestSpec{}, ConstantSpec{}, DescendingSpec{}, QuestSpec{}, QuestPlusSpec{}, Rank3Spec{}};
}

} // namespace

ProcedureSpec readProcedure(const ObjectReader& json) {
    const QString kind = QString::fromStdString(json.text("kind"));
    const std::size_t before = json.problems().size();
    std::vector<QString> known;
    for (ProcedureSpec spec : kinds()) {
        const std::string_view word = kindOf(spec);
        known.push_back(QString::fromUtf8(word.data(), static_cast<qsizetype>(word.size())));
        if (kind != known.back())
            continue;
        KeyReader reader(json);
        reader.know("kind");
        std::visit([&reader](auto& given) { keysOf(given, reader); }, spec);
        reader.refuseOthers("a key of the procedure " + kind);
        if (json.problems().size() == before)
            if (const auto made = makeProcedure(spec, 1); !made)
                addRefusal(made.error(), json, writeProcedure(spec));
        return spec;
    }
    if (json.json().value("kind").isString())
        json.problems().push_back({memberPath(json.path(), "kind"), quoted(kind),
                                   "one of staircase, pest, constant, descending, quest, quest_plus, rank3_quest_plus" + didYouMean(kind, known)});
    return StaircaseSpec{};
}

core::Result<ProcedureSpec> readProcedure(const QByteArray& json, const std::string& file, const Schema& schema) {
    constexpr qsizetype kMostMebibytes = 16; // a table of many outcomes has a million numbers
    const auto parsed = JsonFile::parse(json, QString::fromStdString(file), kMostMebibytes);
    if (!parsed)
        return tl::unexpected(parsed.error());
    Problems problems;
    ProcedureSpec spec = readProcedure(ObjectReader(parsed->root(), QStringLiteral("$"), problems));
    if (problems.empty()) // what was read says more of a fault than a range does
        validated(parsed->root(), schema, QStringLiteral("$"), problems);
    if (!problems.empty())
        return tl::unexpected(parsed->error(problems));
    return spec;
}

QJsonObject writeProcedure(const ProcedureSpec& spec) {
    KeyWriter writer;
    ProcedureSpec copy = spec;
    std::visit([&writer](auto& given) { keysOf(given, writer); }, copy);
    QJsonObject json = writer.json();
    const std::string_view kind = kindOf(spec);
    json.insert("kind", QString::fromUtf8(kind.data(), static_cast<qsizetype>(kind.size())));
    return json;
}

} // namespace chiron::catalogue
