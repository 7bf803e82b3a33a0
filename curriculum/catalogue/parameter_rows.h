// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/json_node.h"
#include "catalogue/named_kinds.h"
#include "catalogue/object_reader.h"
#include "catalogue/schema_nodes.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace chiron::catalogue {

/// A unit in which content gives numbers. The struct has `given * inSi / perSi`. One of the two factors is 1:
/// which one decides the last bit of a value, and forces of stored sessions are the same to the bit.
struct ContentUnit {
    const char* symbol = "1"; ///< as in the schema
    double perSi = 1.0;       ///< how many of it are one of the unit in which the struct has the number
    double inSi = 1.0;        ///< how many of the struct's unit one of it is

    double toSi(double given) const { return given * inSi / perSi; }
};

namespace units {
inline constexpr ContentUnit kPure{};
inline constexpr ContentUnit kMm{"mm", 1000.0};
inline constexpr ContentUnit kUm{"µm", 1e6};
inline constexpr ContentUnit kMm_per_s{"mm/s", 1000.0};
inline constexpr ContentUnit kG{"g", 1000.0};
inline constexpr ContentUnit kS{"s"};
inline constexpr ContentUnit kMs{"ms", 1000.0};
inline constexpr ContentUnit kDeg{"deg", 180.0 / core::kPi};
inline constexpr ContentUnit kN{"N"};
inline constexpr ContentUnit kN_per_m{"N/m"};
inline constexpr ContentUnit kPer_m{"1/m"};
inline constexpr ContentUnit kNs_per_m{"N·s/m"};
inline constexpr ContentUnit kMilliNm{"mN·m", 1000.0};
inline constexpr ContentUnit kKPa{"kPa", 1.0, 1000.0};
} // namespace units

/// The least and the greatest value, in content's unit, or the least and the greatest length of a list.
template <class Number> struct ParameterRange {
    Number least;
    Number most;
};

/// What the schema says of one parameter, except its default.
struct ParameterWords {
    const char* key;         ///< in JSON; ends in its unit
    const char* description; ///< English, for authors of content; not translated
    JsonNode type;           ///< type and limits
    std::optional<JsonNode> items{};

    JsonNode schema(const std::optional<JsonNode>& byDefault) const;
};

/// What the schema says of all parameters of an exercise together.
struct ParametersTitle {
    const char* title;
    const char* description;
    JsonLayout layout = JsonLayout::briefOnOneLine;
};

/// Returns the number of content from which ContentUnit::toSi() gives just `si`, in as few digits as
/// possible.
double contentNumber(double si, const ContentUnit& unit);

JsonNode flagType();
JsonNode identifierType();
JsonNode choiceType(const QStringList& words);
JsonNode referenceType(const NamedKind& kind);

/// Gives the member of a member, for a row.
template <class Owner, class Part, class Value> auto within(Part Owner::*part, Value Part::*member) {
    return [=](Owner& owner) -> Value& { return owner.*part.*member; };
}

/// Returns the whole numbers of a list. The first item that is none, or is not in the range, is a problem and
/// ends the list.
std::vector<std::int64_t> readWholes(const ObjectReader& json, const char* key,
                                     const ParameterRange<std::int64_t>& range);

/// Adds the problem of a word that is none of `words`.
void refuseWord(const ObjectReader& json, const char* key, const std::string& given,
                const QStringList& words);

/// Returns the bytes of a schema's file.
QByteArray parametersFile(const ParametersTitle& title, JsonNode properties);

