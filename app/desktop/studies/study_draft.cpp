// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/study_draft.h"

#include "desktop/studies/participant_sentences.h"

#include <QUndoCommand>
#include <utility>

namespace chiron::desktop {

namespace {
constexpr int kStep = 1;
constexpr int kMostSteps = 200;
} // namespace

class StudyDraft::Step final : public QUndoCommand {
public:
    Step(StudyDraft& draft, const QString& words, QString key, psychophysics::StudyDesign before,
         psychophysics::StudyDesign after, bool structure)
        : QUndoCommand(words), m_draft(draft), m_key(std::move(key)), m_before(std::move(before)),
          m_after(std::move(after)), m_structure(structure) {}
    int id() const override { return m_key.isEmpty() ? -1 : kStep; }
    bool mergeWith(const QUndoCommand* other) override {
        const auto& next = static_cast<const Step&>(*other);
        if (next.m_key != m_key || m_structure)
            return false;
        m_after = next.m_after;
        return true;
    }
    void undo() override { m_draft.put(m_before, true); }
    void redo() override { m_draft.put(m_after, m_structure || !m_draft.m_fromForm); }

private:
    StudyDraft& m_draft;
    QString m_key;
    psychophysics::StudyDesign m_before;
    psychophysics::StudyDesign m_after;
    bool m_structure;
};

StudyDraft::StudyDraft(QObject* parent) : QObject(parent) {
    m_history.setUndoLimit(kMostSteps);
}

void StudyDraft::load(psychophysics::StudyDesign design) {
    m_history.clear();
    m_keptNames.clear();
    put(design, true);
}

void StudyDraft::change(const QString& words, const QString& key,
                        const std::function<void(psychophysics::StudyDesign&)>& edit, bool structure) {
    psychophysics::StudyDesign after = m_design;
    edit(after);
    renewInstructions(after); // keeps the participants' text consistent with the settings
    m_fromForm = true;
    m_history.push(new Step(*this, words, key, m_design, std::move(after), structure));
    m_fromForm = false;
}

void StudyDraft::keepName(const std::string& id) {
    m_keptNames.insert(id);
}

void StudyDraft::put(const psychophysics::StudyDesign& design, bool structure) {
    m_design = design;
    ++m_version;
    emit changed();
    if (structure)
        emit structureChanged();
}

} // namespace chiron::desktop
