// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "desktop/studies/study_jobs.h"

class QLineEdit;

namespace chiron::desktop {

class QuestionnaireForm;

/// Enrols a participant with the fields that the design asks for, and shows the participant's code. The data
/// identify the participant by this code only.
/// Thread: GUI.
class EnrolDialog final : public FormDialog {
    Q_OBJECT
public:
    EnrolDialog(AppContext& context, const OpenStudy& study, QWidget* parent);

signals:
    void enrolledAs(const QString& code); ///< emitted before changed()
    /// Emitted if consent is the next step.
    void consentAsked(const chiron::database::Participant& participant);

protected:
    void submit() override;

private:
    void addFields(const psychophysics::Questionnaire& questionnaire);
    void enrolled(const database::Participant& participant);

    database::StudyNumber m_study;
    QLineEdit* m_identity = nullptr;
    QLineEdit* m_account = nullptr;           ///< login name, if the person has one
    std::vector<QuestionnaireForm*> m_fields; ///< the design's questions about a participant
};

} // namespace chiron::desktop
