// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/roster_template.h"

#include "desktop/accounts/account_words.h"

#include <QCoreApplication>
#include <QSaveFile>

namespace chiron::desktop {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("RosterTemplate", text);
}

} // namespace

QByteArray rosterTemplate(const QLocale& locale) {
    const QStringList lines[] = {{words(QT_TRANSLATE_NOOP("RosterTemplate", "Full name")),
                                  words(QT_TRANSLATE_NOOP("RosterTemplate", "Login name")),
                                  words(QT_TRANSLATE_NOOP("RosterTemplate", "Role"))},
                                 {words(QT_TRANSLATE_NOOP("RosterTemplate", "Example: Anna Miller")),
                                  QStringLiteral("anna.miller"), roleName(database::Role::trainee)},
                                 {words(QT_TRANSLATE_NOOP("RosterTemplate", "Example: Peter Brown")),
                                  QStringLiteral("peter.brown"), roleName(database::Role::trainer)}};
    const QString separator =
        locale.decimalPoint() == QLatin1String(",") ? QStringLiteral(";") : QStringLiteral(",");
    QString text;
    for (const QStringList& line : lines)
        text += line.join(separator) + QStringLiteral("\r\n");
    return QByteArray("\xef\xbb\xbf") + text.toUtf8();
}

core::Result<void> writeRosterTemplate(const QString& name, const QLocale& locale) {
    const QByteArray text = rosterTemplate(locale);
    QSaveFile file(name);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit())
        return core::fail(core::ErrorCode::storage,
                          name.toStdString() + ": " + file.errorString().toStdString());
    return {};
}

} // namespace chiron::desktop