/// One parameter of the struct `P`: its key in JSON, unit, range and meaning, and the member that it fills.
/// Reader and schema are made from such rows. The default is what a new `P` has, unless the row has its own.
template <class P> class ParameterRow {
public:
    /// Gives the member: a pointer to it, or a function where it is the member of a member.
    template <class Value> using Member = std::function<Value&(P&)>;

    static ParameterRow number(const char* key, ContentUnit unit, ParameterRange<double> range,
                               Member<double> member, const char* description);
    /// A number that the struct has in another form: `set` and `get` have it in the struct's unit.
    static ParameterRow derived(const char* key, ContentUnit unit, ParameterRange<double> range,
                                std::function<void(P&, double)> set, std::function<double(P&)> get,
                                const char* description);
    /// A number that limits something; in content, 0 means that there is no limit, in the struct infinity.
    static ParameterRow limit(const char* key, ContentUnit unit, double most, Member<double> member,
                              const char* description);
    /// `Whole` is the integer type of the member. Where that has no negative values, they are read as 0.
    template <class Whole = int>
    static ParameterRow whole(const char* key, ParameterRange<int> range,
                              std::type_identity_t<Member<Whole>> member, const char* description,
                              const char* unit = units::kPure.symbol);
    static ParameterRow flag(const char* key, Member<bool> member, const char* description);
    /// The id of something: lower-case letters, digits and _, at most 40.
    static ParameterRow identifier(const char* key, Member<std::string> member, const char* description);
    /// A name that the struct does not keep: of what the other values were taken from. It has no default.
    static ParameterRow name(const char* key, const char* description);
    /// One of several words.
    template <class Choice>
    static ParameterRow choice(const char* key, std::vector<std::pair<const char*, Choice>> words,
                               std::type_identity_t<Member<Choice>> member, const char* description);
    /// Something that content names, and by default `name` of it.
    template <class Value>
    static ParameterRow reference(const char* key, const NamedKind& kind, Value (*read)(const ObjectReader&),
                                  const char* name, std::type_identity_t<Member<Value>> member,
                                  const char* description);
    /// A list of whole numbers within `range`; `item` describes one of them. What the member's type can hold
    /// is read, as for every number; the schema refuses what is out of the range.
    template <class Whole>
    static ParameterRow wholes(const char* key, ParameterRange<int> length, ParameterRange<int> range,
                               std::type_identity_t<Member<std::vector<Whole>>> member, const char* item,
                               const char* description, const char* unit = units::kPure.symbol);
    /// A list of objects that have the keys of `rows`: all but the optional ones. `item` describes one of
    /// them, and `itemKey` one of its keys in a message: "a key of a place".
    template <class Item>
    static ParameterRow list(const char* key, ParameterRange<int> length,
                             const std::vector<ParameterRow<Item>>& rows, const char* item,
                             const char* itemKey, std::type_identity_t<Member<std::vector<Item>>> member,
                             const char* description);

    /// Returns the row with a default of its own, in content's unit: where a level begins with another value
    /// than a struct that no content fills.
    ParameterRow withDefault(double number) const {
        ParameterRow row = *this;
        row.m_default = JsonNode::number(number);
        return row;
    }

    /// Returns the row without a default: where nothing holds as long as content gives nothing.
    ParameterRow withoutDefault() const {
        ParameterRow row = *this;
        row.m_hasDefault = false;
        return row;
    }
    /// Returns the row of a key that an object in a list may leave out. The object then has the default.
    ParameterRow optional() const {
        ParameterRow row = *this;
        row.m_optional = true;
        return row;
    }

    bool isOptional() const { return m_optional; }
    QString key() const { return QLatin1String(m_words.key); }
    /// Reads the value, which is a problem if it is missing.
    void read(const ObjectReader& json, P& out) const { m_read(json, out); }
    JsonNode schema(const std::optional<JsonNode>& byDefault) const { return m_words.schema(byDefault); }
    /// Returns the value as content gives it.
    JsonNode value(P& from) const { return m_value(from); }
    /// Returns the default as content gives it, if there is one; `fresh` is a new `P`.
    std::optional<JsonNode> byDefault(P& fresh) const {
        if (!m_hasDefault)
            return std::nullopt;
        return m_default ? *m_default : value(fresh);
    }

private:
    using Reads = std::function<void(const ObjectReader& json, P& out)>;
    using Gives = std::function<JsonNode(P& from)>;

    ParameterRow(ParameterWords words, Reads read, Gives value)
        : m_words(std::move(words)), m_read(std::move(read)), m_value(std::move(value)) {}

    ParameterWords m_words;
    Reads m_read;
    Gives m_value;
    std::optional<JsonNode> m_default;
    bool m_hasDefault = true;
    bool m_optional = false;
};

template <class P> std::vector<QString> keysOf(const std::vector<ParameterRow<P>>& rows) {
    std::vector<QString> keys;
    for (const ParameterRow<P>& row : rows)
        keys.push_back(row.key());
    return keys;
}

