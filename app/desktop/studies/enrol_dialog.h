// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "desktop/studies/study_store.h"

class QLineEdit;

namespace chiron::desktop {

class QuestionnaireForm;

/// Enrols a participant, with the fields that the design has for it, and shows the code, the only thing that data will know them by. GUI thread.
class EnrolDialog final : public FormDialog {
    Q_OBJECT
public:
    EnrolDialog(AppContext& context, const OpenStudy& study, QWidget* parent);

signals:
    void enrolledAs(const QString& code); ///< before changed()
    void consentAsked(const chiron::database::Participant& participant); ///< as the next step

protected:
    void submit() override;

private:
    void addFields(const psychophysics::Questionnaire& questionnaire);
    void enrolled(const database::Participant& participant);

    database::StudyNumber m_study;
    QLineEdit* m_identity = nullptr;
    QLineEdit* m_account = nullptr; ///< login name, where they have one
    std::vector<QuestionnaireForm*> m_fields; ///< what the design wants to know of a participant
};

} // namespace chiron::desktop
