// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/login_name_field.h"

#include "database/accounts/account_rules.h"
#include "desktop/accounts/form.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>
#include <QLocale>

namespace chiron::desktop {

LoginNameField::LoginNameField(const Theme& theme, const QString& prefix, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(6));
    m_field = form::textField(theme, column, tr("Login name"), prefix + QStringLiteral(".name"));
    m_rule = kit::label(theme, {}, TextStyle::small, "muted");
    m_rule->setObjectName(prefix + QStringLiteral(".name_rule"));
    column->addWidget(m_rule);
    connect(m_field, &QLineEdit::textChanged, this, &LoginNameField::renew);
    renew();
}

QString LoginNameField::name() const {
    return m_field->text();
}

void LoginNameField::setName(const QString& name) {
    m_field->setText(name);
}

void LoginNameField::focusField() {
    m_field->setFocus();
    m_field->selectAll();
}

void LoginNameField::showTaken() {
    say("bad", tr("Somebody has this login name already. Names that differ only in capital letters count as "
                  "the same."));
    focusField();
}

void LoginNameField::renew() {
    m_good = database::checkName(name().toStdString()).has_value();
    if (m_good)
        say("", tr("No commas."));
    else if (name().isEmpty())
        say("", tr("A login name is needed. No commas."));
    else
        say("bad", tr("This name cannot be used. Use at most %1 characters, no commas and no spaces at the "
                      "ends. Some names are "
                      "reserved for the program.")
                       .arg(QLocale().toString(database::kMaximumNameCharacters)));
    emit changed();
}

void LoginNameField::say(const char* kind, const QString& words) {
    const bool bad = *kind != '\0';
    form::setKind(m_field, kind);
    form::setKind(m_rule, bad ? "bad" : "muted");
    m_rule->setText(words);
    m_field->setAccessibleDescription(words);
}

} // namespace chiron::desktop
