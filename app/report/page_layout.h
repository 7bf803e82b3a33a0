// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <functional>
#include <vector>

class QCPPainter;

namespace chiron::report {

/// A piece of a page that is never split: a heading, a row of a table, a plot. Lengths are in logical pixels
/// (1/96 inch).
struct Block {
    double height = 0.0;
    double gapBefore = 0.0;    ///< omitted at the top of a page
    bool keepWithNext = false; ///< never the last block of a page (headings)
    int header = -1; ///< index of the block that is repeated above this one on a new page (table heads)
    std::function<void(QCPPainter&, const QRectF&)> paint;
};

struct PlacedBlock {
    int block = 0;    ///< index into the blocks
    double top = 0.0; ///< distance from the top of the page's body
};

/// Distributes the blocks over pages of `bodyHeight`, in order. A block taller than a page gets a page of its
/// own. No page is empty, except that an empty list of blocks gives one page. Pure function.
std::vector<std::vector<PlacedBlock>> paginate(const std::vector<Block>& blocks, double bodyHeight);

} // namespace chiron::report
