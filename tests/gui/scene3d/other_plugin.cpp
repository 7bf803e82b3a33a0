// SPDX-License-Identifier: GPL-3.0-or-later
// A plugin of another build: right names, another face. Making a scene with it would be wrong.
#include <cstdlib>

extern "C" {
__attribute__((visibility("default"))) const char* chironSceneAbi() {
    return "chiron-scene 0 Qt 6.0.0 1 1";
}
__attribute__((visibility("default"))) void* chironMakeScene(const void*, void*) {
    std::abort();
}
}
