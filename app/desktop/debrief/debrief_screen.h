// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/debrief/debrief_data.h"
#include "desktop/debrief/verdict.h"
#include "desktop/frame/screen.h"
#include "desktop/playback/moment_words.h"
#include "desktop/training/training_plan.h"

#include <memory>
#include <optional>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace chiron::desktop {

class StatePanel;
class WorkToken;

/// What a session came to: passed or not and why, at most three numbers, the worst moment one click away, every metric below.
/// Place: {session}. The scores are shown as soon as they are read; what needs the recording follows. GUI thread.
class DebriefScreen final : public Screen {
    Q_OBJECT
public:
    DebriefScreen(AppContext& context, const Place& place);
    ~DebriefScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

    /// Writes the printable report; tells where it is, or why not.
    void writeReport(const QString& path);

private:
    database::SessionId sessionId() const;
    void load();
    void showHead(DebriefHead head);
    void focusNextStep();
    void loadDetails();
    void showDetails(const DebriefDetails& details);
    void showWorst(const session::WorstMoment& worst);
    void showForce(const report::ForceFacts& force);
    void showComments(const std::vector<CommentAtMoment>& comments, const MomentWords& moments);
    QWidget* replyButton(const database::SessionComment& comment); ///< null: it is not for this person to answer
    void showNoDetails(const core::Error& error);
    QWidget* headBox();
    QWidget* verdictBox();
    QWidget* decisionsBox(); ///< null where nothing was decided and taken back
    QWidget* actionRow();
    QWidget* headlineRow(); ///< null where nothing is judged
    QWidget* forceBox();
    QWidget* answersBox();
    void askReport();
    void openPlayback(QVariantMap at = {});
    void openWorst(); ///< some seconds before it, to see how it came about
    void openComment(double at_s, const QString& words);
    void openSetup(int level);
    void openResults();
    std::vector<MetricAdvice> adviceNow() const; ///< of the exercise, in the person's language
    bool isMine() const;
    bool mayTryNow() const;       ///< a script has shown this person how it is done
    std::optional<TrainingPlan> demonstration() const; ///< of this level
    bool hasNextLevel() const;

    StatePanel* m_panel = nullptr;
    QVBoxLayout* m_column = nullptr; ///< of the page inside m_panel
    StatePanel* m_answers = nullptr;
    QLabel* m_force = nullptr;  ///< what was felt of what the tissue answered
    QLabel* m_beyond = nullptr; ///< that the law was left
    QPushButton* m_worst = nullptr;
    QVBoxLayout* m_comments = nullptr; ///< where m_commentBox is
    QWidget* m_commentBox = nullptr;   ///< what was written about the session; null: nothing
    QLabel* m_worstText = nullptr; ///< what was worst, and where
    QPushButton* m_report = nullptr;
    std::optional<DebriefHead> m_head;
    std::optional<session::WorstMoment> m_worstMoment;
    std::shared_ptr<WorkToken> m_work;
};

} // namespace chiron::desktop
