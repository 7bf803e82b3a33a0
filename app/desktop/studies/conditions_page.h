// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/study_page.h"

#include <QWidget>

class QVBoxLayout;

namespace chiron::desktop {

/// Edits the conditions of a design, one at a time: the stimuli, the task and the procedures.
/// Thread: GUI.
class ConditionsPage final : public QWidget {
    Q_OBJECT
public:
    ConditionsPage(const DesignPage& page, int shown, QWidget* parent = nullptr);

    int shown() const noexcept { return m_shown; } ///< index of the condition on the page

signals:
    void showAsked(int condition);

private:
    QWidget* sealedBox(); ///< shows codes instead of conditions
    QWidget* sharedBox(); ///< properties that all conditions share
    QString buttonText(const psychophysics::Condition& condition) const;
    QWidget* chooser();
    QWidget* stimulusBox();
    void addNames(FieldGrid& grid);
    bool nameFollowsTitle() const;
    QWidget* instructionsBox();
    void addReference(FieldGrid& grid);
    void showNames(FieldGrid& grid) const;
    void addTask(FieldGrid& grid);
    bool apex() const; ///< the condition on the page is an apex search, which has neither task nor table
    bool hasScale() const;
    QWidget* scaleGrid();
    QWidget* tableBox();
    QWidget* proceduresBox();
    void addCondition();
    void removeCondition();
    void addProcedure();
    const psychophysics::Condition& condition() const;
    void edit(const QString& words, const QString& key,
              const std::function<void(psychophysics::Condition&)>& change, bool structure = false);

    DesignPage m_page;
    int m_shown;
};

} // namespace chiron::desktop
