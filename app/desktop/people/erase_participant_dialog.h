// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/people/erasure_dialog.h"
#include "session/withdrawn_participants.h"

class QComboBox;
class QLabel;

namespace chiron::desktop {

/// Erases a participant who has withdrawn from a study: their identity and free answers, and also the
/// recordings if they wished so.
/// Thread: GUI.
class EraseParticipantDialog final : public ErasureDialog {
    Q_OBJECT
public:
    EraseParticipantDialog(AppContext& context, QWidget* parent);

private:
    void load();
    void loaded(core::Result<std::vector<session::WithdrawnParticipant>> withdrawn);
    void renewWords();
    const session::WithdrawnParticipant* chosen() const; ///< null if nobody is waiting to be erased
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
