// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/form_dialog.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <set>
#include <vector>

class QButtonGroup;
class QLabel;
class QLineEdit;

namespace chiron::desktop {

/// The smallest complete study with this task, for a start without a template.
psychophysics::StudyDesign plainStudy(psychophysics::Task task = psychophysics::Task::rank3);
/// The initial state of a copy: the whole design, but without ethics approval and pilots.
psychophysics::StudyDesign copyOf(psychophysics::StudyDesign design);

/// Creates a draft from a template, or from another study's design, with its own title and key. Templates can
/// be searched by words, like people; none is selected initially. A template that is selected leads to the
/// title, to be typed over. Enter in the filter selects the first match; Down moves into the list.
/// Thread: GUI.
class NewStudyDialog final : public FormDialog {
    Q_OBJECT
public:
    NewStudyDialog(AppContext& context, QWidget* parent);
    NewStudyDialog(AppContext& context, const psychophysics::StudyDesign& copied, QWidget* parent);

signals:
    void created(qlonglong study);

protected:
    void submit() override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    NewStudyDialog(AppContext& context, const QString& title, QWidget* parent);
    void addTemplates();
    void addNames();
    void loadTemplates();
    void loadTaken();
    void showTemplates(std::vector<psychophysics::StudyDesign> templates);
    QWidget* tile(std::size_t index, bool plain);
    void choose(int index);
    void filter();
    bool isFound(int index) const;
    std::optional<int> firstFound() const;
    void suggestTitle();
    void suggestKey();
    void renew();
    QString keyFault() const;
    QString titleFault() const;
    void showFault(QLineEdit* field, QLabel* words, const QString& fault);
    const psychophysics::StudyDesign* chosen() const;

    QLineEdit* m_filter = nullptr; ///< null for a copy
    QWidget* m_list = nullptr;
    QLabel* m_none = nullptr;         ///< shown if no template matches
    QButtonGroup* m_choice = nullptr; ///< null for a copy
    QLineEdit* m_title = nullptr;
    QLineEdit* m_key = nullptr;
    QLabel* m_titleFault = nullptr;
    QLabel* m_keyFault = nullptr;
    bool m_ownTitle = false; ///< typed, not suggested
    bool m_ownKey = false;   ///< typed, not derived from the title
    /// Of the existing studies; titles as titleForComparison() returns them.
    std::set<QString> m_keys, m_titles;
    std::vector<psychophysics::StudyDesign> m_templates;
    std::vector<QString> m_folded; ///< per template: its text as forSearch() returns it
};

} // namespace chiron::desktop
