// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

namespace chiron::catalogue {

/// How the lines of a JSON text are broken.
enum class JsonLayout {
    itemPerLine,    ///< every member of an object and every item of a list has a line of its own
    briefOnOneLine, ///< the same, but JsonNode::brief() values are written on one line
};

/// A JSON value whose keys keep the order in which they were added, which is the order in which people read
/// them. QJsonObject sorts them.
class JsonNode {
public:
    JsonNode() = default; ///< an object without members
    static JsonNode text(const QString& text);
    /// Written with the fewest digits, 15 at least, from which the same number is read.
    static JsonNode number(double number);
    static JsonNode yesNo(bool value);
    static JsonNode list(std::vector<JsonNode> items = {});
    static JsonNode texts(const QStringList& texts);

    void add(const QString& key, JsonNode value); ///< to an object
    void append(JsonNode item);                   ///< to a list
    JsonNode brief() const;                       ///< the same value, marked as short

    QString written(JsonLayout layout) const { return writtenAt(0, layout, false); }

private:
    enum class Type { scalar, object, list };
    using Members = std::vector<std::pair<QString, JsonNode>>;

    QString writtenAt(int depth, JsonLayout layout, bool onOneLine) const;

    Type m_type = Type::object;
    bool m_brief = false;
    QString m_scalar; ///< as written
    Members m_members;
    std::vector<JsonNode> m_items;
};

} // namespace chiron::catalogue
