// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "psychophysics/study/study_design.h"

#include <vector>

class QButtonGroup;
class QLineEdit;

namespace chiron::desktop {

/// A study to begin with: the program's templates, or the smallest one that is complete.
psychophysics::StudyDesign plainStudy();

/// Makes a draft from a template, under a name and a key of its own. GUI thread.
class NewStudyDialog final : public FormDialog {
    Q_OBJECT
public:
    NewStudyDialog(AppContext& context, QWidget* parent);

signals:
    void created(qlonglong study);

protected:
    void submit() override;

private:
    void loadTemplates();
    void showTemplates(std::vector<psychophysics::StudyDesign> templates);
    void choose(int index);
    void renew();

    QWidget* m_list = nullptr;
    QButtonGroup* m_choice = nullptr;
    QLineEdit* m_title = nullptr;
    QLineEdit* m_key = nullptr;
    std::vector<psychophysics::StudyDesign> m_templates;
};

} // namespace chiron::desktop
