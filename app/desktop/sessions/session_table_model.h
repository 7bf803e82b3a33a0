// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sessions/session_list_filter.h"
#include "desktop/theme/theme.h"

#include <QAbstractTableModel>
#include <QIcon>
#include <QLocale>
#include <map>
#include <vector>

namespace chiron::desktop {

/// The model of the session list. It holds all rows in memory, filters and sorts by index, and creates texts
/// when they are shown.
/// Thread: GUI.
class SessionTableModel final : public QAbstractTableModel {
    Q_OBJECT
public:
    /// The person comes first, then the number that identifies the session in messages. sessions_screen.cpp
    /// decides which columns a narrow window leaves out.
    enum Column {
        person,
        number,
        operatorName,
        exercise,
        level,
        attempt,
        started,
        result,
        score,
        comments,
        review,
        device,
        length,
        columns
    };

    SessionTableModel(const Theme& theme, QLocale locale, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;
    void sort(int column, Qt::SortOrder order = Qt::AscendingOrder) override;

    /// Whether the person's cell has the operator as its second line, because that column is left out.
    /// Nothing is added for somebody's own hand.
    void setOperatorWithPerson(bool with);
    void setRows(std::vector<SessionRow> rows); ///< newest first
    void append(std::vector<SessionRow> rows);  ///< appends older sessions
    void replace(SessionRow row);               ///< replaces the row with the same number
    void replace(std::vector<SessionRow> rows); ///< replaces the rows with the same numbers
    void setFilter(const SessionListFilter& filter);
    const SessionListFilter& filter() const noexcept { return m_filter; }

    int total() const noexcept { return static_cast<int>(m_rows.size()); } ///< independent of the filter
    const SessionRow& at(int row) const { return m_rows[m_shown[static_cast<std::size_t>(row)]]; }
    const std::vector<SessionRow>& all() const noexcept { return m_rows; }
    int rowOf(database::SessionId session) const; ///< -1: not shown

private:
    void show();
    void sortShown();
    QString text(const SessionRow& row, int column) const;
    QString operatorWith(const SessionRow& row, int column) const; ///< the second line of a cell
    QString tip(const SessionRow& row) const; ///< includes what a narrow window leaves out
    QVariant picture(const SessionRow& row, int column) const;
    QIcon icon(const WordSign& sign) const;

    const Theme& m_theme;
    QLocale m_locale;
    std::vector<SessionRow> m_rows;
    std::vector<std::size_t> m_shown;
    SessionListFilter m_filter;
    int m_sortColumn = number; ///< newest first
    Qt::SortOrder m_sortOrder = Qt::DescendingOrder;
    bool m_operatorWithPerson = false;
    mutable std::map<std::pair<QString, Colour>, QIcon> m_icons;
};

} // namespace chiron::desktop
