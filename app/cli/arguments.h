// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"

#include <QCommandLineParser>
#include <QStringList>
#include <memory>

namespace chiron::cli {

/// The arguments of one command, their form checked: options known and given once, values there and not
/// empty, operands neither missing nor too many. Typed getters name the option, the value found and what was
/// expected.
class Arguments {
public:
    /// `rest` is what follows the command's words. Failure: wrongUse.
    static core::Result<Arguments> parse(const CommandSpec& command, const QStringList& rest);

    const CommandSpec& command() const { return *m_command; }
    bool has(const QString& option) const;
    bool json() const { return has(QStringLiteral("json")); }
    /// Empty where not given.
    QString value(const QString& option) const;
    /// Empty where not given.
    QString operand(int index) const;

    /// `fallback` where not given. Failure: wrongUse.
    core::Result<double> number(const QString& option, double minimum, double maximum, double fallback) const;
    core::Result<qint64> integer(const QString& option, qint64 minimum, qint64 maximum,
                                 qint64 fallback) const;
    /// A whole number from 0 to 2^64 - 1, for seeds.
    core::Result<quint64> seed(const QString& option, quint64 fallback) const;
    core::Result<qint64> integerOperand(int index, qint64 minimum, qint64 maximum) const;
    /// One of some words. Failure: wrongUse.
    core::Result<QString> choice(const QString& option, const QStringList& words,
                                 const QString& fallback) const;
    /// "a,b,c" as a list; each non-empty, none twice. Empty list where not given. Failure: wrongUse.
    core::Result<QStringList> list(const QString& option) const;

private:
    explicit Arguments(const CommandSpec& command) : m_command(&command) {}
    core::Result<void> checkOptions() const;
    core::Result<void> checkOperands() const;

    const CommandSpec* m_command;
    std::shared_ptr<QCommandLineParser>
        m_parser; ///< shared: the parser cannot be copied, arguments are values
};

/// Refuses a password on the command line, where every user of the machine can read it. Failure: wrongUse,
/// which does not repeat the value.
core::Result<void> refusePasswordArgument(const QStringList& arguments);

} // namespace chiron::cli
