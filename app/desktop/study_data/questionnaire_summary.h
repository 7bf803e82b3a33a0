// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/study_data/study_facts.h"

#include <QWidget>

namespace chiron::desktop {

/// Summarises the answers question by question: distribution and centre of scales and numbers, counts of
/// choices, free texts.
/// Thread: GUI.
class QuestionnaireSummary final : public QWidget {
    Q_OBJECT
public:
    QuestionnaireSummary(AppContext& app, const StudyFacts& facts, QWidget* parent = nullptr);

private:
    QWidget* questionnaireBox(const psychophysics::Questionnaire& questionnaire) const;
    QString scoreName(const std::string& id, const psychophysics::Questionnaire& questionnaire) const;
    /// `answers`: all answers to this questionnaire, of one condition if it is asked after each.
    QStringList scoreLines(const psychophysics::Questionnaire& questionnaire,
                           const std::vector<database::QuestionnaireAnswer>& answers) const;
    QWidget* itemPart(const psychophysics::QuestionnaireItem& item,
                      const std::vector<database::QuestionnaireAnswer>& answers) const;
    QWidget* barsOf(const psychophysics::QuestionnaireItem& item, const std::vector<double>& numbers) const;

    AppContext& m_app;
    const StudyFacts& m_facts;
};

} // namespace chiron::desktop
