// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/study/study_design.h"

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>
#include <set>
#include <string>

namespace chiron::desktop {

/// A design while it is edited. It is a value, and every change can be undone. Forms read it once and call
/// change(); after structureChanged() they are rebuilt.
/// Thread: GUI.
class StudyDraft final : public QObject {
    Q_OBJECT
public:
    explicit StudyDraft(QObject* parent = nullptr);

    const psychophysics::StudyDesign& design() const noexcept { return m_design; }
    /// Sets a loaded design. This is not a step of the history.
    void load(psychophysics::StudyDesign design);
    /// `words` names the step ("Change of the title"). Consecutive changes with the same `key` form one step.
    /// `structure`: parts were added, removed or moved.
    void change(const QString& words, const QString& key,
                const std::function<void(psychophysics::StudyDesign&)>& edit, bool structure = false);

    QUndoStack& history() noexcept { return m_history; }
    /// Counts every change of design(), also by Undo and Redo: a later step can be told from an earlier one.
    int version() const noexcept { return m_version; }

    /// Names that somebody typed while this design is open: titles, and short names of conditions. They no
    /// longer follow a title or a setting.
    void keepName(const std::string& id);
    bool isKeptName(const std::string& id) const { return m_keptNames.contains(id); }

signals:
    void changed();          ///< design() has changed
    void structureChanged(); ///< forms of the design must be rebuilt

private:
    class Step;
    void put(const psychophysics::StudyDesign& design, bool structure);

    psychophysics::StudyDesign m_design;
    QUndoStack m_history;
    std::set<std::string> m_keptNames;
    int m_version = 0;
    bool m_fromForm = false; ///< the form already shows the change
};

} // namespace chiron::desktop
