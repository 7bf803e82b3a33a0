// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/accounts/password_fields.h"

#include "database/accounts/account_rules.h"
#include "desktop/accounts/form.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QLocale>

namespace chiron::desktop {

PasswordFields::PasswordFields(const Theme& theme, const QString& prefix, QWidget* parent)
    : QWidget(parent), m_theme(theme) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(10));
    m_password = form::passwordField(theme, column, tr("New password"), prefix + QStringLiteral(".password"));
    m_repeat =
        form::passwordField(theme, column, tr("Repeat the password"), prefix + QStringLiteral(".repeat"));
    auto* show = new QCheckBox(tr("Show the password"));
    show->setObjectName(prefix + QStringLiteral(".show"));
    column->addWidget(show);
    m_rules = new QWidget;
    auto* rules = new QVBoxLayout(m_rules);
    rules->setContentsMargins(0, 0, 0, 0);
    rules->setSpacing(theme.px(4));
    const QLocale locale;
    addRule(tr("Length: %1 characters or more").arg(locale.toString(database::kMinimumPasswordCharacters)));
    addRule(tr("Variety: %1 different characters or more")
                .arg(locale.toString(database::kMinimumDifferentCharacters)));
    addRule(tr("Not the login name"));
    addRule(tr("Both fields are the same"));
    column->addWidget(m_rules);
    connect(show, &QCheckBox::toggled, this, [this](bool on) {
        m_password->setEchoMode(on ? QLineEdit::Normal : QLineEdit::Password);
        m_repeat->setEchoMode(on ? QLineEdit::Normal : QLineEdit::Password);
    });
    connect(m_password, &QLineEdit::textChanged, this, &PasswordFields::renew);
    connect(m_repeat, &QLineEdit::textChanged, this, &PasswordFields::renew);
    connect(m_password, &QLineEdit::returnPressed, m_repeat, qOverload<>(&QWidget::setFocus));
    connect(m_repeat, &QLineEdit::returnPressed, this, &PasswordFields::submitted);
    renew();
}

void PasswordFields::addRule(const QString& text) {
    auto* row = new QHBoxLayout;
    row->setSpacing(m_theme.px(8));
    Line line{new QLabel, kit::label(m_theme, text, TextStyle::small)};
    row->addWidget(line.sign, 0, Qt::AlignTop);
    row->addWidget(line.words, 1);
    static_cast<QVBoxLayout*>(m_rules->layout())->addLayout(row);
    m_lines.push_back(line);
}

void PasswordFields::setLoginName(const QString& name) {
    m_name = name;
    renew();
}

std::string PasswordFields::password() const {
    return m_password->text().toStdString();
}

void PasswordFields::focusFirst() {
    m_password->setFocus();
}

void PasswordFields::clear() {
    m_password->clear();
    m_repeat->clear();
}

void PasswordFields::renew() {
    const bool empty = m_password->text().isEmpty();
    const database::PasswordCheck check = database::examinePassword(m_name.toStdString(), password());
    const bool same = !empty && m_password->text() == m_repeat->text();
    const bool met[ruleCount] = {check.longEnough && check.storable, check.varied, !empty && check.notTheName,
                                 same};
    QStringList heard;
    for (int rule = 0; rule < ruleCount; ++rule) {
        const Line& line = m_lines[static_cast<std::size_t>(rule)];
        const QString sign = met[rule] ? QStringLiteral("dialog-ok-apply") : QStringLiteral("dialog-cancel");
        line.sign->setPixmap(m_theme.icon(sign, met[rule] ? Colour::good : Colour::muted)
                                 .pixmap(m_theme.px(16), m_theme.px(16)));
        form::setKind(line.words, met[rule] ? "good" : "muted");
        line.words->setAccessibleName(
            (met[rule] ? tr("Done: %1") : tr("Still missing: %1")).arg(line.words->text()));
        heard << line.words->accessibleName();
    }
    m_password->setAccessibleDescription(heard.join(QStringLiteral(". ")));
    m_good = check.ok() && same;
    emit changed();
}

} // namespace chiron::desktop
