// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/messages.h"
#include "support/every_place.h"
#include "support/screen_outline.h"

#include <QFileDialog>
#include <QMenu>
#include <QSet>
#include <functional>

namespace chiron::tests {

/// What comes of something that a person does on a screen: messages, windows that open, the screen that it
/// leads to, or else a change of the screen itself.
class WhatCame {
public:
    explicit WhatCame(DesktopFixture& desktop) : m_desktop(desktop) {
        m_listening = QObject::connect(
            &desktop.context.messages(), &desktop::Messages::told, [this](const desktop::Message& message) {
                m_told << QStringLiteral("message %1 \"%2\" \"%3\"")
                              .arg(static_cast<int>(message.kind))
                              .arg(withoutToday(message.text), withoutToday(message.actionText));
            });
    }
    ~WhatCame() { QObject::disconnect(m_listening); }
    WhatCame(const WhatCame&) = delete;
    WhatCame& operator=(const WhatCame&) = delete;

    /// Does it and waits until nothing changes any more; empty where nothing came in time. Of a screen that
    /// changes by itself
    /// (`moving`) only that it changed is told.
    QStringList of(const std::function<void()>& act, bool moving = false, int patience_ms = 5000) {
        const QSet<QWidget*> before = windows();
        const QPointer<desktop::Screen> screen = m_desktop.window->screen();
        QStringList outline;
        settle(outline, [&] { return ScreenOutline::of(*screen); });
        m_told.clear();
        QTimer::singleShot(0, m_desktop.window.get(), act); // a dialog may hold it until it is closed
        QStringList came;
        if (!QTest::qWaitFor([&] { return !(came = since(before, screen, outline)).isEmpty(); }, patience_ms))
            return {};
        if (moving)
            return {QStringLiteral("something moves")};
        settle(came, [&] { return since(before, screen, outline); });
        static const QRegularExpression backup(QStringLiteral("chiron-backup-[-0-9]+")),
            records(QStringLiteral("[0-9,]+ records")), // the hour; the audit's, too
            ago(QStringLiteral("just now|[0-9]+ (minute|hour)s? ago"));
        return came.replaceInStrings(backup, QStringLiteral("chiron-backup"))
            .replaceInStrings(records, QStringLiteral("0 records"))
            .replaceInStrings(ago, QStringLiteral("lately"));
    }

private:
    /// Looks until what workers bring is there.
    void settle(QStringList& now, const std::function<QStringList()>& look) {
        for (int quiet = 0, looks = 0; quiet < 2 && looks < 400; ++looks) {
            const QStringList next = look();
            quiet = next == now && waitUntilLoaded(m_desktop) ? quiet + 1 : 0;
            now = next;
            QTest::qWait(10);
        }
    }

    static QSet<QWidget*> windows() {
        QSet<QWidget*> shown;
        for (QWidget* top : QApplication::topLevelWidgets())
            if (top->isVisible() && !top->windowFlags().testFlag(Qt::ToolTip))
                shown << top;
        return shown;
    }

    static void add(const QMenu& menu, QStringList& lines) {
        for (const QAction* action : menu.actions())
            lines << QStringLiteral(" entry \"%1\" %2%3%4%5")
                         .arg(withoutToday(action->text()), action->shortcut().toString(),
                              action->isEnabled() ? QString() : QStringLiteral(" disabled"),
                              action->isCheckable() ? QStringLiteral(" checkable") : QString(),
                              action->isChecked() ? QStringLiteral(" checked") : QString());
    }

    static void add(const QWidget& window, QStringList& lines) {
        lines << QStringLiteral("window %1 \"%2\"%3")
                     .arg(window.objectName(), withoutToday(window.windowTitle()),
                          window.isModal() ? QStringLiteral(" modal") : QString());
        if (const auto* menu = qobject_cast<const QMenu*>(&window))
            add(*menu, lines);
        else if (!qobject_cast<const QFileDialog*>(&window)) // what it is made of is Qt's
            for (const QString& line :
                 ScreenOutline::of(window) + QStringList{ScreenOutline::focusOn(window)})
                lines << QLatin1Char(' ') + line;
    }

    QStringList since(const QSet<QWidget*>& before, const QPointer<desktop::Screen>& screen,
                      const QStringList& outline) const {
        QStringList lines = m_told;
        for (QWidget* top : QApplication::topLevelWidgets())
            if (windows().contains(top) && !before.contains(top))
                add(*top, lines);
        desktop::Screen* now = m_desktop.window->screen();
        if (!screen || now != screen) {
            if (now)
                lines << QStringLiteral("goes to %1 \"%2\"")
                             .arg(m_desktop.context.navigator().current().screen, withoutToday(now->title()));
            return lines;
        }
        // Of the screen's own change only that there is one: much of it is on its way ("keeping …"), and
        // screens have tests of their own.
        if (lines.isEmpty() && ScreenOutline::of(*screen) != outline)
            lines << QStringLiteral("the screen changes");
        return lines;
    }

    DesktopFixture& m_desktop;
    QMetaObject::Connection m_listening;
    QStringList m_told;
};

} // namespace chiron::tests
