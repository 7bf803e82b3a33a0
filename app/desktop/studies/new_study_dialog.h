// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "psychophysics/study/study_design.h"

#include <set>
#include <vector>

class QButtonGroup;
class QLabel;
class QLineEdit;

namespace chiron::desktop {

/// A study of no template: the smallest one that is complete.
psychophysics::StudyDesign plainStudy();
/// What a copy of a study begins as: all of its design, but nobody's approval, and no pilot of anything.
psychophysics::StudyDesign copyOf(psychophysics::StudyDesign design);

/// Makes a draft of a template, or of another study's design, under a name and a key of its own. GUI thread.
class NewStudyDialog final : public FormDialog {
    Q_OBJECT
public:
    NewStudyDialog(AppContext& context, QWidget* parent);
    NewStudyDialog(AppContext& context, const psychophysics::StudyDesign& copied, QWidget* parent);

signals:
    void created(qlonglong study);

protected:
    void submit() override;

private:
    NewStudyDialog(AppContext& context, const QString& title, QWidget* parent);
    void addNames();
    void loadTemplates();
    void loadTaken();
    void showTemplates(std::vector<psychophysics::StudyDesign> templates);
    QWidget* tile(std::size_t index, bool plain);
    void choose(int index);
    void suggestKey();
    void renew();
    QString keyFault() const;
    QString titleFault() const;
    void showFault(QLineEdit* field, QLabel* words, const QString& fault);
    const psychophysics::StudyDesign* chosen() const;

    QWidget* m_list = nullptr;
    QButtonGroup* m_choice = nullptr; ///< null for a copy
    QLineEdit* m_title = nullptr;
    QLineEdit* m_key = nullptr;
    QLabel* m_titleFault = nullptr;
    QLabel* m_keyFault = nullptr;
    bool m_ownKey = false; ///< typed, not made from the title
    std::set<QString> m_keys, m_titles; ///< of the studies there are
    std::vector<psychophysics::StudyDesign> m_templates;
};

} // namespace chiron::desktop
