// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "catalogue/problems.h"

#include <QJsonArray>
#include <QJsonObject>
#include <functional>

namespace chiron::catalogue {

/// Reads typed members of a JSON object. A member that is missing or has another type is added to the
/// problems and read as empty.
class ObjectReader {
public:
    ObjectReader(const QJsonObject& object, QString path, Problems& problems)
        : m_object(object), m_path(std::move(path)), m_problems(problems) {}

    std::string text(const QString& key) const;
    double number(const QString& key) const;
    int integer(const QString& key) const;
    bool boolean(const QString& key) const;
    Translated
    translated(const QString& key) const; ///< an object with a text per language, or a text in English
    std::vector<std::string> texts(const QString& key) const;
    void eachObject(const QString& key, const std::function<void(const ObjectReader&)>& visit) const;
    ObjectReader object(const QString& key) const;

    bool has(const QString& key) const { return m_object.contains(key); }
    const QJsonObject& json() const { return m_object; }
    const QString& path() const { return m_path; }
    Problems& problems() const { return m_problems; }

private:
    QJsonValue member(const QString& key, QJsonValue::Type type, const QString& expected) const;

    QJsonObject m_object;
    QString m_path;
    Problems& m_problems;
};

/// Adds a problem for every member of `json` that is not in `known`. `what` describes the known keys in the
/// message: "a parameter of ...".
void refuseUnknownKeys(const ObjectReader& json, const std::vector<QString>& known, const QString& what);

} // namespace chiron::catalogue
