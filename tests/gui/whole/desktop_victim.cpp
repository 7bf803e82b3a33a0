// SPDX-License-Identifier: GPL-3.0-or-later
// The program in the middle of a set, to be killed: prints the database's path once the session is recording, then goes on.
#include "session/live_training.h"
#include "support/desktop_fixture.h"

#include <cstdio>

using namespace chiron;

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    tests::DesktopFixture desktop;
    desktop.logIn("tina");
    desktop.go(QStringLiteral("training"),
               {{QStringLiteral("exercise"), QStringLiteral("sphere_apex")}, {QStringLiteral("level"), 1}, {QStringLiteral("device"), QStringLiteral("mouse")}});
    if (!QTest::qWaitFor([&desktop] { return desktop.context.trialRuns(); }, 20000))
        return 1;
    std::printf("%s\n", qPrintable(desktop.file()));
    std::fflush(stdout);
    return QApplication::exec(); // until it is killed
}
