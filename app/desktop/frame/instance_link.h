// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QObject>
#include <QString>

class QSocketNotifier;

namespace chiron::desktop {

/// Lets a second desktop on the same database raise the first one's window (data.md, Writing). A datagram socket in the
/// user's runtime folder, named after the database: who holds the database's lock listens, who is refused it knocks. Plain
/// system calls, because Qt Network would cost the program's start more than everything else on this screen. GUI thread.
class InstanceLink final : public QObject {
    Q_OBJECT
public:
    explicit InstanceLink(const QString& databaseFile, QObject* parent = nullptr);
    ~InstanceLink() override; ///< the socket's name goes with it

    /// Only by the holder of the database's lock: a name left over by a crash is replaced. Failure: storage; nothing else
    /// depends on it.
    core::Result<void> listen();
    /// True when a program that listens was asked to come forward.
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
