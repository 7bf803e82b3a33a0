// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/number_list.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QStringList>
#include <cmath>
#include <optional>

namespace chiron::desktop {

namespace {

constexpr int kLongestShown = 30;

/// Reads one number with a decimal point or comma; "1.234,5" and "1,234.5" contain thousands separators.
std::optional<double> numberOf(QString word) {
    const qsizetype comma = word.lastIndexOf(QLatin1Char(','));
    const qsizetype point = word.lastIndexOf(QLatin1Char('.'));
    if (comma >= 0 && point >= 0)
        word.remove(comma > point ? QLatin1Char('.') : QLatin1Char(','));
    if (word.count(QLatin1Char(',')) > 1)
        return std::nullopt;
    word.replace(QLatin1Char(','), QLatin1Char('.'));
    word.replace(QChar(0x2212), QLatin1Char('-')); // a typographic minus
    bool good = false;
    const double value = QLocale::c().toDouble(word, &good);
    return good && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

/// Commas separate numbers only if nothing else does and no number can contain a decimal comma.
bool commasSeparate(const QString& text, const QLocale& locale) {
    if (!text.contains(QLatin1Char(',')))
        return false;
    return text.contains(QLatin1Char('.')) ||
           (text.count(QLatin1Char(',')) == 1 && locale.decimalPoint() != QStringLiteral(","));
}

} // namespace

NumberList readNumbers(const QString& text, const QLocale& locale) {
    static const QRegularExpression kGaps(QStringLiteral("[;\\s\\x{00A0}\\x{202F}]+"));
    static const QRegularExpression kPercent(QStringLiteral("\\s*%"));
    const QString plain = QString(text).remove(kPercent).trimmed();
    QStringList words = plain.split(kGaps, Qt::SkipEmptyParts);
    if (words.size() == 1 && commasSeparate(plain, locale))
        words = plain.split(QLatin1Char(','), Qt::SkipEmptyParts);
    NumberList list;
    for (QString word : words) {
        if (words.size() > 1 && word.endsWith(QLatin1Char(','))) // "0.5, 1.5"
            word.chop(1);
        if (const auto value = numberOf(word))
            list.values.push_back(*value);
        else if (list.unread.isEmpty())
            list.unread = word;
    }
    return list;
}

QString unreadWords(const NumberList& list) {
    if (list.unread.isEmpty())
        return {};
    return QCoreApplication::translate("StudyWords",
                                       "“%1” is not a number. Separate numbers by semicolons or line ends.")
        .arg(list.unread.size() > kLongestShown ? list.unread.left(kLongestShown) + QStringLiteral("…")
                                                : list.unread);
}

QString listText(const std::vector<double>& values, const QLocale& locale) {
    QStringList words;
    for (const double value : values)
        words << locale.toString(value, 'g', 6);
    return words.join(QStringLiteral("; "));
}

} // namespace chiron::desktop
