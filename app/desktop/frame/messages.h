// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QObject>
#include <QString>
#include <functional>

namespace chiron::desktop {

/// What the program was doing when an error occurred. The message must not say that something was saved if it
/// was only being read.
enum class Tried {
    saving,  ///< also changing, making or running something
    reading, ///< reading stored data
    opening, ///< opening the site itself
};

enum class MessageKind { done, information, warning, error };

/// One short message at the bottom of the window, as text with an icon: what happened, what was kept, what to
/// do.
struct Message {
    MessageKind kind = MessageKind::information;
    QString text;
    QString actionText; ///< for example "Undo"; empty if there is no action
    std::function<void()> action;
};

/// Passes messages from the screens to the main window, which shows them. Errors stay until they are closed;
/// others disappear after some seconds.
/// Thread: GUI.
class Messages : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    void tell(const Message& message) { emit told(message); }
    void done(const QString& text) { tell({MessageKind::done, text, {}, {}}); }
    void information(const QString& text) { tell({MessageKind::information, text, {}, {}}); }
    void warning(const QString& text) { tell({MessageKind::warning, text, {}, {}}); }
    /// `what` is the screen's own sentence ("The session could not be opened."); the error's text follows it.
    void error(const QString& what, const core::Error& error, Tried tried = Tried::saving);

signals:
    void told(const chiron::desktop::Message& message);
};

/// Describes an error for the user: what kind of error it is, what to do, and then the details of its
/// message.
QString inWords(const core::Error& error, Tried tried = Tried::saving);

} // namespace chiron::desktop
