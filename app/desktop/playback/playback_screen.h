// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/playback/moment_words.h"
#include "desktop/playback/playback_clock.h"
#include "desktop/playback/playback_data.h"
#include "desktop/scene3d/scene_note.h"

#include <memory>
#include <optional>

class QCheckBox;
class QTabWidget;
class QComboBox;
class QLabel;
class QVBoxLayout;

namespace chiron::database {
class SessionRepository;
}

namespace chiron::scene3d {
class ISceneView;
}

namespace chiron::desktop {

class CommentPanel;
class PlaybackPlots;
class Scrubber;
class StatePanel;
class WorkToken;

/// Plays a stored session back: scene, scrubber, force and speed under one cursor, events, comments on
/// moments, and a second session as a ghost. Trainers void a session here, or count it again. The place is
/// {session, at_s, ghost}, plus a caption with its moment: {caption, caption_s}, or {caption, at_tick} for
/// the executed tick that a comment belongs to. {reply} names a comment to answer.
/// Thread: GUI.
class PlaybackScreen final : public Screen {
    Q_OBJECT
public:
    PlaybackScreen(AppContext& context, const Place& place);
    ~PlaybackScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;

    PlaybackClock& clock() noexcept { return m_clock; }
    /// The caption in the scene at this time for a person who followed a link here (place {caption,
    /// caption_s}): one line, visible for as long as it takes to read.
    scene3d::SceneNote captionAt(double t_s) const;
    /// Stores the session as void and reports the result. The data layer decides whether that is permitted.
    void declareVoid(const QString& reason);
    void countAgain(const QString& reason); ///< reverses declareVoid(), with the same checks

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    database::SessionId sessionId() const;
    void load();
    void showData(PlaybackData loaded);
    void build();
    QWidget* headBox();
    QWidget* stageColumn();
    QWidget* sideColumn();
    QWidget* ghostBox();
    QWidget* readoutRow();
    QWidget* switchRow(); ///< null if the layer has no such switches
    QCheckBox* switchBox(const PlaybackSwitch& of);
    scene3d::SceneSetup sceneSetup() const;
    void makeScene();
    void fitScene();
    void showMoment(double t_s);
    void notePlace();
    bool handleKey(QKeyEvent* event);
    void seekMark(int direction);
    void zoomPlots(int key);

    void loadGhosts();
    void showGhosts(const std::vector<GhostCandidate>& candidates);
    void chooseGhost();
    void showGhost(PlaybackData ghost);

    void loadComments();
    void answerAsked();  ///< for a place that names a comment
    void writeComment(); ///< at the moment shown: pauses the clock and focuses the field
    void addComment(const QString& text, std::optional<std::uint64_t> tick);
    MomentWords momentWords() const;
    void askDecision(); ///< to void the session, or to count a voided one again
    void decide(core::Result<void> (database::SessionRepository::*decision)(database::SessionId,
                                                                            const std::string&),
                const QString& reason, const QString& done, const QString& failed);
    void openResults();
    void readMoment(); ///< from the place, in seconds or as an executed tick

    PlaybackClock m_clock;
    StatePanel* m_panel = nullptr;
    std::optional<PlaybackData> m_data;
    double m_moment_s = -1.0;         ///< moment that a link led to; negative if none
    std::optional<double> m_stopAt_s; ///< playing pauses here once
    std::optional<session::PlaybackTrack> m_ghost;
    std::shared_ptr<WorkToken> m_work;
    std::shared_ptr<WorkToken> m_ghostWork;
    QWidget* m_sceneFrame = nullptr;
    QVBoxLayout* m_sceneHolder = nullptr;
    std::unique_ptr<scene3d::ISceneView> m_scene;
    QLabel* m_readout = nullptr;
    Scrubber* m_scrubber = nullptr;
    PlaybackPlots* m_plots = nullptr;
    QTabWidget* m_tabs = nullptr; ///< tabs: events, comments
    CommentPanel* m_comments = nullptr;
    QComboBox* m_ghostChoice = nullptr;
};

} // namespace chiron::desktop
