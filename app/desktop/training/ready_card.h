// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/control_guide.h"

#include <QStringList>
#include <QWidget>

class QKeyEvent;
class QPushButton;

namespace chiron::desktop {

class ScrollPage;

/// What a person has to know before the clock starts.
struct ReadyFacts {
    QString exercise;
    QString level;
    QString goal;                      ///< the objective in one sentence
    std::vector<ControlHint> controls; ///< of the device in hand
    QString keys;                      ///< all of its controls, as a line of text
    QStringList marks;                 ///< what the marks in the scene mean
    QString limit;                     ///< of force, with what is felt of it
    QStringList gates;                 ///< what is needed to pass
    bool offersPractice = true;        ///< a minute that does not count can be had from the card
    bool offersDemonstration = false;  ///< an expert can be watched first, where somebody is new to the level
    bool offersLeave = false;          ///< the exercise can be left from the card
    QString practised;                 ///< that minute has just ended: what comes now; empty: it was not taken
    QString clock;                     ///< how many trials, and when the clock starts
};

/// The card before the first trial of a level: what to do, with which movements and up to which force. It explains the movements to
/// somebody who is new to the level; "More" shows what counts and what the marks mean. Its text scrolls, its buttons never do. "Go", Enter
/// or the first movement with a key of the tool begins.
///
/// A key that means something in the scene presses no button because that happens to have the focus: Space, which pauses there, presses
/// none; a key that was held down before the card came does nothing; and a card that comes by itself, after a practice, gives the focus to
/// no button, so that what was meant for the practice begins nothing. GUI thread.
class ReadyCard final : public QWidget {
    Q_OBJECT
public:
    enum class Kind {
        first,  ///< before the first session at this level: with how each movement is made
        brief,  ///< before a later one
        whole,  ///< everything: somebody asked for it
        paused  ///< whole, while a session waits
    };

    ReadyCard(const Theme& theme, const ReadyFacts& facts, Kind kind, QWidget* parent = nullptr);

    Kind kind() const noexcept { return m_kind; }
    /// Keys (Qt::Key) whose press is a first movement.
    void setToolKeys(std::vector<int> keys) { m_toolKeys = std::move(keys); }
    bool scroll(int key); ///< false: no key that scrolls, or nothing to scroll
    void takeFocus(); ///< onto "Go", or onto the card itself where it came by itself

signals:
    void goAsked();
    void practiceAsked();
    void watchAsked();
    void wholeAsked(); ///< of a brief card
    void helpAsked();
    void leaveAsked();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    bool isShort() const noexcept { return m_kind == Kind::first || m_kind == Kind::brief; }
    bool pressed(const QKeyEvent& key);
    QWidget* buildText(const ReadyFacts& facts);
    QWidget* buildControls(const std::vector<ControlHint>& controls);
    QWidget* buildButtons(const ReadyFacts& facts);

    const Theme& m_theme;
    Kind m_kind;
    bool m_cameByItself;
    std::vector<int> m_toolKeys;
    ScrollPage* m_page = nullptr;
    QPushButton* m_go = nullptr;
};

} // namespace chiron::desktop
