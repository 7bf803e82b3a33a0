// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace chiron::core {

/// The one function that every thread which runs models calls first: round to nearest, flush denormals to zero
/// (FTZ and DAZ). Without it the same inputs could give other bits on another thread.
void setModelFloatingPointEnvironment() noexcept;

/// Names the processor features that choose the maths library's variants (e.g. "x86-64+fma+avx2"): two machines of
/// one class give the same bits, others may differ in the last one.
std::string cpuClass();

/// Identifies the build (version and compiler); a recording made by another build is not compared bit for bit.
std::string buildId();

/// The part of a build's name that decides about forces: the compiler and the models id, without the program's version. The models id
/// names the laws and their numerics; it is raised by every change that alters a force, and by nothing else.
std::string forcesOfBuild(const std::string& buildId);
/// The models id in a build's name, e.g. "2"; empty where it has none.
std::string modelsOfBuild(const std::string& buildId);

} // namespace chiron::core
