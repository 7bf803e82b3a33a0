// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/lock/lock_controller.h"

#include "database/accounts/account_service.h"
#include "desktop/frame/app_context.h"
#include "desktop/lock/lock_cover.h"

#include <QApplication>
#include <QEvent>

namespace chiron::desktop {

LockController::LockController(AppContext& context, QMainWindow& window)
    : QObject(&window), m_context(context), m_window(window) {
    connect(&m_idle, &IdleLock::idle, this, &LockController::lock);
    connect(&context, &AppContext::lockAsked, this, &LockController::lock);
    connect(&context, &AppContext::activity, &m_idle, &IdleLock::touch);
    connect(&context, &AppContext::trialRunsChanged, &m_idle, &IdleLock::setHeld);
    connect(&context, &AppContext::actorChanged, this, [this] { m_idle.setActive(m_context.loggedIn()); });
    connect(
        &context, &AppContext::appearanceChanged, this,
        [this] {
            if (isLocked())
                cover();
        },
        Qt::QueuedConnection); // after the window has been rebuilt
    m_idle.setHeld(context.trialRuns());
    m_idle.setActive(context.loggedIn());
}

void LockController::lock() {
    if (isLocked() || !m_context.loggedIn() || m_context.trialRuns())
        return;
    m_titleBefore = m_window.windowTitle();
    m_focusBefore = QApplication::focusWidget();
    cover();
    qApp->installEventFilter(this);
    hideOthers();
    m_idle.setActive(false);
}

void LockController::cover() {
    delete m_cover;
    m_cover = new LockCover(m_context.theme(), m_context.shownName(), &m_window);
    m_cover->setGeometry(m_window.rect());
    connect(m_cover, &LockCover::submitted, this, &LockController::tryUnlock);
    connect(m_cover, &LockCover::switchAsked, this, &LockController::switchUser);
    m_window.setWindowTitle(tr("Locked - Chiron"));
    if (m_window.centralWidget())
        m_window.centralWidget()->hide(); // hidden, not just covered, also from screen readers
    m_cover->show();
    m_cover->raise();
    m_cover->focusFirst();
}

void LockController::hideOthers() {
    if (QWidget* popup = QApplication::activePopupWidget())
        popup->close();
    for (QWidget* other : QApplication::topLevelWidgets()) {
        if (other != &m_window && other->isVisible()) {
            m_hidden.emplace_back(other);
            other->hide();
        }
    }
}

void LockController::uncover() {
    qApp->removeEventFilter(this);
    m_cover->hide();
    m_cover->deleteLater(); // the call comes from one of its own buttons
    m_cover = nullptr;
    m_window.setWindowTitle(m_titleBefore);
    if (m_window.centralWidget())
        m_window.centralWidget()->show();
    for (const QPointer<QWidget>& other : std::exchange(m_hidden, {}))
        if (other)
            other->show();
    if (m_focusBefore)
        m_focusBefore->setFocus();
    m_idle.setActive(m_context.loggedIn());
}

void LockController::tryUnlock(const QString& password) {
    m_cover->setWorking(true);
    database::Database* database = &m_context.site().database();
    m_context.background().run(
        m_cover,
        [database, actor = m_context.actor(), password = password.toStdString()](WorkToken&) {
            return database::AccountService(*database).tryConfirm(actor, password);
        },
        [this](tl::expected<database::Actor, database::Refusal> actor) {
            if (!actor) {
                m_cover->showRefusal(actor.error());
                return;
            }
            uncover();
            emit m_context.unlocked();
        });
}

void LockController::switchUser() {
    for (const QPointer<QWidget>& other : std::exchange(m_hidden, {}))
        if (other)
            other->close(); // the next person must not see what somebody else had open
    m_context.logOutNow();
    m_titleBefore = m_window.windowTitle();
    m_focusBefore = nullptr;
    uncover();
}

bool LockController::mayPass(QObject* watched, const QEvent& event) const {
    switch (event.type()) {
    case QEvent::Shortcut:
    case QEvent::ShortcutOverride:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::ContextMenu:
        break;
    default:
        return true;
    }
    // A window's own event is forwarded to one of its widgets; a shortcut's is not.
    if (!watched->isWidgetType())
        return event.type() != QEvent::Shortcut;
    auto* widget = static_cast<QWidget*>(watched);
    return widget == m_cover || m_cover->isAncestorOf(widget);
}

bool LockController::eventFilter(QObject* watched, QEvent* event) {
    if (!isLocked())
        return false;
    if (watched == &m_window && event->type() == QEvent::Resize)
        m_cover->setGeometry(m_window.rect());
    if (event->type() == QEvent::Show && watched->isWidgetType()) {
        auto* widget = static_cast<QWidget*>(watched);
        if (widget->isWindow() && widget != &m_window && !m_cover->isAncestorOf(widget)) {
            m_hidden.emplace_back(widget);
            // This window was opened while the program was locked.
            QMetaObject::invokeMethod(widget, &QWidget::hide, Qt::QueuedConnection);
        }
    }
    return !mayPass(watched, *event);
}

} // namespace chiron::desktop
