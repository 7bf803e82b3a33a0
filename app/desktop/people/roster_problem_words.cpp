// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/accounts/account_rules.h"
#include "desktop/people/roster_dialog.h"

#include <QCoreApplication>
#include <QLocale>

namespace chiron::desktop {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("RosterWords", text);
}

QString faultWords(const database::RosterProblem& problem) {
    using database::RosterFault;
    const QString value = QString::fromStdString(problem.value);
    const QLocale locale;
    switch (problem.fault) {
    case RosterFault::notClosed:
        return words(QT_TRANSLATE_NOOP("RosterWords", "a quotation mark is opened here and never closed"));
    case RosterFault::tooManyLines:
        return words(QT_TRANSLATE_NOOP("RosterWords", "too many lines, %1 at most")).arg(locale.toString(value.toInt()));
    case RosterFault::nobody:
        return words(QT_TRANSLATE_NOOP("RosterWords", "a header line and at least one person are needed"));
    case RosterFault::unknownColumn:
        return words(QT_TRANSLATE_NOOP("RosterWords", "the column \"%1\" is unknown or appears twice")).arg(value);
    case RosterFault::columnMissing:
        return words(QT_TRANSLATE_NOOP("RosterWords", "the columns name, roles and password are needed"));
    case RosterFault::fieldCount:
        return words(QT_TRANSLATE_NOOP("RosterWords", "has %1 fields instead of %2")).arg(value, locale.toString(problem.other));
    case RosterFault::roles:
        return words(QT_TRANSLATE_NOOP("RosterWords", "roles \"%1\": only trainee, trainer, researcher and admin, separated by semicolons")).arg(value);
    case RosterFault::name:
        return words(QT_TRANSLATE_NOOP("RosterWords", "the name \"%1\" cannot be used")).arg(value);
    case RosterFault::displayName:
        return words(QT_TRANSLATE_NOOP("RosterWords", "the full name is too long"));
    case RosterFault::password:
        return words(QT_TRANSLATE_NOOP("RosterWords", "the password needs at least %1 characters, %2 of them different, and must not be "
                                                      "the name"))
            .arg(locale.toString(database::kMinimumPasswordCharacters), locale.toString(database::kMinimumDifferentCharacters));
    case RosterFault::nameTwice:
        return words(QT_TRANSLATE_NOOP("RosterWords", "\"%1\" is already in line %2")).arg(value, locale.toString(problem.other));
    case RosterFault::nameTaken:
        return words(QT_TRANSLATE_NOOP("RosterWords", "\"%1\" already exists at this site")).arg(value);
    }
    return {};
}

} // namespace

QString rosterProblemWords(const database::RosterProblem& problem) {
    return words(QT_TRANSLATE_NOOP("RosterWords", "Line %1: %2")).arg(QLocale().toString(problem.line), faultWords(problem));
}

} // namespace chiron::desktop
