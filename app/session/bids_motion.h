// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/haptic_frame.h"
#include "core/result.h"
#include "session/new_folder.h"
#include "session/session_view.h"
#include "session/yield_load.h"

#include <QString>
#include <QStringList>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace chiron::session {

/// The names of the files of one recording and their descriptions. Labels consist of letters and digits only,
/// as BIDS requires.
struct BidsRecording {
    QString subject;     ///< "K7M4QX"
    QString task;        ///< "stiffness"
    QString acquisition; ///< distinguishes several recordings of one run; empty: there is only one
    int run = 1;
    QString taskDescription;
    QString protocolSha256; ///< empty: not part of a study

    QString stem() const; ///< "sub-K7M4QX_task-stiffness"
    QString tail() const; ///< "_acq-sitting1_run-1"
};

/// The type of an event at which tissue gave way.
inline constexpr const char* kTissueYielded = "tissue_yielded";

/// A span of ticks that an events file lists.
struct BidsEvent {
    std::uint64_t firstTick = 0, lastTick = 0;
    QString type;  ///< "trial", "practice", "spoiled"
    QString value; ///< number of the presentation
};

/// Tissue that gave way under a tool.
struct BidsYield {
    int tool = 0;
    YieldLoad load;                ///< under which it gave way
    std::optional<core::Vec3> p_W; ///< where, m, W; no value if the packet was refused
};

/// A span of the recording as an events file lists it, in seconds since the first sample.
struct BidsSpan {
    double onset_s = 0.0;
    double end_s = 0.0;
    QString type;  ///< as in BidsEvent, or kTissueYielded
    QString value; ///< number of the presentation or trial; of the trial in which tissue gave way
    std::optional<BidsYield> yield = std::nullopt; ///< kTissueYielded
};

/// What the events of a recording mean, in English.
struct BidsMeaning {
    std::map<QString, QString> types; ///< of BidsSpan::type, except kTissueYielded
    QString duration;
    QString ordinal;
};

/// Finds the spans of an events file while the samples of a recording are written, so that it is decoded
/// once.
class BidsSpans {
public:
    BidsSpans() = default;
    BidsSpans(const BidsSpans&) = delete;
    BidsSpans& operator=(const BidsSpans&) = delete;
    virtual ~BidsSpans() = default;
    /// Call it for each frame, in order; `t_s`: since the first one.
    virtual void add(const core::HapticFrame& frame, double t_s) = 0;
    virtual BidsMeaning meaning() const = 0;
    /// The spans that began within the recording.
    virtual std::vector<BidsSpan> take() = 0;
};

/// The letters and digits of a word; "x" if it has none.
QString bidsLabel(const QString& words);
/// Assigns a unique label to each word. Labels that differ only in case count as equal, because file systems
/// may not distinguish case. A word that is already a valid label keeps it; other words with the same letters
/// and digits get "x2", "x3", … in the order of the words' characters. The result does not depend on the
/// order of the words.
std::map<QString, QString> bidsLabels(QStringList words);

/// Writes sub-X/motion/..._motion.tsv (no heading), _motion.json, _channels.tsv, _channels.json and
/// _events.tsv of one stored session: one row per executed tick of tool 0 with position and orientation in
/// the workspace's frame, time since the first tick, and tissue, commanded and measured force as MISC
/// channels.
/// Errors: those of the reader, storage.
core::Result<void> writeBidsMotion(NewFolder& folder, SessionView& session, const BidsRecording& recording,
                                   BidsSpans& spans);
/// The same with events whose ticks are known.
core::Result<void> writeBidsMotion(NewFolder& folder, SessionView& session, const BidsRecording& recording,
                                   const std::vector<BidsEvent>& events);

/// Writes `folder` as a BIDS dataset of this session only, with its trials, and the moments at which tissue
/// gave way, as events.
/// Errors: badInput if the folder exists; storage; those of the reader.
core::Result<void> exportSessionBids(SessionView& session, const std::filesystem::path& folder);

} // namespace chiron::session
