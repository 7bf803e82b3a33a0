// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "session/new_folder.h"
#include "session/session_view.h"

#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <map>

namespace chiron::session {

/// How the files of one recording are called, and what is said of it: labels of letters and digits alone, as BIDS has them.
struct BidsRecording {
    QString subject; ///< "K7M4QX"
    QString task;    ///< "stiffness"
    QString acquisition; ///< of several recordings of one run; empty: none
    int run = 1;
    QString taskDescription;
    QString protocolSha256; ///< empty: not of a study

    QString stem() const; ///< "sub-K7M4QX_task-stiffness"
    QString tail() const; ///< "_acq-sitting1_run-1"
};

/// A span of ticks that an events file tells of.
struct BidsEvent {
    std::uint64_t firstTick = 0, lastTick = 0;
    QString type;  ///< "trial", "practice", "spoiled"
    QString value; ///< number of the presentation
};

/// The letters and digits of a word; "x" where it has none.
QString bidsLabel(const QString& words);
/// A label for each word, none twice whatever the case (file systems may not tell it): a word that is a label already keeps it, others
/// of the same letters and digits get "x2", "x3", … in the order of the words' characters. The same for the same words in any order.
std::map<QString, QString> bidsLabels(QStringList words);

/// Writes sub-X/motion/..._motion.tsv (no heading), _motion.json, _channels.tsv, _channels.json and _events.tsv of one stored session:
/// each executed tick of tool 0, position and orientation in the workspace's frame, time since the first tick, tissue, commanded and
/// measured force as MISC channels. Failure: the reader's, storage.
core::Result<void> writeBidsMotion(NewFolder& folder, SessionView& session, const BidsRecording& recording, const std::vector<BidsEvent>& events);

/// Writes `folder` as a BIDS dataset of this session alone, its trials as events. Failure: badInput where it exists, storage, the reader's.
core::Result<void> exportSessionBids(SessionView& session, const std::filesystem::path& folder);

} // namespace chiron::session
