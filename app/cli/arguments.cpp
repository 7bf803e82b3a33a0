// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/arguments.h"

#include "cli/cli_errors.h"

#include <cmath>

namespace chiron::cli {

namespace {

QString place(const CommandSpec& command, const QString& what) {
    return QStringLiteral("%1: %2").arg(command.name(), what);
}

QString seeHelp(const CommandSpec& command) {
    return QStringLiteral("see chiron-cli %1 --help").arg(command.name());
}

QString optionNames(const CommandSpec& command) {
    QStringList names;
    for (const OptionSpec& option : command.options)
        names << QStringLiteral("--") + option.name;
    for (const OptionSpec& option : commonOptions())
        names << QStringLiteral("--") + option.name;
    return names.join(QStringLiteral(", "));
}

} // namespace

const std::vector<OptionSpec>& commonOptions() {
    static const std::vector<OptionSpec> options{
        {QStringLiteral("json"), {}, QStringLiteral("print exactly one JSON document"), false},
        {QStringLiteral("database"), QStringLiteral("FILE"),
         QStringLiteral("the database; default: chiron/chiron.db in the user's data folder"), false},
        {QStringLiteral("as"), QStringLiteral("NAME"),
         QStringLiteral("who acts; the password comes from CHIRON_PASSWORD or --password-stdin"), false},
        {QStringLiteral("password-stdin"),
         {},
         QStringLiteral("read the password from the first line of stdin"),
         false},
        {QStringLiteral("help"), {}, QStringLiteral("show this help"), false},
    };
    return options;
}

core::Result<Arguments> Arguments::parse(const CommandSpec& command, const QStringList& rest) {
    Arguments arguments(command);
    arguments.m_parser = std::make_shared<QCommandLineParser>();
    arguments.m_parser->setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);
    for (const auto* options : {&command.options, &commonOptions()}) {
        for (const OptionSpec& option : *options)
            arguments.m_parser->addOption(QCommandLineOption(option.name, option.help, option.valueName));
    }
    // The parser skips the first word as the program's name. parse() reports errors, while process() would
    // end the program.
    if (!arguments.m_parser->parse(QStringList{QStringLiteral("chiron-cli")} + rest)) {
        const QString reason =
            printable(arguments.m_parser->errorText()).replace(QLatin1Char('\n'), QLatin1String("\\n"));
        return wrongUse(place(command, QStringLiteral("%1 Expected options: %2; %3")
                                           .arg(reason, optionNames(command), seeHelp(command))));
    }
    if (arguments.has(QStringLiteral("help")))
        return arguments;
    CHIRON_TRY(arguments.checkOptions());
    CHIRON_TRY(arguments.checkOperands());
    return arguments;
}

core::Result<void> Arguments::checkOptions() const {
    for (const auto* options : {&m_command->options, &commonOptions()}) {
        for (const OptionSpec& option : *options) {
            const QString name = QStringLiteral("--") + option.name;
            if (option.required && !has(option.name))
                return wrongUse(
                    place(*m_command, QStringLiteral("%1 is missing; expected %1 %2: %3; %4")
                                          .arg(name, option.valueName, option.help, seeHelp(*m_command))));
            if (option.valueName.isEmpty())
                continue;
            const QStringList values = m_parser->values(option.name);
            if (values.size() > 1)
                return wrongUse(
                    place(*m_command, QStringLiteral("%1 is given %2 times, last with %3; expected once")
                                          .arg(name)
                                          .arg(values.size())
                                          .arg(quoted(values.last()))));
            if (!values.isEmpty() && values[0].isEmpty())
                return wrongUse(
                    place(*m_command, QStringLiteral("%1: \"\": expected %2").arg(name, option.valueName)));
        }
    }
    return {};
}

core::Result<void> Arguments::checkOperands() const {
    const QStringList given = m_parser->positionalArguments();
    const int wanted = static_cast<int>(m_command->operands.size());
    for (int i = 0; i < wanted; ++i) {
        const OperandSpec& operand = m_command->operands[static_cast<std::size_t>(i)];
        if (operand.required && given.size() <= i)
            return wrongUse(place(*m_command, QStringLiteral("%1 is missing: expected %2; %3")
                                                  .arg(operand.name, operand.help, seeHelp(*m_command))));
        if (i < given.size() && given[i].isEmpty())
            return wrongUse(
                place(*m_command, QStringLiteral("%1: \"\": expected %2").arg(operand.name, operand.help)));
    }
    if (given.size() > wanted)
        return wrongUse(place(*m_command, QStringLiteral("%1: one argument too many; expected %2; %3")
                                              .arg(quoted(given[wanted]))
                                              .arg(wanted)
                                              .arg(seeHelp(*m_command))));
    return {};
}

