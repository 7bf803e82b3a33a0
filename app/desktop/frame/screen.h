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

/// A command of a screen, reachable from the command palette (Ctrl+K), the list of shortcuts (?) and its own
/// keys.
struct ScreenCommand {
    QString text;      ///< translated, worded like a button
    QKeySequence keys; ///< may be empty
    std::function<void()> act;
    bool registersKeys = true; ///< false: the screen handles the keys itself, and they are only listed
};

/// One screen. It is constructed when the person goes there and destroyed when they leave. A change of theme,
/// scale or language constructs it again from its Place, so texts and colours are read once, in the
/// constructor. Show something at once; start whatever needs the database in enter() and run it through
/// Background.
/// Thread: GUI.
class Screen : public QWidget {
    Q_OBJECT
public:
    Screen(AppContext& context, const Place& place, QWidget* parent = nullptr);

    virtual QString title() const = 0; ///< translated
    /// Called once, after the screen has been put into the window. Load data and set the focus here.
    virtual void enter() {}
    /// Called before the screen is left, and before the program closes. Returning false keeps the person
    /// here; the function may ask them.
    virtual bool mayLeave() { return true; }
    /// While this is true (a trial is running) the screen must not be locked, rebuilt or interrupted.
    virtual bool isBusy() const { return false; }
    virtual std::vector<ScreenCommand> commands() { return {}; }
    /// Translated help text for F1: the purpose of this screen and how to use it, in a few plain paragraphs
    /// separated by blank lines.
    virtual QString help() const = 0;
    /// Called on F1 before the help is shown; true if the screen has shown something more helpful itself.
    virtual bool helpItself() { return false; }

protected:
    AppContext& context() const noexcept { return m_context; }
    const Place& place() const noexcept { return m_place; }

private:
    AppContext& m_context;
    Place m_place;
};

} // namespace chiron::desktop
