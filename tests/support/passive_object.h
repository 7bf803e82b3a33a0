// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/tool_state.h"

#include <algorithm>
#include <array>

namespace chiron::tests {

/// P2's passive object model as books, as published; what the supervisor's observer per body
/// (haptics/passivity_observer.h) is held against: an object is watched at each place where it is touched;
/// what it stores there is told by the extension of its springs, and set against what it has shown to the
/// user.
///   displayed += f(k−1)·(x(k) − x(k−1))      work of the force that was shown, on the tool; > 0: the user
///   was given energy stored     = U(k)                        of the springs there (elastic, dent, bristle
///   if one likes) made       = displayed + stored          > 0: more has come out, or could, than was put
///   in: the object was not passive
/// Per contact and for the whole object (tools pass energy to each other through it). The work is what the
/// loop really does: the force held over a tick, so a sampled spring makes up to ½ k Δx² a tick, which is
/// what the supervisor's observer and controller (haptics/passivity_*) stand behind. One a body. Source: P2
/// "Passive Object Modeling"; Hannaford & Ryu 2002 for the books.
class PassiveObject {
public:
    struct Contact {
        bool touching = false;
        core::Vec3 start = core::Vec3::Zero(); ///< where the contact began, W
        core::Vec3 at = core::Vec3::Zero();    ///< the tool now
        core::Vec3 force = core::Vec3::Zero(); ///< shown since then, on the tool, W
        double displayed_J = 0.0;
        double stored_J = 0.0;

        double made_J() const noexcept { return displayed_J + stored_J; }
        /// P2: "whether it has moved from its initial position", how far, m.
        double moved_m() const noexcept { return (at - start).norm(); }
    };

    /// One tick of tool `tool` (0..kMaxTools−1): it is at `p`, touches or not, the springs hold `stored_J`
    /// there, and `force` will be shown until the next tick. A contact ends when the tool leaves; its books
    /// close then and are added to closed_J().
    void update(std::size_t tool, bool touching, const core::Vec3& p, const core::Vec3& force,
                double stored_J) noexcept {
        Contact& c = m_contacts[tool];
        if (c.touching)
            c.displayed_J += c.force.dot(p - c.at);
        if (touching && !c.touching) {
            c = Contact();
            c.start = p;
        }
        if (!touching && c.touching) {
            m_closed_J += c.displayed_J;
            c = Contact();
        }
        c.touching = touching;
        c.at = p;
        c.force = touching ? force : core::Vec3(core::Vec3::Zero());
        c.stored_J = touching ? stored_J : 0.0;
        m_worst_J = std::max(m_worst_J, made_J());
    }
    void reset() noexcept { *this = PassiveObject(); }

    const Contact& contact(std::size_t tool) const noexcept { return m_contacts[tool]; }
    double displayed_J() const noexcept { return sum(&Contact::displayed_J) + m_closed_J; }
    double stored_J() const noexcept { return sum(&Contact::stored_J); }
    /// > 0: the object has made energy since reset().
    double made_J() const noexcept { return displayed_J() + stored_J(); }
    double worst_J() const noexcept { return m_worst_J; }   ///< largest made_J() so far, ≥ 0
    double closed_J() const noexcept { return m_closed_J; } ///< displayed by contacts that have ended

private:
    double sum(double Contact::*what) const noexcept {
        double all = 0.0;
        for (const Contact& c : m_contacts)
            all += c.*what;
        return all;
    }
    std::array<Contact, core::kMaxTools> m_contacts{};
    double m_closed_J = 0.0;
    double m_worst_J = 0.0;
};

} // namespace chiron::tests
