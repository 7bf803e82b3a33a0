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
