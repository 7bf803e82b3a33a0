// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/writer_lock.h"

namespace chiron::database {

core::Result<std::unique_ptr<QLockFile>> takeWriterLock(const std::string& file) {
    const QString name = QString::fromStdString(file + ".lock");
    auto lock = std::make_unique<QLockFile>(name);
    lock->setStaleLockTime(0); // a lock becomes stale only through the death of its holder
    if (lock->tryLock(300)) {
        return lock;
    }
    if (lock->error() != QLockFile::LockFailedError) {
        return core::fail(core::ErrorCode::storage,
                          file + ".lock: cannot be created (folder missing or not writable)");
    }
    qint64 pid = 0;
    QString host;
    QString program;
    if (!lock->getLockInfo(&pid, &host, &program)) {
        // The program was killed between creating the file and signing it. A live holder also keeps it
        // flocked, so this removes only the files of dead holders.
        lock->removeStaleLockFile();
        if (lock->tryLock(300)) {
            return lock;
        }
    }
    return core::fail(core::ErrorCode::locked,
                      file + ": " + program.toStdString() + " (process " + std::to_string(pid) +
                          ") has it open for writing; nothing was changed; end it there or try again later");
}

} // namespace chiron::database
