// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QJsonDocument>
#include <QString>
#include <vector>

namespace chiron::cli {

class Arguments;

/// The result of a command: the document that --json prints, and the text that is printed without --json. A
/// command writes nothing else to stdout.
struct CommandOutput {
    QJsonDocument json;
    QString text;
    int exitCode = 0; ///< 1 if the check fails (verify, score, replay, device check)
};

struct OptionSpec {
    QString name;      ///< without dashes
    QString valueName; ///< empty for a flag
    QString help;
    bool required = false;
};

struct OperandSpec {
    QString name; ///< as in the help: "TRACE.csv"
    QString help;
    bool required = true;
};

/// One command, which is one row of the table. The handler receives arguments whose form is already checked.
struct CommandSpec {
    QString group; ///< "user"
    QString verb;  ///< "add"; empty where the group is the command
    QString summary;
    std::vector<OperandSpec> operands;
    std::vector<OptionSpec> options; ///< in addition to those that every command has
    QString example;                 ///< one line, starting with chiron-cli
    bool draws = false;              ///< needs a QApplication (fonts, pictures)
    core::Result<CommandOutput> (*run)(const Arguments& arguments) = nullptr;

    QString name() const { return verb.isEmpty() ? group : group + QLatin1Char(' ') + verb; }
};

/// Options that every command has: --json, --database, --as, --password-stdin, --help.
const std::vector<OptionSpec>& commonOptions();

} // namespace chiron::cli
