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

/// Lists every session of the site: find, open, play, void, archive, export the list. The newest sessions are
/// shown as soon as they are read; the rest follows. The place contains the filter. A place without
/// parameters shows the list as the person left it on the same day; one with parameters (a link) shows its
/// own filter and leaves the person's unchanged. {all} shows everything.
class SessionsScreen final : public Screen {
    Q_OBJECT
public:
    SessionsScreen(AppContext& context, const Place& place);

    QString title() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;
    QString help() const override;

    SessionTableModel& model() const { return *m_model; }
    bool isComplete() const noexcept { return m_complete; } ///< every session has been read

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
    void fitColumns(); ///< shows the columns that the table has room for
    void load();
    void loadRest(database::SessionId before);
    void take(core::Result<std::vector<SessionRow>> rows, bool first);
    void showState();
    void noteState();
    void chooseFilter(const SessionListFilter& filter); ///< by hand: becomes the person's own filter
    void selectSomething();
    static QString sealedWords();
    void showActions();
    const SessionRow* selected() const;
    void open(const QString& screen);
    void openResults(); ///< of the selected session's person, at its exercise
    void askDecision(); ///< to void the selected session, or to count a voided one again
    void decide(database::SessionId session, VoidSessionDialog::Decision decision, const QString& reason);
    void archive(database::SessionId session, bool archived);
    /// Reads this session and the others at its level again, because which of a person's attempts awaits a
    /// review depends on the others.
    void reload(database::SessionId session);
    void exportList();

    SessionFilterBar* m_filterBar = nullptr;
    SessionTableModel* m_model = nullptr;
    QTableView* m_table = nullptr;
    std::array<int, SessionTableModel::columns> m_widths{}; ///< in pixels
    StatePanel* m_panel = nullptr;
    QLabel* m_count = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_play = nullptr;
    QPushButton* m_results = nullptr;
    QPushButton* m_void = nullptr;
    QPushButton* m_reinstate = nullptr;
    QPushButton* m_archive = nullptr;
    QPushButton* m_save = nullptr;
    database::SessionId m_wanted = 0; ///< session to select once it is loaded
    bool m_complete = false;
    ExerciseTitles m_titles;
};

} // namespace chiron::desktop
