// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/object_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::catalogue {

QJsonValue ObjectReader::member(const QString& key, QJsonValue::Type type, const QString& expected) const {
    const QJsonValue value = m_object.value(key);
    if (value.type() == type)
        return value;
    m_problems.push_back({memberPath(m_path, key),
                          value.isUndefined() ? QStringLiteral("missing") : QStringLiteral("another type"),
                          expected});
    return QJsonValue(type);
}

std::string ObjectReader::text(const QString& key) const {
    return member(key, QJsonValue::String, QStringLiteral("a text")).toString().toStdString();
}

double ObjectReader::number(const QString& key) const {
    const double value = member(key, QJsonValue::Double, QStringLiteral("a number")).toDouble();
    if (!std::isfinite(value))
        m_problems.push_back(
            {memberPath(m_path, key), QStringLiteral("not finite"), QStringLiteral("a number")});
    return value;
}

int ObjectReader::integer(const QString& key) const {
    const double value = number(key);
    if (value != std::floor(value) || std::abs(value) > std::numeric_limits<int>::max()) {
        m_problems.push_back(
            {memberPath(m_path, key), QString::number(value), QStringLiteral("a whole number")});
        return 0;
    }
    return static_cast<int>(value);
}

bool ObjectReader::boolean(const QString& key) const {
    return member(key, QJsonValue::Bool, QStringLiteral("true or false")).toBool();
}

Translated ObjectReader::translated(const QString& key) const {
    if (m_object.value(key).isString())
        return {{"en", text(key)}};
    Translated out;
    const ObjectReader texts = object(key);
    for (const QString& language : texts.json().keys())
        out[language.toStdString()] = texts.text(language);
    if (!out.contains("en"))
        m_problems.push_back({memberPath(memberPath(m_path, key), "en"), QStringLiteral("missing"),
                              QStringLiteral("a text in English at least")});
    return out;
}

std::vector<std::string> ObjectReader::texts(const QString& key) const {
    std::vector<std::string> out;
    const QJsonArray array = member(key, QJsonValue::Array, QStringLiteral("an array of texts")).toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        if (!array[i].isString())
            m_problems.push_back({elementPath(memberPath(m_path, key), i), QStringLiteral("another type"),
                                  QStringLiteral("a text")});
        out.push_back(array[i].toString().toStdString());
    }
    return out;
}

void ObjectReader::eachObject(const QString& key,
                              const std::function<void(const ObjectReader&)>& visit) const {
    const QJsonArray array = member(key, QJsonValue::Array, QStringLiteral("an array of objects")).toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QString at = elementPath(memberPath(m_path, key), i);
        if (!array[i].isObject())
            m_problems.push_back({at, QStringLiteral("another type"), QStringLiteral("an object")});
        visit(ObjectReader(array[i].toObject(), at, m_problems));
    }
}

ObjectReader ObjectReader::object(const QString& key) const {
    return {member(key, QJsonValue::Object, QStringLiteral("an object")).toObject(), memberPath(m_path, key),
            m_problems};
}

void refuseUnknownKeys(const ObjectReader& json, const std::vector<QString>& known, const QString& what) {
    for (const QString& key : json.json().keys())
        if (std::find(known.begin(), known.end(), key) == known.end())
            json.problems().push_back(
                {memberPath(json.path(), key), QStringLiteral("unknown key"), what + didYouMean(key, known)});
}

} // namespace chiron::catalogue
