// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/frame/place.h"

#include <QKeySequence>
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

namespace chiron::desktop {

class AppContext;

/// Something that can be done on a screen: in the command palette (Ctrl+K), in the list of shortcuts (?) and by its keys.
struct ScreenCommand {
    QString text;      ///< translated, as a button would say it
    QKeySequence keys; ///< may be empty
    std::function<void()> act;
    bool registersKeys = true; ///< false: the screen handles the keys itself; they are only listed
};

/// One screen. Built when somebody goes there, destroyed when they leave; a change of theme, scale or language builds it
/// anew from its Place, so texts and colours are read once, in the constructor. Show something at once; whatever needs the
/// database starts in enter() and comes through Background. GUI thread.
class Screen : public QWidget {
    Q_OBJECT
public:
    Screen(AppContext& context, const Place& place, QWidget* parent = nullptr);

    virtual QString title() const = 0; ///< translated
    /// Called once, after the screen has been put into the window: load, set the focus.
    virtual void enter() {}
    /// Asked before leaving (also before closing the program): false keeps the person here; may ask them.
    virtual bool mayLeave() { return true; }
    /// While true the screen must not be locked, rebuilt or interrupted: a trial runs.
    virtual bool isBusy() const { return false; }
    virtual std::vector<ScreenCommand> commands() { return {}; }
    /// Translated help on F1: what this screen is for and how to use it. A few plain paragraphs, separated by blank lines.
    virtual QString help() const = 0;
    /// F1, before the help is shown: true where the screen has shown something better itself.
    virtual bool helpItself() { return false; }

protected:
    AppContext& context() const noexcept { return m_context; }
    const Place& place() const noexcept { return m_place; }

private:
    AppContext& m_context;
    Place m_place;
};

} // namespace chiron::desktop
