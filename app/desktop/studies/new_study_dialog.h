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

/// A study of no template: the smallest one that is complete.
psychophysics::StudyDesign plainStudy();
/// What a copy of a study begins as: all of its design, but nobody's approval, and no pilot of anything.
psychophysics::StudyDesign copyOf(psychophysics::StudyDesign design);

/// Makes a draft of a template, or of another study's design, under a name and a key of its own. Templates are found by words, as people are; none is chosen
/// beforehand. Enter in the filter takes the first that is found and goes on to the title; Down goes into the list. GUI thread.
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
    QLabel* m_none = nullptr; ///< no template is found
    QButtonGroup* m_choice = nullptr; ///< null for a copy
    QLineEdit* m_title = nullptr;
    QLineEdit* m_key = nullptr;
    QLabel* m_titleFault = nullptr;
    QLabel* m_keyFault = nullptr;
    bool m_ownTitle = false; ///< typed, not suggested
    bool m_ownKey = false; ///< typed, not made from the title
    std::set<QString> m_keys, m_titles; ///< of the studies there are; titles as titleForComparison() makes them
    std::vector<psychophysics::StudyDesign> m_templates;
    std::vector<QString> m_folded; ///< of each template: its words as forSearch() makes them
};

} // namespace chiron::desktop
