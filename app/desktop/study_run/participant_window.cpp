// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/participant_window.h"

#include <QCloseEvent>
#include <QGuiApplication>
#include <QScreen>
#include <QVBoxLayout>

namespace chiron::desktop {

QScreen* ParticipantWindow::otherScreen(const QWidget& window) {
    for (QScreen* screen : QGuiApplication::screens())
        if (screen != window.window()->screen())
            return screen;
    return nullptr;
}

ParticipantWindow::ParticipantWindow(const Theme& theme, QScreen& screen, QWidget* parent)
    : QWidget(parent, Qt::Window | Qt::FramelessWindowHint), m_screen(&screen) {
    setObjectName(QStringLiteral("participant_window"));
    setProperty("kind", QStringLiteral("page"));
    setAttribute(Qt::WA_StyledBackground);
    setWindowTitle(tr("Study"));
    setPalette(theme.palette());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    connect(qGuiApp, &QGuiApplication::screenRemoved, this, [this](QScreen* gone) {
        if (gone == m_screen)
            emit lost();
    });
}

void ParticipantWindow::take(QWidget* page) {
    m_page = page;
    layout()->addWidget(page);
    if (m_screen)
        setGeometry(m_screen->geometry());
    showFullScreen();
    activateWindow();
}

QWidget* ParticipantWindow::giveBack() {
    hide();
    if (m_page) {
        layout()->removeWidget(m_page);
        m_page->setParent(nullptr);
    }
    return m_page;
}

/// The experimenter ends the session from the other window.
void ParticipantWindow::closeEvent(QCloseEvent* event) {
    event->ignore();
}

} // namespace chiron::desktop
