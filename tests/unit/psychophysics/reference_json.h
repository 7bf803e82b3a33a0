// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <vector>

/// A file of tests/unit/psychophysics/data; empty where it cannot be read.
inline QJsonObject referenceJson(const QString& name) {
    QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/tests/unit/psychophysics/data/") + name);
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object() : QJsonObject();
}

inline std::vector<double> numbers(const QJsonValue& value) {
    std::vector<double> list;
    if (value.isDouble())
        return {value.toDouble()};
    for (const QJsonValue& item : value.toArray())
        list.push_back(item.toDouble());
    return list;
}

/// What a published file's cases came to; printed as one line.
struct ReferenceTally {
    int cases = 0;
    int passed = 0;
    double worst = 0.0; ///< the largest difference of a number compared, in the case's unit
};
