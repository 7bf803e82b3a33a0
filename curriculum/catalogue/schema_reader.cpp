// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/schema.h"

#include "catalogue/json_file.h"

#include <QJsonArray>
#include <QSet>
#include <algorithm>

namespace chiron::catalogue {

namespace {

const std::map<QString, Schema::Type>& typeNames() {
    static const std::map<QString, Schema::Type> kNames{
        {"object", Schema::Type::object},   {"array", Schema::Type::array},
        {"string", Schema::Type::string},   {"number", Schema::Type::number},
        {"integer", Schema::Type::integer}, {"boolean", Schema::Type::boolean}};
    return kNames;
}

const QSet<QString>& keywords() {
    static const QSet<QString> kKeywords{"type",      "title",       "description", "unit",    "default",
                                         "minimum",   "maximum",     "enum",        "format",  "minLength",
                                         "maxLength", "properties",  "required",    "items",   "minItems",
                                         "maxItems",  "uniqueItems", "$ref",        "$schema", "$id"};
    return kKeywords;
}

class SchemaReader {
public:
    explicit SchemaReader(QString directory) : m_directory(std::move(directory)) {}

    core::Result<Schema> file(const QString& name, int depth) {
        constexpr int kDeepestReference = 8;
        if (depth > kDeepestReference)
            return core::fail(core::ErrorCode::badInput,
                              (m_directory + "/" + name + ".json: $: $ref runs in a circle: expected a tree")
                                  .toStdString());
        const auto json = JsonFile::read(m_directory + "/" + name + ".json");
        CHIRON_TRY(json);
        Problems problems;
        Schema schema = node(json->root(), QStringLiteral("$"), depth, problems);
        if (m_failed)
            return tl::unexpected(*m_failed);
        if (!problems.empty())
            return tl::unexpected(json->error(problems));
        return schema;
    }

private:
    Schema node(const QJsonObject& json, const QString& path, int depth, Problems& problems) {
        for (auto it = json.begin(); it != json.end(); ++it)
            if (!keywords().contains(it.key()))
                problems.push_back({memberPath(path, it.key()), QStringLiteral("unknown keyword"),
                                    QStringLiteral("a keyword of the schema subset")});
        Schema schema;
        if (json.contains("$ref")) {
            auto referred = file(json["$ref"].toString().chopped(5), depth + 1); // without .json
            if (!referred) {
                m_failed = m_failed ? m_failed : referred.error();
                return schema;
            }
            schema = std::move(*referred);
        } else if (const auto type = typeNames().find(json["type"].toString()); type != typeNames().end()) {
            schema.type = type->second;
        } else {
            problems.push_back(
                {memberPath(path, "type"), quoted(json["type"].toString()), QStringLiteral("a JSON type")});
        }
        limits(json, schema);
        texts(json, path, schema, problems);
        children(json, path, depth, schema, problems);
        if (json.contains("default")) {
            schema.defaultValue = json["default"];
            validated(schema.defaultValue, schema, memberPath(path, "default"), problems);
        }
        return schema;
    }

    static void limits(const QJsonObject& json, Schema& schema) {
        for (const char* key : {"minimum", "minLength", "minItems"})
            if (json.contains(QLatin1String(key)))
                schema.minimum = json[QLatin1String(key)].toDouble();
        for (const char* key : {"maximum", "maxLength", "maxItems"})
            if (json.contains(QLatin1String(key)))
                schema.maximum = json[QLatin1String(key)].toDouble();
        schema.unique = schema.unique || json["uniqueItems"].toBool();
        schema.identifier = schema.identifier || json["format"].toString() == QLatin1String("identifier");
        schema.paragraphs =
            schema.paragraphs || json["format"].toString() == QLatin1String("translated_paragraphs");
        schema.translated = schema.translated || schema.paragraphs ||
                            json["format"].toString() == QLatin1String("translated");
        for (const QJsonValue value : json["enum"].toArray())
            schema.oneOf.push_back(value.toString());
    }

    static void texts(const QJsonObject& json, const QString& path, Schema& schema, Problems& problems) {
        if (json.contains("description"))
            schema.description = json["description"].toString();
        schema.unit = json["unit"].toString();
        if (schema.description.isEmpty())
            problems.push_back({memberPath(path, "description"), QStringLiteral("missing"),
                                QStringLiteral("what it means")});
        const bool numeric = schema.type == Schema::Type::number || schema.type == Schema::Type::integer;
        if (numeric && (schema.unit.isEmpty() || !schema.minimum || !schema.maximum))
            problems.push_back(
                {path, QStringLiteral("a number without unit or range"),
                 QStringLiteral("\"unit\" (\"1\" for a pure number), \"minimum\" and \"maximum\"")});
    }

    void children(const QJsonObject& json, const QString& path, int depth, Schema& schema,
                  Problems& problems) {
        const QJsonObject properties = json["properties"].toObject();
        for (auto it = properties.begin(); it != properties.end(); ++it)
            schema.properties[it.key()] = std::make_unique<Schema>(
                node(it.value().toObject(), memberPath(memberPath(path, "properties"), it.key()), depth,
                     problems));
        for (const QJsonValue value : json["required"].toArray()) {
            schema.required.push_back(value.toString());
            if (!schema.properties.contains(value.toString()))
                problems.push_back({memberPath(path, "required"), quoted(value.toString()),
                                    QStringLiteral("keys of \"properties\"")});
        }
        if (json.contains("items"))
            schema.items = std::make_unique<Schema>(
                node(json["items"].toObject(), memberPath(path, "items"), depth, problems));
    }

    QString m_directory;
    std::optional<core::Error> m_failed;
};

} // namespace

core::Result<Schema> readSchema(const QString& directory, const QString& name) {
    return SchemaReader(directory).file(name, 0);
}

} // namespace chiron::catalogue
