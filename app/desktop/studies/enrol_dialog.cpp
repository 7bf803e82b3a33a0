// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/enrol_dialog.h"

#include "desktop/accounts/form.h"
#include "desktop/questionnaire/questionnaire_form.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QLineEdit>

namespace chiron::desktop {

EnrolDialog::EnrolDialog(AppContext& context, const OpenStudy& study, QWidget* parent)
    : FormDialog(context, QStringLiteral("enrol"), tr("Enrol a participant"), parent),
      m_study(study.summary.id) {
    const QLocale locale = context.locale();
    column()->addWidget(kit::label(theme(),
                                   tr("%1 of %2 planned participants are enrolled.")
                                       .arg(locale.toString(static_cast<int>(study.participants.size())),
                                            locale.toString(study.design.participantsPlanned)),
                                   TextStyle::body, "muted"));
    m_identity = form::textField(theme(), column(), tr("Identity (name, number in your own list …)"),
                                 QStringLiteral("enrol.identity"));
    column()->addWidget(kit::label(
        theme(),
        tr("This is kept only in the key table, which only the study's author and administrators can "
           "open. Data and exports carry the code."),
        TextStyle::small, "muted"));
    m_account = form::textField(theme(), column(),
                                tr("Login name, if the participant has an account here (optional)"),
                                QStringLiteral("enrol.account"));
    column()->addWidget(kit::label(
        theme(),
        tr("With the login name, an export or erasure of this person's data also covers what they do in this "
           "study. The name is kept only in the key table; no list and no export of the study shows it."),
        TextStyle::small, "muted"));
    for (const psychophysics::Questionnaire& questionnaire : study.design.questionnaires)
        if (questionnaire.when == psychophysics::Questionnaire::When::enrolment)
            addFields(questionnaire);
    setAccept(tr("Enrol"));
    const auto weigh = [this] { // one of them must identify the person
        setAcceptable(!m_identity->text().trimmed().isEmpty() || !m_account->text().trimmed().isEmpty(),
                      tr("Enter an identity first, or a login name."));
    };
    for (QLineEdit* field : {m_identity, m_account})
        connect(field, &QLineEdit::textChanged, this, weigh);
    weigh();
    m_identity->setFocus();
}

/// The design's questions about a participant. The answers are stored with the participation under the code,
/// never in the key table.
void EnrolDialog::addFields(const psychophysics::Questionnaire& questionnaire) {
    column()->addWidget(
        kit::label(theme(), study_words::text(questionnaire.title, context().language()), TextStyle::title));
    auto* form = new QuestionnaireForm(theme(), context().locale(), questionnaire, context().language());
    form->setObjectName(QStringLiteral("enrol.fields.%1").arg(QString::fromStdString(questionnaire.id)));
    column()->addWidget(form);
    m_fields.push_back(form);
}

void EnrolDialog::submit() {
    std::vector<database::QuestionnaireAnswer> answers;
    bool missing = false;
    for (QuestionnaireForm* form : m_fields) {
        missing = form->showMissing() || missing;
        const auto given = form->answers(0);
        answers.insert(answers.end(), given.begin(), given.end());
    }
    if (missing)
        return;
    setWorking(true);
    const QString account = m_account->text().trimmed();
    writeStudies(
        context(), this,
        [study = m_study, identity = m_identity->text().trimmed().toStdString(),
         account = account.toStdString(),
         answers](database::StudyRepository& studies) -> core::Result<database::Participant> {
            auto enrolled = account.empty() ? studies.enrolParticipant(study, identity, 0, {})
                                            : studies.enrolAccount(study, identity, account);
            if (!enrolled || answers.empty())
                return enrolled;
            auto theirs = answers;
            for (database::QuestionnaireAnswer& answer : theirs)
                answer.participant = enrolled->id;
            CHIRON_TRY(studies.storeQuestionnaireAnswers(
                theirs)); // everything is one transaction, so nobody is enrolled
            return enrolled;
        },
        [this, account](const core::Result<database::Participant>& participant) {
            setWorking(false);
            if (participant)
                enrolled(*participant);
            else if (!account.isEmpty() && participant.error().code == core::ErrorCode::notFound)
                say("bad", tr("Nobody has an account with the login name “%1”. Nobody was enrolled. Correct "
                              "the name, or leave the field empty.")
                               .arg(account));
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
    box.layout->addWidget(kit::label(
        theme(), tr("Write it down for the participant, who needs it at every session. Consent comes next."),
        TextStyle::body, "muted"));
    auto* consent = kit::button(theme(), tr("Record the consent now"), "primary");
    consent->setObjectName(QStringLiteral("enrol.consent"));
    connect(consent, &QPushButton::clicked, this, [this, participant] {
        accept();
        emit consentAsked(participant);
    });
    box.layout->addWidget(consent, 0, Qt::AlignLeft);
    showResult(box.frame);
    consent->setFocus();
    emit enrolledAs(QString::fromStdString(participant.code));
    emit changed();
}

} // namespace chiron::desktop
