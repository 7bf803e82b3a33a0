// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::core {

/// Sets rounding to nearest and flushes denormal numbers to zero (FTZ and DAZ). Every thread that runs models
/// calls this function first; otherwise the same inputs could give different bits on another thread.
void setModelFloatingPointEnvironment() noexcept;

/// Names the processor features that decide which variants of the maths library are used (e.g.
/// "x86-64+fma+avx2"). Two machines of one class give the same bits; machines of different classes may differ
/// in the last bit.
std::string cpuClass();

/// Identifies the build (version and compiler). A recording made by another build is not compared bit for
/// bit.
std::string buildId();

/// Returns the part of a build's name on which forces depend: the compiler and the models id, without the
/// program's version. The models id names the laws and their numerics; every change that alters a force
/// raises it, and nothing else does.
std::string forcesOfBuild(const std::string& buildId);
/// Returns the models id in a build's name, e.g. "2"; empty if it has none.
std::string modelsOfBuild(const std::string& buildId);

} // namespace chiron::core
