// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/erasure_dialog.h"
#include "session/withdrawn_participants.h"

class QComboBox;
class QLabel;

namespace chiron::desktop {

/// Erases a participant of a study who has withdrawn: who they were and their free answers, and the recordings where they wished so. GUI thread.
class EraseParticipantDialog final : public ErasureDialog {
    Q_OBJECT
public:
    EraseParticipantDialog(AppContext& context, QWidget* parent);

private:
    void load();
    void loaded(core::Result<std::vector<session::WithdrawnParticipant>> withdrawn);
    void renewWords();
    const session::WithdrawnParticipant* chosen() const; ///< null: nobody waits
    bool isChosen() const override { return chosen() != nullptr; }
    QString whom() const override;
    Erasure erasure() const override;
    QString doneWords() const override;
    QString cannotWords() const override;

    std::vector<session::WithdrawnParticipant> m_withdrawn;
    QComboBox* m_who;
    QLabel* m_words;
};

} // namespace chiron::desktop
