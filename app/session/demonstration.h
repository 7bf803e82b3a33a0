// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// Who does a level in the demonstration site (demo_site.h).
struct DemoPart {
    bool learned = false;      ///< trainees repeat it, and get better: short sessions that say much
    bool ofWhoCan = false;     ///< those trainees have done it who can do the exercise
    bool ofWhoLearns = false;  ///< ... and those who learn
    bool ofOperators = true;   ///< every scripted operator does it
};

/// A column of the table of the demonstration's sessions. Texts are English, UTF-8.
struct DemoColumn {
    std::string heading{}; ///< short, with the unit; ">" in front: to the right
    std::string metric{};  ///< id
    int decimals = 0;
};

/// A picture with the scripted operators beside each other.
struct OperatorComparison {
    std::string file{};       ///< its name: "operators.png"
    std::string title{};
    std::string metric{};     ///< id
    std::string metricName{}; ///< at the axis
    std::string unit{};
    int level = 0;          ///< whose trials are the points; 0: a point a level
    double reference = 0.0; ///< a line, in `unit`
    std::string referenceLabel{};
};

/// The expert's session whose report is printed.
struct DemoReport {
    int level = 1;
    bool plots = false; ///< its plots as pictures, too
};

/// What the demonstration shows of an exercise beside who, how long and how hard.
struct Demonstration {
    std::vector<DemoColumn> columns{};
    std::string legend{}; ///< what the columns say; lines end with a line break
    std::optional<OperatorComparison> comparison{};
    std::optional<DemoReport> report{};
};

} // namespace chiron::session
