// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/study_types.h"
#include "psychophysics/study/study_design.h"

#include <QWidget>
#include <vector>

class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

class AppContext;
class NoticeArea;
class QuestionnaireForm;

/// What a participant is asked after a condition, on their own page: the questionnaires of it one after the other, each stored as it is submitted.
/// No name or value of a condition is in it. GUI thread.
class ConditionQuestions final : public QWidget {
    Q_OBJECT
public:
    /// The run that was completed, and whose it is.
    struct About {
        database::StudyNumber study = 0;
        QString participant; ///< code
        database::StudyRunNumber run = 0;
    };
    ConditionQuestions(AppContext& context, const psychophysics::StudyDesign& design, const About& about, QWidget* parent = nullptr);

    /// Whether the design asks anything after each condition.
    static bool areIn(const psychophysics::StudyDesign& design);

signals:
    void answered(); ///< all of them

private:
    void showNext();
    void submit();

    AppContext& m_context;
    About m_about;
    std::vector<psychophysics::Questionnaire> m_left; ///< the first is shown
    QVBoxLayout* m_column = nullptr;
    QWidget* m_page = nullptr;
    QuestionnaireForm* m_form = nullptr;
    NoticeArea* m_notice = nullptr;
    QPushButton* m_submit = nullptr;
};

} // namespace chiron::desktop
