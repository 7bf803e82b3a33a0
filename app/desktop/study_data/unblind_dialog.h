// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/people/form_dialog.h"

class QLineEdit;

namespace chiron::desktop {

/// Unseals a study's conditions, for a stated reason, and says how many participants have not finished yet.
/// Thread: GUI.
class UnblindDialog final : public FormDialog {
    Q_OBJECT
public:
    /// `toCome`: the number of participants whose remaining runs would be conducted by somebody who is no
    /// longer blind.
    UnblindDialog(AppContext& context, database::StudyNumber study, int toCome, QWidget* parent);

protected:
    void submit() override;

private:
    database::StudyNumber m_study;
    QLineEdit* m_reason = nullptr;
};

} // namespace chiron::desktop
