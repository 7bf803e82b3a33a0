// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_titles.h"

#include "desktop/frame/palette_search.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace chiron::desktop {

namespace {

/// The translation context of the texts.
struct StudyTitles {
    Q_DECLARE_TR_FUNCTIONS(StudyTitles)
};

constexpr qsizetype kLongestCopied = 200; // the repository accepts 500 bytes, and a letter may take two

} // namespace

QString titleForComparison(const QString& title) {
    return forSearch(title.simplified());
}

QString freeTitle(const QString& title, const std::set<QString>& taken) {
    QString free = title;
    for (int n = 2; taken.contains(titleForComparison(free)); ++n)
        free = QStringLiteral("%1 %2").arg(title, QString::number(n));
    return free;
}

QString shortNameOf(const QString& title) {
    constexpr qsizetype kLongest = 40;
    static const QRegularExpression kAccents(QStringLiteral("[\\x{0300}-\\x{036F}]"));
    static const QRegularExpression kOther(QStringLiteral("[^a-z0-9]+"));
    static const QRegularExpression kEnds(QStringLiteral("^[_0-9]+|_+$"));
    QString name = title.normalized(QString::NormalizationForm_D).toLower();
    name.remove(kAccents); // ü becomes u
    return name.replace(kOther, QStringLiteral("_")).remove(kEnds).left(kLongest);
}

QString freeShortName(const QString& wanted, const std::set<QString>& taken) {
    QString name = wanted;
    for (int n = 2; taken.contains(name); ++n)
        name = QStringLiteral("%1_%2").arg(wanted, QString::number(n));
    return name;
}

bool isShortName(const QString& name) {
    static const QRegularExpression kName(QStringLiteral("^[a-z][a-z0-9_]{0,62}$"));
    return kName.match(name).hasMatch();
}

bool isMadeOf(const QString& shortName, const QString& title) {
    static const QRegularExpression kNumberOfCopy(QStringLiteral("_\\d{1,2}$"));
    const QString made = shortNameOf(title);
    return !made.isEmpty() && (shortName == made || QString(shortName).remove(kNumberOfCopy) == made);
}

QString copyTitle(const QString& original, const std::set<QString>& taken) {
    const QString word = StudyTitles::tr("copy");
    QString title = original.simplified().left(kLongestCopied);
    // Otherwise it would become "(copy) (copy)".
    title.remove(
        QRegularExpression(QStringLiteral("\\s*\\(%1( \\d+)?\\)$").arg(QRegularExpression::escape(word))));
    for (int n = 1;; ++n)
        if (const QString copy = n == 1 ? QStringLiteral("%1 (%2)").arg(title, word)
                                        : QStringLiteral("%1 (%2 %3)").arg(title, word, QString::number(n));
            !taken.contains(titleForComparison(copy)))
            return copy;
}

} // namespace chiron::desktop
