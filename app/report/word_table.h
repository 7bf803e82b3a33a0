// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace chiron::report {

/// A table as screen and paper show it: the same words, the same order.
struct WordTable {
    std::vector<QString> head;
    std::vector<std::vector<QString>> rows;
};

} // namespace chiron::report
