// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/people/form_dialog.h"
#include "desktop/studies/freeze_checks.h"

class QCheckBox;

namespace chiron::desktop {

class CheckList;

/// What is looked at before a design is frozen, what freezing does and under which SHA-256; and does it. What must be corrected keeps it from being
/// frozen; what is only worth a look takes a word. GUI thread.
class FreezeDialog final : public FormDialog {
    Q_OBJECT
public:
    FreezeDialog(AppContext& context, const database::StudySummary& study, const psychophysics::StudyDesign& design, const FreezeFacts& facts, QWidget* parent);

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
