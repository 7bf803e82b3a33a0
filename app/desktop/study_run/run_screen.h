// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/screen.h"
#include "desktop/studies/study_store.h"

#include <optional>
#include <vector>

class QComboBox;
class QHBoxLayout;
class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

struct ConditionProgress;
class StatePanel;
class Theme;

/// Who takes part next, at what: studies that can be run, participants by code, their conditions in order (by sealed code where the
/// experimenter is blind) and questionnaires. Place: {study, participant}. GUI thread.
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
    /// Where a row has its button, or has none: as wide in every row, so that what stands before it is in line.
    static QVBoxLayout* buttonCell(QHBoxLayout& line);
    QWidget* leftBox(); ///< what was interrupted of the others; null where nothing was
    QPushButton* resumeButton(const QString& participant, const database::StudyRun& run);
    QString firstChoice() const; ///< whoever was interrupted last, else the first who still takes part
    QWidget* participantBox();
    void addEnrol(QVBoxLayout& layout, bool first); ///< `first`: nothing else is left to do here
    void enrol();
    void askConsent(const database::Participant& participant);
    QWidget* soundNotice(); ///< of a study with masking sound on a machine that plays none; else null
    QWidget* conditionRow(const ParticipantRow& row, int position, const ConditionProgress& progress, bool next);
    /// `run`: of the condition that is asked about, at `position`; null: asked once.
    QWidget* questionnaireRow(const ParticipantRow& row, const psychophysics::Questionnaire& questionnaire, const database::StudyRun* run = nullptr, int position = 0);
    void showParticipant();
    const OpenStudy* study() const;
    const ParticipantRow* participant() const;
    void run(const std::string& condition);

    StatePanel* m_panel = nullptr;
    QComboBox* m_studyChoice = nullptr;
    QComboBox* m_participantChoice = nullptr;
    QVBoxLayout* m_holder = nullptr;
    QWidget* m_shown = nullptr;
    std::vector<OpenStudy> m_studies;
    std::optional<bool> m_heard; ///< whether this machine has a sound output; not asked yet
    database::StudyNumber m_study;
    QString m_participant;
};

} // namespace chiron::desktop
