// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "desktop/studies/study_store.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace chiron::desktop {

/// Instructions and consent text, read by the participant and agreed to; recorded with the consent text's SHA-256. It covers the window, which
/// names conditions. GUI thread.
class ConsentDialog final : public FormDialog {
    Q_OBJECT
public:
    ConsentDialog(AppContext& context, const OpenStudy& study, const database::Participant& participant, QWidget* parent);

protected:
    void submit() override;

private:
    void showText();

    psychophysics::StudyText m_texts;
    psychophysics::StudyText m_told; ///< the instructions
    database::Participant m_participant;
    QComboBox* m_language = nullptr;
    QLabel* m_instructions = nullptr;
    QLabel* m_text = nullptr;
    QCheckBox* m_agreed = nullptr;
};

} // namespace chiron::desktop
