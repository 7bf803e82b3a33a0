// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/first_start/first_start_screen.h"

#include "desktop/accounts/form.h"
#include "desktop/accounts/recovery_code_panel.h"
#include "desktop/first_start/administrator_page.h"
#include "desktop/frame/app_context.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/logo.h"
#include "desktop/widgets/page_footer.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QComboBox>
#include <QDir>
#include <QFileInfo>
#include <QScrollBar>

namespace chiron::desktop {

namespace {
constexpr int kFirstStartWidth_px = 640;
const QString kCode = QStringLiteral("recovery_code");
const QString kName = QStringLiteral("name");
} // namespace

FirstStartScreen::FirstStartScreen(AppContext& context, const Place& place) : Screen(context, place) {
    m_scroll = new ScrollPage(context.theme(), kFirstStartWidth_px);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_scroll, 1);
    m_footer = new PageFooter(context.theme(), kFirstStartWidth_px);
    column->addWidget(m_footer);
    m_scroll->column()->addStretch(1);
    m_room = new QVBoxLayout;
    m_scroll->column()->addLayout(m_room);
    m_scroll->column()->addStretch(1);
    m_language = form::languageChoice(context);
    m_scroll->column()->addWidget(m_language, 0, Qt::AlignHCenter);
    // If the screen was rebuilt for another language or theme while the code was shown, the code must not be
    // lost.
    if (const QString code = place.parameters.value(kCode).toString(); !code.isEmpty())
        showRecoveryCode(place.parameters.value(kName).toString(), code);
    else
        showWelcome();
}

FirstStartScreen::~FirstStartScreen() {
    if (m_work)
        m_work->cancel();
}

QString FirstStartScreen::title() const {
    return tr("Welcome");
}

QString FirstStartScreen::help() const {
    return tr("Chiron is a training suite for the sense of touch in minimally invasive surgery.\n\n\"Set up "
              "this site\" creates an empty "
              "site on this computer and its first administrator, who can add the others. It takes about a "
              "minute.\n\n\"Open the "
              "demonstration site\" creates a separate site with invented people and scripted sessions, so "
              "that you can look around. It "
              "does not affect a site that you set up later. Until you set one up, this choice appears at "
              "every start.");
}

void FirstStartScreen::enter() {
    if (m_code)
        return;
    if (auto* first = findChild<QPushButton*>(QStringLiteral("first_start.set_up")))
        first->setFocus();
}

bool FirstStartScreen::mayLeave() {
    if (!m_code || m_code->isConfirmed())
        return true;
    context().messages().warning(
        tr("The recovery code is not shown again. Write it down and tick the box first."));
    return false;
}

QString FirstStartScreen::demonstrationFile(const QString& siteFile) {
    const QFileInfo info(siteFile);
    return info.absoluteDir().filePath(QStringLiteral("%1-demonstration.db").arg(info.completeBaseName()));
}

void FirstStartScreen::setPage(QWidget* page, QWidget* foot) {
    if (m_page)
        m_page->deleteLater(); // the call may come from one of the page's own buttons
    if (m_page)
        m_page->hide();
    m_page = page;
    m_room->addWidget(page);
    m_footer->hold(foot); // after the page has its place, so that Tab comes to the buttons last
    if (isVisible())
        page->show(); // now, so that it can take the focus
    // Scrolls the page to its top once it has its size.
    QMetaObject::invokeMethod(
        this, [this] { m_scroll->verticalScrollBar()->setValue(0); }, Qt::QueuedConnection);
}

QWidget* FirstStartScreen::choice(const QString& icon, const QString& title, const QString& text,
                                  QPushButton* button) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    const int padding = theme.px(24);
    box.layout->setContentsMargins(padding, padding, padding, padding);
    auto* head = new QHBoxLayout;
    head->setSpacing(theme.px(12));
    auto* picture = new QLabel;
    picture->setPixmap(theme.icon(icon, Colour::accent).pixmap(theme.px(32), theme.px(32)));
    head->addWidget(picture);
    head->addWidget(kit::label(theme, title, TextStyle::title), 1);
    box.layout->addLayout(head);
    box.layout->addWidget(kit::label(theme, text, TextStyle::body, "muted"));
    auto* row = new QHBoxLayout;
    row->addWidget(button);
    row->addStretch();
    box.layout->addLayout(row);
    return box.frame;
}

void FirstStartScreen::showWelcome() {
    const Theme& theme = context().theme();
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(16));
    column->addWidget(logo(theme, 80));
    auto* heading = kit::label(theme, tr("Welcome to Chiron"), TextStyle::display);
    heading->setAlignment(Qt::AlignCenter);
    column->addWidget(heading);
    auto* words = kit::label(
        theme, tr("Learn by touch: practise, see what your hand did, and know when you are ready."),
        TextStyle::body, "muted");
    words->setAlignment(Qt::AlignCenter);
    column->addWidget(words);
    column->addSpacing(theme.px(8));
    auto* setUp = kit::button(theme, tr("Set up this site"), "primary");
    setUp->setObjectName(QStringLiteral("first_start.set_up"));
    connect(setUp, &QPushButton::clicked, this, &FirstStartScreen::showAdministrator);
    column->addWidget(choice(
        QStringLiteral("list-add-user"), tr("Set up your own site"),
        tr("You become its administrator. People, sessions and scores stay on this computer."), setUp));
    auto* demonstration = kit::button(theme, tr("Open the demonstration site"));
    demonstration->setObjectName(QStringLiteral("first_start.demonstration"));
    demonstration->setVisible(!context().site().isOpen());
    connect(demonstration, &QPushButton::clicked, this, &FirstStartScreen::showDemonstration);
    auto* second = choice(QStringLiteral("view-preview"), tr("Look around first"),
                          tr("Invented people and scripted sessions at every level. Creating them takes "
                             "about a minute, only once."),
                          demonstration);
    second->setVisible(!context().site().isOpen()); // an open site without people needs its administrator
    column->addWidget(second);
    setPage(page);
}

