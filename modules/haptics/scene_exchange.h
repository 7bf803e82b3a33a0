// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/spsc_ring.h"
#include "simulation/scene.h"

#include <memory>

namespace chiron::haptics {

/// How scenes enter and leave a running loop without a lock or a delete in the tick: the owner offers a scene it built,
/// the loop takes it at the start of a tick and hands the old one back, the owner collects and deletes it.
/// Threads: offer(), collect() by the owner (GUI or session); take(), retire() by the loop. Destroyed only after the loop
/// has stopped.
class SceneExchange {
public:
    static constexpr std::size_t kCapacity = 4; ///< scenes on their way, not collected yet

    SceneExchange() = default;
    SceneExchange(const SceneExchange&) = delete;
    SceneExchange& operator=(const SceneExchange&) = delete;
    ~SceneExchange();

    /// Hands over a scene. False when four are not collected yet: `scene` keeps it.
    bool offer(std::unique_ptr<simulation::IScene>& scene);
    /// Deletes what the loop gave back; returns how many.
    int collect();

    simulation::IScene* take() noexcept { ///< loop: the next scene, or nullptr
        simulation::IScene* scene = nullptr;
        m_offered.tryPop(scene);
        return scene;
    }
    void retire(simulation::IScene* scene) noexcept { m_retired.tryPush(scene); } ///< loop: always has room, see offer()

private:
    realtime::SpscRing<simulation::IScene*, kCapacity> m_offered;
    realtime::SpscRing<simulation::IScene*, kCapacity> m_retired;
    std::size_t m_onTheirWay = 0; ///< offered and not collected; owner's side
};

} // namespace chiron::haptics
