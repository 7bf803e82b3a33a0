// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "desktop/frame/screen.h"
#include "desktop/studies/study_jobs.h"

class QPushButton;

namespace chiron::desktop {

class NoticeArea;
class QuestionnaireForm;
class StatePanel;

/// Asks one participant to fill in one questionnaire and stores it at once. The place is {study, participant,
/// questionnaire}, plus {run} if it is asked after each condition.
/// Thread: GUI.
class QuestionnaireScreen final : public Screen {
    Q_OBJECT
public:
    QuestionnaireScreen(AppContext& context, const Place& place);

    QString title() const override;
    QString help() const override;
    void enter() override;
    bool mayLeave() override;

private:
    void load();
    void loaded(const core::Result<OpenStudy>& study);
    void build(const psychophysics::Questionnaire& questionnaire);
    void submit();
    void goBack();

    database::StudyNumber m_study;
    QString m_code;
    std::string m_questionnaire;
    database::StudyRunNumber m_run = 0; ///< run of the condition that it is about; 0 if asked once
    database::ParticipantNumber m_participant = 0;
    bool m_stored = false;
    StatePanel* m_panel = nullptr;
    QuestionnaireForm* m_form = nullptr;
    NoticeArea* m_notice = nullptr;
    QPushButton* m_submit = nullptr;
};

} // namespace chiron::desktop
