// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/side_bar.h"

#include "desktop/frame/app_context.h"
#include "desktop/screen_catalogue.h"
#include "desktop/widgets/kit.h"

#include <QScrollArea>

namespace chiron::desktop {

namespace {
constexpr double kCompactAbove = 1.5; // scale above which a window of 720 pixels has no room for all texts
}

SideBar::SideBar(AppContext& context, QWidget* parent) : QWidget(parent), m_context(context) {
    const Theme& theme = context.theme();
    setProperty("kind", QStringLiteral("sidebar"));
    setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(this);
    const int margin = theme.px(12);
    column->setContentsMargins(margin, margin, margin, margin);
    column->setSpacing(theme.px(4));
    column->addWidget(kit::line(theme, QStringLiteral("Chiron"), TextStyle::title));
    column->addSpacing(theme.px(8));
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(entries());
    scroll->setMinimumWidth(scroll->widget()->sizeHint().width() + theme.px(14));
    column->addWidget(scroll, 1);
    column->addWidget(personArea());
    connect(&context, &AppContext::unreadChanged, this, &SideBar::showUnread);
    showUnread(context.unread());
}

void SideBar::showUnread(int sessions) {
    for (const auto& [id, button] : m_buttons) {
        if (id != QStringLiteral("home"))
            continue;
        const QString title = button->property("title").toString();
        button->setText(sessions > 0 ? tr("%1 (%2)").arg(title, m_context.locale().toString(sessions))
                                     : title);
        button->setAccessibleName(
            sessions > 0 ? tr("%1: %n session(s) with new comments", nullptr, sessions).arg(title) : title);
        button->setToolTip(sessions > 0 ? button->accessibleName() : QString());
    }
}

QPushButton* SideBar::entry(const QString& icon, const QString& text, const QString& name) {
    auto* button = kit::button(m_context.theme(), text);
    button->setIcon(m_context.theme().icon(icon, Colour::sidebarText));
    button->setIconSize(QSize(m_context.theme().px(20), m_context.theme().px(20)));
    button->setObjectName(name);
    return button;
}

QWidget* SideBar::entries() {
    auto* list = new QWidget;
    list->setProperty("kind", QStringLiteral("sidebar"));
    auto* column = new QVBoxLayout(list);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(m_context.theme().px(4));
    for (const ScreenEntry& screen : screenCatalogue()) {
        if (!finds(m_context.roles(), screen))
            continue;
        const QString id = QLatin1String(screen.id);
        auto* button = entry(QLatin1String(screen.icon), titleOf(screen), QStringLiteral("nav.") + id);
        button->setProperty("title", titleOf(screen));
        button->setCheckable(true);
        connect(button, &QPushButton::clicked, this, [this, id] {
            m_context.navigator().go(id);
            // A screen that may not be left keeps its highlight.
            showCurrent(m_context.navigator().current().screen);
        });
        m_buttons.emplace_back(id, button);
        column->addWidget(button);
    }
    column->addStretch();
    return list;
}

/// Arranges buttons below each other, or at a large scale side by side and without text, so that the entries
/// above have room.
QBoxLayout* SideBar::inOnePlace(std::initializer_list<QPushButton*> buttons) const {
    const bool compact = m_context.theme().scale() > kCompactAbove;
    auto* place = new QBoxLayout(compact ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    place->setSpacing(m_context.theme().px(compact ? 0 : 4));
    for (QPushButton* button : buttons) {
        if (compact) {
            button->setAccessibleName(button->text());
            button->setToolTip(button->text());
            button->setText({});
            button->setProperty("compact", true);
        }
        place->addWidget(button);
    }
    return place;
}

QWidget* SideBar::personArea() {
    auto* area = new QWidget;
    auto* column = new QVBoxLayout(area);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(m_context.theme().px(4));
    auto* name = kit::label(m_context.theme(), m_context.shownName(), TextStyle::strong);
    name->setObjectName(QStringLiteral("nav.person"));
    connect(&m_context, &AppContext::namesChanged, name,
            [this, name] { name->setText(m_context.shownName()); });
    column->addWidget(name);
    auto* account = entry(QStringLiteral("user-identity"), tr("My account"), QStringLiteral("nav.account"));
    connect(account, &QPushButton::clicked, this,
            [this] { m_context.navigator().go(QStringLiteral("account")); });
    auto* search = entry(QStringLiteral("search"), tr("Find a command"), QStringLiteral("nav.palette"));
    connect(search, &QPushButton::clicked, this, &SideBar::paletteAsked);
    auto* help = entry(QStringLiteral("help-contents"), tr("Help"), QStringLiteral("nav.help"));
    connect(help, &QPushButton::clicked, this, &SideBar::helpAsked);
    auto* lock = entry(QStringLiteral("system-lock-screen"), tr("Lock"), QStringLiteral("nav.lock"));
    connect(lock, &QPushButton::clicked, &m_context, &AppContext::lockAsked);
    auto* leave = entry(QStringLiteral("system-switch-user"), tr("Log out"), QStringLiteral("nav.log_out"));
    leave->setToolTip(tr("Back to the login screen, where somebody else can log in"));
    connect(leave, &QPushButton::clicked, this, [this] { m_context.logOut(); });
    column->addLayout(inOnePlace({account, search, help, lock, leave}));
    return area;
}

void SideBar::showCurrent(const QString& screen) {
    for (const auto& [id, button] : m_buttons)
        button->setChecked(id == screen);
}

} // namespace chiron::desktop