bool Arguments::has(const QString& option) const {
    return m_parser->isSet(option);
}

QString Arguments::value(const QString& option) const {
    return m_parser->value(option);
}

QString Arguments::operand(int index) const {
    return m_parser->positionalArguments().value(index);
}

core::Result<double> Arguments::number(const QString& option, double minimum, double maximum,
                                       double fallback) const {
    if (!has(option))
        return fallback;
    bool isNumber = false;
    const double found = QLocale::c().toDouble(value(option), &isNumber);
    if (!isNumber || !std::isfinite(found) || found < minimum || found > maximum)
        return wrongUse(place(*m_command, QStringLiteral("--%1: %2: expected a number from %3 to %4")
                                              .arg(option, quoted(value(option)))
                                              .arg(minimum)
                                              .arg(maximum)));
    return found;
}

core::Result<qint64> Arguments::integer(const QString& option, qint64 minimum, qint64 maximum,
                                        qint64 fallback) const {
    if (!has(option))
        return fallback;
    bool isNumber = false;
    const qint64 found = value(option).toLongLong(&isNumber, 10);
    if (!isNumber || found < minimum || found > maximum)
        return wrongUse(place(*m_command, QStringLiteral("--%1: %2: expected a whole number from %3 to %4")
                                              .arg(option, quoted(value(option)))
                                              .arg(minimum)
                                              .arg(maximum)));
    return found;
}

core::Result<quint64> Arguments::seed(const QString& option, quint64 fallback) const {
    if (!has(option))
        return fallback;
    bool isNumber = false;
    const quint64 found = value(option).toULongLong(&isNumber, 10);
    if (!isNumber || value(option).startsWith(QLatin1Char('-')))
        return wrongUse(place(
            *m_command, QStringLiteral("--%1: %2: expected a whole number from 0 to 18446744073709551615")
                            .arg(option, quoted(value(option)))));
    return found;
}

core::Result<qint64> Arguments::integerOperand(int index, qint64 minimum, qint64 maximum) const {
    bool isNumber = false;
    const qint64 found = operand(index).toLongLong(&isNumber, 10);
    if (!isNumber || found < minimum || found > maximum)
        return wrongUse(place(*m_command, QStringLiteral("%1: %2: expected a whole number from %3 to %4")
                                              .arg(m_command->operands[static_cast<std::size_t>(index)].name,
                                                   quoted(operand(index)))
                                              .arg(minimum)
                                              .arg(maximum)));
    return found;
}

core::Result<QString> Arguments::choice(const QString& option, const QStringList& words,
                                        const QString& fallback) const {
    if (!has(option))
        return fallback;
    if (!words.contains(value(option)))
        return wrongUse(
            place(*m_command, QStringLiteral("--%1: %2: expected one of %3")
                                  .arg(option, quoted(value(option)), words.join(QStringLiteral(", ")))));
    return value(option);
}

core::Result<QStringList> Arguments::list(const QString& option) const {
    if (!has(option))
        return QStringList();
    const QStringList parts = value(option).split(QLatin1Char(','));
    for (qsizetype i = 0; i < parts.size(); ++i) {
        if (parts[i].trimmed().isEmpty() || parts.indexOf(parts[i]) != i)
            return wrongUse(
                place(*m_command,
                      QStringLiteral("--%1: item %2 of %3: %4: expected words between commas, each once")
                          .arg(option)
                          .arg(i + 1)
                          .arg(quoted(value(option)), quoted(parts[i]))));
    }
    return parts;
}

core::Result<void> refusePasswordArgument(const QStringList& arguments) {
    for (const QString& argument : arguments) {
        if (argument == QLatin1String("--"))
            break;
        const QString name = argument.section(QLatin1Char('='), 0, 0);
        if (name == QLatin1String("--password") || name == QLatin1String("-password") ||
            name == QLatin1String("-p"))
            return wrongUse(
                QStringLiteral("%1: passwords are not taken on the command line, where others can read them; "
                               "expected them in CHIRON_PASSWORD or by --password-stdin")
                    .arg(name));
    }
    return {};
}

} // namespace chiron::cli
