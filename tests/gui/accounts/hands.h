// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/settled.h"

#include <QApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QtTest>

namespace chiron::tests {

/// Keys go to whatever has the focus, as from a keyboard.
inline void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QWidget* target =
        QApplication::focusWidget() ? QApplication::focusWidget() : QApplication::activeWindow();
    QTest::keyClick(target, key, modifiers);
}
inline void type(const QString& text) {
    QTest::keyClicks(QApplication::focusWidget(), text);
}
/// Name of the control with the focus; empty while there is none (a screen that is just coming up).
inline QString focusName() {
    return QApplication::focusWidget() ? QApplication::focusWidget()->objectName() : QString();
}
/// What was shown before is gone, and what came has its place: as it is when a person looks at it.
inline void settle() {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    QTest::qWait(50);
}

/// Tab until the control of this name has the focus; false where the keyboard does not reach it.
inline bool tabTo(const QString& name) {
    QStringList passed;
    for (int i = 0; i < 60; ++i) {
        if (focusName() == name)
            return true;
        passed << focusName();
        press(Qt::Key_Tab);
    }
    qWarning("%s was not reached, but %s", qPrintable(name), qPrintable(passed.join(QLatin1Char(' '))));
    return false;
}

/// Saves what a window shows into the folder of CHIRON_PICTURES, where that is set: to be looked at.
inline void picture(QWidget* window, const QString& name) {
    const QString folder = qEnvironmentVariable("CHIRON_PICTURES");
    if (!folder.isEmpty())
        window->grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
}

} // namespace chiron::tests

/// Nothing on this page is cut off, and every control has a name and a place in the tab order.
#define VERIFY_READABLE(page)                                                                                \
    do {                                                                                                     \
        const QStringList findings_ = chiron::tests::settledFindings(page);                                  \
        QVERIFY2(findings_.isEmpty(), qPrintable(findings_.join(QLatin1Char('\n'))));                        \
    } while (false)
