// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/login/login_screen.h"

#include "database/accounts/account_service.h"
#include "database/integrity/file_health.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/recovery_code_panel.h"
#include "desktop/frame/app_context.h"
#include "desktop/login/login_form.h"
#include "desktop/login/new_password_page.h"
#include "desktop/login/recovery_page.h"
#include "desktop/restore/restore_screen.h"
#include "desktop/site/site_name.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/logo.h"
#include "desktop/widgets/page_footer.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"
#include "session/demo_site.h"

#include <QComboBox>
#include <QScrollBar>

namespace chiron::desktop {

namespace {

constexpr int kLoginWidth_px = 460;
const QString kFailed = QStringLiteral("failed"); // parameter of the place: the site could not be opened

/// The person who was let in, or the reason why not; with the new recovery code if one was used.
struct Recovered {
    tl::expected<database::Actor, database::Refusal> actor;
    std::string newCode;
};

Recovered recoverAndLogIn(database::Database& database, const std::string& name, const std::string& code,
                          const std::string& password) {
    database::AccountService accounts(database);
    const auto newCode = accounts.tryRecover(name, code, password);
    if (!newCode)
        return {tl::unexpected(newCode.error()), {}};
    return {accounts.tryLogin(name, password), *newCode};
}

} // namespace

LoginScreen::LoginScreen(AppContext& context, const Place& place) : Screen(context, place) {
    const Theme& theme = context.theme();
    m_scroll = new ScrollPage(theme, kLoginWidth_px);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_scroll, 1);
    m_footer = new PageFooter(theme, kLoginWidth_px);
    column->addWidget(m_footer);
    auto* heading = new QHBoxLayout; // side by side, so that the whole form fits 720 pixels without scrolling
    heading->setSpacing(theme.px(12));
    heading->addStretch();
    heading->addWidget(logo(theme, 44));
    heading->addWidget(kit::line(theme, QStringLiteral("Chiron"), TextStyle::display));
    heading->addStretch();
    const kit::Box box = kit::box(theme);
    const int padding = theme.px(28);
    box.layout->setContentsMargins(padding, padding, padding, padding);
    m_room = box.layout;
    m_site = new StatePanel(theme);
    m_site->setObjectName(QStringLiteral("login.site"));
    m_room->addWidget(m_site);
    m_scroll->column()->addStretch(1);
    m_scroll->column()->addLayout(heading);
    m_siteName = kit::label(theme, {}, TextStyle::title, "muted");
    m_siteName->setObjectName(QStringLiteral("login.site_name"));
    m_siteName->setAlignment(Qt::AlignCenter);
    m_siteName->hide();
    m_scroll->column()->addWidget(m_siteName);
    m_scroll->column()->addWidget(box.frame);
    m_scroll->column()->addStretch(1);
    m_scroll->column()->addWidget(form::languageChoice(context), 0, Qt::AlignHCenter);
    m_site->showLoading(tr("Opening the site …"));
}

// Called after the first paint, because the form has many controls and is of no use before the names are
// loaded.
void LoginScreen::makeForm() {
    if (m_form)
        return;
    m_form = new LoginForm(context().theme());
    m_site->setContent(m_form);
    connect(m_form, &LoginForm::submitted, this, &LoginScreen::logIn);
    connect(m_form, &LoginForm::forgotten, this, &LoginScreen::showRecovery);
}

QString LoginScreen::title() const {
    return tr("Log in");
}

QString LoginScreen::help() const {
    return tr("Type a few letters of your name, or choose it in the list, then enter your password.\n\nAfter "
              "three wrong passwords the "
              "account is locked for a short time; the button counts down the seconds. No data are "
              "lost.\n\nForgot your password? An "
              "administrator can give you a new one. Administrators can use their recovery code.");
}

void LoginScreen::enter() {
    connect(&context(), &AppContext::siteOpened, this, &LoginScreen::loadNames);
    connect(&context(), &AppContext::siteFailed, this, &LoginScreen::siteFailed);
    if (context().site().isOpen())
        loadNames();
    else if (place().parameters.value(kFailed).toBool())
        openAgain(); // rebuilt after a failure, so the error must be found again
}

void LoginScreen::openAgain() {
    m_site->showLoading(tr("Opening the site …"));
    context().openSite();
}

void LoginScreen::siteFailed(const core::Error& error) {
    context().navigator().note({{kFailed, true}});
    if (error.code == core::ErrorCode::locked) {
        m_site->showError(
            tr("The site could not be opened."), error, [this] { openAgain(); }, Tried::opening);
        return;
    }
    examine(tr("The site could not be opened."), error, [this] { openAgain(); });
}

// A damaged or missing file is restored on a screen of its own. Every other error is shown here.
void LoginScreen::examine(const QString& what, const core::Error& error, std::function<void()> again) {
    const auto token = context().background().run(
        this,
        [file = context().site().file().toStdString()](WorkToken& working) {
            return database::examineFile(file, &working.flag());
        },
        [this, what, error, again = std::move(again)](const database::FileState& file) {
            if (file.health != database::FileHealth::damaged &&
                file.health != database::FileHealth::missing) {
                m_site->showError(what, error, again, Tried::opening);
                return;
            }
            context().background().cancelAndWait();
            context().site().close(); // a restore needs its lock
            context().navigator().replace(RestoreScreen::placeFor(file));
        });
    m_site->showLoading(tr("Checking the site's file …"), token); // a large file takes a while
}

void LoginScreen::loadNames() {
    database::Database* database = &context().site().database();
    context().background().run(
        this, [database](WorkToken&) { return database::AccountService(*database).listLoginNames(); },
        [this](core::Result<std::vector<database::LoginName>> names) { namesLoaded(std::move(names)); });
}

