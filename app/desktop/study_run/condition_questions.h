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

/// Asks the participant, on their own page, the questionnaires that follow a condition, one after the other.
/// Each is stored when it is submitted. It contains no name or value of a condition.
/// Thread: GUI.
class ConditionQuestions final : public QWidget {
    Q_OBJECT
public:
    /// The completed run and its participant.
    struct About {
        database::StudyNumber study = 0;
        QString participant; ///< code
        database::StudyRunNumber run = 0;
    };
    ConditionQuestions(AppContext& context, const psychophysics::StudyDesign& design, const About& about,
                       QWidget* parent = nullptr);

    /// Whether the design contains questionnaires to ask after each condition.
    static bool areIn(const psychophysics::StudyDesign& design);

signals:
    void answered(); ///< all questionnaires are answered

private:
    void showNext();
    void submit();

    AppContext& m_context;
    About m_about;
    std::vector<psychophysics::Questionnaire> m_left; ///< the first one is shown
    QVBoxLayout* m_column = nullptr;
    QWidget* m_page = nullptr;
    QuestionnaireForm* m_form = nullptr;
    NoticeArea* m_notice = nullptr;
    QPushButton* m_submit = nullptr;
};

} // namespace chiron::desktop
