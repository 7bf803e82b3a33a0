// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "psychophysics/study/study_design.h"

class QCheckBox;
class QComboBox;
class QLineEdit;

namespace chiron::desktop {

/// Asks who tries a draft, at which condition, and for their consent; then the trials begin.
/// Thread: GUI.
class PilotDialog final : public FormDialog {
    Q_OBJECT
public:
    PilotDialog(AppContext& context, const psychophysics::StudyDesign& draft, qlonglong study,
                QWidget* parent);

protected:
    void submit() override;

private:
    psychophysics::StudyDesign m_draft;
    qlonglong m_study;
    QComboBox* m_condition = nullptr;
    QLineEdit* m_who = nullptr;
    QCheckBox* m_agreed = nullptr;
    QString m_language; ///< of the displayed consent text
};

} // namespace chiron::desktop
