// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalogue/procedure_refusal.h"

#include <QJsonArray>

namespace chiron::catalogue {

namespace {

/// The place that a refusal refers to.
struct Refused {
    QString path;
    QString rest; ///< of the message, after the names that form the path
};

/// Follows "parameters: slope: prior: expected ..." to the element of that name, and to its member if it has
/// one.
Refused inside(const QJsonValue& value, Refused at) {
    const QJsonArray array = value.toArray();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QJsonObject element = array[i].toObject();
        if (element.isEmpty() || element.value("name").toString() != at.rest.section(": ", 0, 0))
            continue;
        at = {elementPath(at.path, i), at.rest.section(": ", 1)};
        if (const QString member = at.rest.section(": ", 0, 0); element.contains(member))
            at = {memberPath(at.path, member), at.rest.section(": ", 1)};
        break;
    }
    return at;
}

} // namespace

void addRefusal(const core::Error& error, const ObjectReader& json, const QJsonObject& withDefaults) {
    const QString message = QString::fromStdString(error.message);
    QString key;
    for (const QJsonObject& keys : {json.json(), withDefaults})
        for (const QString& word : message.section(": ", 0, 0).split(", "))
            if (key.isEmpty() && keys.contains(word))
                key = word;
    if (key.isEmpty()) // neither present nor with a default
        key = message.section(": ", 0, 0).section(", ", 0, 0);
    const bool given = json.has(key);
    const QJsonValue value = given ? json.json().value(key) : withDefaults.value(key);
    const Refused at = inside(value, {memberPath(json.path(), key), message.section(": ", 1)});
    QString found = given ? QStringLiteral("not usable") : QStringLiteral("missing");
    if (value.isString() || value.isDouble())
        found = (value.isString() ? quoted(value.toString()) : QString::number(value.toDouble())) +
                (given ? "" : " by default");
    else if (const QString place = at.rest.section("expected ", 0, 0); given && place.endsWith(": "))
        found = place.chopped(2); // the message names the place in the list or table and the value found
                                  // there
    json.problems().push_back(
        {at.path, found, message.contains("expected ") ? message.section("expected ", -1) : message});
}

} // namespace chiron::catalogue
