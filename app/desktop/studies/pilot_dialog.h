// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "psychophysics/study/study_design.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace chiron::desktop {

/// Who tries a draft, at which condition, and that they agree; then its trials begin. GUI thread.
class PilotDialog final : public FormDialog {
    Q_OBJECT
public:
    PilotDialog(AppContext& context, const psychophysics::StudyDesign& draft, qlonglong study, QWidget* parent);

protected:
    void submit() override;

private:
    psychophysics::StudyDesign m_draft;
    qlonglong m_study;
    QComboBox* m_condition = nullptr;
    QLineEdit* m_who = nullptr;
    QCheckBox* m_agreed = nullptr;
    QString m_language; ///< of the consent text that is shown
};

} // namespace chiron::desktop
