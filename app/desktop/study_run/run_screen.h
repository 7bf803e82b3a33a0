// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/screen.h"
#include "desktop/studies/study_jobs.h"

#include <optional>
#include <vector>

class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

struct ConditionProgress;
class StatePanel;
class Theme;

/// Chooses who takes part next, and in which condition: studies that can be run, participants by code, their
/// conditions in order (by sealed code if the experimenter is blind) and their questionnaires. It says who
/// comes next. The place is {study, participant, just_ran}; just_ran: the participant comes from a run or a
/// questionnaire, and if nothing is left for them to do, the next one is selected.
/// Thread: GUI.
class RunScreen final : public Screen {
    Q_OBJECT
public:
    RunScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;
    void enter() override;

private:
    void load();
    void loaded(core::Result<std::vector<OpenStudy>> studies);
    void build();
    QWidget* choiceBox();
    /// The cell for the button of a row, with or without one. It is equally wide in every row, so that the
    /// texts before it are aligned.
    static QVBoxLayout* buttonCell(QHBoxLayout& line);
    QWidget* leftBox(); ///< interrupted runs of the other participants; null if there are none
    QPushButton* resumeButton(const QString& participant, const database::StudyRun& run);
    /// The code of somebody who is waiting, besides `except`: who was interrupted last, else the first in the
    /// list, and people with only questions left after all others. Empty if there is nobody.
    QString nextWaiting(const QString& except = {}) const;
    void selectWhoIsNext();
    /// Who comes next, in a sentence.
    QString whoIsNext() const;
    QWidget* participantBox();
    /// Going on with somebody who is waiting, and enrolling somebody. `first`: nothing else is left to do for
    /// the participant who is shown.
    void addOthers(QVBoxLayout& layout, bool first);
    void addEnrol(QVBoxLayout& layout, bool first); ///< `first`: nothing else is left to do on this screen
    void goOnWith(const QString& participant);
    void enrol();
    void askConsent(const database::Participant& participant);
    /// The notice for a device that renders no force; otherwise null.
    QWidget* shownNotice();
    /// The notice for a study with masking sound on a computer without sound output; otherwise null.
    QWidget* soundNotice();
    QWidget* conditionRow(const ParticipantRow& row, int position, const ConditionProgress& progress,
                          bool next);
    /// A questionnaire, about the run of the condition at `position`, or asked once if `run` is null.
    struct Asked {
        const psychophysics::Questionnaire& questionnaire;
        const database::StudyRun* run = nullptr;
        int position = 0;
    };
    bool isAnswered(const ParticipantRow& row, const Asked& asked) const;
    /// `next`: to answer it is the participant's next step.
    QWidget* questionnaireRow(const ParticipantRow& row, const Asked& asked, bool next);
    void showParticipant();
    const OpenStudy* study() const;
    const ParticipantRow* participant() const;
    void run(const std::string& condition);

    StatePanel* m_panel = nullptr;
    QComboBox* m_studyChoice = nullptr;
    QComboBox* m_participantChoice = nullptr;
    QLabel* m_whoIsNext = nullptr;
    QVBoxLayout* m_holder = nullptr;
    QWidget* m_shown = nullptr;
    std::vector<OpenStudy> m_studies;
    std::optional<bool> m_heard; ///< whether this computer has sound output; no value: not yet tested
    database::StudyNumber m_study;
    QString m_participant;
    QString m_finished; ///< whoever has just done everything; empty if somebody else was selected since
};

} // namespace chiron::desktop
