// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/accounts/person.h"
#include "desktop/theme/theme.h"

#include <QAbstractTableModel>
#include <vector>

namespace chiron::desktop {

/// A table model of people: login name, full name, roles, state of the account.
/// Thread: GUI.
class PeopleModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    enum Column { name, fullName, roles, account, columnCountAll };
    static constexpr int kChips = Qt::UserRole; ///< QStringList of role names, for RoleChips
    static constexpr int kPersonId = Qt::UserRole + 1;
    /// For any cell: the row's text as forSearch() returns it.
    static constexpr int kSearch = Qt::UserRole + 2;

    PeopleModel(const Theme& theme, QObject* parent);

    void setPeople(std::vector<database::Person> people);
    const std::vector<database::Person>& people() const { return m_people; }
    const database::Person* find(database::PersonId id) const; ///< null if there is none

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString stateWords(const database::Person& person) const;

    const Theme& m_theme;
    std::vector<database::Person> m_people;
};

/// The names of a person's roles, for chips and lists.
QStringList rolesInWords(const database::RoleSet& roles);

} // namespace chiron::desktop
