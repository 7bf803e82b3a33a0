// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/scene_exchange.h"

namespace chiron::haptics {

SceneExchange::~SceneExchange() {
    collect();
    while (simulation::IScene* scene = take())
        delete scene; // never reached the loop
}

bool SceneExchange::offer(std::unique_ptr<simulation::IScene>& scene) {
    if (m_onTheirWay == kCapacity)
        // This keeps the retire ring, which has the same size, from ever being full.
        return false;
    m_offered.tryPush(scene.release());
    ++m_onTheirWay;
    return true;
}

int SceneExchange::collect() {
    int collected = 0;
    simulation::IScene* scene = nullptr;
    while (m_retired.tryPop(scene)) {
        delete scene;
        --m_onTheirWay;
        ++collected;
    }
    return collected;
}

} // namespace chiron::haptics
