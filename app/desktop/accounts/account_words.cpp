// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/account_words.h"

#include "desktop/frame/messages.h"

#include <QCoreApplication>

namespace chiron::desktop {

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("AccountWords", text);
}

QString commonWords(const database::Refusal& refusal, const QString& wrong) {
    switch (refusal.kind) {
    case database::Refusal::Kind::wrong:
        return wrong;
    case database::Refusal::Kind::mustWait:
        return words(QT_TRANSLATE_NOOP(
            "AccountWords",
            "Too many wrong attempts. This account is locked for a moment; nothing is lost."));
    case database::Refusal::Kind::disabled:
        return words(QT_TRANSLATE_NOOP(
            "AccountWords", "This account is disabled. What was recorded is kept; an administrator can "
                            "enable the account again."));
    case database::Refusal::Kind::failed:
        break;
    }
    return inWords(refusal.error);
}

} // namespace

QString roleName(database::Role role) {
    switch (role) {
    case database::Role::trainee:
        return words(QT_TRANSLATE_NOOP("AccountWords", "Trainee"));
    case database::Role::trainer:
        return words(QT_TRANSLATE_NOOP("AccountWords", "Trainer"));
    case database::Role::researcher:
        return words(QT_TRANSLATE_NOOP("AccountWords", "Researcher"));
    case database::Role::admin:
        return words(QT_TRANSLATE_NOOP("AccountWords", "Administrator"));
    }
    return {};
}

QString refusalWords(const database::Refusal& refusal) {
    return commonWords(
        refusal, words(QT_TRANSLATE_NOOP("AccountWords",
                                         "Wrong name or password. Passwords are case-sensitive; check Caps "
                                         "Lock.")));
}

QString loginRefusalWords(const database::Refusal& refusal) {
    return commonWords(
        refusal,
        words(QT_TRANSLATE_NOOP("AccountWords",
                                "Wrong name or password; check Caps Lock. Ask an administrator; your login "
                                "name may have changed.")));
}

QString wrongPasswordWords() {
    return words(QT_TRANSLATE_NOOP("AccountWords", "Wrong password. Passwords are case-sensitive."));
}

QString recoveryRefusalWords(const database::Refusal& refusal) {
    return commonWords(
        refusal, words(QT_TRANSLATE_NOOP("AccountWords",
                                         "Wrong name or recovery code. The code has five groups of five "
                                         "letters and digits.")));
}

QString waitWords(int seconds) {
    return QCoreApplication::translate("AccountWords", "Try again in %n second(s)", nullptr, seconds);
}

} // namespace chiron::desktop
