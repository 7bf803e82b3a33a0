// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QObject>
#include <QString>
#include <functional>

namespace chiron::desktop {

/// What was tried when an error came: its words must not say "saved" where something was only read.
enum class Tried {
    saving,  ///< or changing, making, running
    reading, ///< of what is stored
    opening, ///< of the site itself
};

enum class MessageKind { done, information, warning, error };

/// One short message at the bottom of the window, in words and with a sign: what happened, what was kept, what to do.
struct Message {
    MessageKind kind = MessageKind::information;
    QString text;
    QString actionText; ///< "Undo"; empty: none
    std::function<void()> action;
};

/// Screens tell; the main window shows. Messages that are errors stay until closed, others go after some seconds. GUI thread.
class Messages : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    void tell(const Message& message) { emit told(message); }
    void done(const QString& text) { tell({MessageKind::done, text, {}, {}}); }
    void information(const QString& text) { tell({MessageKind::information, text, {}, {}}); }
    void warning(const QString& text) { tell({MessageKind::warning, text, {}, {}}); }
    /// `what` is the sentence of the screen ("The session could not be opened."); the error's own words follow.
    void error(const QString& what, const core::Error& error, Tried tried = Tried::saving);

signals:
    void told(const chiron::desktop::Message& message);
};

/// An error in words for people: what kind it is, what to do, then the message's own details.
QString inWords(const core::Error& error, Tried tried = Tried::saving);

} // namespace chiron::desktop
