// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/parameter_rows.h"

namespace chiron::catalogue {

JsonNode ParameterWords::schema(const std::optional<JsonNode>& byDefault) const {
    JsonNode node = type;
    if (byDefault)
        node.add("default", *byDefault);
    node.add("description", JsonNode::text(QString::fromUtf8(description)));
    if (items)
        node.add("items", *items);
    return node;
}

double contentNumber(double si, const ContentUnit& unit) {
    constexpr int kFewest = 15, kEnough = 17;
    const double number = si * unit.perSi / unit.inSi;
    for (int digits = kFewest; digits <= kEnough; ++digits)
        if (const double given = QString::number(number, 'g', digits).toDouble(); unit.toSi(given) == si)
            return given;
    return number;
}

JsonNode flagType() {
    JsonNode node;
    node.add("type", JsonNode::text(QStringLiteral("boolean")));
    return node;
}

JsonNode identifierType() {
    constexpr int kLongest = 40;
    JsonNode node;
    node.add("type", JsonNode::text(QStringLiteral("string")));
    node.add("format", JsonNode::text(QStringLiteral("identifier")));
    node.add("minLength", JsonNode::number(1));
    node.add("maxLength", JsonNode::number(kLongest));
    return node;
}

JsonNode choiceType(const QStringList& words) {
    JsonNode node;
    node.add("type", JsonNode::text(QStringLiteral("string")));
    node.add("enum", JsonNode::texts(words).brief());
    return node;
}

JsonNode referenceType(const NamedKind& kind) {
    JsonNode node;
    node.add("$ref", JsonNode::text(QLatin1String(kind.contentSchema) + QStringLiteral(".json")));
    return node;
}

std::vector<std::int64_t> readWholes(const ObjectReader& json, const char* key,
                                     const ParameterRange<std::int64_t>& range) {
    const QString path = memberPath(json.path(), QLatin1String(key));
    const QJsonValue given = json.json()[QLatin1String(key)];
    if (!given.isArray()) {
        json.problems().push_back(
            {path, given.isUndefined() ? QStringLiteral("missing") : QStringLiteral("another type"),
             QStringLiteral("an array of whole numbers")});
        return {};
    }
    std::vector<std::int64_t> out;
    const QJsonArray array = given.toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const double value = array[i].toDouble(std::numeric_limits<double>::quiet_NaN());
        if (!(value == std::floor(value)) || value < static_cast<double>(range.least) ||
            value > static_cast<double>(range.most)) {
            json.problems().push_back(
                {elementPath(path, i), QStringLiteral("no whole number"), QStringLiteral("a whole number")});
            return out;
        }
        out.push_back(static_cast<std::int64_t>(value));
    }
    return out;
}

void refuseWord(const ObjectReader& json, const char* key, const std::string& given,
                const QStringList& words) {
    QStringList allowed;
    for (const QString& word : words)
        allowed << quoted(word);
    const QString last = allowed.takeLast();
    json.problems().push_back({memberPath(json.path(), QLatin1String(key)),
                               quoted(QString::fromStdString(given)),
                               allowed.join(QStringLiteral(", ")) + QStringLiteral(" or ") + last});
}

QByteArray parametersFile(const ParametersTitle& title, JsonNode properties) {
    return schemaFile(QString::fromUtf8(title.title), QString::fromUtf8(title.description),
                      std::move(properties), {}, title.layout);
}

} // namespace chiron::catalogue
