// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <functional>
#include <vector>

class QCPPainter;

namespace chiron::report {

/// A piece of a page that is never broken: a heading, a row of a table, a plot. Lengths in logical pixels
/// (1/96 inch).
struct Block {
    double height = 0.0;
    double gapBefore = 0.0;    ///< left out at the top of a page
    bool keepWithNext = false; ///< never the last block of a page (headings)
    int header = -1; ///< index of the block that is repeated above this one on a new page (table heads)
    std::function<void(QCPPainter&, const QRectF&)> paint;
};

struct PlacedBlock {
    int block = 0;    ///< index into the blocks
    double top = 0.0; ///< from the top of the page's body
};

/// Puts blocks on pages of `bodyHeight`, in order. A block taller than a page gets a page of its own; no page
/// is empty; without blocks there is one page. Pure.
std::vector<std::vector<PlacedBlock>> paginate(const std::vector<Block>& blocks, double bodyHeight);

} // namespace chiron::report