/// Fills `out` with the parameters that `json` has; the others stay as they are. An unknown key is a problem;
/// `what` describes the known keys in its message: "a parameter of ...".
template <class P>
void readParameters(const std::vector<ParameterRow<P>>& rows, const ObjectReader& json, const QString& what,
                    P& out) {
    for (const ParameterRow<P>& row : rows)
        if (json.has(row.key()))
            row.read(json, out);
    refuseUnknownKeys(json, keysOf(rows), what);
}

/// Returns the file in content/schema that describes the parameters, in the order of the rows.
template <class P>
QByteArray parametersSchema(const ParametersTitle& title, const std::vector<ParameterRow<P>>& rows) {
    P fresh;
    JsonNode properties;
    for (const ParameterRow<P>& row : rows)
        properties.add(row.key(), row.schema(row.byDefault(fresh)));
    return parametersFile(title, std::move(properties));
}

template <class P>
ParameterRow<P> ParameterRow<P>::number(const char* key, ContentUnit unit, ParameterRange<double> range,
                                        Member<double> member, const char* description) {
    return {
        {key, description, numberType("number", QString::fromUtf8(unit.symbol), range.least, range.most)},
        [=](const ObjectReader& json, P& out) { member(out) = unit.toSi(json.number(QLatin1String(key))); },
        [=](P& from) { return JsonNode::number(contentNumber(member(from), unit)); }};
}

template <class P>
ParameterRow<P> ParameterRow<P>::derived(const char* key, ContentUnit unit, ParameterRange<double> range,
                                         std::function<void(P&, double)> set, std::function<double(P&)> get,
                                         const char* description) {
    return {{key, description, numberType("number", QString::fromUtf8(unit.symbol), range.least, range.most)},
            [=](const ObjectReader& json, P& out) { set(out, unit.toSi(json.number(QLatin1String(key)))); },
            [=](P& from) { return JsonNode::number(contentNumber(get(from), unit)); }};
}

template <class P>
ParameterRow<P> ParameterRow<P>::limit(const char* key, ContentUnit unit, double most, Member<double> member,
                                       const char* description) {
    return {{key, description, numberType("number", QString::fromUtf8(unit.symbol), 0.0, most)},
            [=](const ObjectReader& json, P& out) {
                if (const double given = json.number(QLatin1String(key)); given > 0.0)
                    member(out) = unit.toSi(given);
            },
            [=](P& from) {
                const double limit = member(from);
                return JsonNode::number(std::isinf(limit) ? 0.0 : contentNumber(limit, unit));
            }};
}

template <class P>
template <class Whole>
ParameterRow<P> ParameterRow<P>::whole(const char* key, ParameterRange<int> range,
                                       std::type_identity_t<Member<Whole>> member, const char* description,
                                       const char* unit) {
    return {{key, description, numberType("integer", QString::fromUtf8(unit), range.least, range.most)},
            [=](const ObjectReader& json, P& out) {
                const int given = json.integer(QLatin1String(key));
                member(out) = static_cast<Whole>(std::is_unsigned_v<Whole> ? std::max(0, given) : given);
            },
            [=](P& from) { return JsonNode::number(static_cast<double>(member(from))); }};
}

template <class P>
ParameterRow<P> ParameterRow<P>::flag(const char* key, Member<bool> member, const char* description) {
    return {{key, description, flagType()},
            [=](const ObjectReader& json, P& out) { member(out) = json.boolean(QLatin1String(key)); },
            [=](P& from) { return JsonNode::yesNo(member(from)); }};
}

template <class P>
ParameterRow<P> ParameterRow<P>::identifier(const char* key, Member<std::string> member,
                                            const char* description) {
    return {{key, description, identifierType()},
            [=](const ObjectReader& json, P& out) { member(out) = json.text(QLatin1String(key)); },
            [=](P& from) { return JsonNode::text(QString::fromStdString(member(from))); }};
}

template <class P> ParameterRow<P> ParameterRow<P>::name(const char* key, const char* description) {
    const ParameterRow row(
        {key, description, identifierType()}, [](const ObjectReader&, P&) {}, [](P&) { return JsonNode(); });
    return row.withoutDefault();
}

