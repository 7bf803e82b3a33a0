// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

/// One run of chiron-cli.
struct CliRun {
    bool ended = false; ///< by itself: no signal, no time-out
    int exitCode = -1;
    QByteArray out;
    QByteArray err;
};

/// Runs the program with an environment of its own: no password, a data folder that holds nothing, other
/// variables added.
CliRun runCli(const QStringList& arguments, const QByteArray& input = {},
              const QMap<QString, QString>& variables = {});

/// The same, but killed by SIGKILL after so many milliseconds. True: it died of it; false: it was over
/// before.
bool killCli(const QStringList& arguments, int after_ms);

/// Empty if the run is a proper refusal: this exit status, one line on stderr that holds every mention,
/// nothing on stdout, no signal. Otherwise what is wrong with it.
QString refusalFault(const CliRun& run, int exitCode, const QStringList& mentions);

/// The names of all commands ("user add"), read from the program's own help, so that a new one is tested
/// unasked.
QStringList cliCommands();
