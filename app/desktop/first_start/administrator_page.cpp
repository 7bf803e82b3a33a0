// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/first_start/administrator_page.h"

#include "database/accounts/account_rules.h"
#include "database/repositories/site_repository.h"
#include "desktop/accounts/form.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/accounts/password_fields.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

AdministratorPage::AdministratorPage(const Theme& theme, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    column->addWidget(kit::label(theme, tr("Who looks after this site?"), TextStyle::heading));
    column->addWidget(kit::label(
        theme,
        tr("The first person is an administrator, who adds people, makes backups, and may also train, design "
           "studies and run them."),
        TextStyle::body, "muted"));
    m_name = form::textField(theme, column, tr("Login name"), QStringLiteral("first_start.name"));
    m_nameRule =
        kit::label(theme, tr("A short name without commas, such as \"ada\"."), TextStyle::small, "muted");
    column->addWidget(m_nameRule);
    m_displayName = form::textField(theme, column, tr("Full name (may be left empty)"),
                                    QStringLiteral("first_start.display_name"));
    m_siteName =
        form::textField(theme, column, tr("Name of the site, such as the clinic's (may be left empty)"),
                        QStringLiteral("first_start.site_name"));
    m_siteName->setMaxLength(database::kMaximumSiteNameCharacters);
    m_siteName->setToolTip(tr("Shown at the login, on password slips and on reports. Administrators can "
                              "change it in the settings."));
    m_passwords = new PasswordFields(theme, QStringLiteral("first_start"));
    column->addWidget(m_passwords);
    m_back = kit::button(theme, tr("Back"));
    m_back->setObjectName(QStringLiteral("first_start.back"));
    m_create = kit::button(theme, tr("Set up the site"), "primary");
    m_create->setObjectName(QStringLiteral("first_start.create"));
    const form::Foot foot = form::addFoot(theme, column, m_back, m_create);
    m_foot = foot.widget;
    m_notice = foot.notice;
    connect(m_name, &QLineEdit::textChanged, this, &AdministratorPage::renew);
    connect(m_name, &QLineEdit::returnPressed, m_displayName, qOverload<>(&QWidget::setFocus));
    connect(m_displayName, &QLineEdit::returnPressed, m_siteName, qOverload<>(&QWidget::setFocus));
    connect(m_siteName, &QLineEdit::returnPressed, m_passwords, &PasswordFields::focusFirst);
    connect(m_passwords, &PasswordFields::changed, this, &AdministratorPage::renew);
    connect(m_passwords, &PasswordFields::submitted, this, &AdministratorPage::submit);
    connect(m_create, &QPushButton::clicked, this, &AdministratorPage::submit);
    connect(m_back, &QPushButton::clicked, this, &AdministratorPage::backAsked);
    renew();
}

void AdministratorPage::focusFirst() {
    m_name->setFocus();
}

void AdministratorPage::renew() {
    const bool typed = !m_name->text().isEmpty();
    const bool nameGood = database::checkName(m_name->text().toStdString()).has_value();
    form::setKind(m_name, typed && !nameGood ? "bad" : "");
    form::setKind(m_nameRule, typed && !nameGood ? "bad" : "muted");
    m_nameRule->setText(typed && !nameGood ? tr("This name cannot be used. Use at most %1 characters, no "
                                                "commas and no spaces at the ends. Some names are "
                                                "reserved for the program.")
                                                 .arg(QLocale().toString(database::kMaximumNameCharacters))
                                           : tr("A short name without commas, such as \"ada\"."));
    if (m_passwords->property("name") != m_name->text()) {
        m_passwords->setProperty("name", m_name->text());
        m_passwords->setLoginName(m_name->text());
    }
    m_create->setEnabled(!m_working && nameGood && m_passwords->isGood());
}

void AdministratorPage::submit() {
    if (!m_create->isEnabled())
        return;
    emit submitted({m_name->text().toStdString(), m_displayName->text().trimmed().toStdString(),
                    m_passwords->password(), m_siteName->text().trimmed().toStdString()});
}

void AdministratorPage::setWorking(bool working) {
    m_working = working;
    for (QWidget* part : {static_cast<QWidget*>(m_name), static_cast<QWidget*>(m_displayName),
                          static_cast<QWidget*>(m_siteName), static_cast<QWidget*>(m_passwords),
                          static_cast<QWidget*>(m_back)})
        part->setEnabled(!working);
    m_notice->say("info", working ? tr("Creating the site …") : QString());
    renew();
}

void AdministratorPage::showProblem(const QString& text) {
    m_notice->say("bad", text);
}

} // namespace chiron::desktop
