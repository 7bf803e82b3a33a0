// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/page_layout.h"

namespace chiron::report {

namespace {

// The height that must stay together from `first` on: a heading stays with the blocks that follow it.
double heightTogether(const std::vector<Block>& blocks, std::size_t first) {
    double height = blocks[first].height;
    for (std::size_t i = first; i + 1 < blocks.size() && blocks[i].keepWithNext; ++i)
        height += blocks[i + 1].gapBefore + blocks[i + 1].height;
    return height;
}

} // namespace

std::vector<std::vector<PlacedBlock>> paginate(const std::vector<Block>& blocks, double bodyHeight) {
    std::vector<std::vector<PlacedBlock>> pages(1);
    double used = 0.0;
    bool held = false; // the previous block keeps this one on its page
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const Block& block = blocks[i];
        const double gap = pages.back().empty() ? 0.0 : block.gapBefore;
        const double needed = held ? block.height : heightTogether(blocks, i);
        if (!pages.back().empty() && !held && used + gap + needed > bodyHeight) {
            pages.emplace_back();
            used = 0.0;
            if (block.header >= 0) {
                pages.back().push_back({block.header, 0.0});
                used = blocks[static_cast<std::size_t>(block.header)].height;
            }
        }
        const double top = pages.back().empty() ? 0.0 : used + (used > 0.0 ? block.gapBefore : 0.0);
        pages.back().push_back({static_cast<int>(i), top});
        used = top + block.height;
        held = block.keepWithNext;
    }
    return pages;
}

} // namespace chiron::report
