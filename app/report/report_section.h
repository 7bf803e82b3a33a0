// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QString>
#include <vector>

class QDir;

namespace chiron::report {

class BlockMaker;
struct PlotTheme;

/// What only one exercise shows in the report of a session. It holds its own values, and knows how they are drawn. GUI thread, once made.
class ReportSection {
public:
    ReportSection() = default;
    ReportSection(const ReportSection&) = delete;
    ReportSection& operator=(const ReportSection&) = delete;
    virtual ~ReportSection() = default;

    /// Adds its blocks, under a heading. It must outlive their painting.
    virtual void addTo(BlockMaker& blocks) const = 0;
    /// Writes its pictures into `folder`, where it has any, and adds their paths to `written`. Fails with storage.
    virtual core::Result<void> savePictures(const QDir& /*folder*/, const PlotTheme&, std::vector<QString>& /*written*/) const {
        return {};
    }
};

} // namespace chiron::report
