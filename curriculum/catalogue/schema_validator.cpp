// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/schema.h"

#include "catalogue/canonical_json.h"

#include <QJsonArray>
#include <QSet>
#include <algorithm>
#include <cmath>

namespace chiron::catalogue {

namespace {

QString typeName(Schema::Type type) {
    switch (type) {
    case Schema::Type::object:
        return QStringLiteral("an object");
    case Schema::Type::array:
        return QStringLiteral("an array");
    case Schema::Type::string:
        return QStringLiteral("a text");
    case Schema::Type::number:
        return QStringLiteral("a number");
    case Schema::Type::integer:
        return QStringLiteral("a whole number");
    case Schema::Type::boolean:
        break;
    }
    return QStringLiteral("true or false");
}

bool hasType(const QJsonValue& value, Schema::Type type) {
    switch (type) {
    case Schema::Type::object:
        return value.isObject();
    case Schema::Type::array:
        return value.isArray();
    case Schema::Type::string:
        return value.isString();
    case Schema::Type::number:
        return value.isDouble() && std::isfinite(value.toDouble());
    case Schema::Type::integer:
        return value.isDouble() && std::isfinite(value.toDouble()) &&
               value.toDouble() == std::floor(value.toDouble());
    case Schema::Type::boolean:
        break;
    }
    return value.isBool();
}

/// Returns the value as a message shows it.
QString shown(const QJsonValue& value) {
    if (value.isUndefined())
        return QStringLiteral("missing");
    if (value.isString())
        return quoted(value.toString());
    if (value.isObject())
        return QStringLiteral("an object");
    if (value.isArray())
        return QStringLiteral("an array of %1").arg(value.toArray().size());
    if (value.isDouble() && !std::isfinite(value.toDouble()))
        return QStringLiteral("a number beyond all doubles");
    return QString::fromStdString(canonicalJson(value));
}

QString range(const Schema& schema, const QString& what) {
    const QString least = schema.minimum ? QString::number(*schema.minimum) : QString();
    const QString most = schema.maximum ? QString::number(*schema.maximum) : QString();
    QString text = what;
    if (!least.isEmpty() || !most.isEmpty())
        text += QStringLiteral(", %1 to %2")
                    .arg(least.isEmpty() ? QStringLiteral("any") : least,
                         most.isEmpty() ? QStringLiteral("any") : most);
    return schema.unit.isEmpty() || schema.unit == QLatin1String("1") ? text : text + u' ' + schema.unit;
}

bool inRange(const Schema& schema, double size) {
    return (!schema.minimum || size >= *schema.minimum) && (!schema.maximum || size <= *schema.maximum);
}

bool isIdentifier(const QString& text) {
    return !text.isEmpty() && text[0] >= u'a' && text[0] <= u'z' &&
           std::all_of(text.begin(), text.end(), [](QChar c) {
               return c == u'_' || (c >= u'a' && c <= u'z') || (c >= u'0' && c <= u'9');
           });
}

void checkText(const QString& text, const Schema& schema, const QString& path, Problems& problems) {
    if (!schema.oneOf.empty() &&
        std::find(schema.oneOf.begin(), schema.oneOf.end(), text) == schema.oneOf.end()) {
        QString all;
        for (const QString& value : schema.oneOf)
            all += (all.isEmpty() ? QString() : QStringLiteral(", ")) + value;
        problems.push_back(
            {path, quoted(text), QStringLiteral("one of ") + all + didYouMean(text, schema.oneOf)});
    }
    if (!inRange(schema, static_cast<double>(text.size())))
        problems.push_back(
            {path, quoted(text), range(schema, QStringLiteral("a text of this many characters"))});
    if (schema.identifier && !isIdentifier(text))
        problems.push_back(
            {path, quoted(text), QStringLiteral("lower-case letters, digits and _, a letter first")});
    if (std::any_of(text.begin(), text.end(), [&](QChar c) {
            return (c.unicode() < 0x20 && !(schema.paragraphs && c == u'\n')) || c.unicode() == 0x7f;
        }))
        problems.push_back({path, quoted(text), QStringLiteral("a text without control characters")});
}

bool looksLikeLanguage(const QString& key) {
    return (key.size() == 2 || key.size() == 3) &&
           std::all_of(key.begin(), key.end(), [](QChar c) { return c >= u'a' && c <= u'z'; });
}

/// Returns a text in English, or an object with a text per language, as the latter.
QJsonValue checkedTranslation(const QJsonValue& value, const Schema& schema, const QString& path,
                              Problems& problems) {
    if (value.isString()) {
        checkText(value.toString(), schema, path, problems);
        return QJsonObject{{QStringLiteral("en"), value}};
    }
    const QJsonObject texts = value.toObject();
    const QStringList keys = texts.keys();
    if (std::none_of(keys.begin(), keys.end(), looksLikeLanguage)) {
        problems.push_back({path, shown(value),
                            range(schema, QStringLiteral("a text in English, of this many characters"))});
        return value;
    }
    for (const QString& key : keys) {
        const QString at = memberPath(path, key);
        if (!looksLikeLanguage(key))
            problems.push_back(
                {at, QStringLiteral("unknown key"), QStringLiteral("a language, such as \"de\"")});
        else if (!texts[key].isString())
            problems.push_back({at, shown(texts[key]), typeName(Schema::Type::string)});
        else
            checkText(texts[key].toString(), schema, at, problems);
    }
    if (!texts.contains(QStringLiteral("en")))
        problems.push_back({memberPath(path, QStringLiteral("en")), QStringLiteral("missing"),
                            QStringLiteral("a text in English at least")});
    return value;
}

QJsonValue checkedArray(const QJsonArray& array, const Schema& schema, const QString& path,
                        Problems& problems) {
    if (!inRange(schema, static_cast<double>(array.size())))
        problems.push_back(
            {path, shown(array), range(schema, QStringLiteral("an array of this many elements"))});
    QJsonArray out;
    QSet<QString> seen;
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QString at = elementPath(path, i);
        if (schema.unique) {
            const QString text = QString::fromStdString(canonicalJson(array[i]));
            if (seen.contains(text))
                problems.push_back({at, shown(array[i]), QStringLiteral("no element twice")});
            seen.insert(text);
        }
        out.append(schema.items ? validated(array[i], *schema.items, at, problems) : array[i]);
    }
    return out;
}

QJsonValue checkedObject(const QJsonObject& object, const Schema& schema, const QString& path,
                         Problems& problems) {
    std::vector<QString> known;
    for (const auto& [key, ignored] : schema.properties)
        known.push_back(key);
    QJsonObject out;
    for (auto it = object.begin(); it != object.end(); ++it) {
        const QString at = memberPath(path, it.key());
        if (const auto property = schema.properties.find(it.key()); property != schema.properties.end())
            out.insert(it.key(), validated(it.value(), *property->second, at, problems));
        else
            problems.push_back({at, QStringLiteral("unknown key"),
                                QStringLiteral("a key of the schema") + didYouMean(it.key(), known)});
    }
    for (const QString& key : schema.required)
        if (!object.contains(key))
            problems.push_back({memberPath(path, key), QStringLiteral("missing"),
                                typeName(schema.properties.at(key)->type) + QStringLiteral(": ") +
                                    schema.properties.at(key)->description});
    for (const auto& [key, property] : schema.properties)
        if (!object.contains(key) && !property->defaultValue.isUndefined())
            out.insert(key, property->defaultValue);
    return out;
}

} // namespace

QJsonValue validated(const QJsonValue& value, const Schema& schema, const QString& path, Problems& problems) {
    if (schema.translated)
        return checkedTranslation(value, schema, path, problems);
    if (!hasType(value, schema.type)) {
        problems.push_back({path, shown(value), range(schema, typeName(schema.type))});
        return value;
    }
    switch (schema.type) {
    case Schema::Type::object:
        return checkedObject(value.toObject(), schema, path, problems);
    case Schema::Type::array:
        return checkedArray(value.toArray(), schema, path, problems);
    case Schema::Type::string:
        checkText(value.toString(), schema, path, problems);
        return value;
    case Schema::Type::number:
    case Schema::Type::integer:
        if (!inRange(schema, value.toDouble()))
            problems.push_back({path, shown(value), range(schema, typeName(schema.type))});
        return value;
    case Schema::Type::boolean:
        break;
    }
    return value;
}

} // namespace chiron::catalogue
