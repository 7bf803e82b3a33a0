// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <atomic>
#include <string>

namespace chiron::database {

/// What is wrong with a database file that could not be opened.
enum class FileHealth {
    sound,      ///< not the file: its folder, its lock, its key
    missing,    ///< there is no such file
    unreadable, ///< it may not be read, or is no file
    damaged,    ///< cut off, overwritten, or no database at all
    foreign,    ///< another program's database
    newer,      ///< a newer program's site
};

struct FileState {
    FileHealth health = FileHealth::sound;
    std::string detail; ///< what was found, in technical words; empty where it is sound
};

/// Looks at the file without changing it: the header's bytes, the length that it promises, then SQLite's own quick check of every
/// page. Ends early, with sound, when `cancel` is set. Blocking, and long for a large file: a worker's task.
FileState examineFile(const std::string& file, const std::atomic<bool>* cancel = nullptr);

/// The check at opening, in milliseconds however large the site: the length that the header promises, and the pages of the tables
/// that nobody could log in without. A file that is not this program's, or cannot be opened, passes: opening it tells why.
/// Failure: storage, saying what is damaged.
core::Result<void> checkAtOpening(const std::string& file);

} // namespace chiron::database
