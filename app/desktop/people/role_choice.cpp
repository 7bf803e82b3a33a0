// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/role_choice.h"

#include "desktop/accounts/account_words.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>

namespace chiron::desktop {

namespace {

QString permits(database::Role role) {
    switch (role) {
    case database::Role::trainee:
        return RoleChoice::tr("Trains and sees their own results");
    case database::Role::trainer:
        return RoleChoice::tr("Sees everybody's sessions, and can comment on them and void them");
    case database::Role::researcher:
        return RoleChoice::tr(
            "Designs studies and runs them with participants; sees sessions by code, without names");
    case database::Role::admin:
        return RoleChoice::tr("Manages people, storage and the station; may also design and run studies");
    }
    return {};
}

} // namespace

RoleChoice::RoleChoice(const Theme& theme, const QString& prefix, const database::RoleSet& roles,
                       QWidget* parent)
    : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(4));
    column->addWidget(kit::label(theme, tr("Roles (at least one)"), TextStyle::label));
    for (const database::Role role : database::kAllRoles) {
        auto* box = new QCheckBox(roleName(role));
        const std::string_view word = database::token(role);
        box->setObjectName(prefix + QLatin1Char('.') +
                           QString::fromLatin1(word.data(), static_cast<qsizetype>(word.size())));
        box->setChecked(roles.contains(role));
        box->setAccessibleDescription(permits(role));
        column->addWidget(box);
        auto* row = new QHBoxLayout;
        row->addSpacing(theme.px(32));
        row->addWidget(kit::label(theme, permits(role), TextStyle::small, "muted"), 1);
        column->addLayout(row);
        column->addSpacing(theme.px(4));
        m_boxes[role] = box;
        connect(box, &QCheckBox::toggled, this, &RoleChoice::changed);
    }
}

database::RoleSet RoleChoice::roles() const {
    database::RoleSet roles;
    for (const auto& [role, box] : m_boxes)
        if (box->isChecked())
            roles.insert(role);
    return roles;
}

} // namespace chiron::desktop
