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

/// What one value of a content file may be: a subset of JSON Schema (2020-12) with `unit` beside it.
/// Keywords: type, title, description, unit, default, minimum, maximum, enum, format ("identifier", "translated",
/// "translated_paragraphs"),
/// minLength, maxLength, properties, required, items, minItems, maxItems, uniqueItems, $ref (a file of the
/// same folder), $schema, $id. Objects are closed: a key that is not in `properties` is refused. No patterns,
/// so no regular expressions.
struct Schema {
    enum class Type { object, array, string, number, integer, boolean };

    Type type = Type::object;
    QString unit; ///< "" where it has none
    QString description;
    QJsonValue defaultValue = QJsonValue::Undefined;
    std::optional<double> minimum; ///< of the number, the text's length or the array's size; inclusive
    std::optional<double> maximum;
    bool identifier = false;    ///< string: lower-case letters, digits and _, a letter first
    /// string: a text for people, in English (content_texts.h has its translations). An object with a text per language is read as well; either
    /// becomes such an object.
    bool translated = false;
    bool paragraphs = false; ///< translated: it may have line breaks
    bool unique = false;        ///< array: no element twice
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

/// Reads `<directory>/<name>.json` with what it refers to. Failure: badInput as JsonFile has it; a keyword
/// that is not in the subset, a property without description, a number without unit, or a default its own
/// schema refuses.
core::Result<Schema> readSchema(const QString& directory, const QString& name);

/// Checks `value` against `schema`, adds what is wrong to `problems`, and returns the value with every
/// default filled in (meaningful only if nothing was added).
QJsonValue validated(const QJsonValue& value, const Schema& schema, const QString& path, Problems& problems);

} // namespace chiron::catalogue
