// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QStringList>

namespace chiron::tests {

/// Ways in which a disk or a person spoils a closed database file.
inline const QStringList kDamages{QStringLiteral("cut off"), QStringLiteral("zeroed header"),
                                  QStringLiteral("wrecked pages"), QStringLiteral("no database"),
                                  QStringLiteral("empty")};

inline bool damage(const QString& name, const QString& how) {
    QFile file(name);
    if (!file.open(QIODevice::ReadWrite))
        return false;
    const qint64 size = file.size();
    if (how == QLatin1String("cut off"))
        return file.resize(size / 2);
    if (how == QLatin1String("empty"))
        return file.resize(0);
    if (how == QLatin1String("zeroed header"))
        return file.write(QByteArray(4096, '\0')) == 4096;
    if (how == QLatin1String("wrecked pages")) // all but the first, which has the header and the schema
        return file.seek(4096) &&
               file.write(QByteArray(static_cast<qsizetype>(size - 4096), '\xa5')) == size - 4096;
    return file.resize(0) && file.write(QByteArray("Dear diary, today I learnt to knot. ").repeated(400)) > 0;
}

} // namespace chiron::tests
