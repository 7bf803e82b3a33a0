// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStringList>

namespace chiron::test {

/// A small study with everything in it that the reader knows.
inline QByteArray someStudy() {
    return R"({"id":"s","title":{"en":"T","de":"U"},"objective":{"en":"O"},"instructions":{"en":"I"},"consent":{"en":"C"},
"conditions":[{"id":"a","title":{"en":"A"},"stimulus":{"attribute":"stiffness","reference":60,"differences":[0.01,0.02,0.1],
"fixed":{"damping_Ns_per_m":1}},"task":"rank3","procedures":[{"kind":"descending","levels":[0.1,0.02],"repeats":3}]},
{"id":"b","title":{"en":"B"},"instructions":{"en":"Put on the glove.","de":"Ziehen Sie den Handschuh an."},"stimulus":{"attribute":"mass","reference":0.05,"differences":[0.01,0.1]},"task":"2afc",
"scale":"log_difference","criterion":0.8,"procedures":[{"kind":"staircase","start":-1,"minimum":-2,"maximum":-1},
{"kind":"constant","levels":[-1.5,-1]}]}],
"order":"latin_square","trial":{"feedback":true,"practice_trials":2},"fidelity":{"peak_force_N":3},
"questionnaires":[{"id":"q","title":{"en":"Q"},"when":"before","items":[
{"id":"l","text":{"en":"L"},"kind":"likert","scale":7,"low":{"en":"no"},"high":{"en":"yes"},"construct":"face"},
{"id":"n","text":{"en":"N"},"kind":"number","lowest":0,"highest":9},
{"id":"c","text":{"en":"C"},"kind":"choice","choices":[{"en":"x"},{"en":"y"}]},
{"id":"t","text":{"en":"T"},"kind":"text","required":false}]}],
"participants_planned":7,"blind_participant":false,"blind_experimenter":true,"seed":9007199254740991})";
}

/// The value at a path such as "conditions.0.id" exchanged; undefined: taken out.
inline QJsonValue changed(const QJsonValue& json, const QStringList& path, const QJsonValue& value) {
    if (path.isEmpty())
        return value;
    if (json.isArray()) {
        QJsonArray array = json.toArray();
        const qsizetype index = path.front().toInt();
        const QJsonValue inner = changed(array.at(index), path.mid(1), value);
        index < array.size() ? array.replace(index, inner) : array.append(inner);
        return array;
    }
    QJsonObject object = json.toObject();
    object[path.front()] = changed(object[path.front()], path.mid(1), value);
    return object;
}

inline QJsonObject parsed(const QByteArray& json) {
    return QJsonDocument::fromJson(json).object();
}

} // namespace chiron::test