/// Shows no name if the site has none or it cannot be read; the list of names reports such an error.
void LoginScreen::loadSiteName() {
    context().background().run(
        this,
        [&database = context().site().database()](WorkToken&) {
            return readSiteName(database, database::Actor::anonymous());
        },
        [this](const core::Result<QString>& name) {
            m_siteName->setText(name.value_or(QString()));
            m_siteName->setVisible(!m_siteName->text().isEmpty());
        });
}

void LoginScreen::namesLoaded(core::Result<std::vector<database::LoginName>> names) {
    if (!names) {
        examine(tr("The list of names could not be read."), names.error(), [this] {
            m_site->showLoading(tr("Opening the site …"));
            loadNames();
        });
        return;
    }
    if (names->empty()) { // a site always keeps an administrator, so nobody has been added yet
        context().navigator().replace({QStringLiteral("first_start"), {}});
        return;
    }
    makeForm();
    loadSiteName();
    m_form->setNames(*names);
    if (context().site().database().isDemonstration())
        m_form->showDemonstrationHint(
            tr("This is a demonstration: choose anyone. The password for everyone is %1")
                .arg(QString::fromLatin1(session::kDemoPassword)));
    m_site->showContent();
    m_form->focusFirst();
}

void LoginScreen::setPage(QWidget* page, QWidget* foot) {
    if (m_page) {
        m_page->hide();
        m_page->deleteLater(); // the call may come from one of its own buttons
    }
    m_page = page;
    m_site->setVisible(page == nullptr);
    if (page)
        m_room->addWidget(page);
    m_footer->hold(foot); // after the page has its place, so that Tab comes to the buttons last
    if (!page)
        return;
    page->show(); // now, so that it can take the focus
    // Scrolls the page to its top once it has its size.
    QMetaObject::invokeMethod(
        this, [this] { m_scroll->verticalScrollBar()->setValue(0); }, Qt::QueuedConnection);
}

void LoginScreen::showForm() {
    setPage(nullptr);
    m_form->clearPassword(); // the next person may be another one
    m_form->setWorking(false);
    m_form->focusFirst();
}

void LoginScreen::logIn(const QString& name, const QString& password) {
    m_form->setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, name = name.toStdString(), password = password.toStdString()](WorkToken&) {
            return database::AccountService(*database).tryLogin(name, password);
        },
        [this, password](tl::expected<database::Actor, database::Refusal> actor) {
            if (!actor)
                m_form->showRefusal(actor.error());
            else if (actor->mustChangePassword())
                showForced(*actor, password);
            else
                context().logIn(*actor);
        });
}

void LoginScreen::showForced(const database::Actor& actor, const QString& password) {
    auto* page = new NewPasswordPage(context().theme(), QString::fromStdString(actor.name()));
    connect(page, &NewPasswordPage::backAsked, this, &LoginScreen::showForm);
    connect(page, &NewPasswordPage::submitted, this, [this, page, actor, password](const QString& fresh) {
        changePassword(page, actor, password, fresh);
    });
    setPage(page, page->foot());
    page->focusFirst();
}

void LoginScreen::changePassword(NewPasswordPage* page, const database::Actor& actor,
                                 const QString& oldPassword, const QString& newPassword) {
    if (oldPassword == newPassword) {
        page->showProblem(tr("This is the password that you were given. Choose another one."));
        return;
    }
    page->setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        page,
        [database, actor, old = oldPassword.toStdString(),
         fresh = newPassword.toStdString()](WorkToken&) -> core::Result<database::Actor> {
            database::AccountService accounts(*database);
            CHIRON_TRY(accounts.changePassword(actor, old, fresh));
            return accounts.login(actor.name(), fresh);
        },
        [this, page](core::Result<database::Actor> again) {
            if (again) {
                context().logIn(*again);
                return;
            }
            page->setWorking(false);
            page->showProblem(tr("The password was not changed.\n%1").arg(inWords(again.error())));
        });
}

void LoginScreen::showRecovery() {
    auto* page = new RecoveryPage(context().theme(), m_form->name());
    connect(page, &RecoveryPage::backAsked, this, &LoginScreen::showForm);
    connect(page, &RecoveryPage::submitted, this,
            [this, page](const QString& name, const QString& code, const QString& password) {
                recover(page, name, code, password);
            });
    setPage(page, page->foot());
    page->focusFirst();
}

void LoginScreen::recover(RecoveryPage* page, const QString& name, const QString& code,
                          const QString& newPassword) {
    page->setWorking(true);
    database::Database* database = &context().site().database();
    context().background().run(
        page,
        [database, name = name.toStdString(), code = code.toStdString(),
         password = newPassword.toStdString()](WorkToken&) {
            return recoverAndLogIn(*database, name, code, password);
        },
        [this, page, name](Recovered done) {
            if (done.newCode.empty())
                page->showRefusal(done.actor.error());
            else
                showNewCode(done.actor ? *done.actor : database::Actor::anonymous(), name,
                            QString::fromStdString(done.newCode));
        });
}

void LoginScreen::showNewCode(const database::Actor& actor, const QString& name, const QString& code) {
    auto* panel =
        new RecoveryCodePanel(context().theme(), name, code, RecoveryCodePanel::Backups::haveEarlierCode);
    connect(panel, &RecoveryCodePanel::finished, this, [this, actor] {
        if (actor.kind() == database::ActorKind::person)
            context().logIn(actor);
        else
            showForm(); // the new password is set, but the login after it failed
    });
    setPage(panel, panel->foot());
    if (auto* copy = panel->findChild<QWidget*>(QStringLiteral("recovery.copy")))
        copy->setFocus();
}

} // namespace chiron::desktop
