// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>

namespace chiron::desktop {

/// A design while it is edited: a value, every change of which can be undone. Forms read it once and call change(); after
/// structureChanged() they are built anew. GUI thread.
class StudyDraft final : public QObject {
    Q_OBJECT
public:
    explicit StudyDraft(QObject* parent = nullptr);

    const psychophysics::StudyDesign& design() const noexcept { return m_design; }
    /// A design that was loaded: no step of the history.
    void load(psychophysics::StudyDesign design);
    /// `words` name the step ("Change of the title"); changes of the same `key` one after the other are one step. `structure`: parts came,
    /// went or moved.
    void change(const QString& words, const QString& key, const std::function<void(psychophysics::StudyDesign&)>& edit, bool structure = false);

    QUndoStack& history() noexcept { return m_history; }

signals:
    void changed();          ///< design() is another one
    void structureChanged(); ///< and forms of it are out of date

private:
    class Step;
    void put(const psychophysics::StudyDesign& design, bool structure);

    psychophysics::StudyDesign m_design;
    QUndoStack m_history;
    bool m_fromForm = false; ///< the form shows the change already
};

} // namespace chiron::desktop
