// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "desktop/training/control_guide.h"

#include <QStringList>
#include <QWidget>

class QPushButton;

namespace chiron::desktop {

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
    QString practised;                 ///< that minute has just ended: what comes now; empty: it was not taken
    QString clock;                     ///< how many trials, and when the clock starts
};

/// The card before the first trial of a level: what to do, with which movements, up to which force, and what counts. Whole when
/// somebody is new to the level, shorter afterwards; the whole one again whenever they ask. "Go", Enter or the first movement with a
/// key of the tool begins. GUI thread.
class ReadyCard final : public QWidget {
    Q_OBJECT
public:
    enum class Kind {
        whole,  ///< before the first session at this level
        brief,  ///< before a later one
        paused  ///< whole, while a session waits
    };

    ReadyCard(const Theme& theme, const ReadyFacts& facts, Kind kind, QWidget* parent = nullptr);

    Kind kind() const noexcept { return m_kind; }
    /// Keys (Qt::Key) whose press is a first movement.
    void setToolKeys(std::vector<int> keys) { m_toolKeys = std::move(keys); }
    QPushButton* goButton() const { return m_go; }

signals:
    void goAsked();
    void practiceAsked();
    void wholeAsked(); ///< of a brief card
    void helpAsked();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QWidget* buildText(const ReadyFacts& facts);
    QWidget* buildControls(const std::vector<ControlHint>& controls);
    QWidget* buildButtons(const ReadyFacts& facts);

    const Theme& m_theme;
    Kind m_kind;
    std::vector<int> m_toolKeys;
    QPushButton* m_go = nullptr;
};

} // namespace chiron::desktop
