// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/screen.h"
#include "desktop/study_data/study_facts.h"

#include <memory>
#include <vector>

class QComboBox;
class QFileDialog;
class QPushButton;
class QTabBar;
class QVBoxLayout;

namespace chiron::desktop {

class ApexPage;
class StatePanel;
class WorkToken;

/// Shows the results of a study: group and persons, every trial, questionnaires, comparisons of conditions.
/// It also offers unblinding and exports. The place is {study, tab, condition, run}.
/// Thread: GUI.
class StudyDataScreen final : public Screen {
    Q_OBJECT
public:
    enum Tab { groupTab, personTab, trialsTab, questionnairesTab, comparisonTab, tabs };

    StudyDataScreen(AppContext& context, const Place& place);
    ~StudyDataScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

    /// Writes into a new folder in `parent` (or a PDF file), like the buttons after a folder was chosen.
    void exportCsvTo(const QString& parent);
    void exportBidsTo(const QString& parent);
    void exportPdfTo(const QString& file);

private:
    // study_data_screen.cpp
    void loadList();
    void load();
    void loaded(core::Result<StudyFacts> facts);
    void build();
    QWidget* headRow();
    QWidget* shownChoice();
    ApexPage* listening(ApexPage* page);
    void showPage();
    void note();

    // study_data_actions.cpp
    QWidget* toolRow();
    void askUnblind();
    /// If `folder` exists, asks whether to replace it or to keep it beside the new one.
    void chooseFolder(const QString& folder,
                      const std::function<void(const QString& folder, bool replaces)>& then);
    void askFolder(void (StudyDataScreen::*then)(const QString&));
    void askPdf();
    bool mayExport();
    void tellIfCancelled(QFileDialog* dialog);
    QString written(const QString& where) const;
    /// The texts shown while an export is being written, when it succeeds and when it fails.
    struct ExportWords {
        QString writing, written, failed;
    };
    void
    exportTo(const ExportWords& words,
             const std::function<core::Result<void>(database::Connection&, database::StudyReader&)>& write);

    StatePanel* m_panel = nullptr;
    database::StudyNumber m_study;
    int m_tab;
    std::size_t m_condition;
    database::StudyRunNumber m_run;
    std::vector<database::StudySummary> m_list;
    StudyFacts m_facts;
    bool m_withShown;         ///< stored for the logged-in person
    bool m_exporting = false; ///< an export is in progress
    std::shared_ptr<WorkToken> m_work;
    QTabBar* m_bar = nullptr;
    QVBoxLayout* m_holder = nullptr;
    QWidget* m_page = nullptr;
};

} // namespace chiron::desktop
