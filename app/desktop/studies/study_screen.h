// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/screen.h"
#include "desktop/studies/freeze_checks.h"
#include "desktop/studies/study_draft.h"
#include "desktop/studies/study_jobs.h"
#include "desktop/studies/study_page.h"

#include <QTimer>

class QComboBox;
class QLabel;
class QPushButton;
class QTabBar;
class QVBoxLayout;

namespace chiron::desktop {

class NoticeArea;
class ScrollPage;
class StatePanel;

/// Shows one study: its design page by page with Back and Next, and beside it a summary of what a participant
/// will experience. A draft can be edited and every step undone. A valid design is stored at once; an invalid
/// one shows each error at its field. The last page leads to freezing, and after that shows the participants.
/// The place is {study, tab, condition}.
/// Thread: GUI.
class StudyScreen final : public Screen {
    Q_OBJECT
public:
    /// `checkTab` is the last page of a draft; a frozen study has the participants there.
    enum Tab {
        generalTab,
        conditionsTab,
        trialsTab,
        questionnairesTab,
        previewTab,
        participantsTab,
        tabs,
        checkTab = participantsTab
    };

    StudyScreen(AppContext& context, const Place& place);
    ~StudyScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    bool mayLeave() override;
    bool mayLeaveDesign();
    std::vector<ScreenCommand> commands() override;

    StudyDraft& draft() { return m_draft; }
    void importFile(const QString& file);
    void exportFile(const QString& file);
    void showTab(int tab);
    const std::vector<DesignFault>& faults() const { return m_wrong; }

protected:
    /// Enter in a single-line field goes to the next page, like Next.
    void keyPressEvent(QKeyEvent* event) override;

private:
    // study_screen.cpp
    void load();
    void loaded(core::Result<OpenStudy> study);
    void build();
    QWidget* headRow();
    QWidget* toolRow();
    QWidget* faultBar();
    QWidget* stepRow();
    QString nextWords(const QStringList& needed) const;
    void showSteps();
    void stepOn(); ///< to the next page; on the last one to what is missing, or to freezing
    std::vector<FreezeCheck> missing() const; ///< what prevents freezing, known without simulating
    void showPage();
    void sayPreviewEnds(); ///< warns if a preview is running on the page being left
    void showFaults();
    void step(int by);
    void goToField(int tab, int condition, const QString& field);
    void goToFirstFault();
    QWidget* makePage();
    void askConsent(const database::Participant& participant);
    QWidget* makeCheckPage(const DesignPage& page);
    DesignPage designPage();
    bool readOnly() const;
    void note();

    // study_screen_actions.cpp: checking, storing, freezing, import and export
    void changed();
    void check();
    void checkNow();
    void take(const core::Result<psychophysics::StudyDesign>& read);
    bool stored();
    void checked(int version, const core::Result<psychophysics::StudyDesign>& read);
    void save();
    void showState();
    void askFreeze();
    void askPilot();
    void askCopy();
    void askImport();
    void askExport();
    void reloadTo(int tab);

    database::StudyNumber m_study;
    int m_tab;
    int m_condition;
    QString m_participant; ///< selected participant, kept because the list is reloaded after each change
    QString m_language;
    OpenStudy m_open;
    StudyDraft m_draft;
    std::vector<DesignFault> m_wrong; ///< of the newest design that was checked
    bool m_good = true;               ///< the newest design is valid
    bool m_saved = true;              ///< the newest design is stored
    bool m_saving = false;
    int m_version = 0; ///< of the design; counts changes
    QTimer m_check{this};
    StatePanel* m_panel = nullptr;
    QWidget* m_view = nullptr; ///< head, tabs, page and steps; null until the study is loaded
    ScrollPage* m_scroll = nullptr;
    QStringList m_tabNames;
    QWidget* m_steps = nullptr;  ///< the bar with Back and Next
    QLabel* m_missing = nullptr; ///< beside Next: what freezing still waits for
    QTabBar* m_bar = nullptr;
    QLabel* m_state = nullptr;
    NoticeArea* m_faults = nullptr;
    QVBoxLayout* m_holder = nullptr;
    QWidget* m_page = nullptr;
    QPushButton* m_undo = nullptr;
    QPushButton* m_redo = nullptr;
    QPushButton* m_freeze = nullptr;
    QPushButton* m_back = nullptr;
    QPushButton* m_next = nullptr;
    QPushButton* m_toFault = nullptr;
};

} // namespace chiron::desktop
