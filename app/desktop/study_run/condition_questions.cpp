// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_run/condition_questions.h"

#include "database/repositories/study_reader.h"
#include "database/repositories/study_repository.h"
#include "desktop/accounts/notice_area.h"
#include "desktop/frame/app_context.h"
#include "desktop/questionnaire/questionnaire_form.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"

#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

namespace chiron::desktop {

using When = psychophysics::Questionnaire::When;

ConditionQuestions::ConditionQuestions(AppContext& context, const psychophysics::StudyDesign& design,
                                       const About& about, QWidget* parent)
    : QWidget(parent), m_context(context), m_about(about) {
    std::copy_if(design.questionnaires.begin(), design.questionnaires.end(), std::back_inserter(m_left),
                 [](const psychophysics::Questionnaire& each) { return each.when == When::afterCondition; });
    m_column = new QVBoxLayout(this);
    m_column->setContentsMargins(0, 0, 0, 0);
    showNext();
}

bool ConditionQuestions::areIn(const psychophysics::StudyDesign& design) {
    return std::any_of(
        design.questionnaires.begin(), design.questionnaires.end(),
        [](const psychophysics::Questionnaire& each) { return each.when == When::afterCondition; });
}

void ConditionQuestions::showNext() {
    if (m_page) {
        m_column->removeWidget(m_page);
        m_page->hide();
        m_page->deleteLater();
        m_page = nullptr;
    }
    if (m_left.empty()) {
        emit answered();
        return;
    }
    const Theme& theme = m_context.theme();
    const psychophysics::Questionnaire& asked = m_left.front();
    auto* page = new ScrollPage(theme, 820);
    page->column()->addWidget(
        kit::label(theme, study_words::text(asked.title, m_context.language()), TextStyle::heading));
    page->column()->addWidget(kit::label(
        theme, tr("Please answer about the part that you have just finished, and about nothing else."),
        TextStyle::body, "muted"));
    m_form = new QuestionnaireForm(theme, m_context.locale(), asked, m_context.language());
    page->column()->addWidget(m_form);
    m_notice = new NoticeArea(theme);
    page->column()->addWidget(m_notice);
    m_submit = kit::button(theme, tr("Submit"), "primary", QStringLiteral("dialog-ok-apply"));
    m_submit->setObjectName(QStringLiteral("questions.submit"));
    connect(m_submit, &QPushButton::clicked, this, &ConditionQuestions::submit);
    page->column()->addWidget(m_submit, 0, Qt::AlignLeft);
    page->column()->addStretch();
    m_page = page;
    m_column->addWidget(page);
}

void ConditionQuestions::submit() {
    if (m_form->showMissing())
        return;
    m_submit->setEnabled(false);
    m_context.background().run(
        this,
        [&database = m_context.site().database(), actor = m_context.actor(), about = m_about,
         answers = m_form->answers(0, m_about.run)](WorkToken&) {
            return database.write([&](database::WriteContext& writing) -> core::Result<void> {
                const auto who = database::StudyReader(writing.connection(), actor)
                                     .participantByCode(about.study, about.participant.toStdString());
                CHIRON_TRY(who);
                auto theirs = answers;
                for (database::QuestionnaireAnswer& answer : theirs)
                    answer.participant = who->id;
                return database::StudyRepository(writing.connection(), actor)
                    .storeQuestionnaireAnswers(theirs);
            });
        },
        [this](const core::Result<void>& done) {
            m_submit->setEnabled(true);
            if (!done) {
                m_notice->say("bad", tr("The answers were not stored. They are still on this page: press "
                                        "Submit again, and call the experimenter if that does not help.\n%1")
                                         .arg(inWords(done.error())));
                return;
            }
            m_left.erase(m_left.begin());
            showNext();
        });
}

} // namespace chiron::desktop
