// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_runner.h"

#include <csignal>

int main(int argc, char** argv) {
    std::signal(SIGPIPE, SIG_IGN); // a closed pipe becomes an error to report instead of a silent end
    QStringList arguments;
    for (int i = 1; i < argc; ++i)
        arguments << QString::fromLocal8Bit(argv[i]);
    return chiron::cli::runProgram(arguments);
}
