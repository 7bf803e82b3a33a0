// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/account/account_screen.h"

#include "database/accounts/account_rules.h"
#include "database/accounts/account_service.h"
#include "desktop/account/recovery_code_dialog.h"
#include "desktop/accounts/account_words.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/accounts/password_fields.h"
#include "desktop/accounts/wait_countdown.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/interface_language.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QButtonGroup>
#include <QLineEdit>
#include <QRadioButton>

namespace chiron::desktop {

AccountScreen::AccountScreen(AppContext& context, const Place& place) : Screen(context, place) {
    m_page = new ScrollPage(context.theme(), 720);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_page);
    m_page->column()->addWidget(kit::label(context.theme(), title(), TextStyle::heading));
    m_panel = new StatePanel(context.theme());
    m_panel->setObjectName(QStringLiteral("account.panel"));
    m_panel->setContent(nameBox());
    m_page->column()->addWidget(m_panel);
    m_page->column()->addWidget(languageBox());
    m_page->column()->addWidget(passwordBox());
    if (context.has(database::Role::admin))
        m_page->column()->addWidget(recoveryBox());
    m_page->column()->addStretch();
    m_panel->showLoading(tr("Reading your account …"));
}

QString AccountScreen::title() const {
    return tr("My account");
}

QString AccountScreen::help() const {
    return tr("Your own name, language and password.\n\nThe full name is what others see in lists and "
              "reports; your earlier names stay in the site's history. The login name can be changed by an "
              "administrator.\n\nThe language takes effect at once. It is used whenever you log in on this "
              "station, and changes nothing for others.\n\nTo change your password, first enter the one that "
              "you have now.\n\nAdministrators can make a recovery code for themselves here; with it they "
              "can set a new password if they forget theirs.");
}

QWidget* AccountScreen::nameBox() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Name"), TextStyle::title));
    m_loginName = kit::label(theme, {});
    m_loginName->setObjectName(QStringLiteral("account.login_name"));
    box.layout->addWidget(m_loginName);
    m_fullName = form::textField(theme, box.layout, tr("Full name (may be left empty)"),
                                 QStringLiteral("account.full_name"));
    m_saveName = kit::button(theme, tr("Save the name"), "primary");
    m_saveName->setObjectName(QStringLiteral("account.save_name"));
    box.layout->addWidget(m_saveName, 0, Qt::AlignLeft);
    m_nameNotice = new NoticeArea(theme);
    m_nameNotice->setObjectName(QStringLiteral("account.name_notice"));
    box.layout->addWidget(m_nameNotice);
    connect(m_fullName, &QLineEdit::textChanged, this, &AccountScreen::renewName);
    connect(m_fullName, &QLineEdit::returnPressed, this, &AccountScreen::saveName);
    connect(m_saveName, &QPushButton::clicked, this, &AccountScreen::saveName);
    return box.frame;
}

QWidget* AccountScreen::languageBox() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Language"), TextStyle::title));
    auto* group = new QButtonGroup(this);
    const QString own = context().ownLanguage();
    // Each language is named in that language, so that people who cannot read the current one find theirs.
    std::vector<std::pair<QString, QString>> list = languageChoices();
    list.insert(list.begin(), {QString(), tr("As on this station")});
    for (const auto& [id, text] : list) {
        auto* radio = new QRadioButton(text);
        radio->setObjectName(QStringLiteral("account.language.") +
                             (id.isEmpty() ? QStringLiteral("station") : id));
        radio->setChecked(id == own);
        m_languageNow = id == own ? radio : m_languageNow;
        group->addButton(radio);
        box.layout->addWidget(radio);
        connect(
            radio, &QRadioButton::clicked, this, [this, language = id] { chooseLanguage(language); },
            Qt::QueuedConnection);
    }
    box.layout->addWidget(kit::label(
        theme, tr("It is used whenever you log in on this station, and changes nothing for others."),
        TextStyle::small, "muted"));
    return box.frame;
}

