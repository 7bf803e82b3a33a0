// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/withdraw_dialog.h"

#include "desktop/studies/study_jobs.h"
#include "desktop/widgets/kit.h"

#include <QCheckBox>

namespace chiron::desktop {

WithdrawDialog::WithdrawDialog(AppContext& context, const database::Participant& participant, QWidget* parent)
    : FormDialog(context, QStringLiteral("withdraw"),
                 tr("Withdraw %1").arg(QString::fromStdString(participant.code)), parent),
      m_participant(participant) {
    const QString code = QString::fromStdString(participant.code);
    const auto say = [this](const char* name, const QString& words) {
        auto* label = kit::label(theme(), words);
        label->setObjectName(QLatin1String(name));
        column()->addWidget(label);
    };
    say("withdraw.when", tr("Withdraw %1 only if they leave the study for good. If they merely stopped for "
                            "today, do not withdraw them: an interrupted run is resumed under Run.")
                             .arg(code));
    say("withdraw.kept",
        tr("What is kept: everything that was recorded, under the code. Nothing is erased, unless "
           "the participant wants it (below)."));
    say("withdraw.counts", tr("What no longer counts: this participant's answers, also those of finished "
                              "runs. They are left out of group values and comparisons."));
    say("withdraw.ends",
        tr("What ends: an open run cannot be resumed, and no other can be started. The place "
           "in the order of conditions is free for the next participant."));
    m_erase = new QCheckBox(tr("The participant wants the recordings erased"));
    m_erase->setObjectName(QStringLiteral("withdraw.erase"));
    m_erase->setFont(theme().font(TextStyle::body));
    column()->addWidget(m_erase);
    column()->addWidget(kit::label(theme(),
                                   tr("The request is recorded, and administrators are told of it. One of "
                                      "them then erases the recordings (People, Erase a participant)."),
                                   TextStyle::small, "muted"));
    column()->addWidget(kit::notice(theme(), "warning", tr("This cannot be undone.")));
    setAccept(tr("Withdraw %1").arg(code), "danger");
    setCancel(tr("Do not withdraw"));
    setAcceptable(true);
    cancelAtEnter();
}

void WithdrawDialog::submit() {
    setWorking(true);
    writeStudies(
        context(), this,
        [id = m_participant.id, erase = m_erase->isChecked()](database::StudyRepository& studies) {
            return studies.withdrawParticipant(id, erase);
        },
        [this](const core::Result<void>& done) {
            setWorking(false);
            if (!done) {
                say("bad", tr("The participant was not withdrawn.\n%1").arg(inWords(done.error())));
                return;
            }
            context().messages().done(
                tr("%1 no longer takes part.").arg(QString::fromStdString(m_participant.code)));
            emit changed();
            accept();
        });
}

} // namespace chiron::desktop
