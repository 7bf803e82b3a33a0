// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/debrief/debrief_data.h"
#include "desktop/debrief/verdict.h"
#include "desktop/frame/screen.h"
#include "desktop/playback/moment_words.h"
#include "desktop/training/training_plan.h"

#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

class StatePanel;
class WorkToken;

/// Shows the result of a session: passed or not and why, at most three main numbers, a link to the worst
/// moment, and all metrics below. The place is {session}. The scores appear as soon as they are read; what
/// needs the recording follows.
/// Thread: GUI.
class DebriefScreen final : public Screen {
    Q_OBJECT
public:
    DebriefScreen(AppContext& context, const Place& place);
    ~DebriefScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

    /// Writes the printable report and says where it is, or why it could not be written.
    void writeReport(const QString& path);

private:
    database::SessionId sessionId() const;
    void load();
    void showHead(DebriefHead head);
    void focusNextStep();
    void loadDetails();
    void showDetails(const DebriefDetails& details);
    void showWorst(const session::WorstMoment& worst);
    void completeAdvice(const std::vector<session::WorstMoment>& missed);
    void showForce(const report::ForceFacts& force);
    void showComments(const std::vector<CommentAtMoment>& comments, const MomentWords& moments);
    QWidget* replyButton(const database::SessionComment& comment); ///< null if this person may not reply
    void showNoDetails(const core::Error& error);
    QWidget* headBox();
    QWidget* verdictBox();
    void addAdvice(const MetricAdvice& advice, QVBoxLayout& words);
    QWidget* practiceButton(const catalogue::ExerciseLevel& level);
    /// Where the metric is practised; null if the session is not one's own or no lower level judges it.
    const catalogue::ExerciseLevel* practisedAt(const MetricAdvice& advice) const;
    QWidget* decisionsBox(); ///< null if the session was never voided or counted again
    QWidget* actionRow();
    QWidget* headlineRow(); ///< null if no metric is judged
    QWidget* forceBox();
    QWidget* answersBox();
    void askReport();
    void openPlayback(QVariantMap at = {});
    void openWorst(); ///< opens the playback some seconds before the worst moment
    void openComment(double at_s, const QString& words);
    void openSetup(int level);
    void openResults();
    std::vector<MetricAdvice> adviceNow() const; ///< from the exercise, in the person's language
    /// The line with the advice on a missed pass mark.
    struct AdviceLine {
        MetricAdvice advice;
        QLabel* label = nullptr;
    };
    bool isMine() const;
    bool mayTryNow() const; ///< true for a scripted demonstration: the viewer may try it now
    std::optional<TrainingPlan> demonstration() const; ///< the plan of a demonstration of this level
    bool hasNextLevel() const;

    StatePanel* m_panel = nullptr;
    QVBoxLayout* m_column = nullptr; ///< column of the page inside m_panel
    StatePanel* m_answers = nullptr;
    QLabel* m_force = nullptr;  ///< share of the tissue's force that was felt
    QLabel* m_beyond = nullptr; ///< warns that the force law left its valid range
    QPushButton* m_worst = nullptr;
    QVBoxLayout* m_comments = nullptr; ///< the column that contains m_commentBox
    QWidget* m_commentBox = nullptr;   ///< the comments on the session; null if there are none
    std::vector<AdviceLine> m_advice;  ///< one per missed pass mark
    QLabel* m_worstText = nullptr;     ///< describes the worst moment and where it is
    QPushButton* m_report = nullptr;
    std::optional<DebriefHead> m_head;
    std::optional<session::WorstMoment> m_worstMoment;
    std::shared_ptr<WorkToken> m_work;
};

} // namespace chiron::desktop