void FirstStartScreen::showAdministrator() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    const int padding = theme.px(28);
    box.layout->setContentsMargins(padding, padding, padding, padding);
    auto* page = new AdministratorPage(theme);
    box.layout->addWidget(page);
    m_administrator = page;
    connect(page, &AdministratorPage::backAsked, this, [this] {
        showWelcome();
        enter();
    });
    connect(page, &AdministratorPage::submitted, this, &FirstStartScreen::makeSiteFor);
    setPage(box.frame, page->foot());
    page->focusFirst();
}

void FirstStartScreen::makeSiteFor(const AdministratorRequest& request) {
    m_administrator->setWorking(true);
    m_language->setEnabled(false);
    database::Database* open = context().site().isOpen() ? &context().site().database() : nullptr;
    context().background().run(
        this,
        [file = context().site().file().toStdString(), options = context().site().options(), open,
         request](WorkToken&) { return makeSite(file, options, open, request); },
        [this, request](core::Result<MadeSite> made) { siteMade(request, std::move(made)); });
}

void FirstStartScreen::siteMade(const AdministratorRequest& request, core::Result<MadeSite> made) {
    m_language->setEnabled(true);
    if (m_administrator)
        m_administrator->setWorking(false);
    if (!made) {
        if (m_administrator)
            m_administrator->showProblem(tr("The site was not created.\n%1").arg(inWords(made.error())));
        return;
    }
    m_actor = made->actor;
    if (made->database)
        context().takeSite(std::move(made->database), std::move(made->catalogue));
    showRecoveryCode(QString::fromStdString(request.name), QString::fromStdString(made->recoveryCode));
}

void FirstStartScreen::showRecoveryCode(const QString& name, const QString& code) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    const int padding = theme.px(28);
    box.layout->setContentsMargins(padding, padding, padding, padding);
    m_code = new RecoveryCodePanel(theme, name, code, RecoveryCodePanel::Backups::none);
    box.layout->addWidget(m_code);
    // The code is kept in memory only, and discarded with the place.
    context().navigator().note({{kCode, code}, {kName, name}});
    connect(m_code, &RecoveryCodePanel::finished, this, [this] {
        if (m_actor.kind() == database::ActorKind::person)
            context().logIn(m_actor);
        else
            context().navigator().replace({QStringLiteral("login"), {}});
    });
    setPage(box.frame, m_code->foot());
    if (auto* copy = m_code->findChild<QPushButton*>(QStringLiteral("recovery.copy")))
        copy->setFocus();
}

void FirstStartScreen::showDemonstration() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    auto* panel = new StatePanel(theme);
    panel->setObjectName(QStringLiteral("first_start.progress"));
    panel->setMinimumHeight(theme.px(260));
    box.layout->addWidget(panel);
    auto* back = kit::button(theme, tr("Back"));
    back->setObjectName(QStringLiteral("first_start.back"));
    back->hide();
    connect(back, &QPushButton::clicked, this, [this] {
        showWelcome();
        enter();
    });
    box.layout->addWidget(back, 0, Qt::AlignHCenter);
    m_progress = panel;
    m_back = back;
    setPage(box.frame);
    m_language->setEnabled(false);
    const QString file = demonstrationFile(context().site().file());
    m_work = context().background().run(
        this,
        [file = file.toStdString(), options = context().site().options(),
         language = context().language().toStdString()](WorkToken& work) {
            return makeDemonstration(file, options, work, language);
        },
        [this](core::Result<MadeSite> made) { demonstrationMade(std::move(made)); });
    panel->showLoading(
        QFileInfo::exists(file)
            ? tr("Opening the demonstration site …")
            : tr("Creating the demonstration site: people, and scripted sessions at every level …"),
        m_work);
}

void FirstStartScreen::demonstrationMade(core::Result<MadeSite> made) {
    m_work.reset();
    m_language->setEnabled(true);
    if (!made) {
        if (made.error().code == core::ErrorCode::cancelled) {
            showWelcome();
            enter();
            context().messages().information(
                tr("Creation of the demonstration site was stopped; what had been created was removed."));
        } else if (m_progress) {
            m_progress->showError(
                tr("The demonstration site could not be opened."), made.error(),
                [this] { showDemonstration(); }, Tried::saving);
            m_back->show();
        }
        return;
    }
    context().site().setFile(demonstrationFile(context().site().file()));
    context().takeSite(std::move(made->database), std::move(made->catalogue));
    context().navigator().replace({QStringLiteral("login"), {}});
}

} // namespace chiron::desktop
