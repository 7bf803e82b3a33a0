// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/sessions/session_list_filter.h"
#include "desktop/sessions/session_table_model.h"
#include "desktop/sessions/void_dialog.h"

#include <array>

class QLabel;
class QPushButton;
class QTableView;

namespace chiron::desktop {

class SessionFilterBar;
class StatePanel;
class WorkToken;

/// Every session of the site: find, open, play, void, archive, export the list. The newest come first and are shown as soon as
/// they are there; the rest follows. The filter is kept in the place. A place without parameters shows
/// the list as the person left it today; one with them (a link) shows its own and leaves the person's as it was. {all}: everything.
class SessionsScreen final : public Screen {
    Q_OBJECT
public:
    SessionsScreen(AppContext& context, const Place& place);

    QString title() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;
    QString help() const override;

    SessionTableModel& model() const { return *m_model; }
    bool isComplete() const noexcept { return m_complete; } ///< every session has come from the database

    static constexpr int kFirstPage = 100; ///< more than any screen shows at once
    static constexpr int kPage = 2000;

signals:
    void firstRowsShown();
    void loaded();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    QWidget* buildHead();
    QWidget* buildTable();
    QWidget* buildActions();
    void connectTable();
    void fitColumns(); ///< those that the table has room for
    void load();
    void loadRest(database::SessionId before);
    void take(core::Result<std::vector<SessionRow>> rows, bool first);
    void showState();
    void noteState();
    void chooseFilter(const SessionListFilter& filter); ///< by hand: the person's own from then on
    void selectSomething();
    static QString sealedWords();
    void showActions();
    const SessionRow* selected() const;
    void open(const QString& screen);
    void openResults(); ///< of whose session is selected, at its exercise and level
    void askDecision(); ///< to void what is selected, or to count it again where it is void
    void decide(database::SessionId session, VoidSessionDialog::Decision decision, const QString& reason);
    void archive(database::SessionId session, bool archived);
    /// The session, and those at its level: which of a person's attempts awaits a review depends on the others.
    void reload(database::SessionId session);
    void exportList();

    SessionFilterBar* m_filterBar = nullptr;
    SessionTableModel* m_model = nullptr;
    QTableView* m_table = nullptr;
    std::array<int, SessionTableModel::columns> m_widths{}; ///< pixels
    StatePanel* m_panel = nullptr;
    QLabel* m_count = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_play = nullptr;
    QPushButton* m_results = nullptr;
    QPushButton* m_void = nullptr;
    QPushButton* m_reinstate = nullptr;
    QPushButton* m_archive = nullptr;
    QPushButton* m_save = nullptr;
    database::SessionId m_wanted = 0; ///< to be selected once it is there
    bool m_complete = false;
    ExerciseTitles m_titles;
};

} // namespace chiron::desktop
