// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/people/form_dialog.h"
#include "desktop/studies/freeze_checks.h"

class QCheckBox;

namespace chiron::desktop {

class CheckList;

/// Shows the checks, explains what freezing does and under which SHA-256, and freezes the design. An error
/// prevents freezing; advice only has to be confirmed.
/// Thread: GUI.
class FreezeDialog final : public FormDialog {
    Q_OBJECT
public:
    FreezeDialog(AppContext& context, const database::StudySummary& study,
                 const psychophysics::StudyDesign& design, const FreezeFacts& facts, QWidget* parent);

signals:
    void frozen();
    void goAsked(const chiron::desktop::FreezeCheck& check);

protected:
    void submit() override;

private:
    void weigh();

    database::StudyNumber m_study;
    CheckList* m_checks = nullptr;
    QCheckBox* m_seen = nullptr;
    QWidget* m_cannot = nullptr;
};

} // namespace chiron::desktop
