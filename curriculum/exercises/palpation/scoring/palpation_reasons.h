// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scoring/undefined_reason.h"

namespace chiron::scoring {

// clang-format off
namespace reasons {
inline constexpr UndefinedReason kNoLumpsAndArea{"the trace has no lumps and search area", QT_TRANSLATE_NOOP("Metrics", "the recording has neither lumps nor a search area")};
inline constexpr UndefinedReason kNoReports{"the trace has no reports", QT_TRANSLATE_NOOP("Metrics", "the recording has no reports")};
inline constexpr UndefinedReason kLostReports{"the trace lost reports", QT_TRANSLATE_NOOP("Metrics", "reports are missing from the recording")};
inline constexpr UndefinedReason kNoLumpThere{"no lump was there", QT_TRANSLATE_NOOP("Metrics", "there was no lump")};
inline constexpr UndefinedReason kNoLumpFound{"no lump was found", QT_TRANSLATE_NOOP("Metrics", "no lump was found")};
inline constexpr UndefinedReason kNoConfidence{"nobody said how sure a finding is", QT_TRANSLATE_NOOP("Metrics", "no finding has a confidence rating")};
inline constexpr UndefinedReason kNoSizeSaid{"of no lump that was found the size was said", QT_TRANSLATE_NOOP("Metrics", "no lump found was given a size")};
inline constexpr UndefinedReason kNoSizeAsked{"the level asks for no size", QT_TRANSLATE_NOOP("Metrics", "the level asks for no size")};
inline constexpr UndefinedReason kNoHardnessAsked{"the level asks for no hardness", QT_TRANSLATE_NOOP("Metrics", "the level asks for no hardness")};
inline constexpr UndefinedReason kTooFewHardnessOfATrial{"fewer than two lumps of a trial were found and their hardness said", QT_TRANSLATE_NOOP("Metrics", "in no trial were two lumps found and given a hardness")};
inline constexpr UndefinedReason kTooFewHardness{"fewer than two lumps were found and their hardness said", QT_TRANSLATE_NOOP("Metrics", "fewer than two lumps were found and given a hardness")};
inline constexpr UndefinedReason kEquallyHard{"the lumps that were found are equally hard", QT_TRANSLATE_NOOP("Metrics", "the lumps that were found are equally hard")};
inline constexpr UndefinedReason kNoUnequalPair{"no two lumps of different hardness were found and rated", QT_TRANSLATE_NOOP("Metrics", "no two lumps of different hardness were found and rated")};
inline constexpr UndefinedReason kTooFewLumps{"fewer than two lumps were there", QT_TRANSLATE_NOOP("Metrics", "there were fewer than two lumps")};
/// With counts: regions with a lump, regions without one, and how many of each are needed.
inline constexpr UndefinedReason kTooFewRegions{"only # regions with a lump and # without: # of each are needed", QT_TRANSLATE_NOOP("Metrics", "only %1 regions with a lump and %2 without: %3 of each are needed")};
inline constexpr UndefinedReason kNoCoverage{"the trace has no coverage", QT_TRANSLATE_NOOP("Metrics", "the recording has no coverage data")};
inline constexpr UndefinedReason kNoForceBand{"the trace has no force band", QT_TRANSLATE_NOOP("Metrics", "the recording has no force band")};
inline constexpr UndefinedReason kNothingPressed{"nothing was pressed", QT_TRANSLATE_NOOP("Metrics", "nothing was pressed")};
} // namespace reasons
// clang-format on

inline constexpr std::array kPalpationReasons{reasons::kNoLumpsAndArea,  reasons::kNoReports,
                                              reasons::kLostReports,     reasons::kNoLumpThere,
                                              reasons::kNoLumpFound,     reasons::kNoConfidence,
                                              reasons::kNoSizeSaid,      reasons::kNoSizeAsked,
                                              reasons::kNoHardnessAsked, reasons::kTooFewHardnessOfATrial,
                                              reasons::kTooFewHardness,  reasons::kEquallyHard,
                                              reasons::kNoUnequalPair,   reasons::kTooFewLumps,
                                              reasons::kTooFewRegions,   reasons::kNoCoverage,
                                              reasons::kNoForceBand,     reasons::kNothingPressed};

} // namespace chiron::scoring
