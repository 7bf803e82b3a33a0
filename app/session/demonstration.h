// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace chiron::session {

/// Who does a level in the demonstration site (demo_site.h).
struct DemoPart {
    bool learned = false;     ///< trainees repeat it with increasing skill: short sessions that show a
                              ///< learning curve
    bool ofWhoCan = false;    ///< done by the trainee who has mastered the exercise
    bool ofWhoLearns = false; ///< ... and by the trainees who learn it
    bool ofOperators = true;  ///< every scripted operator does it
};

/// A column of the table of the demonstration's sessions. Texts are English, UTF-8.
struct DemoColumn {
    std::string heading{}; ///< short, with the unit; a leading ">" right-aligns it
    std::string metric{};  ///< id
    int decimals = 0;
};

/// A picture that compares the scripted operators.
struct OperatorComparison {
    std::string file{}; ///< file name: "operators.png"
    std::string title{};
    std::string metric{};     ///< id
    std::string metricName{}; ///< axis label
    std::string unit{};
    int level = 0;          ///< level whose trials are the points; 0: one point per level
    double reference = 0.0; ///< value of a reference line, in `unit`
    std::string referenceLabel{};
};

/// The session of the expert whose report is printed.
struct DemoReport {
    int level = 1;
    bool plots = false; ///< also save its plots as pictures
};

/// The content that the demonstration shows of an exercise, in addition to operator, duration and force.
struct Demonstration {
    std::vector<DemoColumn> columns{};
    std::string legend{}; ///< explains the columns; each line ends with a line break
    std::optional<OperatorComparison> comparison{};
    std::optional<DemoReport> report{};
};

} // namespace chiron::session
