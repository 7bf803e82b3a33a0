// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/screen.h"
#include "desktop/training/hand_control.h"
#include "desktop/training/scene_pointer.h"
#include "desktop/training/sound_cue_player.h"
#include "session/study/live_sitting.h"

#include <QTimer>
#include <memory>
#include <optional>

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace chiron::desktop {

class AnswerPanel;
class ApexStage;
class BreakPanel;
class ExperimenterPanel;
class KeyFilter;
class PlacesView;
class StatePanel;

/// One sitting of one participant at one condition: the participant's view (no value, level or condition name) with the experimenter's
/// beside it, when it is wanted: places to compare, or the scene in which an apex is looked for. Each trial is stored as it is answered;
/// leaving keeps the run, which is resumed at the trial. Place: {study, participant, condition}. GUI thread.
class TrialsScreen final : public Screen {
    Q_OBJECT
public:
    TrialsScreen(AppContext& context, const Place& place);
    ~TrialsScreen() override;

    QString title() const override;
    QString help() const override;
    void enter() override;
    bool mayLeave() override;
    bool isBusy() const override { return running(); }
    std::vector<ScreenCommand> commands() override;

    session::LiveSitting* live() const { return m_live.get(); } ///< null before it begins

    /// Why the device is not taken, in the language of the program; empty where it is refused for something else.
    static QString refusalWords(const session::SittingError& error, const QLocale& locale);

private:
    // trials_screen_build.cpp
    QWidget* buildHead();
    QWidget* buildStage();
    void buildLive(); ///< what depends on the task, once it is known
    void buildPlaces();
    void buildApex();
    void buildKeys();
    void toolKey(int key, bool down);
    void connectPointer();
    QWidget& area();   ///< of the scene
    QObject& source(); ///< of its mouse and keys

    // trials_screen_show.cpp
    void showState(const session::LiveStudyView& view);
    void showScene(const session::LiveStudyView& view);
    void showBreak(const session::LiveStudyView& view);
    QString whyNoAnswer(const session::LiveStudyView& view) const;
    QString apexWords(const session::LiveStudyView& view) const;
    QString stoppedText() const;

    // trials_screen.cpp
    void begin();
    void poll();
    void onBreakButton();
    void answer(int answer, std::optional<double> value);
    void mark(); ///< "here it is", of an apex
    void pauseOrResume();
    void stopForce();
    void rearm();
    void askToStop();
    void finished();
    void fail(const core::Error& error);
    void refuse(const QString& words);
    void over();
    void toggleExperimenter();
    void freePointer();
    void capturePointer();
    bool running() const { return m_live && !m_over; }
    void goBack();

    QString m_participant;
    std::string m_condition;
    database::StudyNumber m_study;
    StatePanel* m_panel = nullptr;
    QStackedWidget* m_stage = nullptr;
    BreakPanel* m_break = nullptr;
    QWidget* m_trial = nullptr;
    PlacesView* m_places = nullptr;   ///< null where an apex is looked for
    AnswerPanel* m_answers = nullptr; ///< as m_places
    ApexStage* m_apex = nullptr;      ///< null where places are compared
    QLabel* m_note = nullptr;
    QProgressBar* m_progress = nullptr;
    QWidget* m_timeRow = nullptr;
    QProgressBar* m_time = nullptr;
    ExperimenterPanel* m_experimenter = nullptr;
    QPushButton* m_stop = nullptr;
    KeyFilter* m_keys = nullptr;
    SoundCuePlayer m_sound{4.0};
    bool m_masking = true;
    bool m_over = false;
    bool m_asking = false;
    bool m_begun = false; ///< the instructions were read
    session::LiveStudyView::State m_state = session::LiveStudyView::State::starting;
    QTimer m_frame;
    std::unique_ptr<session::LiveSitting> m_live;
    int m_sessions = 0; ///< whose pointer is connected
    std::unique_ptr<HandControl> m_hand;
    std::unique_ptr<ScenePointer> m_pointer;
};

} // namespace chiron::desktop
