// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/schema_nodes.h"

namespace chiron::catalogue {

JsonNode numberType(const char* type, const QString& unit, double minimum, double maximum) {
    JsonNode node;
    node.add("type", JsonNode::text(QLatin1String(type)));
    node.add("unit", JsonNode::text(unit));
    node.add("minimum", JsonNode::number(minimum));
    node.add("maximum", JsonNode::number(maximum));
    return node;
}

JsonNode arrayType(int fewest, int most) {
    JsonNode node;
    node.add("type", JsonNode::text(QStringLiteral("array")));
    node.add("minItems", JsonNode::number(fewest));
    node.add("maxItems", JsonNode::number(most));
    return node;
}

namespace {

void addProperties(JsonNode& node, JsonNode properties, const QStringList& required) {
    node.add("properties", std::move(properties));
    if (!required.isEmpty())
        node.add("required", JsonNode::texts(required).brief());
}

} // namespace

JsonNode objectNode(const QString& description, JsonNode properties, const QStringList& required) {
    JsonNode node;
    node.add("type", JsonNode::text(QStringLiteral("object")));
    node.add("description", JsonNode::text(description));
    addProperties(node, std::move(properties), required);
    return node;
}

QByteArray schemaFile(const QString& title, const QString& description, JsonNode properties,
                      const QStringList& required, JsonLayout layout) {
    JsonNode schema;
    schema.add("$schema", JsonNode::text(QStringLiteral("https://json-schema.org/draft/2020-12/schema")));
    schema.add("title", JsonNode::text(title));
    schema.add("description", JsonNode::text(description));
    schema.add("type", JsonNode::text(QStringLiteral("object")));
    addProperties(schema, std::move(properties), required);
    return schema.written(layout).toUtf8() + '\n';
}

} // namespace chiron::catalogue
