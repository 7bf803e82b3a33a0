// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>

/// The program that gets killed. If the arguments are those of a child ("--child train|recover DATABASE RINGS
/// WITNESS SEED SECONDS"), does what they say and gives its exit status; else nothing. `train` recovers what
/// it finds, then runs one session of one trial in real time. Needs a QCoreApplication.
std::optional<int> runAsChild(const QStringList& arguments);
