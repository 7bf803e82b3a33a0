// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/json_node.h"

#include <QJsonArray>
#include <QJsonDocument>

namespace chiron::catalogue {

JsonNode JsonNode::text(const QString& text) {
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    JsonNode node;
    node.m_type = Type::scalar;
    node.m_scalar = QString::fromUtf8(list.mid(1, list.size() - 2));
    return node;
}

JsonNode JsonNode::number(double number) {
    constexpr int kFewest = 15, kEnough = 17;
    JsonNode node;
    node.m_type = Type::scalar;
    for (int digits = kFewest; digits <= kEnough; ++digits) {
        node.m_scalar = QString::number(number, 'g', digits);
        if (node.m_scalar.toDouble() == number)
            break;
    }
    return node;
}

JsonNode JsonNode::yesNo(bool value) {
    JsonNode node;
    node.m_type = Type::scalar;
    node.m_scalar = value ? QStringLiteral("true") : QStringLiteral("false");
    return node;
}

JsonNode JsonNode::list(std::vector<JsonNode> items) {
    JsonNode node;
    node.m_type = Type::list;
    node.m_items = std::move(items);
    return node;
}

JsonNode JsonNode::texts(const QStringList& texts) {
    JsonNode node = list();
    for (const QString& each : texts)
        node.append(text(each));
    return node;
}

void JsonNode::add(const QString& key, JsonNode value) {
    m_members.emplace_back(key, std::move(value));
}

void JsonNode::append(JsonNode item) {
    m_items.push_back(std::move(item));
}

JsonNode JsonNode::brief() const {
    JsonNode node = *this;
    node.m_brief = true;
    return node;
}

QString JsonNode::writtenAt(int depth, JsonLayout layout, bool onOneLine) const {
    if (m_type == Type::scalar)
        return m_scalar;
    onOneLine = onOneLine || (m_brief && layout == JsonLayout::briefOnOneLine);
    QStringList inside;
    for (const auto& [key, value] : m_members)
        inside << text(key).m_scalar + QStringLiteral(": ") + value.writtenAt(depth + 1, layout, onOneLine);
    for (const JsonNode& item : m_items)
        inside << item.writtenAt(depth + 1, layout, onOneLine);
    const QString brackets = m_type == Type::object ? QStringLiteral("{}") : QStringLiteral("[]");
    if (inside.isEmpty())
        return brackets;
    if (onOneLine)
        return brackets.front() + inside.join(QStringLiteral(", ")) + brackets.back();
    constexpr int kIndent = 4;
    const QString outer = u'\n' + QString(kIndent * depth, u' ');
    const QString inner = outer + QString(kIndent, u' ');
    return brackets.front() + inner + inside.join(u',' + inner) + outer + brackets.back();
}

} // namespace chiron::catalogue