QWidget* AccountScreen::passwordBox() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Password"), TextStyle::title));
    m_oldPassword = form::passwordField(theme, box.layout, tr("Current password"),
                                        QStringLiteral("account.old_password"));
    m_newPassword = new PasswordFields(theme, QStringLiteral("account"));
    m_newPassword->setLoginName(QString::fromStdString(context().loginName()));
    box.layout->addWidget(m_newPassword);
    m_changePassword = kit::button(theme, tr("Change the password"), "primary");
    m_changePassword->setObjectName(QStringLiteral("account.change_password"));
    box.layout->addWidget(m_changePassword, 0, Qt::AlignLeft);
    m_passwordNotice = new NoticeArea(theme);
    m_passwordNotice->setObjectName(QStringLiteral("account.password_notice"));
    box.layout->addWidget(m_passwordNotice);
    m_wait = new WaitCountdown(this);
    connect(m_wait, &WaitCountdown::changed, this,
            [this](int seconds) { m_changePassword->setText(waitWords(seconds)); });
    connect(m_wait, &WaitCountdown::finished, this, &AccountScreen::renewPassword);
    connect(m_oldPassword, &QLineEdit::textChanged, this, &AccountScreen::renewPassword);
    connect(m_oldPassword, &QLineEdit::returnPressed, m_newPassword, &PasswordFields::focusFirst);
    connect(m_newPassword, &PasswordFields::changed, this, &AccountScreen::renewPassword);
    connect(m_newPassword, &PasswordFields::submitted, this, &AccountScreen::changePassword);
    connect(m_changePassword, &QPushButton::clicked, this, &AccountScreen::changePassword);
    renewPassword();
    return box.frame;
}

QWidget* AccountScreen::recoveryBox() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, tr("Recovery code"), TextStyle::title));
    box.layout->addWidget(
        kit::label(theme, tr("With a recovery code you can set a new password yourself if you forget yours: "
                             "at the login, choose \"Forgot your password?\".")));
    m_recoveryState = kit::label(theme, tr("Reading your account …"), TextStyle::body, "muted");
    m_recoveryState->setObjectName(QStringLiteral("account.recovery_state"));
    box.layout->addWidget(m_recoveryState);
    m_recovery = kit::button(theme, tr("Make a recovery code …"));
    m_recovery->setObjectName(QStringLiteral("account.recovery"));
    box.layout->addWidget(m_recovery, 0, Qt::AlignLeft);
    connect(m_recovery, &QPushButton::clicked, this, &AccountScreen::makeRecoveryCode);
    return box.frame;
}

void AccountScreen::enter() {
    const QString focus = place().parameters.value(QStringLiteral("focus")).toString();
    if (focus == QLatin1String("language"))
        m_languageNow->setFocus();
    if (focus == QLatin1String("recovery") && m_recovery) {
        m_recovery->setFocus();
        // Deferred until it has its position.
        QMetaObject::invokeMethod(
            this, [this] { m_page->ensureWidgetVisible(m_recovery); }, Qt::QueuedConnection);
    }
    load();
    if (m_recovery)
        loadRecovery();
}

void AccountScreen::loadRecovery() {
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor()](WorkToken&) {
            return database::AccountService(*database).hasRecoveryCode(actor);
        },
        [this](const core::Result<bool>& has) {
            m_hasRecoveryCode = has.value_or(false);
            m_recoveryState->setText(
                !has ? tr("The program could not read whether you have a recovery code.\n%1")
                           .arg(inWords(has.error(), Tried::reading))
                : m_hasRecoveryCode ? tr("You have one. If it is lost or somebody else may have seen "
                                         "it, make a new one; it replaces the present one.")
                                    : tr("You have none yet. Without it, only another administrator can "
                                         "help you if you forget your password."));
        });
}

void AccountScreen::makeRecoveryCode() {
    auto* dialog = new RecoveryCodeDialog(context(), m_hasRecoveryCode, this);
    connect(dialog, &FormDialog::changed, this, &AccountScreen::loadRecovery);
    dialog->open();
}

std::vector<ScreenCommand> AccountScreen::commands() {
    std::vector<ScreenCommand> list{{tr("Change my password"), {}, [this] { m_oldPassword->setFocus(); }}};
    if (m_recovery)
        list.push_back({m_recovery->text(), {}, [this] { m_recovery->click(); }});
    return list;
}

void AccountScreen::load() {
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor()](WorkToken&) {
            return database::AccountService(*database).self(actor);
        },
        [this](const core::Result<database::Person>& person) { loaded(person); });
}

