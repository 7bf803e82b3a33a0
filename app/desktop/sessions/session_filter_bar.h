// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "desktop/sessions/session_list_filter.h"
#include "desktop/theme/theme.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDateEdit;
class QLineEdit;
class QPushButton;

namespace chiron::desktop {

/// The controls that filter the list of sessions.
/// Thread: GUI.
class SessionFilterBar final : public QWidget {
    Q_OBJECT
public:
    SessionFilterBar(const Theme& theme, const catalogue::Catalogue& catalogue, const QString& language,
                     QWidget* parent = nullptr);

    /// Shows a filter without emitting changed().
    void setFilter(const SessionListFilter& filter);
    const SessionListFilter& filter() const noexcept { return m_filter; }
    /// Sets the people to choose from: everybody with a session among `rows`, sorted by name.
    void setPeople(const std::vector<SessionRow>& rows);
    QLineEdit* search() const { return m_search; }

signals:
    void changed(const chiron::desktop::SessionListFilter& filter);
    void leaveSearch(); ///< Down or Enter in the search field: move to the list

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QComboBox* choice(const QString& name, const QString& any, const QString& label);
    void buildChoices(const catalogue::Catalogue& catalogue, const QString& language);
    void buildPeriod(const Theme& theme);
    void makeDates();
    void choosePeriod();
    void read();
    void showDates();

    SessionListFilter m_filter;
    bool m_showing = false;
    QLineEdit* m_search = nullptr;
    QComboBox* m_person = nullptr;
    QComboBox* m_exercise = nullptr;
    QComboBox* m_level = nullptr;
    QComboBox* m_state = nullptr;
    QComboBox* m_device = nullptr;
    QComboBox* m_outcome = nullptr;
    QComboBox* m_review = nullptr;
    QComboBox* m_period = nullptr;
    QWidget* m_dates = nullptr;
    QDateEdit* m_from = nullptr; ///< created when days are first chosen
    QDateEdit* m_to = nullptr;
    QCheckBox* m_commented = nullptr;
    QCheckBox* m_archived = nullptr;
    QPushButton* m_clear = nullptr;
};

} // namespace chiron::desktop
