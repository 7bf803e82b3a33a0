// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/problems.h"
#include "core/result.h"

#include <QJsonObject>
#include <QJsonValue>
#include <QString>
#include <map>
#include <memory>
#include <optional>
#include <vector>

namespace chiron::catalogue {

/// Describes the allowed values of one key of a content file: a subset of JSON Schema (2020-12) with `unit`
/// added.
/// Keywords: type, title, description, unit, default, minimum, maximum, enum, format ("identifier",
/// "translated", "translated_paragraphs"), minLength, maxLength, properties, required, items, minItems,
/// maxItems, uniqueItems, $ref (a file of the same folder), $schema, $id. Objects are closed: a key that is
/// not in `properties` is refused. There are no patterns and therefore no regular expressions.
struct Schema {
    enum class Type { object, array, string, number, integer, boolean };

    Type type = Type::object;
    QString unit; ///< "" where it has none
    QString description;
    QJsonValue defaultValue = QJsonValue::Undefined;
    std::optional<double> minimum; ///< limit of the number, the text's length or the array's size; inclusive
    std::optional<double> maximum;
    bool identifier = false; ///< string: lower-case letters, digits and _, starting with a letter
    /// string: a text for people, in English (content_texts.h has its translations). An object with a text
    /// per language is accepted as well. Both forms become such an object.
    bool translated = false;
    bool paragraphs = false;    ///< translated: line breaks are allowed
    bool unique = false;        ///< array: no two equal elements
    std::vector<QString> oneOf; ///< string: the values allowed; empty = any
    std::map<QString, std::unique_ptr<Schema>> properties;
    std::vector<QString> required;
    std::unique_ptr<Schema> items;

    Schema() = default;
    Schema(Schema&&) noexcept = default;
    Schema& operator=(Schema&&) noexcept = default;
    Schema(const Schema&) = delete;
    Schema& operator=(const Schema&) = delete;
};

/// Reads `<directory>/<name>.json` and the files that it refers to.
/// Errors: badInput as JsonFile reports it; a keyword outside the subset, a property without a description, a
/// number without a unit, or a default that its own schema refuses.
core::Result<Schema> readSchema(const QString& directory, const QString& name);

/// Checks `value` against `schema`, adds the faults to `problems`, and returns the value with every default
/// filled in. The result is meaningful only if no problem was added.
QJsonValue validated(const QJsonValue& value, const Schema& schema, const QString& path, Problems& problems);

} // namespace chiron::catalogue
