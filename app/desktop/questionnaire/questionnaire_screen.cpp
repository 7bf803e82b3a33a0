// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/questionnaire/questionnaire_screen.h"

#include "desktop/accounts/notice_area.h"
#include "desktop/questionnaire/questionnaire_form.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QMessageBox>

namespace chiron::desktop {

QuestionnaireScreen::QuestionnaireScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_study(place.parameters.value(QStringLiteral("study")).toLongLong()),
      m_code(place.parameters.value(QStringLiteral("participant")).toString()),
      m_questionnaire(place.parameters.value(QStringLiteral("questionnaire")).toString().toStdString()),
      m_run(place.parameters.value(QStringLiteral("run")).toLongLong()) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    m_panel = new StatePanel(context.theme());
    column->addWidget(m_panel);
}

QString QuestionnaireScreen::title() const {
    return tr("Questionnaire");
}

QString QuestionnaireScreen::help() const {
    return tr("Each participant answers these questions once, or once about each condition.\n\nPress Tab to "
              "move from question to question, the arrow keys to move along "
              "a scale, Space to choose. Required questions are marked if they are left unanswered. The "
              "answers are stored under the "
              "participant's code as soon as they are submitted.");
}

void QuestionnaireScreen::enter() {
    load();
}

void QuestionnaireScreen::load() {
    m_panel->showLoading(
        tr("Reading the questions …"),
        readStudies(
            context(), this,
            [study = m_study](database::StudyReader& reader) { return openStudy(reader, study); },
            [this](const core::Result<OpenStudy>& study) { loaded(study); }));
}

void QuestionnaireScreen::loaded(const core::Result<OpenStudy>& study) {
    if (!study) {
        m_panel->showError(tr("The questionnaire could not be read"), study.error(), [this] { load(); });
        return;
    }
    for (const ParticipantRow& row : study->participants)
        if (QString::fromStdString(row.participant.code) == m_code)
            m_participant = row.participant.id;
    for (const psychophysics::Questionnaire& questionnaire : study->design.questionnaires)
        if (m_participant != 0 && questionnaire.id == m_questionnaire) {
            if (m_run != 0 ? study->answeredAfter.contains({m_run, m_questionnaire})
                           : study->answered.contains({m_participant, m_questionnaire}))
                m_panel->showEmpty(tr("Already answered"),
                                   m_run != 0 ? tr("Each participant answers it once about each condition.")
                                              : tr("Each participant answers a questionnaire once."),
                                   tr("Back"), [this] { goBack(); });
            else
                build(questionnaire);
            return;
        }
    m_panel->showError(tr("This questionnaire does not exist"),
                       {core::ErrorCode::notFound, m_code.toStdString() + ", " + m_questionnaire});
}

void QuestionnaireScreen::build(const psychophysics::Questionnaire& questionnaire) {
    const Theme& theme = context().theme();
    auto* page = new ScrollPage(theme, 820);
    page->column()->addWidget(
        kit::label(theme, study_words::text(questionnaire.title, context().language()), TextStyle::heading));
    page->column()->addWidget(kit::label(theme, tr("Participant %1").arg(m_code), TextStyle::body, "muted"));
    m_form = new QuestionnaireForm(theme, context().locale(), questionnaire, context().language());
    page->column()->addWidget(m_form);
    m_notice = new NoticeArea(theme);
    page->column()->addWidget(m_notice);
    m_submit = kit::button(theme, tr("Submit"), "primary", QStringLiteral("dialog-ok-apply"));
    m_submit->setObjectName(QStringLiteral("questionnaire.submit"));
    connect(m_submit, &QPushButton::clicked, this, &QuestionnaireScreen::submit);
    page->column()->addWidget(m_submit, 0, Qt::AlignLeft);
    page->column()->addStretch();
    m_panel->setContent(page);
    m_panel->showContent();
}

void QuestionnaireScreen::submit() {
    if (m_form->showMissing())
        return;
    m_submit->setEnabled(false);
    writeStudies(
        context(), this,
        [answers = m_form->answers(m_participant, m_run)](database::StudyRepository& studies) {
            return studies.storeQuestionnaireAnswers(answers);
        },
        [this](const core::Result<void>& done) {
            m_submit->setEnabled(true);
            if (!done) {
                m_notice->say("bad", tr("The answers were not stored. They are still on this page: press "
                                        "Submit again, and call the experimenter if that does not help.\n%1")
                                         .arg(inWords(done.error())));
                return;
            }
            m_stored = true;
            context().messages().done(tr("Thank you. The answers are stored."));
            goBack();
        });
}

bool QuestionnaireScreen::mayLeave() {
    if (m_stored || !m_form || m_form->answered() == 0)
        return true;
    QMessageBox box(QMessageBox::Question, title(), tr("Leave without submitting?"), QMessageBox::NoButton,
                    window());
    box.setInformativeText(tr("The answers on this page are not stored yet."));
    QPushButton* stay = box.addButton(tr("Stay"), QMessageBox::RejectRole);
    QPushButton* leave = box.addButton(tr("Leave"), QMessageBox::DestructiveRole);
    box.setDefaultButton(stay);
    box.exec();
    return box.clickedButton() == leave;
}

void QuestionnaireScreen::goBack() {
    context().navigator().replace({QStringLiteral("study_run"),
                                   {{QStringLiteral("study"), qlonglong(m_study)},
                                    {QStringLiteral("participant"), m_code},
                                    {QStringLiteral("just_ran"), true}}});
}

} // namespace chiron::desktop
