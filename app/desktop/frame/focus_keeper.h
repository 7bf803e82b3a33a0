// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <QWidget>
#include <vector>

namespace chiron::desktop {

/// Keeps the keyboard focus where the person is working. When a focused control is disabled or hidden, Qt
/// moves the focus to the next control; a button whose action has been carried out, or a list that reloads,
/// would lose the focus in this way. This class returns it to the list that was last used, or else to the
/// control itself once it can take the focus again. If the person moves the focus in the meantime, it stays
/// there. When the page around the control goes, the focus stays in what showed this page: on the first
/// control of the page that came instead. Qt would move it to whatever comes next, often the side bar, or
/// nowhere. Where a person or the program's own code put the focus meanwhile, it stays.
/// Thread: GUI.
class FocusKeeper final : public QObject {
    Q_OBJECT
public:
    explicit FocusKeeper(QWidget& window);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void moved(QWidget* before, QWidget* now);
    void lost(QWidget* control);
    void giveBack();
    bool canTake(const QWidget* control) const;
    bool hasGoneWithItsPage() const;
    bool movedByQt(const QWidget* before) const;
    void comesBack();
    void stayNear();
    QWidget* firstControlIn(QWidget& place) const;

    QWidget& m_window;
    QPointer<QWidget> m_before;                ///< had the focus before m_place
    QPointer<QWidget> m_place;                 ///< has the focus now
    QPointer<QWidget> m_list;                  ///< the list that last had the focus
    QPointer<QWidget> m_hidden;                ///< hidden or disabled with the focus; Qt moves the focus next
    QPointer<QWidget> m_waiting;               ///< lost the focus and gets it back
    QPointer<QWidget> m_last;                  ///< the control of this window that last had the focus ...
    std::vector<QPointer<QWidget>> m_around;   ///< ... and what it stands in, from the inside to the outside
    std::vector<QPointer<QWidget>> m_goneFrom; ///< what a control stood in that went with its page
    QPointer<QWidget> m_fellTo;                ///< where Qt moved the focus then; null: nowhere
    QTimer m_pageComes;                        ///< until the page that comes instead is there
    bool m_justMoved = false;                  ///< the focus moved in this turn of the event loop
    /// The focus moved forward as by Tab, which is also how Qt moves it away from a control that is disabled
    /// or hidden.
    bool m_movedOn = false;
    /// The window has become active and Qt looks for a control that takes the focus, because the one that had
    /// it cannot.
    bool m_seeks = false;
};

} // namespace chiron::desktop
