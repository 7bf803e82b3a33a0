// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/messages.h"

#include <QCoreApplication>

namespace chiron::desktop {

void Messages::error(const QString& what, const core::Error& error, Tried tried) {
    tell({MessageKind::error, what + QLatin1Char('\n') + inWords(error, tried), {}, {}});
}

QString inWords(const core::Error& error, Tried tried) {
    const auto words = [](const char* text) { return QCoreApplication::translate("ErrorWords", text); };
    QString advice;
    switch (error.code) {
    case core::ErrorCode::notAllowed:
        advice = words(QT_TRANSLATE_NOOP(
            "ErrorWords", "Your account does not permit this. If you need it, ask an administrator."));
        break;
    case core::ErrorCode::notFound:
        advice = tried == Tried::opening
                     ? words(QT_TRANSLATE_NOOP(
                           "ErrorWords",
                           "A file that the site needs is missing. Put it back, then try again. Nothing was "
                           "changed."))
                     : words(QT_TRANSLATE_NOOP(
                           "ErrorWords", "It no longer exists or was never created. Nothing was changed."));
        break;
    case core::ErrorCode::storage:
        advice = tried == Tried::saving
                     ? words(QT_TRANSLATE_NOOP(
                           "ErrorWords",
                           "It could not be saved. What was recorded before is kept; check the free space "
                           "and try again."))
                     : words(QT_TRANSLATE_NOOP(
                           "ErrorWords",
                           "It could not be read. Check that the drive is connected and that you may read "
                           "the file, then try again. Nothing was changed."));
        break;
    case core::ErrorCode::locked:
        advice = words(QT_TRANSLATE_NOOP(
            "ErrorWords", "Another program is writing to this database. Close the database there, then try "
                          "again."));
        break;
    case core::ErrorCode::device:
        advice = words(QT_TRANSLATE_NOOP(
            "ErrorWords",
            "The device did not respond correctly. Check its cable and power, then try again."));
        break;
    case core::ErrorCode::cancelled:
        advice = words(QT_TRANSLATE_NOOP(
            "ErrorWords", "The operation was stopped before it finished. Nothing was changed."));
        break;
    case core::ErrorCode::doesNotHold:
        advice = words(QT_TRANSLATE_NOOP("ErrorWords", "The check found errors."));
        break;
    case core::ErrorCode::wrongUse:
    case core::ErrorCode::badInput:
        advice = tried == Tried::saving
                     ? words(QT_TRANSLATE_NOOP("ErrorWords", "The input is not valid. Nothing was changed."))
                     : words(QT_TRANSLATE_NOOP("ErrorWords",
                                               "The stored data are not valid. Nothing was changed."));
        break;
    }
    return QCoreApplication::translate("ErrorWords", "%1\nDetails: %2")
        .arg(advice, QString::fromStdString(error.message));
}

} // namespace chiron::desktop
