// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QObject>
#include <QString>

class QSocketNotifier;

namespace chiron::desktop {

/// Lets a second desktop on the same database raise the first one's window (data.md, Writing). It uses a
/// datagram socket in the user's runtime folder, named after the database. The process that holds the
/// database's lock listens on it; a process that is refused the lock sends to it. It uses plain system calls,
/// because loading Qt Network would add more to the program's start than everything else on this screen.
/// Thread: GUI.
class InstanceLink final : public QObject {
    Q_OBJECT
public:
    explicit InstanceLink(const QString& databaseFile, QObject* parent = nullptr);
    ~InstanceLink() override; ///< removes the socket's name

    /// Only the holder of the database's lock may call this. A socket name left over by a crash is replaced.
    /// Errors: storage; nothing else depends on it.
    core::Result<void> listen();
    /// Returns true if a listening program was asked to raise its window.
    static bool raiseOther(const QString& databaseFile);

signals:
    void raiseAsked();

private:
    void receive();

    QString m_path;
    int m_socket = -1;
    QSocketNotifier* m_notifier = nullptr;
};

} // namespace chiron::desktop