template <class P>
template <class Choice>
ParameterRow<P> ParameterRow<P>::choice(const char* key, std::vector<std::pair<const char*, Choice>> words,
                                        std::type_identity_t<Member<Choice>> member,
                                        const char* description) {
    QStringList allowed;
    for (const auto& [word, meant] : words)
        allowed << QLatin1String(word);
    return {{key, description, choiceType(allowed)},
            [=](const ObjectReader& json, P& out) {
                const std::string given = json.text(QLatin1String(key));
                for (const auto& [word, meant] : words)
                    if (given == word) {
                        member(out) = meant;
                        return;
                    }
                refuseWord(json, key, given, allowed);
            },
            [=](P& from) {
                QString chosen;
                for (const auto& [word, meant] : words)
                    if (member(from) == meant)
                        chosen = QLatin1String(word);
                return JsonNode::text(chosen);
            }};
}

template <class P>
template <class Value>
ParameterRow<P> ParameterRow<P>::reference(const char* key, const NamedKind& kind,
                                           Value (*read)(const ObjectReader&), const char* name,
                                           std::type_identity_t<Member<Value>> member,
                                           const char* description) {
    JsonNode named;
    named.add(kind.key, JsonNode::text(QLatin1String(name)));
    return {{key, description, referenceType(kind)},
            [=](const ObjectReader& json, P& out) { member(out) = read(json.object(QLatin1String(key))); },
            [named = named.brief()](P&) { return named; }};
}

template <class P>
template <class Whole>
ParameterRow<P> ParameterRow<P>::wholes(const char* key, ParameterRange<int> length,
                                        ParameterRange<int> range,
                                        std::type_identity_t<Member<std::vector<Whole>>> member,
                                        const char* item, const char* description, const char* unit) {
    static_assert(sizeof(Whole) < sizeof(std::int64_t));
    JsonNode one = numberType("integer", QString::fromUtf8(unit), range.least, range.most);
    one.add("description", JsonNode::text(QString::fromUtf8(item)));
    return {{key, description, arrayType(length.least, length.most), std::move(one)},
            [=](const ObjectReader& json, P& out) {
                member(out).clear();
                for (const std::int64_t given : readWholes(
                         json, key, {std::numeric_limits<Whole>::min(), std::numeric_limits<Whole>::max()}))
                    member(out).push_back(static_cast<Whole>(given));
            },
            [=](P& from) {
                JsonNode numbers = JsonNode::list();
                for (const Whole each : member(from))
                    numbers.append(JsonNode::number(static_cast<double>(each)));
                return numbers.brief();
            }};
}

template <class P>
template <class Item>
ParameterRow<P>
ParameterRow<P>::list(const char* key, ParameterRange<int> length,
                      const std::vector<ParameterRow<Item>>& rows, const char* item, const char* itemKey,
                      std::type_identity_t<Member<std::vector<Item>>> member, const char* description) {
    JsonNode properties;
    QStringList required;
    Item fresh{};
    for (const ParameterRow<Item>& row : rows) {
        properties.add(row.key(), row.schema(row.isOptional() ? row.byDefault(fresh) : std::nullopt));
        if (!row.isOptional())
            required << row.key();
    }
    return {{key, description, arrayType(length.least, length.most),
             objectNode(QString::fromUtf8(item), std::move(properties), required)},
            [=](const ObjectReader& json, P& out) {
                member(out).clear();
                json.eachObject(QLatin1String(key), [&](const ObjectReader& one) {
                    Item& added = member(out).emplace_back();
                    for (const ParameterRow<Item>& row : rows)
                        if (!row.isOptional() || one.has(row.key()))
                            row.read(one, added);
                    refuseUnknownKeys(one, keysOf(rows), QString::fromUtf8(itemKey));
                });
            },
            [=](P& from) {
                JsonNode items = JsonNode::list();
                for (Item& each : member(from)) {
                    JsonNode node;
                    for (const ParameterRow<Item>& row : rows)
                        node.add(row.key(), row.value(each));
                    items.append(std::move(node));
                }
                return items.brief();
            }};
}

} // namespace chiron::catalogue