void AccountScreen::loaded(const core::Result<database::Person>& person) {
    if (!person) {
        m_panel->showError(tr("Your account could not be read."), person.error(), [this] {
            m_panel->showLoading(tr("Reading your account …"));
            load();
        });
        return;
    }
    m_storedName = QString::fromStdString(person->displayName);
    m_loginName->setText((context().has(database::Role::admin)
                              ? tr("Login name: %1. You can change it under People.")
                              : tr("Login name: %1. An administrator can change it."))
                             .arg(QString::fromStdString(person->name)));
    m_newPassword->setLoginName(QString::fromStdString(person->name));
    m_fullName->setText(m_storedName);
    m_panel->showContent();
    renewName();
    const QWidget* at = window()->focusWidget();
    if (at == this || !isAncestorOf(at)) // nobody has chosen a control
        m_fullName->setFocus();
}

void AccountScreen::renewName() {
    const QString name = m_fullName->text().trimmed();
    const bool good = name.toUcs4().size() <= database::kMaximumDisplayNameCharacters;
    form::setKind(m_fullName, good ? "" : "bad");
    if (!good)
        m_nameNotice->say("bad",
                          tr("The full name is too long: use at most %1 characters.")
                              .arg(context().locale().toString(database::kMaximumDisplayNameCharacters)));
    else if (!m_savesName)
        m_nameNotice->clear();
    m_fullName->setEnabled(!m_savesName);
    m_saveName->setEnabled(!m_savesName && good && name != m_storedName);
}

void AccountScreen::saveName() {
    if (!m_saveName->isEnabled())
        return;
    m_savesName = true;
    m_nameNotice->say("info", tr("Saving …"));
    renewName();
    database::Database* database = &context().site().database();
    const QString name = m_fullName->text().trimmed();
    context().background().run(
        this,
        [database, actor = context().actor(), name = name.toStdString()](WorkToken&) {
            return database::AccountService(*database).changeDisplayName(actor, name);
        },
        [this, name](const core::Result<void>& done) {
            m_savesName = false;
            m_storedName = done ? name : m_storedName;
            renewName();
            m_fullName->setFocus();
            if (done)
                m_nameNotice->say("good", name.isEmpty() ? tr("Others now see only your login name.")
                                                         : tr("Your name is now %1.").arg(name));
            else
                m_nameNotice->say("bad", tr("Your name was not changed.\n%1").arg(inWords(done.error())));
        });
}

void AccountScreen::chooseLanguage(const QString& language) {
    context().navigator().note({{QStringLiteral("focus"), QStringLiteral("language")}});
    context().setOwnLanguage(language);
}

void AccountScreen::renewPassword() {
    const bool free = !m_changesPassword && !m_wait->isRunning();
    m_oldPassword->setEnabled(free);
    m_newPassword->setEnabled(!m_changesPassword);
    m_changePassword->setEnabled(free && !m_oldPassword->text().isEmpty() && m_newPassword->isGood());
    if (!m_wait->isRunning())
        m_changePassword->setText(m_changesPassword ? tr("Checking …") : tr("Change the password"));
}

void AccountScreen::changePassword() {
    if (!m_changePassword->isEnabled())
        return;
    const std::string old = m_oldPassword->text().toStdString();
    const std::string fresh = m_newPassword->password();
    if (old == fresh) {
        m_passwordNotice->say("bad", tr("This is the password that you have now. Choose another one."));
        m_newPassword->focusFirst();
        return;
    }
    m_changesPassword = true;
    m_passwordNotice->clear();
    renewPassword();
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), old, fresh](WorkToken&) {
            return database::AccountService(*database).tryChangePassword(actor, old, fresh);
        },
        [this](const tl::expected<void, database::Refusal>& done) { passwordChanged(done); });
}

void AccountScreen::passwordChanged(const tl::expected<void, database::Refusal>& done) {
    m_changesPassword = false;
    m_oldPassword->clear();
    if (done) {
        m_newPassword->clear();
        m_passwordNotice->say(
            "good", tr("Your password has been changed. From your next login, only the new one is valid."));
    } else if (done.error().kind == database::Refusal::Kind::wrong) {
        m_passwordNotice->say("warning", tr("The current password is wrong. Nothing was changed. Passwords "
                                            "are case-sensitive; check Caps Lock."));
    } else {
        m_passwordNotice->say(done.error().kind == database::Refusal::Kind::failed ? "bad" : "warning",
                              tr("The password was not changed.\n%1").arg(refusalWords(done.error())));
    }
    m_wait->start(done ? 0 : done.error().wait_ns);
    renewPassword();
    if (m_oldPassword->isEnabled())
        m_oldPassword->setFocus();
}

} // namespace chiron::desktop
