// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/translations/text_rules.h"

#include <QRegularExpression>
#include <algorithm>

namespace chiron::test {
namespace {

QStringList placeholders(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral("%L?(?:n|[1-9][0-9]?)"));
    QStringList found;
    for (auto it = pattern.globalMatch(text); it.hasNext();)
        found << it.next().captured();
    std::sort(found.begin(), found.end());
    return found;
}

qsizetype mnemonics(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral("&(?=[^& ])"));
    return QString(text).remove(QLatin1String("&&")).count(pattern);
}

/// The sign that ends a text, behind closing quotation marks and brackets; nothing for a letter or a digit.
QString ending(const QString& text) {
    static const QRegularExpression closing(
        QStringLiteral("[\\s\\x{00A0}\\x{202F}\"')\\]“”»’]+$")); // also spaces that do not break
    static const QString signs = QStringLiteral(".…:!?,;");
    const QString bare = QString(text).remove(closing);
    if (bare.isEmpty() || !signs.contains(bare.back()))
        return {};
    return bare.back() == QLatin1Char(';') ? QStringLiteral("?")
                                           : QString(bare.back()); // the Greek question mark
}

QString spaceBefore(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral("^\\s*"));
    return pattern.match(text).captured();
}

QString spaceAfter(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral("\\s*$"));
    return pattern.match(text).captured();
}

QStringList faultsOfForm(const QString& source, const QString& form) {
    QStringList faults;
    if (form.trimmed().isEmpty())
        return {QStringLiteral("is empty")};
    if (placeholders(source) != placeholders(form))
        faults << QStringLiteral("has other placeholders");
    if (source.count(QLatin1Char('\n')) != form.count(QLatin1Char('\n')))
        faults << QStringLiteral("has other line breaks");
    if (spaceBefore(source) != spaceBefore(form) || spaceAfter(source) != spaceAfter(form))
        faults << QStringLiteral("has other spaces at the ends");
    if (ending(source) != ending(form))
        faults << QStringLiteral("ends with another sign");
    if (mnemonics(source) != mnemonics(form))
        faults << QStringLiteral("has other mnemonics");
    return faults;
}

} // namespace

QStringList faultsOf(const TsMessage& message, int pluralForms) {
    QStringList faults;
    if (!message.finished)
        faults << QStringLiteral("is not finished");
    if (message.translations.size() != (message.counts ? pluralForms : 1))
        faults << QStringLiteral("does not have all its forms");
    for (const QString& form : message.translations)
        for (const QString& fault : faultsOfForm(message.source, form))
            faults << QStringLiteral("%1 (\"%2\")").arg(fault, form);
    return faults;
}

} // namespace chiron::test
