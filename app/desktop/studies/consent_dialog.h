// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "desktop/studies/study_jobs.h"

class QCheckBox;
class QComboBox;
class QLabel;

namespace chiron::desktop {

/// Shows instructions and consent text for the participant to read and agree to. The consent is stored with
/// the consent text's SHA-256. The dialog covers the window, because the window names conditions.
/// Thread: GUI.
class ConsentDialog final : public FormDialog {
    Q_OBJECT
public:
    ConsentDialog(AppContext& context, const OpenStudy& study, const database::Participant& participant,
                  QWidget* parent);

protected:
    void submit() override;

private:
    void showText();

    psychophysics::StudyDesign m_design;
    psychophysics::StudyText m_texts;
    psychophysics::StudyText m_told; ///< shownInstructions()
    database::Participant m_participant;
    QComboBox* m_language = nullptr;
    QLabel* m_instructions = nullptr;
    QLabel* m_force = nullptr;
    QLabel* m_text = nullptr;
    QCheckBox* m_agreed = nullptr;
};

} // namespace chiron::desktop
