// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/frame/screen.h"

#include "core/result.h"

#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;

namespace chiron::desktop {

class FittedTable;
class StatePanel;

/// Lists the researcher's studies with state, identity and progress, and offers to create studies and to act
/// on the selected one. The place is {archived, study}.
/// Thread: GUI.
class StudiesScreen final : public Screen {
    Q_OBJECT
public:
    StudiesScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

    /// Creates a study from a JSON file. Tests call it directly, without a file dialog.
    void importFile(const QString& file);

private:
    QWidget* headRow();
    QWidget* tablePart();
    QWidget* actionRow();
    void load();
    void loaded(core::Result<std::vector<database::StudySummary>> studies);
    void fill();
    void showActions();
    void askNew();
    void askCopy();
    void askFile();
    void create(const std::string& key, const std::string& title, const std::string& json);
    void open(const QString& screen);
    void archive(const database::StudySummary& study, bool archived, bool canUndo);
    void close();
    const database::StudySummary* selected() const;

    StatePanel* m_panel = nullptr;
    FittedTable* m_table = nullptr;
    QLabel* m_count = nullptr;
    QCheckBox* m_archived = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_run = nullptr;
    QPushButton* m_data = nullptr;
    QPushButton* m_copy = nullptr;
    QPushButton* m_close = nullptr;
    QPushButton* m_archive = nullptr;
    std::vector<database::StudySummary> m_studies;
    database::StudyNumber m_wanted = 0;
};

} // namespace chiron::desktop
