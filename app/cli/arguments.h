// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command_spec.h"

#include <QCommandLineParser>
#include <QStringList>
#include <memory>

namespace chiron::cli {

/// The arguments of one command after a check of their form: every option is known and given at most once,
/// every value is present and not empty, and there are neither too few nor too many operands. The messages of
/// the typed getters name the option, the value found and what was expected.
class Arguments {
public:
    /// `rest` holds the arguments after the words of the command.
    /// Errors: wrongUse.
    static core::Result<Arguments> parse(const CommandSpec& command, const QStringList& rest);

    const CommandSpec& command() const { return *m_command; }
    bool has(const QString& option) const;
    bool json() const { return has(QStringLiteral("json")); }
    /// Empty if the option is not given.
    QString value(const QString& option) const;
    /// Empty if the operand is not given.
    QString operand(int index) const;

    /// Returns `fallback` if the option is not given.
    /// Errors: wrongUse.
    core::Result<double> number(const QString& option, double minimum, double maximum, double fallback) const;
    core::Result<qint64> integer(const QString& option, qint64 minimum, qint64 maximum,
                                 qint64 fallback) const;
    /// A whole number from 0 to 2^64 - 1, for seeds.
    core::Result<quint64> seed(const QString& option, quint64 fallback) const;
    core::Result<qint64> integerOperand(int index, qint64 minimum, qint64 maximum) const;
    /// Returns one of `words`, or `fallback` if the option is not given.
    /// Errors: wrongUse.
    core::Result<QString> choice(const QString& option, const QStringList& words,
                                 const QString& fallback) const;
    /// Splits "a,b,c" into a list whose items are non-empty and distinct. Returns an empty list if the option
    /// is not given.
    /// Errors: wrongUse.
    core::Result<QStringList> list(const QString& option) const;

private:
    explicit Arguments(const CommandSpec& command) : m_command(&command) {}
    core::Result<void> checkOptions() const;
    core::Result<void> checkOperands() const;

    const CommandSpec* m_command;
    /// Shared because the parser cannot be copied, while Arguments is a value.
    std::shared_ptr<QCommandLineParser> m_parser;
};

/// Refuses a password on the command line, where every user of the machine can read it.
/// Errors: wrongUse; the message does not repeat the value.
core::Result<void> refusePasswordArgument(const QStringList& arguments);

} // namespace chiron::cli
