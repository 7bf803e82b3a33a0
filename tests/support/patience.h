// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace chiron::tests {

/// How long a test waits for what must come. Nothing is asserted about time: it only ends a run that hangs,
/// so it is far longer than a machine with much other work needs, and Qt's own 5 s are used nowhere
/// (test_documents looks).
inline constexpr int kPatience_ms = 120'000;

} // namespace chiron::tests
