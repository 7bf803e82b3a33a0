// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "desktop/studies/study_store.h"

class QLineEdit;

namespace chiron::desktop {

/// Enrols a participant and shows the code, the only thing that data will know them by. GUI thread.
class EnrolDialog final : public FormDialog {
    Q_OBJECT
public:
    EnrolDialog(AppContext& context, const OpenStudy& study, QWidget* parent);

protected:
    void submit() override;

private:
    void enrolled(const database::Participant& participant);

    database::StudyNumber m_study;
    QLineEdit* m_identity = nullptr;
};

} // namespace chiron::desktop
