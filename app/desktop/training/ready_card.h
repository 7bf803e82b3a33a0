// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/control_guide.h"

#include <QAbstractSlider>
#include <QStringList>
#include <QWidget>

class QKeyEvent;
class QLabel;
class QPushButton;

namespace chiron::desktop {

class ScrollPage;

/// The information that a person needs before the clock starts.
struct ReadyFacts {
    QString exercise;
    QString level;
    QString goal;                      ///< the objective in one sentence
    std::vector<ControlHint> controls; ///< of the present device
    QString keys;                      ///< all controls, as a line of text
    QStringList marks;                 ///< meanings of the marks in the scene
    QString limit;                     ///< force limit, and how much of the force is felt
    QStringList gates;                 ///< requirements for passing
    bool offersPractice = true;        ///< offers a practice minute that does not count
    bool offersDemonstration = false;  ///< offers a demonstration, for people new to the level
    bool offersLeave = false;          ///< offers to leave the exercise
    QString practised;                 ///< after the practice minute: what comes now; otherwise empty
    QString clock;                     ///< number of trials, and when the clock starts, or that it is stopped
};

/// The card before the first trial of a level: task, movements, force limit, scoring and the meaning of the
/// marks. People who know the level get a brief one, with "More" for the rest. Its text scrolls, its buttons
/// do not. "Go", Enter or the first movement key of the tool starts the session, so Space reads on where the
/// text is longer than the window; on the cards that were asked for the arrow and page keys do so, too, and
/// no movement key starts before the end of the text was reached.
///
/// A key with a meaning in the scene must not press a button by accident. Space pauses in the scene and
/// therefore presses no button. A key held down since before the card appeared does nothing. A card that
/// appears by itself, after a practice, focuses no button, so that a key meant for the practice starts
/// nothing.
/// Thread: GUI.
class ReadyCard final : public QWidget {
    Q_OBJECT
public:
    enum class Kind {
        first, ///< before the first session at this level: everything
        brief, ///< before a later session: task, names of the movements, force limit
        whole, ///< everything, on request
        paused ///< like whole, while the session is paused
    };

    ReadyCard(const Theme& theme, const ReadyFacts& facts, Kind kind, QWidget* parent = nullptr);

    Kind kind() const noexcept { return m_kind; }
    /// The keys (Qt::Key) whose press counts as a first movement.
    void setToolKeys(std::vector<int> keys) { m_toolKeys = std::move(keys); }
    bool scroll(int key); ///< false: no scrolling key of this card, or nothing more in its direction
    bool readOn(bool back = false); ///< by a page; false: nothing more in this direction
    bool isRead() const;            ///< whether a first movement may start the session
    /// On a card of Kind::paused: what is true of the clock now, and whether force is stopped, so that the
    /// card's button only leads back to the scene. Call it whenever this may have changed.
    void setHeld(bool stopped, const QString& clock);
    void takeFocus(); ///< moves the focus to "Go", or to the card itself if the card appeared by itself

signals:
    void goAsked();
    void practiceAsked();
    void watchAsked();
    void wholeAsked(); ///< from a brief card
    void helpAsked();
    void leaveAsked();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    /// Whether the person asked for this card, so that no key is a first movement before it is read.
    bool wasAskedFor() const noexcept { return m_kind == Kind::whole || m_kind == Kind::paused; }
    bool pressed(const QKeyEvent& key);
    bool scrollBy(QAbstractSlider::SliderAction step); ///< false: the text is at its end already
    QWidget* buildText(const ReadyFacts& facts);
    QWidget* buildControls(const std::vector<ControlHint>& controls);
    QWidget* buildReadOn();
    QWidget* buildButtons(const ReadyFacts& facts);

    const Theme& m_theme;
    Kind m_kind;
    bool m_cameByItself;
    bool m_endSeen = false; ///< the text was scrolled to its end
    std::vector<int> m_toolKeys;
    ScrollPage* m_page = nullptr;
    QPushButton* m_go = nullptr;
    QLabel* m_clock = nullptr;
};

} // namespace chiron::desktop
