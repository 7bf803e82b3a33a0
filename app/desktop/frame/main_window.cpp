// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/main_window.h"

#include "desktop/backups/backup_keeper.h"
#include "desktop/frame/about_dialog.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/command_palette.h"
#include "desktop/frame/enter_key.h"
#include "desktop/frame/focus_keeper.h"
#include "desktop/frame/help_dialogs.h"
#include "desktop/frame/message_bar.h"
#include "desktop/frame/palette_finder.h"
#include "desktop/frame/screen.h"
#include "desktop/frame/side_bar.h"
#include "desktop/frame/still_wheel.h"
#include "desktop/lock/lock_controller.h"
#include "desktop/screen_catalogue.h"
#include "desktop/widgets/kit.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QShortcut>
#include <QTimer>

namespace chiron::desktop {

MainWindow::MainWindow(AppContext& context) : m_context(context) {
    setObjectName(QStringLiteral("main_window"));
    setWindowTitle(QStringLiteral("Chiron"));
    setMinimumSize(960, 540);
    resize(1280, 720);
    m_actions.palette = [this] { showCommandPalette(); };
    m_actions.shortcuts = [this] {
        showShortcuts(m_context.theme(), commandsNow(m_context, m_screen, m_actions), this);
    };
    m_actions.help = [this] {
        if (m_screen && !m_screen->helpItself())
            showHelp(m_context.theme(), *m_screen, this);
    };
    m_actions.about = [this] { showAbout(m_context.theme(), this); };
    m_actions.close = [this] { close(); };
    build();
    m_finder = new PaletteFinder(context, this);
    new EnterKey(this);
    new StillWheel(this);
    new FocusKeeper(*this);
    new LockController(context, *this);
    new BackupKeeper(context, this);
    connect(&context.navigator(), &Navigator::moved, this, &MainWindow::showPlace);
    connect(&context.messages(), &Messages::told, this, &MainWindow::tell);
    context.navigator().setGuard([this] { return !m_screen || m_screen->mayLeave(); });
    connect(&context, &AppContext::appearanceChanged, this, [this] {
        if (m_context.trialRuns())
            m_rebuildWanted = true;
        else
            rebuild();
    });
    connect(&context, &AppContext::actorChanged, this, [this] { m_rebuildWanted = true; });
    connect(&context, &AppContext::rolesChanged, this, &MainWindow::renewNavigation);
    connect(&context, &AppContext::trialRunsChanged, this, [this](bool runs) {
        if (!runs && m_rebuildWanted)
            QTimer::singleShot(0, this, &MainWindow::rebuild);
    });
}

MainWindow::~MainWindow() {
    m_context.navigator().setGuard({});
}

void MainWindow::build() {
    m_rebuildWanted = false;
    m_frame = new QWidget;
    m_frame->setProperty("kind", QStringLiteral("page"));
    auto* row = new QHBoxLayout(m_frame);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    // Builds only what is visible now, so that the login appears as quickly as an empty window would.
    m_sideBar = nullptr;
    if (m_context.loggedIn())
        addSideBar();
    m_column = new QVBoxLayout;
    m_column->setSpacing(0);
    m_banner = nullptr;
    m_stage = new QVBoxLayout;
    m_stage->setContentsMargins(0, 0, 0, 0);
    m_column->addLayout(m_stage, 1);
    m_messages = nullptr;
    m_messageRoom = statusLine();
    m_messageRoom->setFixedHeight(MessageBar::roomHeight(m_context.theme()));
    m_messageRoom->hide();
    m_column->addWidget(m_messageRoom);
    row->addLayout(m_column, 1);
    if (QWidget* before = centralWidget())
        before->setEnabled(false); // work that ends before the deletion must not move the focus into it
    setCentralWidget(m_frame);     // deletes the previous frame
    m_frame->show();               // now, because nothing in a hidden frame can take the focus
}

void MainWindow::addSideBar() {
    m_sideBar = new SideBar(m_context);
    connect(m_sideBar, &SideBar::paletteAsked, this, m_actions.palette);
    connect(m_sideBar, &SideBar::helpAsked, this, m_actions.help);
    static_cast<QHBoxLayout*>(m_frame->layout())->insertWidget(0, m_sideBar);
}

/// Shows the side bar of the person's new roles. The screen stays, unless these roles no longer find it.
void MainWindow::renewNavigation() {
    if (!m_sideBar)
        return;
    const bool wasShown = !m_sideBar->isHidden();
    m_sideBar->hide();
    m_sideBar->deleteLater();
    addSideBar();
    m_sideBar->setVisible(wasShown);
    const Place& place = m_context.navigator().current();
    const ScreenEntry* entry = findScreen(place.screen);
    if (entry && !entry->roles.empty() && !finds(m_context.roles(), *entry)) {
        m_context.navigator().replace({QStringLiteral("home"), {}});
        return;
    }
    m_sideBar->showCurrent(place.screen);
    renewShortcuts(); // the numbers of the screens have changed
}

/// The room that messages are shown in. Without a message it shows hints that help everywhere.
QWidget* MainWindow::statusLine() const {
    const Theme& theme = m_context.theme();
    auto* line = new QWidget;
    line->setProperty("kind", QStringLiteral("status"));
    line->setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(theme.px(24), 0, theme.px(16), 0);
    if (m_context.loggedIn())
        row->addWidget(kit::label(
            theme, tr("F1: help with this screen · Ctrl+K: find a screen, command, person, session or study"),
            TextStyle::small, "muted"));
    return line;
}

QWidget* MainWindow::banner() const {
    const Theme& theme = m_context.theme();
    auto* banner = new QWidget;
    banner->setProperty("kind", QStringLiteral("banner"));
    banner->setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(banner);
    row->setContentsMargins(theme.px(16), theme.px(4), theme.px(16), theme.px(4));
    row->addWidget(kit::label(
        theme,
        tr("Demonstration site: invented people and scripted sessions. Do not record real training here."),
        TextStyle::small));
    return banner;
}

void MainWindow::tell(const Message& message) {
    if (!m_messages)
        m_messages = new MessageBar(m_context.theme(), m_frame);
    const Place& place = m_context.navigator().current();
    if (const ScreenEntry* entry = findScreen(place.screen); entry && !entry->sitting)
        // The room also appears on the login; it stays until the screen changes, so that nothing moves twice.
        m_messageRoom->show();
    m_messages->setRoom(m_messageRoom->isHidden() ? nullptr : m_messageRoom);
    m_frame->layout()->activate(); // its position is known now
    m_messages->tell(message);
}

/// Training sessions, study sessions and the login need the whole window. During a session a message floats
/// where there is no control; the login makes room with the first message.
void MainWindow::showMessageRoom(const Place& place) {
    const ScreenEntry* entry = findScreen(place.screen);
    const bool told = m_messages && m_messages->isVisible();
    const bool login = place.screen == QLatin1String("login");
    m_messageRoom->setVisible(entry && !entry->sitting && (!login || told));
    if (m_messages)
        m_messages->setRoom(m_messageRoom->isHidden() ? nullptr : m_messageRoom);
}

void MainWindow::rebuild() {
    const Place place = m_context.navigator().current();
    m_screen = nullptr;
    build();
    showPlace(place);
}

void MainWindow::showPlace(const Place& place) {
    const ScreenEntry* entry = findScreen(place.screen);
    if (!entry)
        return;
    bool workedThere = false;
    if (m_rebuildWanted)
        build(); // another person has another navigation
    else if (m_screen) {
        workedThere = m_screen->isAncestorOf(focusWidget());
        m_stage->removeWidget(m_screen);
        m_screen->hide();
        m_screen->setEnabled(false); // work that ends in the meantime must not move the focus into it
        m_screen->deleteLater();     // the call may come from one of its own buttons
    }
    if (m_sideBar)
        m_sideBar->setVisible(entry->framed && m_context.loggedIn());
    const bool demonstration = m_context.site().isOpen() && m_context.site().database().isDemonstration();
    if (demonstration && !m_banner) {
        m_banner = banner();
        m_column->insertWidget(0, m_banner);
    }
    if (m_banner)
        m_banner->setVisible(demonstration);
    showMessageRoom(place);
    m_screen = entry->make(m_context, place);
    m_stage->addWidget(m_screen);
    m_screen->show(); // now, so that enter() can focus one of its controls
    if (workedThere)  // otherwise it would fall to the side bar; Tab leads from here to the first control
        m_screen->setFocus(Qt::OtherFocusReason);
    if (m_sideBar)
        m_sideBar->showCurrent(place.screen);
    setWindowTitle(tr("%1 - Chiron").arg(m_screen->title()));
    renewShortcuts();
    m_screen->enter();
}

void MainWindow::renewShortcuts() {
    delete m_shortcuts;
    m_shortcuts = new QObject(this);
    for (const CommandGroup& group : commandsNow(m_context, m_screen, m_actions)) {
        for (const ScreenCommand& command : group.commands) {
            if (command.keys.isEmpty() || !command.registersKeys || !command.act)
                continue;
            auto* shortcut = new QShortcut(command.keys, this);
            // The call is queued, because the action may replace the shortcuts.
            connect(shortcut, &QShortcut::activated, m_shortcuts, command.act, Qt::QueuedConnection);
            connect(m_shortcuts, &QObject::destroyed, shortcut, [shortcut] {
                // This happens at once, because two shortcuts for the same keys are ambiguous and neither
                // acts.
                shortcut->setEnabled(false);
                shortcut->deleteLater();
            });
        }
    }
}

void MainWindow::showCommandPalette() {
    auto* palette = new CommandPalette(m_context.theme(), commandsNow(m_context, m_screen, m_actions), this);
    m_finder->serve(*palette);
    palette->open();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(!m_screen || m_screen->mayLeave());
}

bool MainWindow::event(QEvent* event) {
    const bool handled = QMainWindow::event(event);
    if (event->type() == QEvent::UpdateRequest && !m_painted) {
        m_painted = true;
        emit firstPainted();
    }
    return handled;
}

} // namespace chiron::desktop
