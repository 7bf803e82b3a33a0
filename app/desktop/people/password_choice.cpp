// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/password_choice.h"

#include "database/accounts/generated_password.h"
#include "desktop/accounts/password_fields.h"
#include "desktop/widgets/kit.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QRadioButton>

namespace chiron::desktop {

PasswordChoice::PasswordChoice(const Theme& theme, const QString& prefix, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(6));
    column->addWidget(kit::label(theme, tr("Initial password"), TextStyle::label));
    m_generate = new QRadioButton(tr("Generate one (shown once)"));
    m_generate->setObjectName(prefix + QStringLiteral(".generate"));
    m_generate->setChecked(true);
    m_type = new QRadioButton(tr("Type one"));
    m_type->setObjectName(prefix + QStringLiteral(".type"));
    m_fields = new PasswordFields(theme, prefix);
    m_fields->hide();
    column->addWidget(m_generate);
    column->addWidget(m_type);
    column->addWidget(m_fields);
    column->addWidget(
        kit::label(theme, tr("It has to be changed at the next login, so that only its owner knows it."),
                   TextStyle::small, "muted"));
    connect(m_type, &QRadioButton::toggled, this, [this](bool typed) {
        m_fields->setVisible(typed);
        if (typed)
            m_fields->focusFirst();
        emit changed();
    });
    connect(m_fields, &PasswordFields::changed, this, &PasswordChoice::changed);
}

void PasswordChoice::setLoginName(const QString& name) {
    m_fields->setLoginName(name);
}

bool PasswordChoice::isGood() const {
    return isGenerated() || m_fields->isGood();
}

bool PasswordChoice::isGenerated() const {
    return m_generate->isChecked();
}

std::string PasswordChoice::password() const {
    return isGenerated() ? database::generatedPassword() : m_fields->password();
}

QWidget* handedPassword(const Theme& theme, const QString& headline, const QString& loginName,
                        const QString& password) {
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    column->addWidget(kit::notice(theme, "good", headline));
    column->addWidget(kit::label(
        theme, PasswordChoice::tr(
                   "Hand this password to %1. It is shown only now and has to be changed at the next login.")
                   .arg(loginName)));
    const kit::Box box = kit::box(theme, "raised");
    auto* words = kit::label(theme, password, TextStyle::mono);
    words->setObjectName(QStringLiteral("handed.password"));
    words->setAlignment(Qt::AlignCenter);
    words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    box.layout->addWidget(words);
    column->addWidget(box.frame);
    auto* copy = kit::button(theme, PasswordChoice::tr("Copy"), "", QStringLiteral("edit-copy"));
    copy->setObjectName(QStringLiteral("handed.copy"));
    QObject::connect(copy, &QPushButton::clicked, copy, [copy, password] {
        QGuiApplication::clipboard()->setText(password);
        copy->setText(PasswordChoice::tr("Copied"));
    });
    column->addWidget(copy, 0, Qt::AlignLeft);
    return whole;
}

} // namespace chiron::desktop
