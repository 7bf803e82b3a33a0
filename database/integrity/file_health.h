// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <atomic>
#include <string>

namespace chiron::database {

/// The reason why a database file could not be opened.
enum class FileHealth {
    sound,      ///< the file is not the reason: its folder, its lock or its key is
    missing,    ///< there is no such file
    unreadable, ///< it may not be read, or is not a file
    damaged,    ///< cut off, overwritten, or not a database at all
    foreign,    ///< another program's database
    newer,      ///< the site of a newer program
};

struct FileState {
    FileHealth health = FileHealth::sound;
    std::string detail; ///< what was found, in technical terms; empty if the file is sound
};

/// Examines the file without changing it: the bytes of the header, the length that the header states, then
/// SQLite's own quick check of every page. It ends early, with sound, when `cancel` is set.
/// Thread: a worker; blocks, and takes long for a large file.
FileState examineFile(const std::string& file, const std::atomic<bool>* cancel = nullptr);

/// The check at opening, which takes milliseconds for a site of any size: the length that the header states,
/// and the pages of the tables that are needed to log in. A file that does not belong to this program, or
/// cannot be opened, passes, because opening it reports the reason.
/// Errors: storage, saying what is damaged.
core::Result<void> checkAtOpening(const std::string& file);

} // namespace chiron::database
