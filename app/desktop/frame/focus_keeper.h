// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QWidget>

namespace chiron::desktop {

/// Keeps the focus where the work is. Qt gives the focus of a control that is disabled or hidden to whatever stands next; a
/// button whose action is done, or a list that loads anew, would lose it so. Here it goes to the list that was worked in, and
/// else back to the control once that can take it again. Whoever moves the focus meanwhile keeps it there. GUI thread.
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

    QWidget& m_window;
    QPointer<QWidget> m_before;  ///< had the focus last
    QPointer<QWidget> m_place;   ///< took it from there
    QPointer<QWidget> m_list;    ///< the list that had it last
    QPointer<QWidget> m_hidden;  ///< has been hidden and still has it: Qt moves it next
    QPointer<QWidget> m_waiting; ///< lost it, and is to have it again
    bool m_justMoved = false;    ///< in the present turn of the event loop
    bool m_movedOn = false;      ///< as Qt does for a control that is going, and as Tab does
};

} // namespace chiron::desktop
