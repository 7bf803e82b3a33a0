// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "desktop/people/form_dialog.h"
#include "psychophysics/study/study_design.h"

namespace chiron::desktop {

/// Says what freezing does and under which SHA-256, and does it. GUI thread.
class FreezeDialog final : public FormDialog {
    Q_OBJECT
public:
    FreezeDialog(AppContext& context, const database::StudySummary& study, const psychophysics::StudyDesign& design, QWidget* parent);

signals:
    void frozen();

protected:
    void submit() override;

private:
    database::StudyNumber m_study;
};

} // namespace chiron::desktop
