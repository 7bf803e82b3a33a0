// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/people/form_dialog.h"

class QCheckBox;

namespace chiron::desktop {

/// Withdraws a participant from a study.
/// Thread: GUI.
class WithdrawDialog final : public FormDialog {
    Q_OBJECT
public:
    WithdrawDialog(AppContext& context, const database::Participant& participant, QWidget* parent);

protected:
    void submit() override;

private:
    database::Participant m_participant;
    QCheckBox* m_erase = nullptr;
};

} // namespace chiron::desktop
