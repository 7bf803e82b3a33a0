// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>

namespace chiron::tests {

/// Days, times of day, sizes of files, digests, folders and the codes of participants are of today, and
/// become one 0.
inline QString withoutToday(QString text) {
    static const QRegularExpression digest(QStringLiteral("\\b[0-9a-f]{8,}\\b")),
        day(QStringLiteral("\\b((Mon|Tue|Wed|Thu|Fri|Sat|Sun)[a-z]*,? )?([0-9]{1,2} "
                           ")?(Jan(uary)?|Feb(ruary)?|Mar(ch)?|Apr(il)?|May|June?|July?|Aug(ust)?|Sept?("
                           "ember)?|Oct(ober)?|Nov(ember)?|Dec(ember)?)( [0-9]{1,2})?(,? [0-9]{4})?\\b")),
        hour(QStringLiteral("\\b[0-9]{1,2}:[0-9]{2}(:[0-9]{2})?([\\x{202f}\\x{00a0} ](AM|PM))?")),
        isoDay(QStringLiteral("\\b20[0-9]{2}-[0-9]{2}-[0-9]{2}\\b")), folder(QStringLiteral("/[^ ]*/")),
        code(QStringLiteral("\\b[0-9A-Z]{3}-[0-9A-Z]{3}\\b")),
        shortDay(QStringLiteral("\\b[0-9]{1,2}([/.])[0-9]{1,2}\\1([0-9]{4}|[0-9]{2})\\b")),
        size(QStringLiteral("\\b[0-9.]+[\\x{202f}\\x{00a0} ](kB|MB|GB|TB)\\b"));
    for (const QRegularExpression& ofToday : {code, digest, isoDay, shortDay, day, hour, size})
        text.replace(ofToday, QStringLiteral("0"));
    return text.replace(folder, QStringLiteral("/…/"));
}

} // namespace chiron::tests
