// SPDX-License-Identifier: GPL-3.0-or-later
#include "session_report/apex_study_plots.h"
#include "session_report/study_report_text.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace chiron::session_report {

namespace {

/// The first whole number in the words; 0 where there is none.
int countIn(const std::string& words) {
    const auto digit = std::find_if(words.begin(), words.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    return digit == words.end() ? 0 : std::atoi(words.c_str() + (digit - words.begin()));
}

} // namespace

QString apexWarning(const std::string& warning) {
    const std::size_t colon = warning.find(": ");
    const std::string token = warning.substr(0, colon);
    const std::string words = colon == std::string::npos ? warning : warning.substr(colon + 2);
    const int n = countIn(words);
    if (token == "no_trials")
        return Words::tr("There is no mark to summarise.");
    if (token == "left_out")
        return Words::tr("%n trial(s) have no mark and are left out.", nullptr, n);
    if (token == "few_participants")
        return Words::tr("Only %n participant(s): how people differ is hardly known.", nullptr, n);
    if (token == "few_trials")
        return Words::tr("Some participants have fewer than 10 marks.");
    if (token == "bias_x")
        return Words::tr("Errors in x lean to one side: the absolute error is not scatter alone.");
    if (token == "bias_y")
        return Words::tr("Errors in y lean to one side: the absolute error is not scatter alone.");
    if (token == "beyond_radius")
        return Words::tr("%n mark(s) lie off the sphere.", nullptr, n);
    if (token == "planned")
        return Words::tr("%n mark(s) are of the observer for planning: nothing was rendered.", nullptr, n);
    if (token == "out_of_contact")
        return Words::tr("%n mark(s) were set without touching anything.", nullptr, n);
    if (token == "withdrawn")
        return Words::tr("%n participant(s) who withdrew are left out.", nullptr, n);
    if (token == "simulated_left_out")
        return Words::tr("%n simulated participant(s) are left out: the group is of people.", nullptr, n);
    if (token == "simulated")
        return Words::tr("The group is of simulated participants alone.");
    return QString::fromStdString(words);
}

} // namespace chiron::session_report
