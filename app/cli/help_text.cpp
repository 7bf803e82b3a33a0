// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/help_text.h"

#include "cli/command_table.h"

#include <algorithm>

namespace chiron::cli {

namespace {

using Lines = std::vector<std::pair<QString, QString>>;

QString columns(const Lines& lines) {
    qsizetype widest = 0;
    for (const auto& line : lines)
        widest = std::max(widest, line.first.size());
    QString text;
    for (const auto& [left, right] : lines)
        text += QStringLiteral("  ") + left.leftJustified(widest + 2) + right + QLatin1Char('\n');
    return text;
}

QString optionForm(const OptionSpec& option) {
    return QStringLiteral("--") + option.name +
           (option.valueName.isEmpty() ? QString() : QLatin1Char(' ') + option.valueName);
}

QString usage(const CommandSpec& command) {
    QString line = QStringLiteral("chiron-cli ") + command.name();
    for (const OperandSpec& operand : command.operands)
        line +=
            operand.required ? QLatin1Char(' ') + operand.name : QStringLiteral(" [%1]").arg(operand.name);
    for (const OptionSpec& option : command.options)
        line += option.required ? QLatin1Char(' ') + optionForm(option)
                                : QStringLiteral(" [%1]").arg(optionForm(option));
    return line;
}

const QString kExitCodes = QStringLiteral(
    "Exit status: 0 done; 1 a check failed, or the command was cancelled; 2 wrong use or not allowed;\n"
    "3 bad input; 4 storage or the writer's lock; 5 device.\n");

} // namespace

QString overallHelp() {
    Lines lines;
    for (const CommandSpec& command : commandTable())
        lines.emplace_back(command.name(), command.summary);
    return QStringLiteral("Usage: chiron-cli COMMAND [OPTIONS]\n\nCommands:\n") + columns(lines) +
           QStringLiteral("\nEach has its own help: chiron-cli COMMAND --help\n\nExample:\n  chiron-cli "
                          "exercise list --json\n\n") +
           kExitCodes;
}

QString groupHelp(const QString& group) {
    Lines lines;
    QString example;
    for (const CommandSpec& command : commandTable()) {
        if (command.group != group)
            continue;
        lines.emplace_back(command.name(), command.summary);
        if (example.isEmpty())
            example = command.example;
    }
    return QStringLiteral("Usage: chiron-cli %1 COMMAND [OPTIONS]\n\nCommands:\n").arg(group) +
           columns(lines) + QStringLiteral("\nExample:\n  %1\n").arg(example);
}

QString commandHelp(const CommandSpec& command) {
    Lines operands;
    for (const OperandSpec& operand : command.operands)
        operands.emplace_back(operand.name, operand.help);
    Lines options;
    for (const OptionSpec& option : command.options)
        options.emplace_back(optionForm(option),
                             option.help + (option.required ? QStringLiteral(" (required)") : QString()));
    for (const OptionSpec& option : commonOptions())
        options.emplace_back(optionForm(option), option.help);
    QString text = QStringLiteral("%1\n\nUsage: %2\n").arg(command.summary, usage(command));
    if (!operands.empty())
        text += QStringLiteral("\nArguments:\n") + columns(operands);
    text += QStringLiteral("\nOptions:\n") + columns(options);
    return text + QStringLiteral("\nExample:\n  %1\n\n").arg(command.example) + kExitCodes;
}

} // namespace chiron::cli
