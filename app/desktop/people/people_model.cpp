// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/people_model.h"

#include "desktop/frame/palette_search.h"

#include "desktop/accounts/account_words.h"

#include <algorithm>

namespace chiron::desktop {

PeopleModel::PeopleModel(const Theme& theme, QObject* parent) : QAbstractTableModel(parent), m_theme(theme) {}

void PeopleModel::setPeople(std::vector<database::Person> people) {
    beginResetModel();
    m_people = std::move(people);
    endResetModel();
}

const database::Person* PeopleModel::find(database::PersonId id) const {
    const auto found = std::find_if(m_people.begin(), m_people.end(),
                                    [id](const database::Person& p) { return p.id == id; });
    return found == m_people.end() ? nullptr : &*found;
}

int PeopleModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_people.size());
}

int PeopleModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columnCountAll;
}

QString PeopleModel::stateWords(const database::Person& person) const {
    if (!person.enabled)
        return tr("Disabled");
    return person.mustChangePassword ? tr("Must change the password") : tr("Can log in");
}

QVariant PeopleModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const database::Person& person = m_people[static_cast<std::size_t>(index.row())];
    if (role == kPersonId)
        return static_cast<qlonglong>(person.id);
    if (role == kSearch)
        return forSearch(QStringList{QString::fromStdString(person.name),
                                     QString::fromStdString(person.displayName),
                                     rolesInWords(person.roles).join(QLatin1Char(' ')), stateWords(person)}
                             .join(QLatin1Char(' ')));
    if (role == kChips && index.column() == roles)
        return rolesInWords(person.roles);
    if (role == Qt::DecorationRole && index.column() == account)
        return !person.enabled             ? m_theme.icon(QStringLiteral("dialog-cancel"), Colour::bad)
               : person.mustChangePassword ? m_theme.icon(QStringLiteral("dialog-warning"), Colour::warning)
                                           : m_theme.icon(QStringLiteral("dialog-ok-apply"), Colour::good);
    if (role == Qt::ForegroundRole && !person.enabled)
        return m_theme.color(Colour::muted);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case name:
        return QString::fromStdString(person.name);
    case fullName:
        return QString::fromStdString(person.displayName);
    case roles:
        return rolesInWords(person.roles).join(QStringLiteral(", "));
    case account:
        return stateWords(person);
    default:
        return {};
    }
}

QVariant PeopleModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal)
        return {};
    if (role == Qt::TextAlignmentRole)
        return int{Qt::AlignLeft | Qt::AlignVCenter};
    if (role != Qt::DisplayRole)
        return {};
    switch (section) {
    case name:
        return tr("Login name");
    case fullName:
        return tr("Full name");
    case roles:
        return tr("Roles");
    case account:
        return tr("Account");
    default:
        return {};
    }
}

QStringList rolesInWords(const database::RoleSet& roles) {
    QStringList names;
    for (const database::Role role : database::kAllRoles)
        if (roles.contains(role))
            names << roleName(role);
    return names;
}

} // namespace chiron::desktop
