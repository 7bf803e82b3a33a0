// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

namespace chiron::report {

/// A table that screen and paper show with the same words in the same order.
struct WordTable {
    std::vector<QString> head;
    std::vector<std::vector<QString>> rows;
};

} // namespace chiron::report
