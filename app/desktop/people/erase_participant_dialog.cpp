// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/erase_participant_dialog.h"

#include "desktop/accounts/form.h"
#include "desktop/frame/app_context.h"
#include "desktop/studies/study_jobs.h"
#include "desktop/widgets/kit.h"

#include <QComboBox>
#include <QLineEdit>

namespace chiron::desktop {

EraseParticipantDialog::EraseParticipantDialog(AppContext& context, QWidget* parent)
    : ErasureDialog(context, QStringLiteral("erase_participant"), tr("Erase a study participant"), parent) {
    column()->addWidget(kit::notice(theme(), "bad", tr("This cannot be undone.")));
    auto* which =
        kit::label(theme(),
                   tr("This erases the identity behind the code in one study; if the same person has "
                      "an account, it stays. To erase an account, choose the person in the list and "
                      "press \"Erase\"."),
                   TextStyle::body, "muted");
    which->setObjectName(QStringLiteral("erase_participant.which"));
    column()->addWidget(which);
    column()->addWidget(kit::label(theme(), tr("Participant who has withdrawn"), TextStyle::label));
    m_who = new QComboBox;
    m_who->setObjectName(QStringLiteral("erase_participant.who"));
    m_who->setAccessibleName(tr("Participant who has withdrawn"));
    column()->addWidget(m_who);
    m_words = kit::label(theme(), tr("Reading the studies …"), TextStyle::body);
    m_words->setObjectName(QStringLiteral("erase_participant.words"));
    column()->addWidget(m_words);
    addReason();
    addPassword();
    connect(m_who, &QComboBox::currentIndexChanged, this, &EraseParticipantDialog::renewWords);
    m_who->setEnabled(false);
    load();
}

void EraseParticipantDialog::load() {
    readStudies(
        context(), this, [](database::StudyReader& reader) { return session::withdrawnParticipants(reader); },
        [this](core::Result<std::vector<session::WithdrawnParticipant>> withdrawn) {
            loaded(std::move(withdrawn));
        });
}

void EraseParticipantDialog::loaded(core::Result<std::vector<session::WithdrawnParticipant>> withdrawn) {
    if (!withdrawn) {
        m_words->setText(
            tr("The studies could not be read.\n%1").arg(inWords(withdrawn.error(), Tried::reading)));
        return;
    }
    m_withdrawn = *std::move(withdrawn);
    for (const session::WithdrawnParticipant& each : m_withdrawn)
        m_who->addItem(tr("%1, %2").arg(QString::fromStdString(each.participant.code),
                                        QString::fromStdString(each.studyTitle)));
    m_who->setEnabled(!m_withdrawn.empty());
    renewWords();
    if (!m_withdrawn.empty())
        m_who->setFocus();
}

void EraseParticipantDialog::renewWords() {
    const session::WithdrawnParticipant* who = chosen();
    m_words->setText(!who ? tr("No participant who has withdrawn is waiting to be erased. Researchers "
                               "withdraw a participant on the study's Run screen.")
                     : who->participant.recordingsToErase
                         ? tr("Overwritten: who the participant was, the answers to questionnaires, comments "
                              "on their sessions and, as the participant "
                              "wished, the recordings. Kept under the code: runs and trials.")
                         : tr("Overwritten: who the participant was, the answers to questionnaires and "
                              "comments on their sessions. Kept under the code: "
                              "runs, trials and recordings; the participant did not ask for the recordings "
                              "to be erased."));
    renew();
}

const session::WithdrawnParticipant* EraseParticipantDialog::chosen() const {
    const int row = m_who->currentIndex();
    return row >= 0 && row < static_cast<int>(m_withdrawn.size())
               ? &m_withdrawn[static_cast<std::size_t>(row)]
               : nullptr;
}

QString EraseParticipantDialog::whom() const {
    return chosen() ? QString::fromStdString(chosen()->participant.code) : QString();
}

ErasureDialog::Erasure EraseParticipantDialog::erasure() const {
    return [id = chosen()->participant.id](database::AccountService& accounts, const database::Actor& actor,
                                           const std::string& password, const std::string& reason) {
        return accounts.eraseParticipant(actor, password, id, reason);
    };
}

QString EraseParticipantDialog::doneWords() const {
    return tr("%1 was erased. Runs and trials are kept under the code.").arg(whom());
}

QString EraseParticipantDialog::cannotWords() const {
    return tr("%1 cannot be erased now: no session of the participant may be running.").arg(whom());
}

} // namespace chiron::desktop
