// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QString>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace chiron::session {

/// Reads members of one stored JSON object and remembers the first that is missing or of the wrong type, so
/// that a damaged row gives one clear Error instead of silent zeros.
class JsonReader {
public:
    JsonReader(const QJsonObject& object, QString place) : m_object(object), m_place(std::move(place)) {}

    /// Reads a number; returns `otherwise` if an earlier version did not write the key.
    double number(const char* key, double otherwise) {
        return m_object.contains(QLatin1String(key)) ? number(key) : otherwise;
    }
    double number(const char* key) { return value(key, QJsonValue::Double, "a number").toDouble(); }
    bool boolean(const char* key) { return value(key, QJsonValue::Bool, "true or false").toBool(); }
    QString string(const char* key) { return value(key, QJsonValue::String, "a text").toString(); }
    std::string text(const char* key) { return string(key).toStdString(); }
    QJsonObject object(const char* key) { return value(key, QJsonValue::Object, "an object").toObject(); }
    QJsonArray array(const char* key) { return value(key, QJsonValue::Array, "a list").toArray(); }
    std::vector<double> numbers(const char* key) {
        std::vector<double> all;
        for (const QJsonValue& item : array(key)) {
            if (!item.isDouble())
                note(key, QStringLiteral("expected a list of numbers"));
            all.push_back(item.toDouble());
        }
        return all;
    }
    /// Reads one of two words: true for `yes`, false for `no`.
    bool oneOf(const char* key, const char* yes, const char* no) {
        const QString word = string(key);
        if (word != QLatin1String(yes) && word != QLatin1String(no))
            note(key, QStringLiteral("expected \"%1\" or \"%2\"").arg(QLatin1String(yes), QLatin1String(no)));
        return word == QLatin1String(yes);
    }

    /// Reads a whole number within [low, high]. A number outside this range is an error and never wraps
    /// around.
    std::int64_t integer(const char* key, std::int64_t low, std::int64_t high) {
        const double v = number(key);
        if (!(v >= static_cast<double>(low) && v <= static_cast<double>(high)) || v != std::floor(v)) {
            note(key, QStringLiteral("expected a whole number from %1 to %2").arg(low).arg(high));
            return low;
        }
        return static_cast<std::int64_t>(v);
    }

    bool ok() const { return m_problem.isEmpty(); }
    core::Error error() const { return {core::ErrorCode::badInput, m_problem.toStdString()}; }

private:
    QJsonValue value(const char* key, QJsonValue::Type type, const char* expected) {
        const QJsonValue found = m_object.value(QLatin1String(key));
        if (found.type() != type)
            note(key, QStringLiteral("expected %1").arg(QLatin1String(expected)));
        return found;
    }
    void note(const char* key, const QString& what) {
        if (m_problem.isEmpty())
            m_problem = QStringLiteral("%1.%2: %3").arg(m_place, QLatin1String(key), what);
    }

    const QJsonObject m_object;
    QString m_place;
    QString m_problem;
};

} // namespace chiron::session
