// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "realtime/spsc_ring.h"
#include "simulation/scene.h"

#include <memory>

namespace chiron::haptics {

/// Moves scenes into and out of a running loop without a lock or a delete in the tick. The owner offers a
/// scene that it has built, the loop takes it at the start of a tick and hands back the old one, and the
/// owner collects and deletes that. Destroy the exchange only after the loop has stopped.
/// Thread: offer() and collect() by the owner (GUI or session); take() and retire() by the loop.
class SceneExchange {
public:
    static constexpr std::size_t kCapacity = 4; ///< scenes offered and not yet collected

    SceneExchange() = default;
    SceneExchange(const SceneExchange&) = delete;
    SceneExchange& operator=(const SceneExchange&) = delete;
    ~SceneExchange();

    /// Hands over a scene. Returns false if four are not yet collected; `scene` then keeps it.
    bool offer(std::unique_ptr<simulation::IScene>& scene);
    /// Deletes the scenes that the loop gave back; returns how many.
    int collect();

    simulation::IScene* take() noexcept { ///< for the loop: the next scene, or nullptr
        simulation::IScene* scene = nullptr;
        m_offered.tryPop(scene);
        return scene;
    }
    /// For the loop. There is always room, see offer().
    void retire(simulation::IScene* scene) noexcept { m_retired.tryPush(scene); }

private:
    realtime::SpscRing<simulation::IScene*, kCapacity> m_offered;
    realtime::SpscRing<simulation::IScene*, kCapacity> m_retired;
    std::size_t m_onTheirWay = 0; ///< offered and not collected; used by the owner only
};

} // namespace chiron::haptics
