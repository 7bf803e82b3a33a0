// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>
#include <vector>

class QDir;

namespace chiron::report {

class BlockMaker;
struct PlotTheme;

/// The part of a session's report that is specific to one exercise. It holds its own values and draws them.
/// Thread: GUI after construction.
class ReportSection {
public:
    ReportSection() = default;
    ReportSection(const ReportSection&) = delete;
    ReportSection& operator=(const ReportSection&) = delete;
    virtual ~ReportSection() = default;

    /// Adds its blocks, under a heading. The section must outlive the painting of the blocks.
    virtual void addTo(BlockMaker& blocks) const = 0;
    /// Writes its pictures, if any, into `folder` and adds their paths to `written`.
    /// Errors: storage.
    virtual core::Result<void> savePictures(const QDir& /*folder*/, const PlotTheme&,
                                            std::vector<QString>& /*written*/) const {
        return {};
    }
};

} // namespace chiron::report
