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

/// Says what kind of file it is instead of a list, and how to convert it; empty for a text file.
QString fileWords(database::RosterFault fault) {
    using database::RosterFault;
    switch (fault) {
    case RosterFault::excelFile:
        return words(QT_TRANSLATE_NOOP("RosterWords",
                                       "This is an Excel workbook (.xlsx). Open it in Excel, choose File > "
                                       "Save As and the file type “CSV UTF-8 (comma delimited)”, "
                                       "then choose the new file here."));
    case RosterFault::oldExcelFile:
        return words(QT_TRANSLATE_NOOP("RosterWords",
                                       "This is an old Excel workbook (.xls). Open it in Excel, choose File "
                                       "> Save As and the file type “CSV UTF-8 (comma delimited)”, "
                                       "then choose the new file here."));
    case RosterFault::openDocumentFile:
        return words(QT_TRANSLATE_NOOP("RosterWords",
                                       "This is a LibreOffice spreadsheet (.ods). Open it in LibreOffice, "
                                       "choose File > Save As and the file type “Text CSV”, then choose "
                                       "the new file here."));
    case RosterFault::pdfFile:
        return words(QT_TRANSLATE_NOOP("RosterWords",
                                       "This is a PDF, which has no columns to read. Ask for the list "
                                       "as a table, save it as CSV, then choose that file here."));
    case RosterFault::archiveFile:
        return words(QT_TRANSLATE_NOOP("RosterWords",
                                       "This is a ZIP archive. Unpack it and choose the CSV file in it."));
    default:
        return {};
    }
}

QString faultWords(const database::RosterProblem& problem) {
    using database::RosterFault;
    const QString value = QString::fromStdString(problem.value);
    const QLocale locale;
    switch (problem.fault) {
    case RosterFault::notText:
        return words(QT_TRANSLATE_NOOP("RosterWords", "this is not a text file; a CSV file is needed"));
    case RosterFault::notReadable:
        return words(QT_TRANSLATE_NOOP(
            "RosterWords", "some letters cannot be read; save the list as “CSV UTF-8” once more"));
    case RosterFault::notClosed:
        return words(QT_TRANSLATE_NOOP("RosterWords", "a quotation mark is opened here and never closed"));
    case RosterFault::tooManyLines:
        return words(QT_TRANSLATE_NOOP("RosterWords", "too many lines, %1 at most"))
            .arg(locale.toString(value.toInt()));
    case RosterFault::nobody:
        return words(
            QT_TRANSLATE_NOOP("RosterWords", "a line with headings and at least one person are needed"));
    case RosterFault::noHeadings:
        return words(QT_TRANSLATE_NOOP("RosterWords",
                                       "headings are needed here, such as login name, full name and role; "
                                       "\"%1\" is none of them. “Save a template …” makes a file that "
                                       "has them"))
            .arg(value);
    case RosterFault::columnTwice:
        return words(QT_TRANSLATE_NOOP("RosterWords",
                                       "the column \"%1\" holds what another column holds already"))
            .arg(value);
    case RosterFault::columnMissing:
        return problem.value == "role"
                   ? words(QT_TRANSLATE_NOOP("RosterWords",
                                             "no column holds the roles; give one the heading “Role”"))
                   : words(QT_TRANSLATE_NOOP(
                         "RosterWords", "no column holds the login name; give one the heading “Login name”"));
    case RosterFault::fieldCount:
        return words(QT_TRANSLATE_NOOP("RosterWords", "has %1 fields, and there are %2 headings; put a value "
                                                      "that holds the separator into quotation marks"))
            .arg(value, locale.toString(problem.other));
    case RosterFault::roles:
        return words(QT_TRANSLATE_NOOP("RosterWords", "\"%1\" is not a role; write trainee, trainer, "
                                                      "researcher or administrator, separated by semicolons"))
            .arg(value);
    case RosterFault::name:
        return value.isEmpty() ? words(QT_TRANSLATE_NOOP("RosterWords", "a login name is needed"))
                               : words(QT_TRANSLATE_NOOP(
                                           "RosterWords",
                                           "\"%1\" cannot be used; use at most %2 characters and no commas"))
                                     .arg(value, locale.toString(database::kMaximumNameCharacters));
    case RosterFault::displayName:
        return words(QT_TRANSLATE_NOOP("RosterWords", "the full name is too long; use at most %1 characters"))
            .arg(locale.toString(database::kMaximumDisplayNameCharacters));
    case RosterFault::password:
        return words(QT_TRANSLATE_NOOP(
                         "RosterWords",
                         "the password needs at least %1 characters, %2 of them different, and must not be "
                         "the name"))
            .arg(locale.toString(database::kMinimumPasswordCharacters),
                 locale.toString(database::kMinimumDifferentCharacters));
    case RosterFault::nameTwice:
        return words(QT_TRANSLATE_NOOP("RosterWords", "\"%1\" is already in line %2"))
            .arg(value, locale.toString(problem.other));
    default:
        return {};
    }
}

} // namespace

QString rosterProblemWords(const database::RosterProblem& problem) {
    if (const QString file = fileWords(problem.fault); !file.isEmpty())
        return file;
    const QString line = QLocale().toString(problem.line);
    const bool inColumn = !problem.column.empty() && problem.fault != database::RosterFault::columnTwice &&
                          problem.fault != database::RosterFault::fieldCount;
    return inColumn ? words(QT_TRANSLATE_NOOP("RosterWords", "Line %1, column “%2”: %3"))
                          .arg(line, QString::fromStdString(problem.column), faultWords(problem))
                    : words(QT_TRANSLATE_NOOP("RosterWords", "Line %1: %2")).arg(line, faultWords(problem));
}

} // namespace chiron::desktop
