// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/enrol_dialog.h"

#include "desktop/accounts/form.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

EnrolDialog::EnrolDialog(AppContext& context, const OpenStudy& study, QWidget* parent)
    : FormDialog(context, QStringLiteral("enrol"), tr("Enrol a participant"), parent), m_study(study.summary.id) {
    const QLocale locale = context.locale();
    column()->addWidget(kit::label(theme(), tr("%1 of %2 planned participants are enrolled.")
                                                .arg(locale.toString(static_cast<int>(study.participants.size())), locale.toString(study.design.participantsPlanned)),
                                   TextStyle::body, "muted"));
    m_identity = form::textField(theme(), column(), tr("Identity (name, number in your own list …)"), QStringLiteral("enrol.identity"));
    column()->addWidget(kit::label(theme(), tr("This is kept only in the key table, which only the study's author and administrators can "
                                               "open. Data and exports carry the code."),
                                   TextStyle::small, "muted"));
    setAccept(tr("Enrol"));
    connect(m_identity, &QLineEdit::textChanged, this, [this] { setAcceptable(!m_identity->text().trimmed().isEmpty()); });
    m_identity->setFocus();
}

void EnrolDialog::submit() {
    setWorking(true);
    writeStudies(
        context(), this,
        [study = m_study, identity = m_identity->text().trimmed().toStdString()](database::StudyRepository& studies) { return studies.enrolParticipant(study, identity, 0, {}); },
        [this](const core::Result<database::Participant>& participant) {
            setWorking(false);
            if (participant)
                enrolled(*participant);
            else
                say("bad", tr("The participant was not enrolled.\n%1").arg(inWords(participant.error())));
        });
}

void EnrolDialog::enrolled(const database::Participant& participant) {
    const kit::Box box = kit::box(theme());
    box.layout->addWidget(kit::label(theme(), tr("The participant's code is"), TextStyle::body));
    auto* code = kit::label(theme(), QString::fromStdString(participant.code), TextStyle::display, "accent");
    code->setObjectName(QStringLiteral("enrol.code"));
    code->setTextInteractionFlags(Qt::TextSelectableByMouse);
    box.layout->addWidget(code);
    box.layout->addWidget(kit::label(theme(), tr("Write it down for the participant, who needs it at every sitting. Consent comes next."), TextStyle::body, "muted"));
    showResult(box.frame);
    emit changed();
}

} // namespace chiron::desktop
